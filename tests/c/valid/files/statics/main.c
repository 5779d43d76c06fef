/* Static functions, objects and tags of the same names in two files. */
#include <stdio.h>

struct state { int steps; char name[4]; } now = {1, "abc"};
static int count = 10;
static struct state helper(int n) { struct state s = {n, "one"}; count++; return s; }
extern double other(int);

int main(void)
{
    struct state s = helper(3);
    printf("%d %s %d %g %d\n", s.steps, s.name, count, other(4), now.steps);
    return 0;
}
