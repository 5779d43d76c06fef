/* Complex functions (C17 7.3), by the formulas of W. Kahan, "Branch cuts for complex elementary
 * functions", 1987, where they need care near the cuts. */
#include <complex.h>
#include <math.h>

#define FROM_DOUBLE(name)                             \
    float _Complex name##f(float _Complex z)          \
    {                                                 \
        return name(z);                               \
    }                                                 \
    long double _Complex name##l(long double _Complex z) \
    {                                                 \
        return name(z);                               \
    }

double _Complex clog(double _Complex z)
{
    double x = __real__ z, y = __imag__ z, size = hypot(x, y), real = log(size);

    if (size > 0.5 && size < 2) { /* where log(size) loses its figures */
        double a = fmax(fabs(x), fabs(y)), b = fmin(fabs(x), fabs(y));
        real = 0.5 * log1p((a - 1) * (a + 1) + b * b);
    }
    return CMPLX(real, atan2(y, x));
}

double _Complex clog10(double _Complex z)
{
    double _Complex natural = clog(z);

    return CMPLX(__real__ natural / M_LN10, __imag__ natural / M_LN10);
}

double _Complex cexp(double _Complex z)
{
    double x = __real__ z, y = __imag__ z, size = exp(x);

    if (y == 0)
        return CMPLX(size, y);
    return CMPLX(size * cos(y), size * sin(y));
}

double _Complex csqrt(double _Complex z)
{
    double x = __real__ z, y = __imag__ z, part, scale = 1;

    if (x == 0 && y == 0)
        return CMPLX(0, y);
    if (isinf(y))
        return CMPLX(INFINITY, y);
    if (fabs(x) > 0x1p1020 || fabs(y) > 0x1p1020) {
        x /= 16, y /= 16, scale = 4;
    } else if (fabs(x) < 0x1p-1000 && fabs(y) < 0x1p-1000) {
        x *= 0x1p106, y *= 0x1p106, scale = 0x1p-53;
    }
    part = sqrt((fabs(x) + hypot(x, y)) / 2);
    if (x >= 0)
        return CMPLX(part * scale, y / (2 * part) * scale);
    return CMPLX(fabs(y) / (2 * part) * scale, copysign(part, y) * scale);
}

double _Complex csinh(double _Complex z)
{
    double x = __real__ z, y = __imag__ z;

    if (y == 0)
        return CMPLX(sinh(x), y);
    return CMPLX(sinh(x) * cos(y), cosh(x) * sin(y));
}

double _Complex ccosh(double _Complex z)
{
    double x = __real__ z, y = __imag__ z;

    if (y == 0)
        return CMPLX(cosh(x), x < 0 ? -y : y);
    return CMPLX(cosh(x) * cos(y), sinh(x) * sin(y));
}

double _Complex ctanh(double _Complex z)
{
    double x = __real__ z, y = __imag__ z, slope, wide, sine;

    if (fabs(x) > 22)
        return CMPLX(copysign(1, x), 4 * sin(y) * cos(y) * exp(-2 * fabs(x)));
    slope = tan(y), wide = 1 + slope * slope, sine = sinh(x);
    return CMPLX(wide * sqrt(1 + sine * sine) * sine / (1 + wide * sine * sine),
                 slope / (1 + wide * sine * sine));
}

double _Complex casin(double _Complex z)
{
    double _Complex below = csqrt(CMPLX(1 - __real__ z, -__imag__ z));
    double _Complex above = csqrt(CMPLX(1 + __real__ z, __imag__ z));

    return CMPLX(atan2(__real__ z, __real__(below * above)), asinh(__imag__(~below * above)));
}

double _Complex cacos(double _Complex z)
{
    double _Complex below = csqrt(CMPLX(1 - __real__ z, -__imag__ z));
    double _Complex above = csqrt(CMPLX(1 + __real__ z, __imag__ z));

    return CMPLX(2 * atan2(__real__ below, __real__ above), asinh(__imag__(~above * below)));
}

double _Complex cacosh(double _Complex z)
{
    double _Complex below = csqrt(CMPLX(__real__ z - 1, __imag__ z));
    double _Complex above = csqrt(CMPLX(__real__ z + 1, __imag__ z));

    return CMPLX(asinh(__real__(~below * above)), 2 * atan2(__imag__ below, __real__ above));
}

double _Complex catanh(double _Complex z)
{
    double x = __real__ z, y = __imag__ z;

    return CMPLX(0.25 * log1p(4 * x / ((1 - x) * (1 - x) + y * y)),
                 0.5 * atan2(2 * y, (1 - x) * (1 + x) - y * y));
}

/* The circular functions are the hyperbolic ones on the axis turned by 90 degrees: f(z) is
 * -i g(iz), and cos(z) is cosh(iz). */
static double _Complex turned(double _Complex z)
{
    return CMPLX(-__imag__ z, __real__ z);
}

static double _Complex back(double _Complex z)
{
    return CMPLX(__imag__ z, -__real__ z);
}

double _Complex csin(double _Complex z)
{
    return back(csinh(turned(z)));
}

double _Complex ccos(double _Complex z)
{
    return ccosh(turned(z));
}

double _Complex ctan(double _Complex z)
{
    return back(ctanh(turned(z)));
}

double _Complex casinh(double _Complex z)
{
    return back(casin(turned(z)));
}

double _Complex catan(double _Complex z)
{
    return back(catanh(turned(z)));
}

double _Complex conj(double _Complex z)
{
    return ~z;
}

double _Complex cproj(double _Complex z)
{
    if (isinf(__real__ z) || isinf(__imag__ z))
        return CMPLX(INFINITY, copysign(0, __imag__ z));
    return z;
}

double _Complex cpow(double _Complex base, double _Complex exponent)
{
    return cexp(exponent * clog(base));
}

float _Complex cpowf(float _Complex base, float _Complex exponent)
{
    return cpow(base, exponent);
}

long double _Complex cpowl(long double _Complex base, long double _Complex exponent)
{
    return cpow(base, exponent);
}

FROM_DOUBLE(cacos)
FROM_DOUBLE(casin)
FROM_DOUBLE(catan)
FROM_DOUBLE(ccos)
FROM_DOUBLE(csin)
FROM_DOUBLE(ctan)
FROM_DOUBLE(cacosh)
FROM_DOUBLE(casinh)
FROM_DOUBLE(catanh)
FROM_DOUBLE(ccosh)
FROM_DOUBLE(csinh)
FROM_DOUBLE(ctanh)
FROM_DOUBLE(cexp)
FROM_DOUBLE(clog)
FROM_DOUBLE(clog10)
FROM_DOUBLE(csqrt)
FROM_DOUBLE(conj)
FROM_DOUBLE(cproj)

#define REAL(type, suffix)                              \
    type cabs##suffix(type _Complex z)                  \
    {                                                   \
        return hypot(__real__ z, __imag__ z);           \
    }                                                   \
    type carg##suffix(type _Complex z)                  \
    {                                                   \
        return atan2(__imag__ z, __real__ z);           \
    }                                                   \
    type cimag##suffix(type _Complex z)                 \
    {                                                   \
        return __imag__ z;                              \
    }                                                   \
    type creal##suffix(type _Complex z)                 \
    {                                                   \
        return __real__ z;                              \
    }

REAL(double, )
REAL(float, f)
REAL(long double, l)
