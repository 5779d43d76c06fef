/* A counter that nobody set, and that decides in the end. */
#include <stdlib.h>

struct counts { int hits, misses; };

int main(void)
{
    struct counts *c = malloc(sizeof *c);
    int i;

    c->misses = 0;
    for (i = 0; i < 10; i++) {
        c->hits += i;
        c->misses += 1;
    }
    if (c->misses != 10)
        return 2;
    return c->hits > 3; // error: uninitialised read
}
