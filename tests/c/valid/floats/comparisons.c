/* Comparisons of floating values, NaN and infinities among them. */
#include <stdio.h>

static void compare(double a, double b)
{
    printf("%g %g: %d %d %d %d %d %d\n", a, b, a < b, a <= b, a > b, a >= b, a == b, a != b);
}

int main(void)
{
    double zero = 0.0, inf = 1 / zero, nan = inf - inf;
    float f = 0.1f, fnan = (float) nan;

    compare(1, 2);
    compare(2, 1);
    compare(1, 1);
    compare(0.0, -0.0);
    compare(inf, inf);
    compare(-inf, inf);
    compare(inf, 1e308);
    printf("%d %d %d %d %d %d\n", nan < 1, nan <= 1, nan > 1, nan >= 1, nan == nan, nan != nan);
    printf("%d %d %d\n", fnan == fnan, fnan < 0, !(fnan >= 0));
    printf("%d %d\n", f == 0.1, f < 0.1);
    printf("%d %d\n", f > 0, f == f);
    if (nan)
        printf("nan is true\n");
    if (!zero)
        printf("zero is false\n");
    if (-0.0)
        printf("never\n");
    printf("%d %d\n", zero && 1, nan || 0);
    printf("%s\n", nan > 0 ? "more" : "not more");
    while (zero < 3.5)
        zero++;
    printf("%g\n", zero);
    return 0;
}
