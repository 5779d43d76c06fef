/* The longest possible sequence of characters is a token (C17 6.4p4). */
#include <stdio.h>

#define PLUS +
#define F(x) x
#define N 10

int main(void)
{
    int a = 5, b = 3, c;

    c = a+++b;
    printf("%d %d %d\n", a, b, c);
    c = a---b;
    printf("%d %d %d\n", a, b, c);
    c = a- -b;
    printf("%d\n", c);
    c = a+ +b - -1;
    printf("%d\n", c);
    c = +PLUS a;
    printf("%d %d\n", c, a);
    c = -F(-a);
    printf("%d\n", c);
    printf("%d %d\n", a<b?a:b, a>>1>b);
    printf("%d\n", N-1-F(-1));
    printf("%d %d\n", a&&b, a&b);
    printf("%g %g\n", 1.e1, .5+.5);
    printf("%d\n", 0x1f+1);
    return 0;
}
