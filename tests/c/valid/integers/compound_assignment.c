/* E1 op= E2 computes in the common type and evaluates E1 once (C17 6.5.16.2). */
#include <stdio.h>

static int evaluations;
static int cell[3] = { 7, 8, 9 };

static int *at(int i)
{
    evaluations++;
    return &cell[i];
}

int main(void)
{
    int i = 100;
    unsigned u = 7;
    short s = 1000;
    unsigned char c = 10;
    long long ll = 1;
    float f = 10;
    double d = 2.5;
    char *p = "abcdef";

    i += 5; i -= 3; i *= 2; i /= 3; i %= 40;
    printf("%d\n", i);
    i <<= 4; i >>= 1; i |= 3; i &= 0x7e; i ^= 0xff;
    printf("%d\n", i);
    u -= 10;
    printf("%u\n", u);
    s *= 100;
    printf("%d\n", s);
    c *= 2.6;
    printf("%d\n", c);
    c += 300;
    printf("%d\n", c);
    i = 7;
    i *= 1.5;
    printf("%d\n", i);
    i -= 0.5;
    printf("%d\n", i);
    ll <<= 40;
    ll |= 1;
    ll += -3;
    printf("%lld\n", ll);
    f /= 4;
    d *= f;
    printf("%g %g\n", f, d);
    p += 2;
    p -= 1;
    printf("%s\n", p);
    *at(1) += 10;
    *at(2) <<= 2;
    printf("%d %d %d\n", cell[1], cell[2], evaluations);
    i = 2;
    c = s = i = 12345;
    printf("%d %d %d\n", c, s, i);
    return 0;
}
