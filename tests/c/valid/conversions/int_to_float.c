/* Integer to floating conversion rounds to nearest when it must. */
#include <stdio.h>

int main(void)
{
    int i = 16777217, n = -5;
    unsigned u = 4294967295u;
    long long ll = 9007199254740993ll;
    unsigned long long ull = 18446744073709551615ull;
    unsigned char c = 200;
    short s = -200;

    printf("%.9g %.17g\n", (float) i, (double) i);
    printf("%.9g %.17g\n", (float) u, (double) u);
    printf("%.9g %.17g\n", (float) ll, (double) ll);
    printf("%.9g %.17g\n", (float) ull, (double) ull);
    printf("%g %g\n", (double) c, (float) s);
    printf("%d %g\n", n / 2, n / 2.0);
    printf("%g\n", (double) (unsigned) n);
    printf("%.17g\n", (double) -9223372036854775807ll);
    printf("%g %g\n", 1.0 * n, n + 0.5f);
    printf("%.17g\n", 10 * 0.1 + n);
    printf("%g\n", (double) (n > 0 ? i : n));
    printf("%g\n", (double) 'A');
    return 0;
}
