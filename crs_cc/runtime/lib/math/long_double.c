/* The functions for long double, which is double (C17 7.12). */
#include <math.h>

#define ONE(type, name)          \
    type name##l(long double x)  \
    {                            \
        return name(x);          \
    }
#define TWO(name)                                      \
    long double name##l(long double x, long double y)  \
    {                                                  \
        return name(x, y);                             \
    }
#define WITH(kind, name)                       \
    long double name##l(long double x, kind y)  \
    {                                           \
        return name(x, y);                      \
    }

ONE(long double, acos)
ONE(long double, asin)
ONE(long double, atan)
ONE(long double, cos)
ONE(long double, sin)
ONE(long double, tan)
ONE(long double, acosh)
ONE(long double, asinh)
ONE(long double, atanh)
ONE(long double, cosh)
ONE(long double, sinh)
ONE(long double, tanh)
ONE(long double, exp)
ONE(long double, exp2)
ONE(long double, expm1)
ONE(long double, log)
ONE(long double, log10)
ONE(long double, log1p)
ONE(long double, log2)
ONE(long double, logb)
ONE(long double, cbrt)
ONE(long double, fabs)
ONE(long double, sqrt)
ONE(long double, erf)
ONE(long double, erfc)
ONE(long double, lgamma)
ONE(long double, tgamma)
ONE(long double, ceil)
ONE(long double, floor)
ONE(long double, nearbyint)
ONE(long double, rint)
ONE(long double, round)
ONE(long double, trunc)
ONE(int, ilogb)
ONE(long, lrint)
ONE(long, lround)
ONE(long long, llrint)
ONE(long long, llround)

TWO(atan2)
TWO(pow)
TWO(hypot)
TWO(fmod)
TWO(remainder)
TWO(copysign)
TWO(nextafter)
TWO(fdim)
TWO(fmax)
TWO(fmin)
TWO(nexttoward)

WITH(int *, frexp)
WITH(int, ldexp)
WITH(int, scalbn)
WITH(long, scalbln)

long double modfl(long double x, long double *whole)
{
    double part, rest = modf(x, &part);

    *whole = part;
    return rest;
}

long double fmal(long double x, long double y, long double z)
{
    return fma(x, y, z);
}

long double remquol(long double x, long double y, int *quotient)
{
    return remquo(x, y, quotient);
}

long double nanl(const char *text)
{
    return nan(text);
}
