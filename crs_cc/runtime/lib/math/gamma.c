/* Gamma function and its logarithm (C17 7.12.8.3 and 7.12.8.4). Errors: tgamma 0.65,
   lgamma 1.4 ulp; close to lgamma's zeros below -2 it is 2^-58 in absolute terms.

   From 10 on Stirling's series, with log and exp in two parts; below, the recurrence
   gamma(x + 1) = x gamma(x) leads there; from -10 down the reflection
   gamma(x) gamma(1 - x) = pi / sin(pi x) does (Abramowitz and Stegun 6.1). The zeros of lgamma at 1
   and 2 have polynomials of their own. The polynomials were fitted at Chebyshev points. */
#include <errno.h>
#include <math.h>

#include "kernel.h"

#define PI_HI 0x1.921fb54442d18p+1
#define PI_LO 0x1.1a62633145c07p-53
#define LOG_PI_HI 0x1.250d048e7a1bdp+0
#define LOG_PI_LO 0x1.7abf2ad8d5088p-57
#define HALF_LOG_2PI_HI 0x1.d67f1c864beb5p-1
#define HALF_LOG_2PI_LO -0x1.65b5a1b7ff5dfp-55

int signgam;

static const double series[] = {             /* of Stirling's correction times x, in 1/x^2 */
    0x1.5555555555555p-4, -0x1.6c16c16c0ba33p-9, 0x1.a01a00d4c8353p-11,
    -0x1.38122c1da5be1p-11, 0x1.b84da6b7b609ep-11, -0x1.c84007120f1dbp-10,
};

static const double at_one[] = {             /* lgamma(1 + t)/t */
    -0x1.2788cfc6fb619p-1, 0x1.a51a6625307d2p-1, -0x1.9a4d55beab2d5p-2,
    0x1.151322ac7e197p-2, -0x1.a8b9c17aa72f0p-3, 0x1.5b40cb0e75b94p-3,
    -0x1.2703a1db68d8fp-3, 0x1.010b37a83dc70p-3, -0x1.c8067244f7e01p-4,
    0x1.9a01426ad6721p-4, -0x1.748b9a532e4edp-4, 0x1.558857adecb2bp-4,
    -0x1.3b399035c6ed2p-4, 0x1.2187ce99cd84ap-4, -0x1.0e2cdf9bf0914p-4,
    0x1.2a6de97e271acp-4, -0x1.1927c464e41a1p-4,
};

static const double at_two[] = {             /* lgamma(2 + t)/t */
    0x1.b0ee6072093cep-2, 0x1.4a34cc4a60fa6p-2, -0x1.13e001a557599p-4,
    0x1.51322ac7d83b5p-6, -0x1.e404fc21fd414p-8, 0x1.7add6eae1dbc7p-9,
    -0x1.38ac5b8762272p-10, 0x1.0b36aeebfc782p-11, -0x1.d3fe36ff70be5p-13,
    0x1.a1288cb92d7c3p-14, -0x1.7888c15307598p-15, 0x1.57bd97aba6e33p-16,
    -0x1.4c272ade72289p-17, 0x1.34098c7f746ddp-18,
};

static struct __crs_pair multiply(struct __crs_pair a, struct __crs_pair b)
{
    struct __crs_pair result;
    double product, error;

    TWO_PRODUCT(product, error, a.hi, b.hi);
    FAST_TWO_SUM(result.hi, result.lo, product, error + (a.hi * b.lo + a.lo * b.hi));
    return result;
}

/* log gamma(x) for 10 <= x < 2^60. */
static struct __crs_pair stirling(struct __crs_pair x)
{
    struct __crs_pair l = __crs_log_pair(x.hi, x.lo), factor, result;
    double sum, low, error, inverse = 1 / x.hi;

    TWO_SUM(factor.hi, factor.lo, x.hi, -0.5);
    factor.lo += x.lo;
    result = multiply(factor, l);
    TWO_SUM(sum, low, result.hi, -x.hi);
    low += result.lo - x.lo;
    TWO_SUM(sum, error, sum, HALF_LOG_2PI_HI);
    low += error + HALF_LOG_2PI_LO;
    low += inverse * __crs_polynomial(series, sizeof series / sizeof *series, inverse * inverse);
    FAST_TWO_SUM(result.hi, result.lo, sum, low);
    return result;
}

/* log |gamma(x)| = stirling(*shifted) - log |product| for x >= -10 that is not a pole. */
static struct __crs_pair shift(double x, double low, struct __crs_pair *shifted)
{
    struct __crs_pair product = {1, 0}, factor;
    int count = x < 10 ? (int)__builtin_ceil(10 - x) : 0, i;

    for (i = 0; i < count; i++) {
        TWO_SUM(factor.hi, factor.lo, x, (double)i);
        factor.lo += low;
        product = multiply(product, factor);
    }
    TWO_SUM(shifted->hi, shifted->lo, x, (double)count);
    shifted->lo += low;
    return product;
}

