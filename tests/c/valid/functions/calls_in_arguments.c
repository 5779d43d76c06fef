/* Calls nested in arguments, through tables, recursive in their own arguments. */
#include <stdio.h>

static int add(int a, int b) { return a + b; }
static int apply(int (*f)(int, int), int a, int b) { return f(a, b); }
static int ackermann(int m, int n)
{
    return m == 0 ? n + 1 : n == 0 ? ackermann(m - 1, 1) : ackermann(m - 1, ackermann(m, n - 1));
}
static double weighted(double a, int b, float c, long long d, char e, short f)
{
    return a + b * 2 + c * 3 + d * 4 + e * 5 + f * 6;
}
static int many(int a, int b, int c, int d, int e, int f, int g, int h, int i, int j)
{
    return a - b + c - d + e - f + g - h + i - j;
}
static int changes(int a) { a *= 2; a++; return a; }

int main(void)
{
    int x = 5;
    int (*table[])(int, int) = { add, add };

    printf("%d\n", add(add(1, 2), add(add(3, 4), 5)));
    printf("%d\n", apply(table[0], apply(add, 1, 2), table[1](x, x)));
    printf("%d %d\n", ackermann(2, 3), ackermann(1, ackermann(1, 1)));
    printf("%g\n", weighted(0.5, 1.9, 2, 3.0f, 'A' - 64, 70000));
    printf("%d\n", many(1, 2, 3, 4, 5, 6, 7, 8, 9, add(5, 5)));
    printf("%d %d\n", changes(x), x);
    printf("%d\n", changes(changes(changes(1))));
    printf("%s %d %c\n", x > 4 ? "yes" : "no", printf("first: "), "abc"[add(1, 1)]);
    return 0;
}
