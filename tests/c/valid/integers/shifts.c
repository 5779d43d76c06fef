/* Shifts of every width; the type is that of the promoted left operand (C17 6.5.7). */
#include <stdio.h>

int main(void)
{
    int n = -64;
    unsigned u = 0x80000001u;
    long long ll = -1234567890123ll;
    unsigned long long ull = 0x8000000000000001ull;
    unsigned char c = 0x81;
    signed char sc = -127;
    int i;

    for (i = 0; i < 8; i++)
        printf("%d ", n >> i);
    printf("\n");
    for (i = 0; i < 32; i += 5)
        printf("%x %x ", u << i, u >> i);
    printf("\n");
    for (i = 0; i < 64; i += 9)
        printf("%lld ", ll >> i);
    printf("\n");
    for (i = 0; i < 64; i += 9)
        printf("%llx %llx ", ull << i, ull >> i);
    printf("\n");
    printf("%d %d %d\n", c << 1, c >> 1, sc >> 1);
    printf("%x\n", (unsigned char) (c << 1));
    printf("%u\n", 1u << 31);
    printf("%llu %llu\n", 1ull << 63, 1ull << 32);
    u <<= 3;
    n >>= 2;
    ull >>= 60;
    c <<= 4;
    printf("%x %d %llx %x\n", u, n, ull, c);
    printf("%lld\n", 1ll << (char) 40);
    printf("%u\n", (unsigned) sizeof(c << 1ll));
    return 0;
}
