/* Order of evaluation: &&, ||, ?:, the comma, full expressions, arguments before a call. */
#include <stdio.h>

static int counter;
static int next(void) { return ++counter; }
static int note(char c, int value) { putchar(c); return value; }

int main(void)
{
    int i = 0, a[4] = { 0 };

    i++ && note('x', 1);
    i++ && note('y', 1);
    (i++, a[i & 3] = i, i) == 3 ? note('z', 1) : note('!', 0);
    note('a', 0) || note('b', 1) || note('c', 1);
    note('d', 1) && note('e', 0) && note('f', 1);
    note('g', 0) ? note('h', 1) : note('i', 1), note('j', 1);
    putchar('\n');
    for (int k = next(); k < 10; k = next())
        if (k % 4 == 0)
            next();
    printf("%d %d %d\n", i, a[3], counter);
    i = (counter = 5, counter++ + 10);
    printf("%d %d\n", i, counter);
    i = i > 0 && i++ < 100 && i == 16;
    printf("%d\n", i);
    int x = 3, y = (x++, x), z = (x *= 2, x + y);
    printf("%d %d %d\n", x, y, z);
    return 0;
}
