/* float to double and back, to integers of all widths and back (C17 6.3.1.4, 6.3.1.5). */
#include <stdio.h>

static float narrow(double d) { return d; }
static double widen(float f) { return f; }
static long long whole(float f) { return f; }

int main(void)
{
    float f = 0.1, g = 16777216;
    double d = 0.1;
    unsigned char c = 255.9f;
    short s = -1.9;
    unsigned u = 4294967295.0;
    long long q = -9007199254740993;
    unsigned long long uq = 18446744073709551615u;

    printf("%a %a %d\n", f, d, f == d);
    printf("%a %a\n", narrow(1e-40), narrow(3.5e38));
    printf("%a %a\n", widen(0.1f), (double) (float) d - d);
    printf("%d %d %u\n", c, s, u);
    printf("%a %a\n", g + 1, (double) g + 1);
    printf("%a %a\n", (double) q, (float) q);
    printf("%a %a\n", (double) uq, (float) uq);
    printf("%a %a\n", (double) (1ull << 63), (float) 4294967295u);
    printf("%lld %lld\n", whole(-1e15f), (long long) 9.2e18);
    printf("%llu %u\n", (unsigned long long) 1.8e19, (unsigned) 3e9);
    printf("%d %d\n", (_Bool) 0.1, (_Bool) -0.0);
    printf("%d %d %d\n", (int) 2.999999, (int) -2.999999, (int) 1e-300);
    printf("%d\n", (char) 65.9 == 'A');
    f = 16777217;
    d = 16777217;
    printf("%d %d\n", f == d, f == (float) d);
    f = 1.0f / 3;
    printf("%a %a\n", f, f * 3.0);
    return 0;
}
