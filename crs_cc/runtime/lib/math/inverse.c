/* Inverse trigonometric functions (C17 7.12.4.1 to 7.12.4.4).
   Errors: atan, atan2 0.51, asin, acos 0.64 ulp.

   The angle of (x, y), 0 <= y <= x, is atan(c) + atan t with c = j/16 near y/x and
   t = (y - c x)/(x + c y), |t| <= 1/32: a table of atan(j/16) in two parts, t in two parts, and a
   polynomial. asin and acos are polynomials up to 1/2; beyond, asin x = pi/2 - 2 asin s with
   s = sqrt((1 - x)/2) in two parts (W. J. Cody, W. Waite, "Software Manual for the Elementary
   Functions", 1980). The polynomials were fitted at Chebyshev points. */
#include <errno.h>
#include <math.h>

#include "kernel.h"

#define HALF_PI_HI 0x1.921fb54442d18p+0
#define HALF_PI_LO 0x1.1a62633145c07p-54

static const struct __crs_pair table[17] = {
    {0x0.0p+0, 0x0.0p+0},
    {0x1.ff55bb72cfdeap-5, -0x1.c934d86d23f1dp-60},
    {0x1.fd5ba9aac2f6ep-4, -0x1.cd37686760c17p-59},
    {0x1.7b97b4bce5b02p-3, 0x1.347b0b4f881cap-58},
    {0x1.f5b75f92c80ddp-3, 0x1.8ab6e3cf7afbdp-57},
    {0x1.362773707ebccp-2, -0x1.963a544b672d8p-57},
    {0x1.6f61941e4def1p-2, -0x1.c63aae6f6e918p-56},
    {0x1.a64eec3cc23fdp-2, -0x1.24dec1b50b7ffp-56},
    {0x1.dac670561bb4fp-2, 0x1.a2b7f222f65e2p-56},
    {0x1.0657e94db30d0p-1, -0x1.d5b495f6349e6p-56},
    {0x1.1e00babdefeb4p-1, -0x1.928df287a668fp-58},
    {0x1.345f01cce37bbp-1, 0x1.1021137c71102p-55},
    {0x1.4978fa3269ee1p-1, 0x1.2419a87f2a458p-56},
    {0x1.5d58987169b18p-1, 0x1.0028e4bc5e7cap-57},
    {0x1.700a7c5784634p-1, -0x1.8c34d25aadef6p-56},
    {0x1.819d0b7158a4dp-1, -0x1.bf76229d3b917p-56},
    {0x1.921fb54442d18p-1, 0x1.1a62633145c07p-55},
};

/* The angle of (x, y) for 0 < y <= x with y/x > 2^-60, and 2^-900 < x < 2^900. */
static struct __crs_pair first_octant(double y, double x)
{
    struct __crs_pair angle;
    int j = (int)(y / x * 16 + 0.5);
    double c = j * 0.0625, top, top_low, bottom, bottom_low, product, error, t, t_low, z, p;

    TWO_PRODUCT(product, error, c, x);
    top = y - product;
    top_low = -error;
    TWO_PRODUCT(product, error, c, y);
    TWO_SUM(bottom, bottom_low, x, product);
    bottom_low += error;
    t = top / bottom;
    TWO_PRODUCT(product, error, t, bottom);
    t_low = ((top - product) - error + (top_low - t * bottom_low)) / bottom;
    z = t * t;
    p = -0x1.5555555555555p-2 + z * (0x1.999999999985dp-3 + z * (-0x1.249249223ff19p-3 + z * (
        0x1.c71c40f64f76bp-4 + z * -0x1.738b90b97ca14p-4)));
    FAST_TWO_SUM(angle.hi, angle.lo, table[j].hi, t);
    angle.lo += table[j].lo + (t_low + t * z * p);
    return angle;
}

/* Brings both coordinates into first_octant's range; their ratio must not be extreme. */
static struct __crs_pair scaled_octant(double y, double x)
{
    if (x > 0x1p800) {
        x *= 0x1p-300;
        y *= 0x1p-300;
    } else if (x < 0x1p-800) {
        x *= 0x1p400;
        y *= 0x1p400;
    }
    return first_octant(y, x);
}

