/* Products and quotients of complex numbers (C17 G.5.1), called by the compiler. The quotient is
 * that of libgcc 12, which scales as in M. Baudin and R. Smith, "A robust complex division in
 * Scilab", 2012. */
#include <float.h>
#include <math.h>

#define BIG (DBL_MAX / 2)
#define SMALL DBL_MIN
#define RAISE (1 / DBL_EPSILON)
#define SMALL_ENOUGH (BIG * DBL_EPSILON)

double _Complex __muldc3(double a, double b, double c, double d);
double _Complex __divdc3(double a, double b, double c, double d);
float _Complex __mulsc3(float a, float b, float c, float d);
float _Complex __divsc3(float a, float b, float c, float d);

/* Returns 1 or 0 with the sign of a number, 1 if it is infinite. */
static double boxed(double x)
{
    return copysign(isinf(x) ? 1 : 0, x);
}

static double zero_for_nan(double x)
{
    return isnan(x) ? copysign(0, x) : x;
}

double _Complex __muldc3(double a, double b, double c, double d)
{
    double real = a * c - b * d, imaginary = a * d + b * c;
    int again = 0;

    if (!isnan(real) || !isnan(imaginary))
        return __builtin_complex(real, imaginary);
    if (isinf(a) || isinf(b)) {
        a = boxed(a), b = boxed(b), c = zero_for_nan(c), d = zero_for_nan(d);
        again = 1;
    }
    if (isinf(c) || isinf(d)) {
        c = boxed(c), d = boxed(d), a = zero_for_nan(a), b = zero_for_nan(b);
        again = 1;
    }
    if (!again && (isinf(a * c) || isinf(b * d) || isinf(a * d) || isinf(b * c))) {
        a = zero_for_nan(a), b = zero_for_nan(b), c = zero_for_nan(c), d = zero_for_nan(d);
        again = 1;
    }
    if (again)
        return __builtin_complex(INFINITY * (a * c - b * d), INFINITY * (a * d + b * c));
    return __builtin_complex(real, imaginary);
}

/* Divides (a + ib) by (c + id) where |c| >= |d|; `turn` is -1 if both were turned to that. */
static double _Complex divided(double a, double b, double c, double d)
{
    double ratio, whole;

    if (fabs(c) >= BIG)
        a /= 2, b /= 2, c /= 2, d /= 2;
    if (fabs(c) < SMALL ||
        (fabs(a) < SMALL && fabs(b) < SMALL_ENOUGH && fabs(c) < SMALL_ENOUGH) ||
        (fabs(b) < SMALL && fabs(a) < SMALL_ENOUGH && fabs(c) < SMALL_ENOUGH))
        a *= RAISE, b *= RAISE, c *= RAISE, d *= RAISE;
    ratio = d / c, whole = d * ratio + c;
    if (fabs(ratio) > SMALL)
        return __builtin_complex((b * ratio + a) / whole, (b - a * ratio) / whole);
    return __builtin_complex((a + d * (b / c)) / whole, (b - d * (a / c)) / whole);
}

double _Complex __divdc3(double a, double b, double c, double d)
{
    double _Complex result;

    if (fabs(c) < fabs(d)) { /* (a + ib) / (c + id) = (b - ia) / (d - ic) */
        result = divided(b, -a, d, -c);
    } else {
        result = divided(a, b, c, d);
    }
    if (!isnan(__real__ result) || !isnan(__imag__ result))
        return result;
    if (c == 0 && d == 0 && (!isnan(a) || !isnan(b)))
        return __builtin_complex(copysign(INFINITY, c) * a, copysign(INFINITY, c) * b);
    if ((isinf(a) || isinf(b)) && isfinite(c) && isfinite(d)) {
        a = boxed(a), b = boxed(b);
        return __builtin_complex(INFINITY * (a * c + b * d), INFINITY * (b * c - a * d));
    }
    if ((isinf(c) || isinf(d)) && isfinite(a) && isfinite(b)) {
        c = boxed(c), d = boxed(d);
        return __builtin_complex(0 * (a * c + b * d), 0 * (b * c - a * d));
    }
    return result;
}

float _Complex __mulsc3(float a, float b, float c, float d)
{
    float real = a * c - b * d, imaginary = a * d + b * c;

    if (isnan(real) && isnan(imaginary))
        return __muldc3(a, b, c, d);
    return __builtin_complex(real, imaginary);
}

/* In double nothing overflows. */
float _Complex __divsc3(float a, float b, float c, float d)
{
    double whole = (double)c * c + (double)d * d;
    float real = ((double)a * c + (double)b * d) / whole;
    float imaginary = ((double)b * c - (double)a * d) / whole;

    if (isnan(real) && isnan(imaginary))
        return __divdc3(a, b, c, d);
    return __builtin_complex(real, imaginary);
}
