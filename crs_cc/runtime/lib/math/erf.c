/* Error functions (C17 7.12.8.1 and 7.12.8.2). Errors: erf 0.85, erfc 0.82 ulp.

   erf is an odd polynomial up to 0.65. From 0.5 on, erfc x = exp(-x^2) f(t)/(1 + 2 x), where f is a
   polynomial in t = (x - 5/2)/(x + 5/2) and nearly constant (M. M. Shepherd, J. G. Laframboise,
   "Chebyshev approximation of (1 + 2x) exp(x^2) erfc x", Math. Comp. 36, 1981), all in two parts.
   The polynomials were fitted at Chebyshev points. */
#include <errno.h>
#include <math.h>

#include "kernel.h"

#define F_HI 0x1.43cc6f6c9672cp+0                          /* f(0) */
#define F_LO 0x1.8f862044f93b1p-56

static const double near_zero[] = {          /* erf x / x - 1 in x^2 */
    0x1.06eba8214db69p-3, -0x1.812746b0379e6p-2, 0x1.ce2f21a042b21p-4,
    -0x1.b82ce31281f7dp-6, 0x1.565bcd0c7a3d1p-8, -0x1.c02db359aa606p-11,
    0x1.f9a3040e58cb3p-14, -0x1.f4cda65f95ceap-17, 0x1.b97debba1c017p-20,
    -0x1.59c02318c2fe8p-23, 0x1.a16e24561246bp-27,
};

static const double tail[] = {               /* (f(t) - f(0))/t */
    -0x1.f52c5d7e22302p-4, -0x1.959ac16f8571dp-4, 0x1.42d379989b5eap-3,
    -0x1.a5c0c8a403c4dp-4, 0x1.0c6092a5a1f10p-5, 0x1.e894895a9974ep-11,
    -0x1.1f2f13253170bp-8, 0x1.01e11d34350afp-11, 0x1.4b6a495cecb98p-11,
    -0x1.731c0139731a7p-14, -0x1.dc254a92e835ep-14, 0x1.a48cba553366ap-18,
    0x1.7ccd6ac5a9e08p-16, 0x1.5ded61fb09c75p-19, -0x1.1a997e93385f2p-18,
    -0x1.a8fd7c526b5edp-20, 0x1.133b837c259a0p-21, 0x1.1f44e52a1f374p-21,
    0x1.bc849d56f4678p-25, -0x1.1f92e60d67362p-23, -0x1.ccbc18aeb5cb6p-25,
    0x1.f72ef2d2c2f9dp-26, 0x1.c6efea72382ddp-27, -0x1.8b4b4998a6be9p-28,
};

static double small_erf(double x)
{
    double z = x * x;

    return x * __crs_polynomial(near_zero, sizeof near_zero / sizeof *near_zero, z);
}

/* erfc x for 0.5 <= x < 30. */
static double large_erfc(double x)
{
    double square, square_low, f, f_low, top, top_low, bottom, bottom_low, q, product, error;
    double t = (x - 2.5) / (x + 2.5);
    struct __crs_scaled parts;

    TWO_PRODUCT(square, square_low, x, x);
    parts = __crs_exp_pair(-square, -square_low);
    FAST_TWO_SUM(f, f_low, F_HI,
                 F_LO + t * __crs_polynomial(tail, sizeof tail / sizeof *tail, t));
    TWO_PRODUCT(top, top_low, parts.hi, f);
    top_low += parts.hi * f_low + parts.lo * f;
    TWO_SUM(bottom, bottom_low, 1, 2 * x);
    q = top / bottom;
    TWO_PRODUCT(product, error, q, bottom);
    q += ((top - product) - error + (top_low - q * bottom_low)) / bottom;
    return __crs_ldexp(q, parts.exponent);
}

double erf(double x)
{
    double magnitude = __builtin_fabs(x);

    if (magnitude < 0.65)
        return magnitude < 0x1p-1000 ? x + x * 0.12837916709551258 : x + small_erf(x);
    if (magnitude > 6)
        return __builtin_copysign(1, x);
    return x != x ? x : __builtin_copysign(1 - large_erfc(magnitude), x);
}

double erfc(double x)
{
    if (__builtin_fabs(x) < 0.5)
        return x < 0.25 ? 1 - (x + small_erf(x)) : 0.5 - (x - 0.5 + small_erf(x));
    if (x != x)
        return x;
    if (x > 28)
        return x == INFINITY ? 0 : __crs_underflow(1);
    if (x < 0)
        return x < -6 ? 2 : 2 - large_erfc(-x);
    return large_erfc(x);
}
