/* Logarithms (C17 7.12.6.7 to 7.12.6.10). Error: 0.51 ulp.

   x = 2^n m with m in [0.70, 1.42); a table gives c near 1/m, of 20 bits so that r = m c - 1 is
   exact in two parts, and -log c; then log x = n log 2 - log c + log(1 + r) (P. T. P. Tang,
   "Table-driven implementation of the logarithm function", ACM TOMS 16, 1990), here summed with
   twice a double's digits because pow and others need them. The polynomial was fitted at Chebyshev
   points. */
#include <math.h>

#include "kernel.h"

#define LN2_HI 0x1.62e42fefa38p-1            /* a multiple of 2^-42, as are the table's hi */
#define LN2_LO 0x1.ef35793c7673p-45
#define FIRST 45                             /* the table's rows are for m near FIRST/64, ... */

static const struct {
    double c, hi, lo;                        /* c and -log c */
} table[] = {
    {0x1.6c16c00000000p+0, -0x1.68ac7fe9c7000p-2, 0x1.82f966ca9df86p-44},
    {0x1.642c800000000p+0, -0x1.522ad0738a000p-2, -0x1.d7ce0ad74385dp-46},
    {0x1.5c98800000000p+0, -0x1.3c251f7333000p-2, -0x1.03b54ab5c12a2p-46},
    {0x1.5555600000000p+0, -0x1.269641134d000p-2, -0x1.c93c334b1010bp-45},
    {0x1.4e5e000000000p+0, -0x1.1178c8227e000p-2, 0x1.c210fb8fb4d72p-45},
    {0x1.47ae200000000p+0, -0x1.f9920ecb3a000p-3, 0x1.8d03da7cce9c4p-48},
    {0x1.4141400000000p+0, -0x1.d103772656000p-3, 0x1.c4a7e7861a190p-47},
    {0x1.3b13c00000000p+0, -0x1.a93f33c8ac000p-3, 0x1.4391f682b24f4p-44},
    {0x1.3521c00000000p+0, -0x1.823bae5518000p-3, 0x1.9f917eb795332p-45},
    {0x1.2f68400000000p+0, -0x1.5bf3b6b542000p-3, -0x1.2c7eb6fa0f5bfp-45},
    {0x1.29e4200000000p+0, -0x1.3660270156000p-3, -0x1.e0c614b3bdb26p-44},
    {0x1.2492400000000p+0, -0x1.1178a8227e000p-3, 0x1.7084443942ab2p-44},
    {0x1.1f70400000000p+0, -0x1.da72063844000p-4, 0x1.1ddb06a6b91e1p-44},
    {0x1.1a7ba00000000p+0, -0x1.933675d594000p-4, 0x1.ef750efa1627bp-44},
    {0x1.15b1e00000000p+0, -0x1.4d30bdd208000p-4, 0x1.073a28fa4a459p-44},
    {0x1.1111200000000p+0, -0x1.085a6b59dc000p-4, -0x1.8068c36a8211cp-44},
    {0x1.0c97200000000p+0, -0x1.894bf149f8000p-5, 0x1.d7e63f236957ep-44},
    {0x1.0842200000000p+0, -0x1.0417b89e68000p-5, 0x1.cbb871ec3ed0cp-45},
    {0x1.0410400000000p+0, -0x1.0205258930000p-6, -0x1.591d27c392ec1p-44},
    {0x1p+0, 0x0.0p+0, 0x0.0p+0},
    {0x1.f81f800000000p-1, 0x1.fc0b0b0fc0000p-7, 0x1.f8f3e86147e01p-49},
    {0x1.f07c000000000p-1, 0x1.f82db0e7a0000p-6, 0x1.980312729348fp-45},
    {0x1.e913000000000p-1, 0x1.77474f6338000p-5, 0x1.07e26ad242126p-44},
    {0x1.e1e2000000000p-1, 0x1.f0a10c0128000p-5, -0x1.d59a92de0b93cp-45},
    {0x1.dae6000000000p-1, 0x1.341db961bc000p-4, 0x1.9d092aed8cba6p-44},
    {0x1.d41d400000000p-1, 0x1.6f0d38ae58000p-4, -0x1.434641b10f0bdp-44},
    {0x1.cd85800000000p-1, 0x1.a92603a4b4000p-4, -0x1.61c9dd0830ed5p-44},
    {0x1.c71c800000000p-1, 0x1.e26ff6e2b0000p-4, 0x1.2e5e93fdd5937p-44},
    {0x1.c0e0800000000p-1, 0x1.0d779fcd0a000p-3, 0x1.4cb30ef8beba7p-46},
    {0x1.bacf800000000p-1, 0x1.29557f8200000p-3, 0x1.c4699590e411dp-44},
    {0x1.b4e8000000000p-1, 0x1.44d336ccbc000p-3, -0x1.70cac0bdf22e7p-46},
    {0x1.af28800000000p-1, 0x1.5ff2a70a7c000p-3, -0x1.05871583bd7b2p-44},
    {0x1.a98f000000000p-1, 0x1.7ab860210e000p-3, 0x1.048ddfb597060p-46},
    {0x1.a41a400000000p-1, 0x1.9525b1cf46000p-3, -0x1.217137d49c039p-44},
    {0x1.9ec9000000000p-1, 0x1.af3c24e810000p-3, -0x1.e1a51f5ea52b7p-44},
    {0x1.9999800000000p-1, 0x1.c8fffc79ae000p-3, -0x1.77944bdf45989p-45},
    {0x1.948b000000000p-1, 0x1.e270c6e2b0000p-3, 0x1.7cbd522655eddp-44},
    {0x1.8f9c000000000p-1, 0x1.fb9206d5e8000p-3, -0x1.d570000ec91dcp-47},
    {0x1.8acb800000000p-1, 0x1.0a327a273a000p-2, 0x1.aff171272b157p-53},
    {0x1.8618800000000p-1, 0x1.16757ababe000p-2, -0x1.fc7fbf78ab8a7p-44},
    {0x1.8181800000000p-1, 0x1.229423bcf8000p-2, -0x1.9e976f595b40dp-44},
    {0x1.7d06000000000p-1, 0x1.2e8e0bae12000p-2, 0x1.4c2700879c369p-44},
    {0x1.78a4c00000000p-1, 0x1.3a64db5695000p-2, -0x1.938e30bb373f6p-44},
    {0x1.745d000000000p-1, 0x1.4618fc21c8000p-2, -0x1.3d819f2f62f77p-46},
    {0x1.702e000000000p-1, 0x1.51aae872e0000p-2, -0x1.74bd8c5b5272cp-44},
    {0x1.6c16c00000000p-1, 0x1.5d1bdff581000p-2, -0x1.856bdc9726ce2p-44},
    {0x1.6816800000000p-1, 0x1.686c85e9b1000p-2, 0x1.33b110b4d95a9p-44},
};

