/* x y + z rounded once (C17 7.12.13): the product and z as integers of 192 bits. */
#include <errno.h>
#include <math.h>

#include "kernel.h"

/* (-1)^negative (high 2^64 + low) 2^exponent, and a little more when `inexact`. */
struct wide {
    int negative, exponent, inexact;
    unsigned long long high, low;
};

static unsigned long long mantissa_of(double x, int *exponent)
{
    union __crs_bits number;

    number.value = x;
    *exponent = EXPONENT_OF(number.bits);
    if (*exponent == 0) {
        *exponent = 1 - 1075;
        return number.bits & FRACTION_BITS;
    }
    *exponent -= 1075;
    return (number.bits & FRACTION_BITS) | 1ULL << 52;
}

/* Shifts so that the uppermost bit of 126 is set, and the sum of two does not overflow. */
static void normalize(struct wide *x)
{
    while (x->high >> 61 == 0) {
        x->high = x->high << 1 | x->low >> 63;
        x->low <<= 1;
        x->exponent--;
    }
}

static struct wide multiply(double x, double y)
{
    struct wide result;
    int ex, ey;
    unsigned long long a = mantissa_of(x, &ex), b = mantissa_of(y, &ey);
    unsigned long long a_low = a & 0xffffffff, b_low = b & 0xffffffff;
    unsigned long long low = a_low * b_low;
    unsigned long long middle = (a >> 32) * b_low + a_low * (b >> 32) + (low >> 32);

    result.negative = (__builtin_copysign(1, x) < 0) != (__builtin_copysign(1, y) < 0);
    result.low = middle << 32 | (low & 0xffffffff);
    result.high = (a >> 32) * (b >> 32) + (middle >> 32);
    result.exponent = ex + ey;
    result.inexact = 0;
    normalize(&result);
    return result;
}

static struct wide widen(double x)
{
    struct wide result;

    result.negative = x < 0;
    result.high = 0;
    result.low = mantissa_of(x, &result.exponent);
    result.inexact = 0;
    normalize(&result);
    return result;
}

/* Brings a number to a larger exponent. */
static void shift_right(struct wide *x, int count)
{
    x->exponent += count;
    if (count >= 128) {
        x->inexact = 1;
        x->high = x->low = 0;
        return;
    }
    if (count >= 64) {
        x->inexact |= x->low != 0;
        x->low = x->high;
        x->high = 0;
        count -= 64;
    }
    if (count > 0) {
        x->inexact |= x->low << (64 - count) != 0;
        x->low = x->low >> count | x->high << (64 - count);
        x->high >>= count;
    }
}

/* Adds b, whose absolute value is not the larger one. What b lost by shifting lies below every bit:
   after a subtraction the sum is a little less than the bits say, so that one is borrowed. */
static void add(struct wide *a, struct wide *b)
{
    shift_right(b, a->exponent - b->exponent);
    if (a->negative == b->negative) {
        a->low += b->low;
        a->high += b->high + (a->low < b->low);
    } else {
        a->high -= b->high + (a->low < b->low);
        a->low -= b->low;
        if (b->inexact) {
            a->high -= a->low == 0;
            a->low--;
        }
    }
    a->inexact = b->inexact;
}

static double round_wide(struct wide *x)
{
    unsigned long long kept, rest, half;
    double result;
    int drop;

    if (x->high == 0 && x->low == 0)
        return 0;
    while (x->high >> 63 == 0) {
        x->high = x->high << 1 | x->low >> 63;
        x->low <<= 1;
        x->exponent--;
    }
    x->exponent += 64;
    x->inexact |= x->low != 0;
    drop = x->exponent + 11 < -1074 ? -1074 - x->exponent : 11;
    if (drop > 64)
        return __crs_underflow(x->negative ? -1 : 1);
    half = 1ULL << (drop - 1);
    kept = x->high >> (drop - 1) >> 1;
    rest = x->high - (kept << (drop - 1) << 1);
    if (rest > half || (rest == half && (x->inexact || kept & 1)))
        kept++;
    result = __crs_ldexp((double)kept, x->exponent + drop);
    return x->negative ? -result : result;
}

double fma(double x, double y, double z)
{
    struct wide product, term;

    if (x - x != 0 || y - y != 0 || z - z != 0)
        return z - z != 0 && x - x == 0 && y - y == 0 ? z : x * y + z;
    if (x == 0 || y == 0 || z == 0) {
        if (x == 0 || y == 0)
            return x * y + z;
        product = multiply(x, y);
        return round_wide(&product);
    }
    product = multiply(x, y);
    term = widen(z);
    if (product.exponent > term.exponent ||
        (product.exponent == term.exponent &&
         (product.high > term.high || (product.high == term.high && product.low >= term.low)))) {
        add(&product, &term);
        return round_wide(&product);
    }
    add(&term, &product);
    return round_wide(&term);
}
