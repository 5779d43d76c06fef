/* Floating constants: suffixes, exponents, hexadecimal. */
#include <stdio.h>
#include <float.h>

int main(void)
{
    printf("%g %g %g %g\n", 1., .5, 1e3, 1.5e-3);
    printf("%g %g %g\n", 0x1p4, 0x1.8p1, 0x.8p-1);
    printf("%.9g %.17g\n", 0.1f, 0.1);
    printf("%u %u\n", (unsigned) sizeof 1.0f, (unsigned) sizeof 1.0);
    printf("%.17g\n", 3.14159265358979323846264338327950288);
    printf("%.17g %.17g\n", 9007199254740993.0, 9007199254740991.0);
    printf("%.17g\n", 123456789012345678901234567890.0);
    printf("%.17g\n", 4.9406564584124654e-324);
    printf("%d %d\n", DBL_DIG, FLT_DIG);
    printf("%g %g\n", DBL_MAX, DBL_MIN);
    printf("%g %g\n", FLT_MAX, FLT_MIN);
    printf("%g %g\n", DBL_EPSILON, FLT_EPSILON);
    printf("%d %d %d\n", DBL_MANT_DIG, FLT_MANT_DIG, FLT_RADIX);
    printf("%d\n", 1.0 + DBL_EPSILON > 1.0 && 1.0 + DBL_EPSILON / 2 == 1.0);
    return 0;
}
