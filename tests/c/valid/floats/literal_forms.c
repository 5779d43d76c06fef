/* Every form of a floating constant (C17 6.4.4.2). */
#include <float.h>
#include <stdio.h>

int main(void)
{
    printf("%g %g %g %g\n", 1., .5, 1e3, 1E-2);
    printf("%g %g %g\n", 12.5e+1, 0e0, 00.25);
    printf("%a %a %a\n", 0x1p3, 0x.8p1, 0x1.8P-1);
    printf("%u %u %u\n", (unsigned) sizeof 1.f, (unsigned) sizeof 1., (unsigned) sizeof 1e0F);
    printf("%a %a\n", 0.1f, 0.1);
    printf("%a %a\n", 3.4028235e38f, 1.7976931348623157e308);
    printf("%a %a\n", 1e-45f, 4.9406564584124654e-324);
    printf("%a %a\n", 1e-46f, 1e-400);
    printf("%a\n", 123456789012345678901234567890.0);
    printf("%a\n", 0.30000000000000004);
    printf("%d %d %g\n", FLT_DIG, DBL_MANT_DIG, DBL_EPSILON);
    printf("%g %g %g\n", FLT_MAX, DBL_MIN, FLT_EPSILON);
    printf("%d\n", 0.1 + 0.2 == 0.3);
    printf("%d\n", 1e16 + 1 == 1e16);
    printf("%a\n", 2.2250738585072011e-308);
    printf("%a %a\n", 9007199254740993.0, 9007199254740992.5);
    return 0;
}
