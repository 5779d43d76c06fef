/* Exponential functions (C17 7.12.6.1 to 7.12.6.3). Errors: exp, exp2, exp10 0.52
   ulp, 0.75 where the result is subnormal; expm1 0.80 ulp.

   exp(x) = 2^(n/32) exp(r) with n the integer nearest to 32 x / log 2, so that |r| <= log(2)/64:
   a table of 2^(j/32) in two parts and a polynomial (P. T. P. Tang, "Table-driven implementation of
   the exponential function", ACM TOMS 15, 1989). Polynomials were fitted at Chebyshev points. */
#include <errno.h>
#include <math.h>

#include "kernel.h"

#define INVERSE 0x1.71547652b82fep+5         /* 32 / log 2 */
#define STEP_HI 0x1.62e42fefap-6             /* log 2 / 32, 37 bits */
#define STEP_LO 0x1.cf79abc9e3b3ap-45
#define LN2 0x1.62e42fefa39efp-1
#define LN10_HI 0x1.26bb1bbb55516p+1
#define LN10_LO -0x1.f48ad494ea3e9p-53

static const struct __crs_pair powers[32] = {
    {0x1p+0, 0x0.0p+0},
    {0x1.059b0d3158574p+0, 0x1.d73e2a475b465p-55},
    {0x1.0b5586cf9890fp+0, 0x1.8a62e4adc610bp-54},
    {0x1.11301d0125b51p+0, -0x1.6c51039449b3ap-54},
    {0x1.172b83c7d517bp+0, -0x1.19041b9d78a76p-55},
    {0x1.1d4873168b9aap+0, 0x1.e016e00a2643cp-54},
    {0x1.2387a6e756238p+0, 0x1.9b07eb6c70573p-54},
    {0x1.29e9df51fdee1p+0, 0x1.612e8afad1255p-55},
    {0x1.306fe0a31b715p+0, 0x1.6f46ad23182e4p-55},
    {0x1.371a7373aa9cbp+0, -0x1.63aeabf42eae2p-54},
    {0x1.3dea64c123422p+0, 0x1.ada0911f09ebcp-55},
    {0x1.44e086061892dp+0, 0x1.89b7a04ef80d0p-59},
    {0x1.4bfdad5362a27p+0, 0x1.d4397afec42e2p-56},
    {0x1.5342b569d4f82p+0, -0x1.07abe1db13cadp-55},
    {0x1.5ab07dd485429p+0, 0x1.6324c054647adp-54},
    {0x1.6247eb03a5585p+0, -0x1.383c17e40b497p-54},
    {0x1.6a09e667f3bcdp+0, -0x1.bdd3413b26456p-54},
    {0x1.71f75e8ec5f74p+0, -0x1.16e4786887a99p-55},
    {0x1.7a11473eb0187p+0, -0x1.41577ee04992fp-55},
    {0x1.82589994cce13p+0, -0x1.d4c1dd41532d8p-54},
    {0x1.8ace5422aa0dbp+0, 0x1.6e9f156864b27p-54},
    {0x1.93737b0cdc5e5p+0, -0x1.75fc781b57ebcp-57},
    {0x1.9c49182a3f090p+0, 0x1.c7c46b071f2bep-56},
    {0x1.a5503b23e255dp+0, -0x1.d2f6edb8d41e1p-54},
    {0x1.ae89f995ad3adp+0, 0x1.7a1cd345dcc81p-54},
    {0x1.b7f76f2fb5e47p+0, -0x1.5584f7e54ac3bp-56},
    {0x1.c199bdd85529cp+0, 0x1.11065895048ddp-55},
    {0x1.cb720dcef9069p+0, 0x1.503cbd1e949dbp-56},
    {0x1.d5818dcfba487p+0, 0x1.2ed02d75b3707p-55},
    {0x1.dfc97337b9b5fp+0, -0x1.1a5cd4f184b5cp-54},
    {0x1.ea4afa2a490dap+0, -0x1.e9c23179c2893p-54},
    {0x1.f50765b6e4540p+0, 0x1.9d3e12dd8a18bp-54},
};

