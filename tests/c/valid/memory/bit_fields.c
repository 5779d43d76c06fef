/* Setting one bit-field of a unit is no use of the others. */
#include <stdio.h>
#include <stdlib.h>

struct flags { unsigned a : 3, b : 5, c : 20; signed d : 4; };

int main(void)
{
    struct flags f, *g = malloc(sizeof *g);

    f.a = 5;
    f.b = 17;
    printf("%u %u\n", f.a, f.b);
    g->c = 70000;
    g->d = -3;
    g->c += 1;
    printf("%u %d\n", g->c, g->d);
    free(g);
    return 0;
}
