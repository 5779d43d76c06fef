/* Floating values in conditions, with !, &&, ?:, in loops, and as _Bool. */
#include <stdbool.h>
#include <stdio.h>

static int truth(double d) { return d ? 1 : 0; }
static bool as_bool(float f) { return f; }

int main(void)
{
    double d = 0.25, tiny = 4.9e-324;
    float f = -0.0f;
    int turns = 0;

    printf("%d %d %d %d\n", truth(0.0), truth(-0.0), truth(tiny), truth(1e-320));
    printf("%d %d %d\n", as_bool(0.5f), as_bool(f), as_bool(1e-45f));
    printf("%d %d %d\n", !d, !f, !!tiny);
    printf("%d %d %d\n", d && f, d || f, f || !d);
    while (d) {
        d -= 0.0625;
        turns++;
    }
    printf("%d\n", turns);
    for (f = 1; f; f /= 2)
        turns++;
    printf("%d\n", turns);
    do
        d += 0.1;
    while (d < 0.95);
    printf("%.17g\n", d);
    if (f)
        printf("never\n");
    else if (d - 1)
        printf("not one\n");
    bool flag = 0.001;
    flag += 0.5;
    printf("%d %g\n", flag, flag + 0.5);
    return 0;
}
