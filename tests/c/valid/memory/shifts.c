/* Every count that C allows, in every width. */
#include <stdio.h>

int main(void)
{
    unsigned u = 0, i;
    int s = -1;
    unsigned long long w = 0;
    unsigned char c = 1;

    for (i = 0; i < 32; i++)
        u ^= 1u << i | 0x80000000u >> i;
    for (i = 0; i < 64; i++)
        w ^= 1ull << i | i >> (i & 31);
    for (i = 0; i < 32; i++)
        s ^= s >> i;
    c <<= 7;
    c >>= 3;
    printf("%u %llu %d %d\n", u, w, s, c);
    return 0;
}
