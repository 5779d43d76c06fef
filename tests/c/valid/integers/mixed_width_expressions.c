/* One expression with many widths: each step in the type C gives it. */
#include <stdio.h>

int main(void)
{
    unsigned char a = 0xF0;
    signed char b = -16;
    short c = -300;
    unsigned short d = 60000;
    int e = 70000;
    unsigned f = 3000000000u;
    long long g = -5000000000ll;
    unsigned long long h = 10000000000000000000ull;

    printf("%d\n", a + b + c + d);
    printf("%u\n", a + b * c - d + f);
    printf("%lld\n", g + e - f);
    printf("%llu\n", h + g + b);
    printf("%lld\n", (long long) (h / 3) % e + c);
    printf("%d\n", (a & b) == 0xF0);
    printf("%d\n", (unsigned char) b == a);
    printf("%d %d\n", (short) d, (short) e);
    printf("%u\n", (unsigned) g);
    printf("%d\n", (int) (h >> 33));
    printf("%lld\n", (long long) c * d * e);
    printf("%d\n", (signed char) (a >> 1) * (short) (d << 1));
    printf("%d\n", g < f ? c : a);
    printf("%llx\n", (unsigned long long) b);
    printf("%llx\n", (unsigned long long) (unsigned) b);
    printf("%llx\n", (unsigned long long) (unsigned char) b);
    return 0;
}
