/* Remainders (C17 7.12.10), by long division of the significands: exact. */
#include <math.h>

#include "kernel.h"

/* A positive finite number as an integer of 53 bits times 2^exponent. */
struct integer {
    unsigned long long m;
    int exponent;
};

static struct integer take_apart(double x)
{
    union __crs_bits number;
    struct integer result;

    number.value = x;
    result.m = number.bits & FRACTION_BITS;
    result.exponent = EXPONENT_OF(number.bits);
    if (result.exponent == 0)
        result.exponent = 1;
    else
        result.m |= 1ULL << 52;
    while (result.m >> 52 == 0) {
        result.m <<= 1;
        result.exponent--;
    }
    return result;
}

/* The remainder of the truncated quotient of positive finite numbers; *quotient receives the lowest
   bits of the quotient, 31 at least. */
static double divide(double x, double y, unsigned int *quotient)
{
    struct integer a, b;
    unsigned long long q;
    int step;

    *quotient = 0;
    if (x < y)
        return x;
    a = take_apart(x);
    b = take_apart(y);
    q = a.m / b.m;
    a.m %= b.m;
    while (a.exponent > b.exponent && a.m != 0) {
        step = a.exponent - b.exponent;
        step = step < 11 ? step : 11;
        a.m <<= step;
        a.exponent -= step;
        q = q << step | a.m / b.m;
        a.m %= b.m;
    }
    step = a.exponent - b.exponent;
    *quotient = step < 32 ? q << step : 0;
    return a.m == 0 ? 0 : __crs_ldexp((double)a.m, b.exponent - 1075);
}

/* Deals with arguments that have no remainder, and with an infinite y; returns 1 when it did. */
static int is_special(double x, double y, double *result)
{
    if (x != x || y != y)
        *result = x + y;
    else if (x - x != 0 || y == 0)
        *result = __crs_domain_error();
    else if (y - y != 0)
        *result = x;
    else
        return 0;
    return 1;
}

double fmod(double x, double y)
{
    unsigned int quotient;
    double result;

    if (is_special(x, y, &result))
        return result;
    return __builtin_copysign(divide(__builtin_fabs(x), __builtin_fabs(y), &quotient), x);
}

/* The remainder of the nearest quotient, of two the even one (IEEE 754 5.3.1). */
static double nearest(double x, double y, unsigned int *quotient)
{
    double r, magnitude = __builtin_fabs(y), half = magnitude * 0.5;

    r = divide(__builtin_fabs(x), magnitude, quotient);
    if (magnitude < 0x1p-1021 ? r + r > magnitude || (r + r == magnitude && *quotient & 1)
                              : r > half || (r == half && *quotient & 1)) {
        r -= magnitude;
        ++*quotient;
    }
    return __builtin_copysign(1, x) < 0 ? -r : r;
}

double remainder(double x, double y)
{
    unsigned int quotient;
    double result;

    return is_special(x, y, &result) ? result : nearest(x, y, &quotient);
}

double drem(double x, double y)
{
    unsigned int quotient;
    double result;

    return is_special(x, y, &result) ? result : nearest(x, y, &quotient);
}

/* Of the quotient its sign and 31 bits. */
double remquo(double x, double y, int *quotient)
{
    unsigned int bits = 0;
    double result;

    if (!is_special(x, y, &result))
        result = nearest(x, y, &bits);
    bits &= 0x7fffffff;
    *quotient = (__builtin_copysign(1, x) < 0) != (__builtin_copysign(1, y) < 0) ? -(int)bits
                                                                              : (int)bits;
    return result;
}
