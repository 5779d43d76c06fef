/* Rounding to whole numbers (C17 7.12.9). All are exact. */
#include <math.h>

double floor(double x)
{
    return __builtin_floor(x);
}

double ceil(double x)
{
    return __builtin_ceil(x);
}

double trunc(double x)
{
    return __builtin_trunc(x);
}

double rint(double x)
{
    return __builtin_rint(x);
}

double nearbyint(double x)
{
    return __builtin_rint(x);
}

/* Halves go away from zero. */
static double round_half_away(double x)
{
    double whole = __builtin_trunc(x);

    if (__builtin_fabs(x - whole) >= 0.5)
        whole += __builtin_copysign(1, x);
    return __builtin_copysign(whole, x);
}

double round(double x)
{
    return round_half_away(x);
}

/* Values that do not fit convert to the least number of the type, as on i386. */
static long to_long(double x)
{
    return x > -2147483649.0 && x < 2147483648.0 ? (long)x : -2147483647L - 1;
}

static long long to_long_long(double x)
{
    return x >= -0x1p63 && x < 0x1p63 ? (long long)x : -9223372036854775807LL - 1;
}

long lrint(double x)
{
    return to_long(__builtin_rint(x));
}

long lround(double x)
{
    return to_long(round_half_away(x));
}

long long llrint(double x)
{
    return to_long_long(__builtin_rint(x));
}

long long llround(double x)
{
    return to_long_long(round_half_away(x));
}

double modf(double x, double *whole)
{
    double rest;

    *whole = __builtin_trunc(x);
    rest = x - x == 0 ? x - *whole : x != x ? x : 0;
    return __builtin_copysign(rest, x);
}
