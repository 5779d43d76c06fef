/* Infinities and NaNs: comparisons, arithmetic, printing, conditions. */
#include <math.h>
#include <stdio.h>

static int order(double a, double b)
{
    return (a < b) | (a <= b) << 1 | (a > b) << 2 | (a >= b) << 3 | (a == b) << 4 | (a != b) << 5;
}

int main(void)
{
    volatile double zero = 0;
    double inf = 1 / zero, nan = inf - inf;
    float finf = (float) inf;

    printf("%g %g %f %E\n", inf, -inf, inf, -inf);
    printf("%d %d %d\n", order(nan, nan), order(nan, 1), order(inf, 1));
    printf("%d %d\n", order(-inf, inf), order(inf, finf));
    printf("%d %d %d\n", nan == nan, nan != nan, !(nan < 1));
    printf("%d %d %d\n", isnan(nan) != 0, isinf(inf) != 0, isnan(inf) != 0);
    printf("%d %d\n", nan ? 1 : 0, !nan);
    printf("%g %g %g\n", inf + 1, 1 / inf, -1 / inf);
    printf("%d %d\n", isnan(inf * 0) != 0, isnan(sqrt(-1.0 - zero)) != 0);
    printf("%g %g\n", fmax(nan, 3), fmin(2, nan));
    printf("%g %g\n", fabs(-inf), floor(inf));
    printf("%d %d\n", HUGE_VAL == inf, INFINITY == finf);
    printf("%d %d %d\n", isfinite(1e308) != 0, isfinite(1e308 * 10) != 0, signbit(-zero) != 0);
    if (nan > 0 || nan <= 0 || nan == 0)
        printf("never\n");
    while (!(nan >= 1)) {
        printf("left\n");
        break;
    }
    return 0;
}
