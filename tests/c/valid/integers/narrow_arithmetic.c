/* Arithmetic in char and short is done in int; only the store narrows. */
#include <stdio.h>

static signed char same(signed char c) { return c; }
static unsigned char low(int n) { return n; }

int main(void)
{
    unsigned char a = 200, b = 100;
    signed char c = 127, d = -128;
    short s = 32767;
    unsigned short t = 65535;

    printf("%d %d %d\n", a + b, (unsigned char) (a + b), a - b - a);
    printf("%d %d\n", a * b, ~a);
    printf("%d %d\n", -a, !a);
    c++;
    d--;
    s++;
    t++;
    printf("%d %d %d %d\n", c, d, s, t);
    a += b;
    b -= 101;
    printf("%d %d\n", a, b);
    a *= 2.6;
    b /= 2;
    b %= 100;
    printf("%d %d\n", a, b);
    printf("%d %d\n", same(300), low(-1));
    printf("%d\n", (a = 511) + (c = 257));
    printf("%d %d\n", (char) 0x1ff, (short) 0x18000);
    t = 65535;
    printf("%u %d\n", (unsigned) t * t, (t ^ -1) == -65536);
    return 0;
}
