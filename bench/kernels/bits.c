/* CRC-32, population count, xorshift and 64-bit multiplication: integer operations, few branches. */
#include <stdio.h>

static unsigned table[256];
static unsigned char data[65536];

static unsigned crc(unsigned c, const unsigned char *p, int n)
{
    while (n--)
        c = table[(c ^ *p++) & 255] ^ c >> 8;
    return c;
}

static int count(unsigned v)
{
    v -= v >> 1 & 0x55555555;
    v = (v & 0x33333333) + (v >> 2 & 0x33333333);
    return ((v + (v >> 4) & 0x0F0F0F0F) * 0x01010101) >> 24;
}

int main(void)
{
    unsigned i, j, c, x = 2463534242u, ones = 0;
    unsigned long long mixed = 88172645463325252ull;

    for (i = 0; i < 256; i++) {
        for (c = i, j = 0; j < 8; j++)
            c = c & 1 ? 0xEDB88320u ^ c >> 1 : c >> 1;
        table[i] = c;
    }
    for (i = 0; i < sizeof data; i++)
        data[i] = i * i >> 3;
    for (c = i = 0; i < 120; i++)
        c = crc(c, data, sizeof data);
    for (i = 0; i < 4000000; i++) {
        x ^= x << 13;
        x ^= x >> 17;
        x ^= x << 5;
        ones += count(x);
        mixed = mixed * 6364136223846793005ull + x;
    }
    printf("bits %08x %u %llx\n", c, ones, mixed);
    return 0;
}
