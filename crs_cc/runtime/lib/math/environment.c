/* The floating-point environment (C17 7.6): flags that a program sets for itself. */
#include <fenv.h>

#include <crs/write.h>

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

/* Says once that a program that asks for the flags of its arithmetic learns nothing. */
int fetestexcept(int flags)
{
    static int said;

    if (raised == 0 && !said) {
        said = 1;
        __crs_complain("fetestexcept", "() finds no flags: arithmetic raises none here;"
                       " test results with isnan and isinf, and operands before\n");
    }
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
    static int said;

    if (mode != FE_TONEAREST && !said) {
        said = 1;
        __crs_complain("fesetround", "() fails: numbers are always rounded to nearest here;"
                       " nextafter() gives bounds of a result\n");
    }
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