/* base + base_low + log(1 + r + low), for |r| <= 0.0115. */
static struct __crs_pair combine(double base, double base_low, double r, double low)
{
    struct __crs_pair result;
    double square, square_low, s, s_low, h, h_low, p =
        0x1.5555555555555p-2 + r * (-0x1p-2 + r * (0x1.999999999999ap-3 + r * (
        -0x1.555555555620dp-3 + r * (0x1.2492492493050p-3 + r * (-0x1.ffffff56f1a3ap-4 + r * (
        0x1.c71c712b0f16cp-4 + r * (-0x1.99b39b17a9a91p-4 + r * 0x1.747518a976c85p-4)))))));

    TWO_PRODUCT(square, square_low, r, r);
    FAST_TWO_SUM(s, s_low, r, -0.5 * square);
    s_low += low - (0.5 * square_low + r * low) + r * square * p;
    FAST_TWO_SUM(h, h_low, base, s);
    FAST_TWO_SUM(result.hi, result.lo, h, h_low + (s_low + base_low));
    return result;
}

struct __crs_pair __crs_log_pair(double hi, double lo)
{
    union __crs_bits m;
    double n = -1023, c, r, r_low, upper;
    int j;

    if (hi < 0x1p-1000) {
        hi *= 0x1p100;
        lo *= 0x1p100;
        n -= 100;
    }
    m.value = hi;
    n += EXPONENT_OF(m.bits);
    if (lo != 0)
        lo = __crs_scale(lo, 1023 - EXPONENT_OF(m.bits));
    m.bits = (m.bits & FRACTION_BITS) | 0x3ff0000000000000ULL;
    if (m.value > 1.4140625) {
        m.value *= 0.5;
        lo *= 0.5;
        n += 1;
    }
    hi = m.value;
    j = (int)(hi * 64 + 0.5) - FIRST;
    c = table[j].c;
    m.bits &= 0xffffffff00000000ULL;
    upper = m.value;
    TWO_SUM(r, r_low, upper * c - 1, (hi - upper) * c);
    return combine(n * LN2_HI + table[j].hi, n * LN2_LO + table[j].lo, r, r_low + lo * c);
}

struct __crs_pair __crs_log1p_pair(double x)
{
    double sum, low;

    if (__builtin_fabs(x) < 0.0115)
        return combine(0, 0, x, 0);
    TWO_SUM(sum, low, 1, x);
    return __crs_log_pair(sum, low);
}

/* Deals with the arguments that have no finite logarithm; returns 1 when it did. */
static int is_special(double x, double *result)
{
    if (x > 0 && x < INFINITY)
        return 0;
    if (x == 0)
        *result = __crs_pole_error(-1);
    else
        *result = x < 0 ? __crs_domain_error() : x;
    return 1;
}

double log(double x)
{
    double result;

    return is_special(x, &result) ? result : __crs_log_pair(x, 0).hi;
}

/* log x * (hi + lo), rounded. */
static double in_base(double x, double hi, double lo)
{
    struct __crs_pair l;
    double result, product, error;

    if (is_special(x, &result))
        return result;
    l = __crs_log_pair(x, 0);
    TWO_PRODUCT(product, error, l.hi, hi);
    return product + (error + (l.hi * lo + l.lo * hi));
}

double log2(double x)
{
    return in_base(x, 0x1.71547652b82fep+0, 0x1.777d0ffda0d24p-56);
}

double log10(double x)
{
    return in_base(x, 0x1.bcb7b1526e50ep-2, 0x1.95355baaafad3p-57);
}

double log1p(double x)
{
    if (x > -1 && x < INFINITY)
        return __builtin_fabs(x) < 0x1p-54 ? x : __crs_log1p_pair(x).hi;
    if (x == -1)
        return __crs_pole_error(-1);
    return x < -1 ? __crs_domain_error() : x;
}
