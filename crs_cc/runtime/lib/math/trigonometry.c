/* Sine, cosine and tangent (C17 7.12.4.5 to 7.12.4.7). Errors: sin, cos 0.77, tan 0.90 ulp.

   The argument is reduced to [-pi/4, pi/4] in two parts; there sine and cosine are polynomials,
   fitted at Chebyshev points. The tangent is the quotient of both, corrected. */
#include <math.h>

#include "kernel.h"

struct __crs_pair __crs_sin_kernel(double hi, double lo)
{
    struct __crs_pair result;
    double z = hi * hi, p =
        -0x1.5555555555555p-3 + z * (0x1.1111111111110p-7 + z * (-0x1.a01a01a019936p-13 + z * (
        0x1.71de3a54605eep-19 + z * (-0x1.ae64541266378p-26 + z * (
        0x1.61217ec01749dp-33 + z * -0x1.ab17a79237a19p-41)))));

    result.hi = hi;
    result.lo = hi * z * p + lo * (1 - 0.5 * z);
    return result;
}

/* The square is taken in two parts: its half is subtracted from 1 and may be a third of it. */
struct __crs_pair __crs_cos_kernel(double hi, double lo)
{
    struct __crs_pair result;
    double z, z_low, q;

    TWO_PRODUCT(z, z_low, hi, hi);
    q = 0x1.5555555555555p-5 + z * (-0x1.6c16c16c16966p-10 + z * (0x1.a01a019f4e867p-16 + z * (
        -0x1.27e4fa17a41b4p-22 + z * (0x1.1eeb68b109173p-29 + z * -0x1.907d7aebd5e3dp-37))));
    FAST_TWO_SUM(result.hi, result.lo, 1, -0.5 * z);
    result.lo += z * z * q - (0.5 * z_low + hi * lo);
    return result;
}

double sin(double x)
{
    struct __crs_pair rest, value;
    int quadrant;

    if (__builtin_fabs(x) < 0x1p-27)
        return x;
    if (x - x != 0)
        return x != x ? x : __crs_domain_error();
    quadrant = __crs_reduce(x, &rest);
    value = quadrant & 1 ? __crs_cos_kernel(rest.hi, rest.lo) : __crs_sin_kernel(rest.hi, rest.lo);
    return quadrant & 2 ? -(value.hi + value.lo) : value.hi + value.lo;
}

double cos(double x)
{
    struct __crs_pair rest, value;
    int quadrant;

    if (x - x != 0)
        return x != x ? x : __crs_domain_error();
    quadrant = __crs_reduce(x, &rest) + 1;
    value = quadrant & 1 ? __crs_cos_kernel(rest.hi, rest.lo) : __crs_sin_kernel(rest.hi, rest.lo);
    return quadrant & 2 ? -(value.hi + value.lo) : value.hi + value.lo;
}

/* Both, to the same bits, for little more than one of them. */
void __crs_sin_cos(double x, double *sine, double *cosine)
{
    struct __crs_pair rest, across, along;
    double high, low;
    int quadrant;

    if (__builtin_fabs(x) < 0x1p-27 || x - x != 0) {
        *sine = sin(x);
        *cosine = cos(x);
        return;
    }
    quadrant = __crs_reduce(x, &rest);
    across = __crs_sin_kernel(rest.hi, rest.lo);
    along = __crs_cos_kernel(rest.hi, rest.lo);
    high = quadrant & 1 ? along.hi + along.lo : across.hi + across.lo;
    low = quadrant & 1 ? across.hi + across.lo : along.hi + along.lo;
    *sine = quadrant & 2 ? -high : high;
    *cosine = (quadrant + 1) & 2 ? -low : low;
}

double tan(double x)
{
    struct __crs_pair rest, top, bottom;
    double q, product, error;

    if (__builtin_fabs(x) < 0x1p-27)
        return x;
    if (x - x != 0)
        return x != x ? x : __crs_domain_error();
    if (__crs_reduce(x, &rest) & 1) {
        top = __crs_cos_kernel(rest.hi, rest.lo);
        bottom = __crs_sin_kernel(-rest.hi, -rest.lo);
    } else {
        top = __crs_sin_kernel(rest.hi, rest.lo);
        bottom = __crs_cos_kernel(rest.hi, rest.lo);
    }
    FAST_TWO_SUM(top.hi, top.lo, top.hi, top.lo);
    FAST_TWO_SUM(bottom.hi, bottom.lo, bottom.hi, bottom.lo);
    q = top.hi / bottom.hi;
    TWO_PRODUCT(product, error, q, bottom.hi);
    return q + ((top.hi - product) - error + (top.lo - q * bottom.lo)) / bottom.hi;
}
