/* Bit tricks: counting, reversing, rotating, isolating, fields in words. */
#include <stdio.h>

static int count(unsigned n)
{
    int c = 0;

    for (; n; n &= n - 1)
        c++;
    return c;
}

static unsigned reverse(unsigned n)
{
    n = (n >> 1 & 0x55555555) | (n & 0x55555555) << 1;
    n = (n >> 2 & 0x33333333) | (n & 0x33333333) << 2;
    n = (n >> 4 & 0x0F0F0F0F) | (n & 0x0F0F0F0F) << 4;
    n = (n >> 8 & 0x00FF00FF) | (n & 0x00FF00FF) << 8;
    return n >> 16 | n << 16;
}

static unsigned rotate(unsigned n, int by) { return n << by | n >> (32 - by); }

static int log2_(unsigned n)
{
    int r = -1;

    while (n)
        n >>= 1, r++;
    return r;
}

static unsigned get(unsigned word, int low, int width) { return word >> low & ((1u << width) - 1); }

static unsigned set(unsigned word, int low, int width, unsigned value)
{
    unsigned mask = ((1u << width) - 1) << low;

    return (word & ~mask) | (value << low & mask);
}

static unsigned morton(unsigned short x, unsigned short y)
{
    unsigned r = 0;
    int i;

    for (i = 0; i < 16; i++)
        r |= (x >> i & 1u) << 2 * i | (y >> i & 1u) << (2 * i + 1);
    return r;
}

int main(void)
{
    unsigned values[] = { 0, 1, 0x80000000, 0xFFFFFFFF, 0x12345678, 0xDEADBEEF };
    int i;

    for (i = 0; i < 6; i++) {
        unsigned v = values[i];
        printf("%d %08x %08x %d %x\n", count(v), reverse(v), rotate(v, 5), log2_(v), v & -v);
    }
    printf("%x %x\n", get(0xABCD1234, 8, 12), set(0xFFFFFFFF, 4, 8, 0x5A));
    printf("%x %x\n", morton(0xFFFF, 0), morton(0x1234, 0x00FF));
    printf("%d %d %d\n", 5 ^ 3, ~5, 6 & ~2);
    printf("%llx\n", 0xF0F0F0F0F0F0F0F0ull ^ 0xFFFFFFFF00000000ull);
    printf("%d\n", (10 & -10) == 2 && (12 & 11) == 8);
    return 0;
}
