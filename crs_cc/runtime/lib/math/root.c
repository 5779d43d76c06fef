/* Roots (C17 7.12.7). Errors: sqrt 0.50, cbrt 0.51, hypot 0.51 ulp. */
#include <errno.h>
#include <math.h>

#include "kernel.h"

double sqrt(double x)
{
    if (x < 0)
        return __crs_domain_error();
    return __builtin_sqrt(x);
}

/* A first guess from a third of the exponent, Newton's steps, and a last one from the exact error
   x - y^3. */
double cbrt(double x)
{
    union __crs_bits number;
    double magnitude = __builtin_fabs(x), factor = 1, y, square, square_low, cube, cube_low, rest;
    int i;

    if (x == 0 || x - x != 0)
        return x;
    if (magnitude < 0x1p-900) {
        magnitude *= 0x1p300;
        factor = 0x1p-100;
    } else if (magnitude > 0x1p900) {
        magnitude *= 0x1p-300;
        factor = 0x1p100;
    }
    number.value = magnitude;
    number.bits = number.bits / 3 + 0x2a9f851eb0000000ULL;   /* 2/3 of the bias, less a little */
    y = number.value;
    for (i = 0; i < 4; i++)
        y = y - (y * y * y - magnitude) / (3 * y * y);
    TWO_PRODUCT(square, square_low, y, y);
    TWO_PRODUCT(cube, cube_low, square, y);
    cube_low += square_low * y;
    rest = (magnitude - cube) - cube_low;
    return __builtin_copysign((y + rest / (3 * square)) * factor, x);
}

/* Both squares and the root's error in two parts. */
double hypot(double x, double y)
{
    double a = __builtin_fabs(x), b = __builtin_fabs(y), factor = 1;
    double aa, aa_low, bb, bb_low, sum, sum_low, root, square, square_low;

    if (a == INFINITY || b == INFINITY)
        return INFINITY;
    if (a < b) {
        root = a;
        a = b;
        b = root;
    }
    if (x != x || y != y || b <= a * 0x1p-54)
        return a + b;
    if (a > 0x1p500) {
        factor = 0x1p600;
    } else if (a < 0x1p-450) {
        factor = 0x1p-600;
    }
    a = factor == 1 ? a : a / factor;
    b = factor == 1 ? b : b / factor;
    TWO_PRODUCT(aa, aa_low, a, a);
    TWO_PRODUCT(bb, bb_low, b, b);
    FAST_TWO_SUM(sum, sum_low, aa, bb);
    sum_low += aa_low + bb_low;
    root = __builtin_sqrt(sum);
    TWO_PRODUCT(square, square_low, root, root);
    root = (root + ((sum - square) - square_low + sum_low) / (2 * root)) * factor;
    if (root == INFINITY)
        errno = ERANGE;
    return root;
}
