/* The expansion of a macro is rescanned, together with the following tokens (C17 6.10.3.4). */
#include <stdio.h>

static int SELF = 6;
static int LEFT = 3;

#define f(a) a*g
#define g(a) f(a)
#define CALL(name) name(
#define LATE twice
#define twice(x) ((x) + (x))
#define A B
#define B C
#define C 42
#define SELF SELF + 1
#define LEFT RIGHT
#define RIGHT LEFT
#define NAME(x) x
#define PASS(x) NAME
#define COMMA ,
#define TWO(x, y) x - y
#define APPLY(m, args) m args

int main(void)
{
    int g = 7;

    printf("%d\n", f(2)(9));
    printf("%d\n", CALL(twice) 5));
    printf("%d\n", LATE(6));
    printf("%d\n", A);
    printf("%d %d\n", LEFT, SELF);
    printf("%d\n", PASS(1)(8));
    printf("%d\n", APPLY(TWO, (9, 4)));
    printf("%d %d\n", NAME(1) COMMA NAME(2));
    printf("%d\n", twice(twice(3)));
    return 0;
}
