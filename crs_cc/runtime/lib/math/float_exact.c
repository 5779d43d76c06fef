/* The exact functions for float (C17 7.12), and nextafterf, which steps by units of float. */
#include <errno.h>
#include <math.h>

float fabsf(float x)
{
    return __builtin_fabsf(x);
}

float floorf(float x)
{
    return __builtin_floorf(x);
}

float ceilf(float x)
{
    return __builtin_ceilf(x);
}

float truncf(float x)
{
    return __builtin_truncf(x);
}

float rintf(float x)
{
    return __builtin_rintf(x);
}

float nearbyintf(float x)
{
    return __builtin_rintf(x);
}

float sqrtf(float x)
{
    if (x < 0)
        errno = EDOM;
    return __builtin_sqrtf(x);
}

float copysignf(float x, float y)
{
    return __builtin_copysignf(x, y);
}

float roundf(float x)
{
    return (float)round(x);
}

float logbf(float x)
{
    return (float)logb(x);
}

float fmodf(float x, float y)
{
    return (float)fmod(x, y);
}

float remainderf(float x, float y)
{
    return (float)remainder(x, y);
}

float fmaxf(float x, float y)
{
    return (float)fmax(x, y);
}

float fminf(float x, float y)
{
    return (float)fmin(x, y);
}

float fdimf(float x, float y)
{
    if (x != x || y != y)
        return x + y;
    return x > y ? x - y : 0;
}

/* The product is exact as a double; rounding the sum to odd makes the second rounding right. */
float fmaf(float x, float y, float z)
{
    union { double value; unsigned long long bits; } sum;
    double product = (double)x * y, part, error;

    sum.value = product + z;
    part = sum.value - product;
    error = (product - (sum.value - part)) + (z - part);
    if (error != 0 && error - error == 0 && !(sum.bits & 1))
        sum.bits += (error > 0) == (sum.value > 0) ? 1 : -1;
    return (float)sum.value;
}

float frexpf(float x, int *exponent)
{
    return (float)frexp(x, exponent);
}

float ldexpf(float x, int exponent)
{
    float result = (float)ldexp(x, exponent);

    if ((result == 0 && x != 0) || (__builtin_fabsf(result) == INFINITY && x - x == 0))
        errno = ERANGE;
    return result;
}

float scalbnf(float x, int exponent)
{
    float result = (float)scalbn(x, exponent);

    if ((result == 0 && x != 0) || (__builtin_fabsf(result) == INFINITY && x - x == 0))
        errno = ERANGE;
    return result;
}

float scalblnf(float x, long exponent)
{
    float result = (float)scalbln(x, exponent);

    if ((result == 0 && x != 0) || (__builtin_fabsf(result) == INFINITY && x - x == 0))
        errno = ERANGE;
    return result;
}

float modff(float x, float *whole)
{
    double part, rest = modf(x, &part);

    *whole = (float)part;
    return (float)rest;
}

float nanf(const char *text)
{
    (void)text;
    return NAN;
}

float remquof(float x, float y, int *quotient)
{
    return (float)remquo(x, y, quotient);
}

int ilogbf(float x)
{
    return ilogb(x);
}

long lrintf(float x)
{
    return lrint(x);
}

long lroundf(float x)
{
    return lround(x);
}

long long llrintf(float x)
{
    return llrint(x);
}

long long llroundf(float x)
{
    return llround(x);
}

static float next(float x, double y)
{
    union { float value; unsigned int bits; } number;

    if (x != x || y != y)
        return (float)(x + y);
    if (x == y)
        return (float)y;
    number.value = x;
    if (x == 0)
        number.bits = y > 0 ? 1 : 0x80000001u;
    else if ((x < y) == (x > 0))
        number.bits++;
    else
        number.bits--;
    if (number.value - number.value != 0 || __builtin_fabsf(number.value) < 0x1p-126F)
        errno = ERANGE;
    return number.value;
}

float nextafterf(float x, float y)
{
    return next(x, y);
}

float nexttowardf(float x, long double y)
{
    return next(x, y);
}
