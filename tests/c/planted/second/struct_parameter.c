/* A table of functions, one of which wants a struct. */
#include <stdio.h>
struct pair { int a, b; };
static int sum(struct pair p) { return p.a + p.b; }
static int first(int a, int b) { return a - b; }
static int (*const table[])(int, int) = {first, PLANT((int (*)(int, int))sum, first)};
int main(void)
{
    int i, n = 0;
    (void)sum;
    for (i = 0; i < 2; i++)
        n += table[i](4, 3); // error: mismatched call
    printf("%d\n", n);
    return 0;
}
