/* Functions that round, split and join: exact by definition. */
#include <math.h>
#include <stdio.h>

int main(void)
{
    static const double tests[] = { 0.5, 1.5, 2.5, -0.5, -1.5, 0.49999999999999994, 1e15 + 0.5,
                                    -7.9, 3, 0.0, 4503599627370497.5 };
    int exponent;
    double whole, part;

    for (unsigned i = 0; i < sizeof tests / sizeof *tests; i++) {
        double x = tests[i];
        printf("%g: %g %g %g %g %g %ld\n", x, floor(x), ceil(x), trunc(x), round(x), rint(x),
               lround(x > 1e9 ? 0 : x));
    }
    part = modf(-3.75, &whole);
    printf("%g %g\n", part, whole);
    part = frexp(48, &exponent);
    printf("%g %d %g\n", part, exponent, ldexp(part, exponent + 1));
    printf("%g %g %g\n", fmod(7.5, 2), fmod(-7.5, 2), fmod(1e20, 3));
    printf("%g %g\n", copysign(3, -0.0), fabs(-2.5));
    printf("%g %g %g\n", remainder(7.5, 2), fdim(5, 3), fdim(3, 5));
    printf("%a %a\n", nextafter(1, 2), nextafter(0, -1));
    printf("%g %d\n", scalbn(1.5, 10), ilogb(1000));
    printf("%g %g\n", sqrt(2.25), logb(0.3));
    return 0;
}
