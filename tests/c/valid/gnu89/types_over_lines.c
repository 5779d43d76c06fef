/* Declarations that go on after a struct's members, or are parameters of 1978. */
#include <stdio.h>

struct pair { int a, b; }
const first = { 1, 2 };

struct point { int x; }
*where;

enum side { LEFT, RIGHT }
static
side = RIGHT;

int sum(a, b)
int a;
char *b;
{
    return a + *b;
}

struct pair
swapped(p)
struct pair p;
{
    struct pair q = { p.b, p.a };
    return q;
}

int main(void)
{
    struct pair q = swapped(first);
    where = 0;
    printf("%d %d %d %d %d\n", q.a, q.b, side, sum(1, "A"), where == 0);
    return 0;
}
