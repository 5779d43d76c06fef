/* Mixed operands are converted to the common type of C17 6.3.1.8. */
#include <stdio.h>

int main(void)
{
    int i = -1;
    unsigned u = 1;
    long l = -2;
    unsigned long ul = 3;
    long long ll = -4;
    unsigned long long ull = 5;
    unsigned char uc = 255;
    short s = -5;

    printf("%d %d %d\n", i < u, i > u, i == 4294967295u);
    printf("%u %u\n", i + u, i * u);
    printf("%u %u\n", u - 2, (u - 2) / 2);
    printf("%lu %d\n", l + ul, l < ul);
    printf("%lld %d\n", ll + u, ll < u);
    printf("%llu %d\n", ll + ull, ll < ull);
    printf("%lld %lld\n", i + ll, u + ll);
    printf("%d %d\n", s < uc, s + uc);
    printf("%d %u\n", s / 2, s / u);
    printf("%d %d\n", -7 / 2, -7 % 2);
    printf("%u %u\n", -7 / 2u, -7 % 2u);
    printf("%lld %llu\n", -7 / 2ll, -7 / 2ull);
    printf("%d\n", sizeof(i) > -1);
    printf("%d\n", (unsigned char) 255 == (signed char) -1);
    printf("%u %u %u %u\n", (unsigned) sizeof(i + u), (unsigned) sizeof(l + ll),
           (unsigned) sizeof(uc + s), (unsigned) sizeof(1 ? uc : ll));
    printf("%llu\n", 1 ? i : ull);
    printf("%u\n", 1 ? i : u);
    return 0;
}
