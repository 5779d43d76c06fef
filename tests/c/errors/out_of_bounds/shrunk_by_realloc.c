/* A block is used beyond its new end. */
#include <stdlib.h>

int main(void)
{
    int *p = malloc(100 * sizeof *p);

    p = realloc(p, 50 * sizeof *p);
    p[50] = 1; // error: out of bounds
    return 0;
}
