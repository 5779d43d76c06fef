/* Loop counters of every type, wrapping, downward, floating, pointers. */
#include <stdio.h>

int main(void)
{
    unsigned char c;
    unsigned u;
    long long ll;
    signed char s;
    double d;
    int v[5] = { 5, 4, 3, 2, 1 }, *p, n;

    for (n = 0, c = 250; c; c++)
        n++;
    printf("%d\n", n);
    for (n = 0, u = 5; u-- > 0;)
        n += u;
    printf("%d %u\n", n, u);
    for (n = 0, ll = 1; ll < 1ll << 40; ll <<= 3)
        n++;
    printf("%d %lld\n", n, ll);
    for (n = 0, s = 100; s > 0; s += 5)
        n++;
    printf("%d %d\n", n, s);
    for (n = 0, d = 0; d < 1; d += 0.1)
        n++;
    printf("%d\n", n);
    for (n = 0, p = v + 5; p-- != v;)
        n = n * 10 + *p;
    printf("%d\n", n);
    for (u = 1; u; u <<= 1)
        n ^= u;
    printf("%d\n", n);
    return 0;
}