/* sin(pi x); x must not be an integer. */
static struct __crs_pair sine_of_pi(double x)
{
    double whole = __builtin_rint(x), rest = x - whole, near = __builtin_fabs(rest), angle, error;
    struct __crs_pair sine;

    if (near > 0.25) {
        TWO_PRODUCT(angle, error, 0.5 - near, PI_HI);
        sine = __crs_cos_kernel(angle, error + (0.5 - near) * PI_LO);
    } else {
        TWO_PRODUCT(angle, error, near, PI_HI);
        sine = __crs_sin_kernel(angle, error + near * PI_LO);
    }
    FAST_TWO_SUM(sine.hi, sine.lo, sine.hi, sine.lo);
    if ((rest < 0) != (__builtin_fabs(whole * 0.5 - __builtin_trunc(whole * 0.5)) == 0.5)) {
        sine.hi = -sine.hi;
        sine.lo = -sine.lo;
    }
    return sine;
}

static double divide(struct __crs_pair top, struct __crs_pair bottom, int exponent)
{
    double q = top.hi / bottom.hi, product, error;

    TWO_PRODUCT(product, error, q, bottom.hi);
    q += ((top.hi - product) - error + (top.lo - q * bottom.lo)) / bottom.hi;
    return __crs_ldexp(q, exponent);
}

double tgamma(double x)
{
    struct __crs_pair shifted, product, value, pi = {PI_HI, PI_LO};
    struct __crs_scaled parts;
    double one, low;

    if (x != x || x == INFINITY)
        return x;
    if (x == 0)
        return __crs_pole_error(x);
    if (x < 0 && x == __builtin_floor(x))
        return __crs_domain_error();
    if (__builtin_fabs(x) < 0x1p-60)
        return __builtin_fabs(x) <= 0x1p-1024 ? __crs_overflow(x) : 1 / x;
    if (x > 172)
        return __crs_overflow(1);
    if (x < -184)
        return __crs_underflow(sine_of_pi(x).hi);
    if (x < -10)
        TWO_SUM(one, low, 1, -x);
    else
        one = x, low = 0;
    product = shift(one, low, &shifted);
    value = stirling(shifted);
    parts = __crs_exp_pair(value.hi, value.lo);
    value.hi = parts.hi;
    value.lo = parts.lo;
    if (x < -10)
        return divide(pi, multiply(value, sine_of_pi(x)), -parts.exponent);
    return divide(value, product, parts.exponent);
}

/* x (log x - 1), which is all that counts of Stirling's series from 2^60 on. */
static double huge_lgamma(double x)
{
    struct __crs_pair l = __crs_log_pair(x, 0), factor;
    double sum, low;

    TWO_SUM(sum, low, l.hi, -1.0);
    l.hi = sum;
    l.lo += low;
    factor.hi = x * 0x1p-60;
    factor.lo = 0;
    return __crs_ldexp(multiply(factor, l).hi, 60);
}

/* log |gamma(x)| by recurrence or reflection. */
static double general_lgamma(double x, int *sign)
{
    struct __crs_pair shifted, part, product;
    double one, low, sum, error;

    if (x < -10) {
        TWO_SUM(one, low, 1, -x);
        shifted.hi = one;
        shifted.lo = low;
        product = sine_of_pi(x);
        part = stirling(shifted);
        TWO_SUM(sum, low, LOG_PI_HI, -part.hi);
        low += LOG_PI_LO - part.lo;
    } else {
        product = shift(x, 0, &shifted);
        part = stirling(shifted);
        sum = part.hi;
        low = part.lo;
    }
    if (product.hi < 0) {
        *sign = -1;
        product.hi = -product.hi;
        product.lo = -product.lo;
    }
    part = __crs_log_pair(product.hi, product.lo);
    TWO_SUM(sum, error, sum, -part.hi);
    return sum + (error + low - part.lo);
}

double __crs_log_gamma(double x, int *sign)
{
    double t;

    *sign = 1;
    if (x - x != 0)
        return x * x;
    if (x <= 0 && x == __builtin_floor(x))
        return __crs_pole_error(1);
    if (__builtin_fabs(x) < 0x1p-60) {
        *sign = x < 0 ? -1 : 1;
        return -__crs_log_pair(__builtin_fabs(x), 0).hi;
    }
    if (x > 0x1p60)
        return huge_lgamma(x);
    t = x - 1;
    if (__builtin_fabs(t) < 0.2)
        return t == 0 ? 0 : t * __crs_polynomial(at_one, sizeof at_one / sizeof *at_one, t);
    t = x - 2;
    if (__builtin_fabs(t) < 0.25)
        return t * __crs_polynomial(at_two, sizeof at_two / sizeof *at_two, t);
    return general_lgamma(x, sign);
}

double lgamma(double x)
{
    return __crs_log_gamma(x, &signgam);
}

/* The sign of gamma(x) is stored where the caller specifies (BSD). */
double lgamma_r(double x, int *sign)
{
    return __crs_log_gamma(x, sign);
}

float lgammaf_r(float x, int *sign)
{
    return (float)__crs_log_gamma(x, sign);
}
