/* Complex numbers (C17 7.3). */
#ifndef _COMPLEX_H
#define _COMPLEX_H

#define complex _Complex
#define _Complex_I (__extension__ 1.0iF)
#undef I
#define I _Complex_I
#define CMPLX(real, imaginary) __builtin_complex((double)(real), (double)(imaginary))
#define CMPLXF(real, imaginary) __builtin_complex((float)(real), (float)(imaginary))
#define CMPLXL(real, imaginary) __builtin_complex((long double)(real), (long double)(imaginary))

#define __CRS_COMPLEX(name)                      \
    double _Complex name(double _Complex z);     \
    float _Complex name##f(float _Complex z);    \
    long double _Complex name##l(long double _Complex z);

__CRS_COMPLEX(cacos)
__CRS_COMPLEX(casin)
__CRS_COMPLEX(catan)
__CRS_COMPLEX(ccos)
__CRS_COMPLEX(csin)
__CRS_COMPLEX(ctan)
__CRS_COMPLEX(cacosh)
__CRS_COMPLEX(casinh)
__CRS_COMPLEX(catanh)
__CRS_COMPLEX(ccosh)
__CRS_COMPLEX(csinh)
__CRS_COMPLEX(ctanh)
__CRS_COMPLEX(cexp)
__CRS_COMPLEX(clog)
__CRS_COMPLEX(clog10)
__CRS_COMPLEX(csqrt)
__CRS_COMPLEX(conj)
__CRS_COMPLEX(cproj)
#undef __CRS_COMPLEX

double _Complex cpow(double _Complex base, double _Complex exponent);
float _Complex cpowf(float _Complex base, float _Complex exponent);
long double _Complex cpowl(long double _Complex base, long double _Complex exponent);

double cabs(double _Complex z);
float cabsf(float _Complex z);
long double cabsl(long double _Complex z);
double carg(double _Complex z);
float cargf(float _Complex z);
long double cargl(long double _Complex z);
double cimag(double _Complex z);
float cimagf(float _Complex z);
long double cimagl(long double _Complex z);
double creal(double _Complex z);
float crealf(float _Complex z);
long double creall(long double _Complex z);

#endif
