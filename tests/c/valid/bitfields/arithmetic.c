/* Bit-fields in expressions: promotion, wraparound, assignment values, increments, signs. */
#include <stdio.h>

struct s {
    unsigned a : 3;
    signed b : 3;
    unsigned c : 31;
    unsigned d : 32;
    int e : 1;
    _Bool f : 1;
    unsigned char g : 5;
    unsigned short : 0;
    short h : 10;
};

int main(void)
{
    struct s s = { 7, -4, 1, 1, 0, 1, 31, -512 };
    int n;

    printf("%d %d %u %u\n", s.a, s.b, s.c, s.d);
    printf("%d %d %d %d\n", s.e, s.f, s.g, s.h);
    printf("%d %d\n", s.a - 8 < 0, s.c - 2 < 0);
    printf("%d\n", s.d - 2 < 0);
    printf("%d %d\n", ~s.a, -s.g);
    s.a++;
    s.b--;
    s.g += 3;
    s.h -= 1;
    printf("%d %d %d %d\n", s.a, s.b, s.g, s.h);
    n = s.a = 13;
    printf("%d %d\n", n, s.a);
    n = s.b = 6;
    printf("%d %d\n", n, s.b);
    printf("%d %d\n", s.a++, ++s.a);
    s.e = 1;
    s.f = 4;
    printf("%d %d %d\n", s.e, s.f, s.f + s.f);
    s.c = -1;
    s.d = -1;
    printf("%u %u %d\n", s.c, s.d, s.c + 1 < 0);
    s.a = 5;
    s.a <<= 1;
    s.a |= 1;
    s.b = s.a * 3;
    printf("%d %d\n", s.a, s.b);
    printf("%u\n", (unsigned) sizeof s);
    return 0;
}
