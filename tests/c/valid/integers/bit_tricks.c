/* Bit arithmetic as old programs do it: counting, reversing, rotating, powers of two. */
#include <stdio.h>

static unsigned count(unsigned x)
{
    x = x - (x >> 1 & 0x55555555u);
    x = (x & 0x33333333u) + (x >> 2 & 0x33333333u);
    return ((x + (x >> 4) & 0x0f0f0f0fu) * 0x01010101u) >> 24;
}

static unsigned reverse(unsigned x)
{
    unsigned out = 0;
    for (int i = 0; i < 32; i++, x >>= 1)
        out = out << 1 | (x & 1);
    return out;
}

static unsigned rotate(unsigned x, int by) { return x << (by & 31) | x >> (-by & 31); }
static int is_power(unsigned x) { return x && !(x & x - 1); }
static int lowest(int x) { return x & -x; }

static unsigned swap(unsigned x)
{
    return x >> 24 | (x >> 8 & 0xff00) | (x << 8 & 0xff0000) | x << 24;
}

int main(void)
{
    static const unsigned tests[] = { 0, 1, 0x80000000u, 0xffffffffu, 0x12345678, 0x00f0 };

    for (unsigned i = 0; i < sizeof tests / sizeof *tests; i++) {
        unsigned x = tests[i];
        printf("%08x %2u %08x %08x %d %08x %08x\n", x, count(x), reverse(x), rotate(x, 5),
               is_power(x), (unsigned) lowest((int) x), swap(x));
    }
    int a = 5, b = 9;
    a ^= b;
    b ^= a;
    a ^= b;
    printf("%d %d %d\n", a, b, (a & b) + (a | b) == a + b);
    return 0;
}
