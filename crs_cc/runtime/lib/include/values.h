/* System V values.h: old names of limits. */
#ifndef _VALUES_H
#define _VALUES_H

#include <float.h>
#include <limits.h>

#define CHARBITS 8
#define BITSPERBYTE 8
#define SHORTBITS 16
#define INTBITS 32
#define LONGBITS 32
#define PTRBITS 32
#define FLOATBITS 32
#define DOUBLEBITS 64
#define BITS(type) (BITSPERBYTE * (int)sizeof(type))
#define MINSHORT SHRT_MIN
#define MAXSHORT SHRT_MAX
#define MININT INT_MIN
#define MAXINT INT_MAX
#define MINLONG LONG_MIN
#define MAXLONG LONG_MAX
#define MAXDOUBLE DBL_MAX
#define MINDOUBLE DBL_MIN
#ifndef MAXFLOAT
#define MAXFLOAT FLT_MAX
#endif
#define MINFLOAT FLT_MIN
#define DMINEXP DBL_MIN_EXP
#define DMAXEXP DBL_MAX_EXP
#define FMINEXP FLT_MIN_EXP
#define FMAXEXP FLT_MAX_EXP

#endif
