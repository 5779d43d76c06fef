/* A counter that nobody set is increased. */
#include <stdlib.h>

struct counts { int hits, misses; };

int main(void)
{
    struct counts *c = malloc(sizeof *c);
    int i;

    c->misses = 0;
    for (i = 0; i < 10; i++) {
        c->hits += i; // error: uninitialised read
        c->misses += 1;
    }
    if (c->misses != 10)
        return 2;
    return c->hits > 3;
}
