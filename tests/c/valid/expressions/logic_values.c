/* Relational, equality and logical operators give the int 0 or 1. */
#include <stdio.h>

int main(void)
{
    int a = 5, b = 7, t;
    unsigned big = 3000000000u;
    double d = 1e20;
    char *s = "abc", *end = s + 3;
    int counts[2] = { 0, 0 };

    printf("%d%d%d%d%d%d\n", a < b, a <= b, a > b, a >= b, a == b, a != b);
    printf("%d %d\n", (a < b) + (b > a) + !0, (a < b) * 10);
    printf("%d %d\n", big > 5, d > big);
    printf("%d %d %d\n", s < end, s == end - 3, end > s);
    for (t = -3; t < 6; t++)
        counts[t > 0]++;
    printf("%d %d\n", counts[0], counts[1]);
    t = a < b;
    t = t == !(a > b);
    printf("%d\n", t);
    printf("%d %d %d\n", !5, !!5, !0.0);
    printf("%d\n", -(a < b));
    printf("%d\n", (a < b) << 3 | (a > b) << 2 | (a != b));
    printf("%u\n", (unsigned) sizeof(1.0 < 2.0));
    printf("%d\n", a < b < 2);
    printf("%d\n", (a & 1) == 1 && (b & 2) != 0);
    return 0;
}
