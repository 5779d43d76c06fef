/* Unsigned arithmetic is modulo 2 to the width (C17 6.2.5p9). */
#include <stdio.h>
#include <limits.h>

int main(void)
{
    unsigned u = UINT_MAX;
    unsigned char c = UCHAR_MAX;
    unsigned short s = USHRT_MAX;
    unsigned long l = ULONG_MAX;
    unsigned long long ll = ULLONG_MAX;

    printf("%u %u %u\n", u + 1, u + 2, u * u);
    printf("%u %u\n", 0u - 1, -1u / 2);
    c++;
    s += 2;
    l += 3;
    ll += 4;
    printf("%u %u %lu %llu\n", c, s, l, ll);
    c -= 1;
    s -= 2;
    printf("%u %u\n", c, s);
    printf("%u\n", 2654435761u * 40503u);
    printf("%llu\n", 6364136223846793005ull * 1442695040888963407ull);
    printf("%u %u\n", -u, ~u);
    printf("%lu\n", 65536ul * 65536ul);
    printf("%llu\n", 4294967296ull * 4294967295ull);
    u = 5;
    u -= 10;
    printf("%u %d\n", u, (int) u);
    return 0;
}
