/* %f %e %g with flags, widths and precisions; correctly rounded. */
#include <stdio.h>

int main(void)
{
    double values[] = { 0, 1, -1, 0.5, 1.5, 2.5, 0.1, 123456.789, 1e-5, 1e21, 3.14159265358979,
                        -0.000123456, 1e100, 5e-324, 1.7976931348623157e308, 999999.5, 0.045 };
    int i;

    for (i = 0; i < (int) (sizeof values / sizeof *values); i++)
        printf("%.3f|%.6e|%g|%.0f\n", values[i] > 1e30 ? 0 : values[i], values[i], values[i],
               values[i] > 1e30 ? 0 : values[i]);
    printf("[%10.3f] [%-10.3f] [%+.2f] [% .2f] [%010.3f]\n", 3.14159, 3.14159, 2.0, 2.0, -3.14159);
    printf("[%12.4e] [%-12.2E] [%+g] [%G]\n", 12345.678, 0.00012, 100000.0, 1e-10);
    printf("[%#.0f] [%#g] [%.10g] [%.15g] [%.17g]\n", 3.0, 1.0, 0.1, 0.1, 0.1);
    printf("[%*.*f] [%-*.*f]\n", 9, 2, 2.71828, 9, 3, 2.71828);
    printf("%f %f\n", 1.0 / 3, 2.0f / 3);
    printf("%.20f\n", 0.1);
    printf("%.1f %.1f %.1f %.1f\n", 0.25, 0.35, -0.05, 0.95);
    printf("%g %g %g %g\n", 100000.0, 1000000.0, 0.0001, 0.00001);
    printf("%e %e\n", 0.0, 9.9999999);
    printf("%f %e %g %F\n", 1e400, -1e400, 1e400, 1e400);
    return 0;
}
