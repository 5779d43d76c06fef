/* Shared parts of the mathematical functions. */
#include <errno.h>
#include <math.h>

#include "kernel.h"

double __crs_domain_error(void)
{
    errno = EDOM;
    return NAN;
}

double __crs_pole_error(double sign)
{
    errno = ERANGE;
    return __builtin_copysign(INFINITY, sign);
}

double __crs_overflow(double sign)
{
    errno = ERANGE;
    return __builtin_copysign(INFINITY, sign);
}

double __crs_underflow(double sign)
{
    errno = ERANGE;
    return __builtin_copysign(0.0, sign);
}

double __crs_scale(double value, int exponent)
{
    union __crs_bits power;

    if (exponent > 1000) {
        value *= 0x1p1000;
        exponent -= 1000;
    } else if (exponent < -1000) {
        power.bits = (unsigned long long)(exponent + 600 + 1023) << 52;
        return value * power.value * 0x1p-600;
    }
    power.bits = (unsigned long long)(exponent + 1023) << 52;
    return value * power.value;
}

double __crs_polynomial(const double *c, int count, double x)
{
    double sum = c[--count];

    while (count-- > 0)
        sum = sum * x + c[count];
    return sum;
}