double __crs_angle(double y, double x)
{
    double up = __builtin_fabs(y), right = __builtin_fabs(x), angle, low;
    struct __crs_pair part;

    if (up <= right * 0x1p-60) {
        angle = x > 0 ? up / right : 2 * HALF_PI_HI;
        if (angle == 0)
            errno = ERANGE;
        return __builtin_copysign(angle, y);
    }
    if (right <= up * 0x1p-60)
        return __builtin_copysign(HALF_PI_HI, y);
    if (up <= right) {
        part = scaled_octant(up, right);
        if (x > 0)
            return __builtin_copysign(part.hi + part.lo, y);
        FAST_TWO_SUM(angle, low, 2 * HALF_PI_HI, -part.hi);
        low += 2 * HALF_PI_LO - part.lo;
    } else {
        part = scaled_octant(right, up);
        if (x > 0) {
            part.hi = -part.hi;
            part.lo = -part.lo;
        }
        FAST_TWO_SUM(angle, low, HALF_PI_HI, part.hi);
        low += HALF_PI_LO + part.lo;
    }
    return __builtin_copysign(angle + low, y);
}

double atan(double x)
{
    if (x - x != 0)
        return x != x ? x : __builtin_copysign(HALF_PI_HI, x);
    return __builtin_fabs(x) < 0x1p-27 ? x : __crs_angle(x, 1);
}

/* Infinite coordinates count as equally large, zero ones keep their sign (C17 F.10.1.4). */
double atan2(double y, double x)
{
    if (x != x || y != y)
        return x + y;
    if (x - x != 0 || y - y != 0) {
        x = __builtin_copysign(x - x != 0 ? 1 : 0, x);
        y = __builtin_copysign(y - y != 0 ? 1 : 0, y);
    }
    if (y == 0)
        return __builtin_copysign(__builtin_copysign(1, x) > 0 ? 0 : 2 * HALF_PI_HI, y);
    return __crs_angle(y, x);
}

/* (asin s - s)/s for s^2 = z <= 1/4. */
static double arc_tail(double z)
{
    return z * (0x1.5555555555555p-3 + z * (0x1.3333333333389p-4 + z * (
        0x1.6db6db6dac0eap-5 + z * (0x1.f1c71c7a5e151p-6 + z * (0x1.6e8ba121b9d5fp-6 + z * (
        0x1.1c4efd20ebb99p-6 + z * (0x1.c990a42b32b03p-7 + z * (0x1.7b02ef007d23ep-7 + z * (
        0x1.3b462d121c5d2p-7 + z * (0x1.31777489dfd29p-7 + z * (0x1.8dcdf11997e0fp-9 + z * (
        0x1.40c91fa8deb7ep-6 + z * (-0x1.3bd7e353ddbc2p-6 + z * 0x1.e58a4f278e007p-6)))))))))))));
}

/* asin sqrt(z) for z <= 1/4, in two parts. */
static struct __crs_pair arc_of_root(double z)
{
    struct __crs_pair arc;
    double s = __builtin_sqrt(z), product, error;

    TWO_PRODUCT(product, error, s, s);
    arc.hi = s;
    arc.lo = s * arc_tail(z);
    if (s > 0)
        arc.lo += ((z - product) - error) / (2 * s);
    return arc;
}

double asin(double x)
{
    double magnitude = __builtin_fabs(x), hi, lo;
    struct __crs_pair arc;

    if (magnitude <= 0.5)
        return magnitude < 0x1p-27 ? x : x + x * arc_tail(x * x);
    if (!(magnitude <= 1))
        return x != x ? x : __crs_domain_error();
    arc = arc_of_root((1 - magnitude) * 0.5);
    FAST_TWO_SUM(hi, lo, HALF_PI_HI, -2 * arc.hi);
    return __builtin_copysign(hi + (lo + HALF_PI_LO - 2 * arc.lo), x);
}

double acos(double x)
{
    double magnitude = __builtin_fabs(x), hi, lo;
    struct __crs_pair arc;

    if (magnitude <= 0.5) {
        FAST_TWO_SUM(hi, lo, HALF_PI_HI, -x);
        return hi + (lo + HALF_PI_LO - x * arc_tail(x * x));
    }
    if (!(magnitude <= 1))
        return x != x ? x : __crs_domain_error();
    arc = arc_of_root((1 - magnitude) * 0.5);
    if (x > 0)
        return 2 * arc.hi + 2 * arc.lo;
    FAST_TWO_SUM(hi, lo, 2 * HALF_PI_HI, -2 * arc.hi);
    return hi + (lo + 2 * HALF_PI_LO - 2 * arc.lo);
}
