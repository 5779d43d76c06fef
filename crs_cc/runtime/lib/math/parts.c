/* Parts and neighbours of a number, and results of comparisons (C17 7.12.6, 7.12.7.2, 7.12.11,
   7.12.12). All are exact; ldexp and its like round once where the result is subnormal. */
#include <errno.h>
#include <limits.h>
#include <math.h>

#include "kernel.h"

/* The exponent e of a finite x other than zero, 1 <= |x| 2^-e < 2. */
static int exponent_of(double x)
{
    union __crs_bits number;

    number.value = x;
    if (EXPONENT_OF(number.bits) != 0)
        return EXPONENT_OF(number.bits) - 1023;
    number.value = x * 0x1p54;
    return EXPONENT_OF(number.bits) - 1023 - 54;
}

/* Two steps keep the intermediate result normal, so that only the last one rounds. */
double __crs_ldexp(double x, int exponent)
{
    double result = x;
    int old;

    if (x == 0 || x - x != 0)
        return x;
    old = exponent_of(x);
    if (exponent > 2200)
        exponent = 2200;
    if (exponent < -2200)
        exponent = -2200;
    if (old < -1022) {
        result *= 0x1p54;
        exponent -= 54;
        old += 54;
    }
    if (old + exponent > 1023)
        return __crs_overflow(x);
    if (old + exponent < -1076)
        return __crs_underflow(x);
    result = __crs_scale(__crs_scale(result, -old), old + exponent);
    if (result == 0)
        errno = ERANGE;
    return result;
}

double ldexp(double x, int exponent)
{
    return __crs_ldexp(x, exponent);
}

double scalbn(double x, int exponent)
{
    return __crs_ldexp(x, exponent);
}

double scalbln(double x, long exponent)
{
    return __crs_ldexp(x, exponent);
}

double frexp(double x, int *exponent)
{
    *exponent = 0;
    if (x == 0 || x - x != 0)
        return x;
    *exponent = exponent_of(x) + 1;
    return __crs_ldexp(x, -*exponent);
}

int ilogb(double x)
{
    if (x != 0 && x - x == 0)
        return exponent_of(x);
    errno = EDOM;
    return x == 0 ? FP_ILOGB0 : x != x ? FP_ILOGBNAN : INT_MAX;
}

double logb(double x)
{
    if (x == 0)
        return __crs_pole_error(-1);
    return x - x != 0 ? x * x : exponent_of(x);
}

static double next(double x, double y)
{
    union __crs_bits number;

    if (x != x || y != y)
        return x + y;
    if (x == y)
        return y;
    number.value = x;
    if (x == 0)
        number.bits = y > 0 ? 1 : SIGN_BIT | 1;
    else if ((x < y) == (x > 0))
        number.bits++;
    else
        number.bits--;
    if (number.value - number.value != 0 || __builtin_fabs(number.value) < 0x1p-1022)
        errno = ERANGE;
    return number.value;
}

double nextafter(double x, double y)
{
    return next(x, y);
}

double nexttoward(double x, long double y)
{
    return next(x, y);
}

double nan(const char *text)
{
    (void)text;
    return NAN;
}

double fabs(double x)
{
    return __builtin_fabs(x);
}

double copysign(double x, double y)
{
    return __builtin_copysign(x, y);
}

double fmax(double x, double y)
{
    if (x != x || y != y)
        return x != x ? y : x;
    if (x == y)
        return __builtin_copysign(1, x) < 0 ? y : x;
    return x > y ? x : y;
}

double fmin(double x, double y)
{
    if (x != x || y != y)
        return x != x ? y : x;
    if (x == y)
        return __builtin_copysign(1, x) < 0 ? x : y;
    return x < y ? x : y;
}

double fdim(double x, double y)
{
    double result;

    if (x != x || y != y)
        return x + y;
    result = x > y ? x - y : 0;
    if (result == INFINITY && x != INFINITY && y != -INFINITY)
        errno = ERANGE;
    return result;
}

int finite(double x)
{
    return x - x == 0;
}
