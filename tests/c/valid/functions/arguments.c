/* Parameters are copies; many of them, of every type. */
#include <stdio.h>

static int many(int a, char b, short c, long d, unsigned char e, unsigned short f, unsigned g, int h,
                int i, int j)
{
    return a + b * 2 + c * 3 + (int) d * 4 + e * 5 + f * 6 + (int) g * 7 + h * 8 + i * 9 + j * 10;
}

static double mixed(int a, double b, float c, long long d, char e, double f)
{
    return a + b * 10 + c * 100 + d * 1000 + e * 10000 + f * 100000;
}

static int modify(int n, int *p)
{
    n = n * 2;
    (*p)++;
    return n + *p;
}

static long long pick(long long a, int b, long long c) { return b ? a : c; }
static int nothing(void) { return 42; }
static void no_result(int *p) { *p = 7; return; }

static int falls_through(int n)
{
    if (n > 3)
        return 1;
    n += 10;
    return n;
}

int main(void)
{
    int n = 5, m = 1;

    printf("%d\n", many(1, 2, 3, 4, 5, 6, 7, 8, 9, 10));
    printf("%d\n", many(-1, -2, -3, -4, 255, 65535, 1u << 20, -8, -9, -10));
    printf("%g\n", mixed(1, 2.5, 0.25f, -3, 'A', 1e-3));
    printf("%d ", modify(n, &m));
    printf("%d %d\n", n, m);
    printf("%lld %lld\n", pick(1ll << 40, 1, 2), pick(1, 0, -(1ll << 50)));
    printf("%d\n", nothing() + nothing());
    no_result(&n);
    printf("%d %d %d\n", n, falls_through(4), falls_through(2));
    printf("%d\n", modify(modify(1, &m), &m));
    return 0;
}
