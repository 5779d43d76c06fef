/* Arguments and results are converted as if by assignment. */
#include <stdio.h>

static double half(double x) { return x / 2; }
static int truncated(double x) { return x; }
static float single(double x) { return x; }
static unsigned char low(int n) { return n; }
static long long wide(int n) { return n; }
static unsigned as_unsigned(short s) { return s; }
static char sign(float f) { return f < 0 ? -1 : f > 0; }

int main(void)
{
    char c = 7;
    float f = 2.75f;
    unsigned u = 4000000000u;
    double d;
    int i;

    printf("%g %g %g\n", half(c), half(f), half(u));
    printf("%d %d\n", truncated(9.99), truncated(f));
    printf("%.9g\n", single(0.1));
    printf("%d %d\n", low(511), low(-1));
    printf("%lld %lld\n", wide(u), wide(-1));
    printf("%u\n", as_unsigned(-1));
    printf("%d %d %d\n", sign(-3), sign(0), sign(1e-30));
    d = i = f;
    printf("%g %d\n", d, i);
    f = d = 1.0 / 3;
    printf("%.9g %.17g\n", f, d);
    c = i = 1000;
    printf("%d %d\n", c, i);
    return 0;
}
