/* tgmath.h selects by type; fenv.h, inttypes.h and complex comparisons of math.h. */
#include <fenv.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <tgmath.h>

int main(void)
{
    float f = 2.0F;
    double d = 2.0;
    imaxdiv_t divided = imaxdiv(-7, 2);
    int exponent;

    printf("%d %d %d\n", (int)sizeof sqrt(f), (int)sizeof sqrt(d), (int)sizeof sqrt(2));
    printf("%d %d %d\n", (int)sizeof pow(f, f), (int)sizeof pow(f, d), (int)sizeof atan2(f, 1));
    printf("%.9g %.17g %.17g\n", sqrt(f), sqrt(d), sin(1));
    printf("%.9g %.17g %.17g\n", pow(f, 0.5F), pow(2, 0.5F), fma(f, f, d));
    printf("%.9g", frexp(f * 5, &exponent));
    printf(" %d\n", exponent);
    printf("%ld %lld\n", lrint(2.5F), llround(-2.5));
    printf("%d %d %d\n", fegetround() == FE_TONEAREST, fesetround(FE_TONEAREST),
           feclearexcept(FE_ALL_EXCEPT));
    feraiseexcept(FE_OVERFLOW);
    printf("%d %d\n", fetestexcept(FE_OVERFLOW) != 0, fetestexcept(FE_INVALID) != 0);
    printf("%jd %jd %jd\n", divided.quot, divided.rem, imaxabs(-5));
    printf("%jd %ju\n", strtoimax("-9223372036854775809", NULL, 10),
           strtoumax("0xffffffffffffffff", NULL, 0));
    return 0;
}
