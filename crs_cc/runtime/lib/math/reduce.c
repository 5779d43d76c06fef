/* Reduction of angles modulo pi/2.

   Up to 2^20 multiples pi/2 is subtracted in four pieces of 33 bits, so that the products are exact
   (Cody and Waite, "Software Manual for the Elementary Functions", 1980). Beyond, x * 2/pi is
   multiplied out in integers from just those bits of 2/pi that matter (M. Payne and R. Hanek,
   "Radian reduction for trigonometric functions", SIGNUM Newsletter 18, 1983). */
#include "kernel.h"

#define TWO_OVER_PI 0x1.45f306dc9c883p-1
#define PIECE_1 0x1.921fb544p+0
#define PIECE_2 0x1.0b4611a6p-34
#define PIECE_3 0x1.3198a2ep-69
#define PIECE_4 0x1.b839a252049c1p-104
#define HALF_PI_HI 0x1.921fb54442d18p+0
#define HALF_PI_LO 0x1.1a62633145c07p-54
#define WORDS 6

/* 2/pi as a binary fraction, after 64 zeros. */
static const unsigned int two_over_pi[] = {
    0, 0,
    0xa2f9836eu, 0x4e441529u, 0xfc2757d1u, 0xf534ddc0u, 0xdb629599u, 0x3c439041u, 0xfe5163abu,
    0xdebbc561u, 0xb7246e3au, 0x424dd2e0u, 0x06492eeau, 0x09d1921cu, 0xfe1deb1cu, 0xb129a73eu,
    0xe88235f5u, 0x2ebb4484u, 0xe99c7026u, 0xb45f7e41u, 0x3991d639u, 0x835339f4u, 0x9c845f8bu,
    0xbdf9283bu, 0x1ff897ffu, 0xde05980fu, 0xef2f118bu, 0x5a0a6d1fu, 0x6d367ecfu, 0x27cb09b7u,
    0x4f463f66u, 0x9e5fea2du, 0x7527bac7u, 0xebe5f17bu, 0x3d0739f7u, 0x8a5292eau, 0x6bfb5fb1u,
    0x1f8d5d08u, 0x56033046u, 0xfc7b6babu, 0xf0cfbc20u, 0x9af4361du, 0xa9e39161u, 0x5ee61b08u,
};

static int reduce_small(double x, struct __crs_pair *rest)
{
    double n = __builtin_rint(x * TWO_OVER_PI), r, hi, error, low;

    r = x - n * PIECE_1;
    TWO_SUM(hi, low, r, -n * PIECE_2);
    TWO_SUM(r, error, hi, -n * PIECE_3);
    FAST_TWO_SUM(rest->hi, rest->lo, r, low + error - n * PIECE_4);
    return (int)n & 3;
}

/* The fraction of m 2^(e - 2) 2/pi, 32 bits a word, the least significant word first: the words of
   2/pi of which m 2^(e - 2) makes whole numbers are left out. */
static void multiply_out(unsigned int *fraction, unsigned long long m, int e)
{
    const unsigned int *from = two_over_pi + (e + 62) / 32;
    unsigned int shift = (e + 62) % 32, low = m, high = m >> 32;
    unsigned long long carry = 0, upper = 0;
    int i;

    for (i = 0; i < WORDS; i++) {
        const unsigned int *at = from + WORDS - 1 - i;
        unsigned int word = ((unsigned long long)at[0] << 32 | at[1]) << shift >> 32;
        unsigned long long product = (unsigned long long)word * low;
        carry += upper + (unsigned int)product;
        fraction[i] = carry;
        carry = (carry >> 32) + (product >> 32);
        upper = (unsigned long long)word * high;
    }
}

/* For |x| = m 2^e: a quarter turn is a quarter of the fraction, so that its two upper bits are the
   quadrant. The remaining bits are rounded to the nearest quadrant and turned into two doubles. No
   double lies so near to a multiple of pi/2 that all of `upper` would vanish. */
static int reduce_large(double x, struct __crs_pair *rest)
{
    union __crs_bits number;
    unsigned int fraction[WORDS];
    unsigned long long upper, lower;
    int quadrant, zeros;
    double hi, lo, product, error;

    number.value = x;
    multiply_out(fraction, (number.bits & FRACTION_BITS) | 1ULL << 52,
                 EXPONENT_OF(number.bits) - 1075);
    upper = (unsigned long long)fraction[5] << 32 | fraction[4];
    lower = (unsigned long long)fraction[3] << 32 | fraction[2];
    quadrant = upper >> 62;
    upper = upper << 2 | lower >> 62;
    lower = lower << 2 | fraction[1] >> 30;
    hi = HALF_PI_HI;
    if (upper >> 63) {
        quadrant++;
        upper = ~upper;
        lower = ~lower;
        hi = -hi;
    }
    zeros = __builtin_clzll(upper);
    upper = upper << zeros | lower >> 1 >> (63 - zeros);
    lower <<= zeros;
    lo = (double)(upper << 53 | lower >> 11) * 0x1p-64;
    hi = __crs_scale(hi, -53 - zeros);
    TWO_PRODUCT(product, error, hi, (double)(upper >> 11));
    error += hi * lo + __crs_scale(hi < 0 ? -HALF_PI_LO : HALF_PI_LO, -53 - zeros) *
                           (double)(upper >> 11);
    FAST_TWO_SUM(rest->hi, rest->lo, product, error);
    return quadrant & 3;
}

int __crs_reduce(double x, struct __crs_pair *rest)
{
    double magnitude = __builtin_fabs(x);
    int quadrant;

    if (magnitude <= 0x1.921fb54442d18p-1) {
        rest->hi = x;
        rest->lo = 0;
        return 0;
    }
    if (magnitude < 1647000)
        return reduce_small(x, rest);
    quadrant = reduce_large(x, rest);
    if (x > 0)
        return quadrant;
    rest->hi = -rest->hi;
    rest->lo = -rest->lo;
    return -quadrant & 3;
}
