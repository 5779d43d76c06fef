/* The comma operator evaluates its left operand, then yields its right operand (C17 6.5.17). */
#include <stdio.h>

static int f(int a, int b) { return a * 10 + b; }

int main(void)
{
    int i, j, x, y;

    x = (1, 2, 3);
    y = 1, 2, 3;
    printf("%d %d\n", x, y);
    for (i = 0, j = 10; i < j; i++, j--)
        ;
    printf("%d %d\n", i, j);
    printf("%d\n", f((x = 5, x + 1), 2));
    i = (j = 3, j * j);
    printf("%d %d\n", i, j);
    while (x--, x > 2)
        printf("%d ", x);
    printf("\n");
    if (x = 0, y)
        printf("%d %d\n", x, y);
    i = 0;
    i++, i++, i += 5;
    printf("%d\n", i);
    printf("%u\n", (unsigned) sizeof((char) 1, 2.0));
    return (x = 0, x);
}
