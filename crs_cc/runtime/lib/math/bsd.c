/* BSD, System V and GNU names of functions that C has in another form. */
#include <math.h>

#include "kernel.h"

void sincos(double x, double *sine, double *cosine)
{
    *sine = sin(x);
    *cosine = cos(x);
}

void sincosf(float x, float *sine, float *cosine)
{
    *sine = (float)sin(x);
    *cosine = (float)cos(x);
}

/* x brought to 1 <= |x| < 2 by a power of two. */
static double fraction_of(double x)
{
    int exponent;

    return x == 0 || x - x != 0 ? x : 2 * frexp(x, &exponent);
}

double significand(double x)
{
    return fraction_of(x);
}

float significandf(float x)
{
    return (float)fraction_of(x);
}

/* x * 2^exponent for an exponent that is a whole number. */
double scalb(double x, double exponent)
{
    if (x != x || exponent != exponent)
        return x + exponent;
    if (exponent - exponent != 0)
        return exponent > 0 ? x * exponent : x == 0 ? x : x / -exponent;
    if (exponent != __builtin_rint(exponent))
        return __crs_domain_error();
    return __crs_ldexp(x, exponent > 5000 ? 5000 : exponent < -5000 ? -5000 : (int)exponent);
}

int finitef(float x)
{
    return x - x == 0;
}

int finitel(long double x)
{
    return x - x == 0;
}

int isnanf(float x)
{
    return x != x;
}

int isnanl(long double x)
{
    return x != x;
}

/* 1 for infinity, -1 for minus infinity. */
int isinff(float x)
{
    return x == INFINITY ? 1 : x == -INFINITY ? -1 : 0;
}

int isinfl(long double x)
{
    return x == INFINITY ? 1 : x == -INFINITY ? -1 : 0;
}