/* 2^(n/32) exp(r + low) for |r| <= log(2)/64. */
static struct __crs_scaled combine(double n, double r, double low)
{
    struct __crs_scaled result;
    int whole = (int)n, j = whole & 31;
    double s = r + low, p = 0x1p-1 + s * (0x1.555555554dccap-3 + s * (0x1.5555555551910p-5 + s * (
        0x1.11114faa79fd2p-7 + s * 0x1.6c1700057e56ap-10)));

    p = s + ((r - s) + low + s * s * p);
    result.hi = powers[j].hi;
    result.lo = powers[j].lo + result.hi * p;
    result.exponent = (whole - j) / 32;
    return result;
}

struct __crs_scaled __crs_exp_pair(double hi, double lo)
{
    double n = __builtin_rint(hi * INVERSE);

    return combine(n, hi - n * STEP_HI, lo - n * STEP_LO);
}

double __crs_exp(double hi, double lo)
{
    struct __crs_scaled parts;
    double result;

    if (hi > 710)
        return __crs_overflow(1);
    if (hi < -746)
        return __crs_underflow(1);
    parts = __crs_exp_pair(hi, lo);
    result = __crs_scale(parts.hi + parts.lo, parts.exponent);
    if (result == 0 || result == INFINITY)
        errno = ERANGE;
    return result;
}

double exp(double x)
{
    if (x != x || x == INFINITY)
        return x;
    if (x == -INFINITY)
        return 0;
    return __crs_exp(x, 0);
}

double exp2(double x)
{
    struct __crs_scaled parts;
    double n, result;

    if (x != x || x == INFINITY)
        return x;
    if (x >= 1024)
        return __crs_overflow(1);
    if (x < -1076)
        return x == -INFINITY ? 0 : __crs_underflow(1);
    n = __builtin_rint(x * 32);
    parts = combine(n, (x - n / 32) * LN2, 0);
    result = __crs_scale(parts.hi + parts.lo, parts.exponent);
    if (result == 0)
        errno = ERANGE;
    return result;
}

double exp10(double x)
{
    double product, error;

    if (x - x != 0)
        return x == -INFINITY ? 0 : x;
    if (__builtin_fabs(x) > 400)
        return x > 0 ? __crs_overflow(1) : __crs_underflow(1);
    TWO_PRODUCT(product, error, x, LN10_HI);
    return __crs_exp(product, error + x * LN10_LO);
}

/* Near 0 a polynomial; elsewhere 2^e (hi + lo) - 1 with the subtraction in two parts. */
double expm1(double x)
{
    struct __crs_scaled parts;
    double p, power, hi, lo;

    if (__builtin_fabs(x) < 0.36) {
        if (__builtin_fabs(x) < 0x1p-54)
            return x;
        p = 0x1.5555555555556p-3 + x * (0x1.5555555555555p-5 + x * (0x1.1111111110717p-7 + x * (
            0x1.6c16c16c16663p-10 + x * (0x1.a01a01a9b97f7p-13 + x * (
            0x1.a01a01a599753p-16 + x * (0x1.71de065d6f29dp-19 + x * (
            0x1.27e4ddc684112p-22 + x * (
            0x1.af496752963b0p-26 + x * 0x1.1f706fd70e71fp-29))))))));
        return x + (x * x * 0.5 + x * x * x * p);
    }
    if (x != x || x == INFINITY)
        return x;
    if (x < -45)
        return -1;
    if (x > 60)
        return __crs_exp(x, 0);
    parts = __crs_exp_pair(x, 0);
    power = __crs_scale(1, parts.exponent);
    TWO_SUM(hi, lo, power * parts.hi, -1.0);
    return hi + (lo + power * parts.lo);
}
