/* Powers (C17 7.12.7.4): exp(y log x) with the logarithm and the product in two parts.
   Error: 0.62 ulp,
   0.75 where the result is subnormal. */
#include <errno.h>
#include <math.h>

#include "kernel.h"

enum { NO_INTEGER, EVEN, ODD };

static int parity(double y)
{
    if (__builtin_fabs(y) >= 0x1p53)
        return EVEN;
    if (y != __builtin_floor(y))
        return NO_INTEGER;
    return (long long)y & 1 ? ODD : EVEN;
}

/* x^y for a zero or infinite x, or an infinite y (C17 F.10.4.4). */
static double special(double x, double y)
{
    double magnitude = __builtin_fabs(x), sign = 1;

    if (y == INFINITY || y == -INFINITY) {
        if (magnitude == 1)
            return 1;
        return (magnitude > 1) == (y > 0) ? INFINITY : 0;
    }
    if (parity(y) == ODD)
        sign = __builtin_copysign(1, x);
    if (x == 0)
        return y < 0 ? __crs_pole_error(sign) : 0 * sign;
    return y < 0 ? 0 * sign : INFINITY * sign;
}

/* x^y for finite x > 0 and finite y. */
static double positive_power(double x, double y)
{
    struct __crs_pair l = __crs_log_pair(x, 0);
    double product, error;

    if (__builtin_fabs(y) > 0x1p66)
        return l.hi == 0 ? 1 : (l.hi > 0) == (y > 0) ? __crs_overflow(1) : __crs_underflow(1);
    TWO_PRODUCT(product, error, l.hi, y);
    return __crs_exp(product, error + l.lo * y);
}

double pow(double x, double y)
{
    int kind;

    if (y == 0 || x == 1)
        return 1;
    if (x != x || y != y)
        return x + y;
    if (x == 0 || x - x != 0 || y - y != 0)
        return special(x, y);
    if (x > 0)
        return positive_power(x, y);
    kind = parity(y);
    if (kind == NO_INTEGER)
        return __crs_domain_error();
    return kind == ODD ? -positive_power(-x, y) : positive_power(-x, y);
}
