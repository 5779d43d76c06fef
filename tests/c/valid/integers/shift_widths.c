/* A shift has the type of its promoted left operand; that of the right operand does not matter. */
#include <stdio.h>

int main(void)
{
    unsigned char b = 0x80;
    signed char n = -128;
    unsigned short h = 0x8000;
    long long by = 4;
    char one = 1;

    printf("%d %d\n", b << 1, b >> 7);
    printf("%d %d\n", n >> 3, n >> by);
    printf("%d %u\n", h << 15 >> 15 == 0x8000, (unsigned) h << 16);
    printf("%u %u\n", (unsigned) sizeof(b << by), (unsigned) sizeof(1ll << one));
    printf("%lld %lld\n", 1ll << 40, -1ll >> 40);
    printf("%llu %llx\n", 1ull << 63, 0xf0f0f0f0f0f0f0f0ull >> 36);
    b <<= 1;
    h >>= by;
    n >>= one;
    printf("%d %d %d\n", b, h, n);
    for (int i = 0; i < 64; i += 9)
        printf("%llx ", 0x123456789abcdefull >> i ^ 1ull << i);
    printf("\n%d\n", -8 >> 1);
    return 0;
}
