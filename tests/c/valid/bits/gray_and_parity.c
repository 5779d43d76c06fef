/* Gray codes, parity, Hamming distance, a bit set, an LFSR. */
#include <stdio.h>

typedef unsigned char byte;

static byte gray(byte n) { return n ^ n >> 1; }

static byte ungray(byte g)
{
    g ^= g >> 4;
    g ^= g >> 2;
    g ^= g >> 1;
    return g;
}

static int parity(unsigned n)
{
    n ^= n >> 16;
    n ^= n >> 8;
    n ^= n >> 4;
    return 0x6996 >> (n & 15) & 1;
}

static unsigned set[4];
static void add(int n) { set[n / 32] |= 1u << n % 32; }
static void drop(int n) { set[n >> 5] &= ~(1u << (n & 31)); }
static int has(int n) { return set[n / 32] >> n % 32 & 1; }

int main(void)
{
    int i, ok = 1, period = 0;
    unsigned short lfsr = 0xACE1;

    for (i = 0; i < 16; i++)
        printf("%d ", gray(i));
    printf("\n");
    for (i = 0; i < 256; i++)
        ok &= ungray(gray(i)) == i;
    printf("%d\n", ok);
    printf("%d %d %d %d\n", parity(0), parity(1), parity(0xFF), parity(0x80000001 ^ 4));
    for (i = 2; i < 128; i++)
        add(i);
    for (i = 2; i < 128; i++)
        if (has(i)) {
            int j;
            for (j = 2 * i; j < 128; j += i)
                drop(j);
        }
    for (i = 0; i < 128; i++)
        if (has(i))
            printf("%d ", i);
    printf("\n");
    do {
        lfsr = lfsr >> 1 ^ (-(lfsr & 1) & 0xB400);
        period++;
    } while (lfsr != 0xACE1 && period < 2000);
    printf("%d %x\n", period, lfsr);
    return 0;
}
