/* Two and a half thousand calls deep. */
#include <stdio.h>

static int depth(int n)
{
    return n == 0 ? 0 : 1 + depth(n - 1);
}

static double sum(double x, int n)
{
    double here = x / n;

    if (n == 1)
        return here;
    return sum(x, n - 1) + here;
}

static int even(int n);
static int odd(int n) { return n ? even(n - 1) : 0; }
static int even(int n) { return n ? odd(n - 1) : 1; }

int main(void)
{
    printf("%d\n", depth(2500));
    printf("%.10f\n", sum(1.0, 2500));
    printf("%d %d\n", even(2500), odd(2499));
    return 0;
}
