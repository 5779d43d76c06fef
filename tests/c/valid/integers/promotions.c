/* Small integer types promote to int before arithmetic (C17 6.3.1.1). */
#include <stdio.h>

int main(void)
{
    unsigned char a = 200, b = 100;
    signed char c = -128;
    short s = 32767;
    unsigned short us = 65535;
    char ch = 'A';

    printf("%d %d %d\n", a + b, a * b, b - a);
    printf("%d %d %d\n", -c, c * c, c - 1);
    printf("%d %d\n", s + 1, s * 2);
    printf("%d %d %d\n", us + 1, us * 2, -us);
    printf("%d %d %d\n", ~a, ~us, ~c);
    printf("%d %d\n", +ch, ch + 1);
    printf("%u %u\n", (unsigned) sizeof(a + b), (unsigned) sizeof(s * s));
    printf("%d %d\n", (unsigned char) (a + b), (signed char) (a + b));
    printf("%d\n", (short) (s + 1));
    printf("%d\n", a << 4);
    printf("%d %d\n", a > c, us > c);
    printf("%d\n", (a + b) / 7 % 5);
    printf("%d %d\n", !a, !!a);
    a += 100;
    us++;
    c--;
    printf("%d %d %d\n", a, us, c);
    return 0;
}
