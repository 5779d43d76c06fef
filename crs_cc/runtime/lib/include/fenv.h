/* C17 7.6: the floating-point environment. Rounding is to nearest, always: fesetround fails
   for other directions. Arithmetic raises no flags; they are what a program itself raises and
   clears. */
#ifndef _FENV_H
#define _FENV_H

#define FE_INVALID 1
#define FE_DIVBYZERO 4
#define FE_OVERFLOW 8
#define FE_UNDERFLOW 16
#define FE_INEXACT 32
#define FE_ALL_EXCEPT 61
#define FE_TONEAREST 0
#define FE_DOWNWARD 0x400
#define FE_UPWARD 0x800
#define FE_TOWARDZERO 0xc00

typedef unsigned int fexcept_t;
typedef struct { fexcept_t flags; } fenv_t;

#define FE_DFL_ENV ((const fenv_t *)0)

int feclearexcept(int flags);
int fegetexceptflag(fexcept_t *flags, int which);
int feraiseexcept(int flags);
int fesetexceptflag(const fexcept_t *flags, int which);
int fetestexcept(int flags);
int fegetround(void);
int fesetround(int mode);
int fegetenv(fenv_t *environment);
int feholdexcept(fenv_t *environment);
int fesetenv(const fenv_t *environment);
int feupdateenv(const fenv_t *environment);

#endif
