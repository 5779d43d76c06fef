/* Classification (C17 7.12.3), after the macros of math.h. */
#include <math.h>

#include "kernel.h"

int __crs_classify(double x)
{
    double magnitude = __builtin_fabs(x);

    if (x != x)
        return FP_NAN;
    if (magnitude == INFINITY)
        return FP_INFINITE;
    return x == 0 ? FP_ZERO : magnitude < 0x1p-1022 ? FP_SUBNORMAL : FP_NORMAL;
}

int __crs_classifyf(float x)
{
    int kind = __crs_classify(x);

    return kind == FP_NORMAL && __builtin_fabsf(x) < 0x1p-126F ? FP_SUBNORMAL : kind;
}

int __crs_is_nan(double x)
{
    return x != x;
}

/* As on Linux the result has the sign of x. */
int __crs_is_infinite(double x)
{
    return x == INFINITY ? 1 : x == -INFINITY ? -1 : 0;
}

int __crs_is_finite(double x)
{
    return x - x == 0;
}

int __crs_sign_bit(double x)
{
    union __crs_bits number;

    number.value = x;
    return number.bits >> 63;
}

int __crs_is_unordered(double x, double y)
{
    return x != x || y != y;
}
