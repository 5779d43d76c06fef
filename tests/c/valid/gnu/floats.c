/* What kind of number a floating one is, and comparisons that a NaN does not disturb. */
#include <float.h>
#include <stdio.h>

enum { NAN_, INFINITE, NORMAL, SUBNORMAL, ZERO };

static void show(double x)
{
    printf("%d%d%d%d%d%d ", __builtin_isnan(x), !!__builtin_isinf(x), __builtin_isfinite(x),
           !!__builtin_isnormal(x), __builtin_isinf_sign(x), !!__builtin_signbit(x));
    printf("%d\n", __builtin_fpclassify(NAN_, INFINITE, NORMAL, SUBNORMAL, ZERO, x));
}

static void show_float(float x)
{
    printf("%d%d%d%d%d%d ", __builtin_isnan(x), !!__builtin_isinf(x), __builtin_isfinite(x),
           !!__builtin_isnormal(x), __builtin_isinf_sign(x), !!__builtin_signbit(x));
    printf("%d\n", __builtin_fpclassify(NAN_, INFINITE, NORMAL, SUBNORMAL, ZERO, x));
}

static int calls;

static double next(double x)
{
    calls++;
    return x;
}

int main(void)
{
    double nan = __builtin_nan(""), inf = __builtin_inf(), values[] = {nan, -inf, -1, 0, 2.5, inf};
    int i, j;

    show(1);
    show(-0.0);
    show(DBL_MIN / 3);
    show(-__builtin_huge_val());
    show(nan);
    show_float(-1e-40f);
    show_float(__builtin_inff());
    show_float(__builtin_nanf(""));
    show_float(FLT_MIN);
    for (i = 0; i < 6; i++)
        for (j = 0; j < 6; j++)
            printf("%d%d%d%d%d%d%c", __builtin_isgreater(values[i], values[j]),
                   __builtin_isgreaterequal(values[i], values[j]),
                   __builtin_isless(values[i], values[j]),
                   __builtin_islessequal(values[i], values[j]),
                   __builtin_islessgreater(values[i], values[j]),
                   __builtin_isunordered(values[i], values[j]), j == 5 ? '\n' : ' ');
    printf("%d %d ", __builtin_isnan(next(1)), __builtin_isless(next(1), next(2)));
    printf("%d\n", calls);
    printf("%g %g %g %g\n", __builtin_fabs(-2), __builtin_sqrt(2.25), __builtin_copysign(3, -0.0),
           (double)__builtin_floorf(-2.5f));
    printf("%g %g\n", __builtin_pow(2, 10), __builtin_fmax(1, 2) + __builtin_ldexp(1, 3));
    return 0;
}
