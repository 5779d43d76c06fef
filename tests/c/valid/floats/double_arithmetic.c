/* Double arithmetic rounds as IEEE 754 says, operation by operation. */
#include <stdio.h>

int main(void)
{
    double a = 0.1, b = 0.2, c = 3.0, tiny = 1e-300, huge = 1e300;
    double sum = 0;
    int i;

    printf("%.17g %.17g %.17g\n", a + b, a * b, a - b);
    printf("%.17g %.17g\n", a / c, 1 / c);
    printf("%d\n", a + b == 0.3);
    printf("%.17g %.17g\n", tiny * tiny, tiny / huge);
    printf("%g %g\n", huge * huge, -huge * huge);
    for (i = 1; i <= 1000; i++)
        sum += 1.0 / i;
    printf("%.17g\n", sum);
    sum = 0;
    for (i = 1000; i >= 1; i--)
        sum += 1.0 / i;
    printf("%.17g\n", sum);
    printf("%.17g\n", (a + 1e16) - 1e16);
    printf("%.17g\n", -a * -b);
    printf("%g %g\n", 0.0 * -1, -0.0 + 0.0);
    printf("%g\n", 1 / (0.0 * -1));
    a += 1;
    a /= 3;
    a -= b *= 2;
    printf("%.17g %.17g\n", a, b);
    return 0;
}
