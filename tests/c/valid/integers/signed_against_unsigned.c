/* Comparisons and divisions of signed and unsigned operands of all widths (C17 6.3.1.8). */
#include <stdio.h>

int main(void)
{
    signed char c = -1;
    unsigned char uc = 255;
    short s = -1;
    unsigned short us = 65535;
    int i = -1;
    unsigned u = 1;
    long long q = -1;
    unsigned long long uq = 1;

    printf("%d %d %d\n", c == uc, c < uc, s < us);
    printf("%d %d\n", i < u, (unsigned) i > u);
    printf("%d %d %d\n", q < u, q < uq, i < q);
    printf("%d %d\n", c > u, us > i);
    printf("%u %lld\n", i / u, q / u);
    printf("%u %d\n", -7 / 2u, -7 / 2);
    printf("%u %d %lld\n", -7 % 3u, -7 % 3, -7ll % 3u);
    printf("%d\n", -1 < (unsigned char) 1);
    printf("%d\n", -1 < (unsigned) 1);
    printf("%d\n", sizeof(int) > -1);
    printf("%d %d\n", (1 ? -1 : 1u) > 0, (short) -1 < 0u + (unsigned char) 0);
    printf("%llu\n", uq - 2);
    printf("%llu %llu\n", 0ull + i, 0ull + (unsigned) i);
    return 0;
}
