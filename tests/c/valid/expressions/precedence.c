/* Precedence and associativity of all operators. */
#include <stdio.h>

int main(void)
{
    int a = 6, b = 4, c = 3, d = 2, v[] = { 5, 6, 7 }, *p = v;

    printf("%d %d %d\n", a + b * c, (a + b) * c, a - b - c);
    printf("%d %d\n", a / b * c, a * b / c % d);
    printf("%d %d\n", a << 1 + 1, (a << 1) + 1);
    printf("%d %d %d\n", a & b == 4, (a & b) == 4, a & 4 | 1);
    printf("%d %d\n", a ^ b & c | d, (a ^ b) & (c | d));
    printf("%d %d\n", a > b > c, a > (b > c));
    printf("%d %d\n", a == b != c, !a == b);
    printf("%d %d\n", -a + b, -(a + b));
    printf("%d %d\n", ~a & 7, ~(a & 7));
    printf("%d\n", a || b && 0);
    printf("%d\n", a ? b : c ? d : 0);
    printf("%d\n", 0 ? b : 0 ? d : c);
    printf("%d %d\n", *p + 1, *(p + 1));
    printf("%d\n", *p++ + 1);
    printf("%d\n", sizeof(int) * 2 == sizeof(int) + 4);
    printf("%d\n", (char) a + b);
    printf("%d\n", !a + !0);
    a = b = c = 1;
    printf("%d\n", a += b -= c *= 5);
    printf("%d %d %d\n", a, b, c);
    printf("%d\n", a - -b);
    printf("%d\n", a-- - --b);
    printf("%d\n", 10 - 5 - 2 << 2 >> 1);
    return 0;
}
