/* Each operand is evaluated exactly once, also in sizeof (not at all). */
#include <stdio.h>

static int calls;
static int index_of(void) { return calls++; }
struct cell { int n; struct cell *next; };

int main(void)
{
    int v[6] = { 0, 10, 20, 30, 40, 50 };
    struct cell c = { 1, 0 }, d = { 2, &c }, *p = &d;
    int i = 0;

    v[index_of()] += 5;
    v[index_of()]++;
    ++v[index_of()];
    v[index_of()] <<= 1;
    printf("%d %d %d %d calls %d\n", v[0], v[1], v[2], v[3], calls);
    i = sizeof v[index_of()];
    printf("%d calls %d\n", i, calls);
    (p = p->next)->n += 41;
    printf("%d\n", c.n);
    i = 0;
    v[++i] *= 2;
    printf("%d %d\n", i, v[1]);
    return 0;
}
