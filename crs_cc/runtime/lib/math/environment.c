/* The floating-point environment (C17 7.6): flags that a program sets for itself. */
#include <fenv.h>

static fexcept_t raised;

int feclearexcept(int flags)
{
    raised &= ~flags;
    return 0;
}

int feraiseexcept(int flags)
{
    raised |= flags & FE_ALL_EXCEPT;
    return 0;
}

int fetestexcept(int flags)
{
    return raised & flags;
}

int fegetexceptflag(fexcept_t *flags, int which)
{
    *flags = raised & which;
    return 0;
}

int fesetexceptflag(const fexcept_t *flags, int which)
{
    raised = (raised & ~which) | (*flags & which & FE_ALL_EXCEPT);
    return 0;
}

int fegetround(void)
{
    return FE_TONEAREST;
}

int fesetround(int mode)
{
    return mode != FE_TONEAREST;
}

int fegetenv(fenv_t *environment)
{
    environment->flags = raised;
    return 0;
}

int feholdexcept(fenv_t *environment)
{
    environment->flags = raised;
    raised = 0;
    return 0;
}

int fesetenv(const fenv_t *environment)
{
    raised = environment == FE_DFL_ENV ? 0 : environment->flags;
    return 0;
}

int feupdateenv(const fenv_t *environment)
{
    raised |= environment == FE_DFL_ENV ? 0 : environment->flags;
    return 0;
}
