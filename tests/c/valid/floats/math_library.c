/* The common functions of math.h at a few points. */
#include <stdio.h>
#include <math.h>

int main(void)
{
    double x;
    int e;

    for (x = -2; x <= 2; x += 0.5)
        printf("%6.3f %9.6f %9.6f %9.6f %9.6f %9.6f\n", x, sin(x), cos(x), tan(x), atan(x), exp(x));
    for (x = 0.25; x < 20; x *= 2)
        printf("%6.3f %9.6f %9.6f %9.6f %9.6f\n", x, log(x), log10(x), sqrt(x), pow(x, 1.5));
    printf("%.6f %.6f %.6f %.6f\n", atan2(1, 1), atan2(1, -1), atan2(-1, -1), atan2(-1, 1));
    printf("%.6f %.6f %.6f\n", asin(0.5), acos(0.5), acos(-1));
    printf("%.6f %.6f %.6f\n", sinh(1), cosh(1), tanh(1));
    printf("%g %g %g %g\n", floor(-1.5), ceil(-1.5), floor(2.7), ceil(2.1));
    printf("%g %g %g\n", fabs(-3.25), fmod(7.5, 2), fmod(-7.5, 2));
    printf("%g %g\n", pow(2, 10), pow(2, -2));
    printf("%g %g\n", ldexp(0.75, 4), hypot(3, 4));
    x = frexp(48, &e);
    printf("%g %d\n", x, e);
    printf("%g ", modf(-3.75, &x));
    printf("%g\n", x);
    printf("%g %g\n", sqrt(2) * sqrt(2) - 2 < 1e-15 ? 0.0 : 1.0, M_PI > 3.14159 ? 1.0 : 0.0);
    return 0;
}
