/* C17 7.25: type-generic mathematics, for real types. */
#ifndef _TGMATH_H
#define _TGMATH_H

#include <math.h>

/* The function for float if all arguments are, for long double if one is, else for double: the sum
   of the arguments has the type that decides (C17 7.25p3), and integers count as double. */
#define __CRS_GENERIC(name, kind) \
    _Generic((kind), float: name##f, long double: name##l, default: name)
#define __CRS_KIND(x) _Generic((x), float: 1.0F, long double: 1.0L, default: 1.0)

#define acos(x) __CRS_GENERIC(acos, __CRS_KIND(x))(x)
#define asin(x) __CRS_GENERIC(asin, __CRS_KIND(x))(x)
#define atan(x) __CRS_GENERIC(atan, __CRS_KIND(x))(x)
#define acosh(x) __CRS_GENERIC(acosh, __CRS_KIND(x))(x)
#define asinh(x) __CRS_GENERIC(asinh, __CRS_KIND(x))(x)
#define atanh(x) __CRS_GENERIC(atanh, __CRS_KIND(x))(x)
#define cos(x) __CRS_GENERIC(cos, __CRS_KIND(x))(x)
#define sin(x) __CRS_GENERIC(sin, __CRS_KIND(x))(x)
#define tan(x) __CRS_GENERIC(tan, __CRS_KIND(x))(x)
#define cosh(x) __CRS_GENERIC(cosh, __CRS_KIND(x))(x)
#define sinh(x) __CRS_GENERIC(sinh, __CRS_KIND(x))(x)
#define tanh(x) __CRS_GENERIC(tanh, __CRS_KIND(x))(x)
#define exp(x) __CRS_GENERIC(exp, __CRS_KIND(x))(x)
#define log(x) __CRS_GENERIC(log, __CRS_KIND(x))(x)
#define sqrt(x) __CRS_GENERIC(sqrt, __CRS_KIND(x))(x)
#define fabs(x) __CRS_GENERIC(fabs, __CRS_KIND(x))(x)
#define cbrt(x) __CRS_GENERIC(cbrt, __CRS_KIND(x))(x)
#define ceil(x) __CRS_GENERIC(ceil, __CRS_KIND(x))(x)
#define erf(x) __CRS_GENERIC(erf, __CRS_KIND(x))(x)
#define erfc(x) __CRS_GENERIC(erfc, __CRS_KIND(x))(x)
#define exp2(x) __CRS_GENERIC(exp2, __CRS_KIND(x))(x)
#define expm1(x) __CRS_GENERIC(expm1, __CRS_KIND(x))(x)
#define floor(x) __CRS_GENERIC(floor, __CRS_KIND(x))(x)
#define ilogb(x) __CRS_GENERIC(ilogb, __CRS_KIND(x))(x)
#define lgamma(x) __CRS_GENERIC(lgamma, __CRS_KIND(x))(x)
#define llrint(x) __CRS_GENERIC(llrint, __CRS_KIND(x))(x)
#define llround(x) __CRS_GENERIC(llround, __CRS_KIND(x))(x)
#define log10(x) __CRS_GENERIC(log10, __CRS_KIND(x))(x)
#define log1p(x) __CRS_GENERIC(log1p, __CRS_KIND(x))(x)
#define log2(x) __CRS_GENERIC(log2, __CRS_KIND(x))(x)
#define logb(x) __CRS_GENERIC(logb, __CRS_KIND(x))(x)
#define lrint(x) __CRS_GENERIC(lrint, __CRS_KIND(x))(x)
#define lround(x) __CRS_GENERIC(lround, __CRS_KIND(x))(x)
#define nearbyint(x) __CRS_GENERIC(nearbyint, __CRS_KIND(x))(x)
#define rint(x) __CRS_GENERIC(rint, __CRS_KIND(x))(x)
#define round(x) __CRS_GENERIC(round, __CRS_KIND(x))(x)
#define tgamma(x) __CRS_GENERIC(tgamma, __CRS_KIND(x))(x)
#define trunc(x) __CRS_GENERIC(trunc, __CRS_KIND(x))(x)

#define pow(x, y) __CRS_GENERIC(pow, __CRS_KIND(x) + __CRS_KIND(y))(x, y)
#define atan2(x, y) __CRS_GENERIC(atan2, __CRS_KIND(x) + __CRS_KIND(y))(x, y)
#define copysign(x, y) __CRS_GENERIC(copysign, __CRS_KIND(x) + __CRS_KIND(y))(x, y)
#define fdim(x, y) __CRS_GENERIC(fdim, __CRS_KIND(x) + __CRS_KIND(y))(x, y)
#define fmax(x, y) __CRS_GENERIC(fmax, __CRS_KIND(x) + __CRS_KIND(y))(x, y)
#define fmin(x, y) __CRS_GENERIC(fmin, __CRS_KIND(x) + __CRS_KIND(y))(x, y)
#define fmod(x, y) __CRS_GENERIC(fmod, __CRS_KIND(x) + __CRS_KIND(y))(x, y)
#define hypot(x, y) __CRS_GENERIC(hypot, __CRS_KIND(x) + __CRS_KIND(y))(x, y)
#define nextafter(x, y) __CRS_GENERIC(nextafter, __CRS_KIND(x) + __CRS_KIND(y))(x, y)
#define remainder(x, y) __CRS_GENERIC(remainder, __CRS_KIND(x) + __CRS_KIND(y))(x, y)
#define nexttoward(x, y) __CRS_GENERIC(nexttoward, __CRS_KIND(x))(x, y)
#define fma(x, y, z) \
    __CRS_GENERIC(fma, __CRS_KIND(x) + __CRS_KIND(y) + __CRS_KIND(z))(x, y, z)
#define remquo(x, y, quotient) \
    __CRS_GENERIC(remquo, __CRS_KIND(x) + __CRS_KIND(y))(x, y, quotient)
#define frexp(x, exponent) __CRS_GENERIC(frexp, __CRS_KIND(x))(x, exponent)
#define ldexp(x, exponent) __CRS_GENERIC(ldexp, __CRS_KIND(x))(x, exponent)
#define scalbn(x, exponent) __CRS_GENERIC(scalbn, __CRS_KIND(x))(x, exponent)
#define scalbln(x, exponent) __CRS_GENERIC(scalbln, __CRS_KIND(x))(x, exponent)

#endif
