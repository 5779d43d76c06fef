/* Hyperbolic functions and their inverses (C17 7.12.5). Errors: sinh, cosh 0.87, tanh 1.6,
   asinh 0.81, acosh, atanh 0.51 ulp.

   Near 0 sinh and tanh are odd polynomials, fitted at Chebyshev points; elsewhere they are made of
   exp x and its inverse. The inverses are logarithms of arguments in two parts. */
#include <errno.h>
#include <math.h>

#include "kernel.h"

#define LN2_HI 0x1.62e42fefa39efp-1
#define LN2_LO 0x1.abc9e3b39803fp-56

/* (exp x + sign exp -x)/2 for x > 0. */
static double half_sum(double x, double sign)
{
    struct __crs_scaled parts;
    double power, inverse, hi, lo, result;

    if (x > 711)
        return __crs_overflow(1);
    parts = __crs_exp_pair(x, 0);
    if (x > 22) {
        result = __crs_scale(parts.hi + parts.lo, parts.exponent - 1);
        if (result == INFINITY)
            errno = ERANGE;
        return result;
    }
    power = __crs_scale(0.5, parts.exponent);
    inverse = 0.25 / (power * (parts.hi + parts.lo));
    FAST_TWO_SUM(hi, lo, power * parts.hi, sign * inverse);
    return hi + (lo + power * parts.lo);
}

double sinh(double x)
{
    double magnitude = __builtin_fabs(x), z = x * x, p;

    if (x - x != 0 || magnitude < 0x1p-27)
        return x;
    if (magnitude > 1)
        return __builtin_copysign(half_sum(magnitude, -1), x);
    p = 0x1.5555555555555p-3 + z * (0x1.1111111111111p-7 + z * (0x1.a01a01a01a001p-13 + z * (
        0x1.71de3a556f96cp-19 + z * (0x1.ae6456792a77fp-26 + z * (0x1.612467ccb2260p-33 + z * (
        0x1.ae777c36fd5b6p-41 + z * 0x1.99f0806c2628dp-49))))));
    return x + x * z * p;
}

double cosh(double x)
{
    double magnitude = __builtin_fabs(x);

    if (x - x != 0)
        return magnitude;
    return magnitude < 0x1p-27 ? 1 : half_sum(magnitude, 1);
}

double tanh(double x)
{
    double magnitude = __builtin_fabs(x), z = x * x, p;

    if (x != x || magnitude < 0x1p-27)
        return x;
    if (magnitude > 22)
        return __builtin_copysign(1, x);
    if (magnitude > 0.5)
        return __builtin_copysign(1 - 2 / (__crs_exp(2 * magnitude, 0) + 1), x);
    p = -0x1.5555555555555p-2 + z * (0x1.11111111110ecp-3 + z * (-0x1.ba1ba1ba15d59p-5 + z * (
        0x1.664f487feaf6dp-6 + z * (-0x1.226e34a7d8966p-7 + z * (0x1.d6d39b2a0906ap-9 + z * (
        -0x1.7d9e720f64aeep-10 + z * (0x1.350cc7c289ae6p-11 + z * (-0x1.efa9dd5d1334ap-13 + z * (
        0x1.71e5729da5fccp-14 + z * -0x1.810342b83f4d7p-16)))))))));
    return x + x * z * p;
}

/* sqrt(x^2 + add) in two parts, for 1 <= x < 2^500 or so, |add| <= 1. */
static struct __crs_pair root_of_square(double x, double add)
{
    struct __crs_pair root;
    double square, square_low, sum, sum_low, product, error;

    TWO_PRODUCT(square, square_low, x, x);
    TWO_SUM(sum, sum_low, square, add);
    sum_low += square_low;
    root.hi = __builtin_sqrt(sum);
    TWO_PRODUCT(product, error, root.hi, root.hi);
    root.lo = root.hi == 0 ? 0 : ((sum - product) - error + sum_low) / (2 * root.hi);
    return root;
}

/* log(x + sqrt(x^2 + add)). */
static double log_of_sum(double x, double add)
{
    struct __crs_pair root, result;
    double sum, low;

    if (x > 0x1p30) {
        result = __crs_log_pair(x, 0);
        FAST_TWO_SUM(sum, low, result.hi, LN2_HI);
        return sum + (low + result.lo + LN2_LO);
    }
    root = root_of_square(x, add);
    TWO_SUM(sum, low, root.hi, x);
    return __crs_log_pair(sum, low + root.lo).hi;
}

double asinh(double x)
{
    double magnitude = __builtin_fabs(x), z = x * x;
    struct __crs_pair root;
    double top, low;

    if (x - x != 0 || magnitude < 0x1p-27)
        return x;
    if (magnitude > 0.5)
        return __builtin_copysign(log_of_sum(magnitude, 1), x);
    root = root_of_square(magnitude, 1);     /* x + x^2/(1 + root) = x + root - 1 */
    top = z / (1 + root.hi);
    FAST_TWO_SUM(top, low, magnitude, top);
    root = __crs_log1p_pair(top);
    return __builtin_copysign(root.hi + (root.lo + low / (1 + top)), x);
}

/* Near 1: log(1 + t + sqrt(2 t + t^2)) with t = x - 1, which is exact. */
double acosh(double x)
{
    double t, sum, low, root, product, error, square, square_low;
    struct __crs_pair result;

    if (!(x >= 1))
        return x != x ? x : __crs_domain_error();
    if (x == INFINITY)
        return x;
    if (x > 1.5)
        return log_of_sum(x, -1);
    t = x - 1;
    TWO_PRODUCT(square, square_low, t, t);
    FAST_TWO_SUM(sum, low, 2 * t, square);
    root = __builtin_sqrt(sum);
    TWO_PRODUCT(product, error, root, root);
    if (root != 0)
        low = ((sum - product) - error + (low + square_low)) / (2 * root);
    TWO_SUM(sum, error, root, t);
    result = __crs_log1p_pair(sum);
    return result.hi + (result.lo + (low + error) / (1 + sum));
}

double atanh(double x)
{
    double magnitude = __builtin_fabs(x), hi, lo;
    struct __crs_pair plus, minus;

    if (!(magnitude < 1))
        return x != x ? x : magnitude == 1 ? __crs_pole_error(x) : __crs_domain_error();
    if (magnitude < 0x1p-27)
        return x;
    plus = __crs_log1p_pair(x);
    minus = __crs_log1p_pair(-x);
    TWO_SUM(hi, lo, plus.hi, -minus.hi);
    return 0.5 * hi + 0.5 * (lo + plus.lo - minus.lo);
}
