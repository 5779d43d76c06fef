/* Complex declarators (C17 6.7.6). */
#include <stdio.h>

static int values[3] = { 10, 20, 30 };
static int add(int a, int b) { return a + b; }
static int sub(int a, int b) { return a - b; }

static int (*choose(int c))(int, int) { return c == '+' ? add : sub; }
static int (*row(void))[3] { return &values; }
static int *(*pointers(int *(*f)(int *), int *p))(int *) { (void) p; return f; }
static int *step(int *p) { return p + 1; }

int main(void)
{
    int *a[3] = { values, values + 1, values + 2 };
    int (*b)[3] = &values;
    int (*c[2])(int, int) = { add, sub };
    int (*(*d)(int))(int, int) = choose;
    int (*(*e[1])(void))[3] = { row };
    int *(*(*f)(int *(*)(int *), int *))(int *) = pointers;
    const char *const *const g = (const char *const[]){ "one", "two" };
    int (*const h)(int, int) = &add;
    int (((parenthesised))) = 5, *q = &parenthesised, r[2] = { 1, 2 }, (*s)[2] = &r;
    char (*(*t)[2])(void) = 0;
    typedef int operation(int, int);
    operation *u = sub, *v[] = { add, sub, add };

    printf("%d %d\n", *a[2], (*b)[1]);
    printf("%d %d\n", c[0](1, 2), (*c[1])(1, 2));
    printf("%d %d\n", d('+')(5, 6), (*(*d)('-'))(5, 6));
    printf("%d %d\n", (*e[0]())[2], *row()[0]);
    printf("%d\n", *f(step, values)(values));
    printf("%s %s\n", g[0], *(g + 1));
    printf("%d %d %d\n", h(1, 1), *q, (*s)[1]);
    printf("%d %u\n", t == 0, (unsigned) sizeof *t);
    printf("%d %u\n", u(9, 4) + v[2](1, 1), (unsigned) (sizeof v / sizeof *v));
    return 0;
}
