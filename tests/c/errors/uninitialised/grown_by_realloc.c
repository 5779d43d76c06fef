/* The new part of a block has no value. */
#include <stdlib.h>

int main(void)
{
    int *p = calloc(4, sizeof *p);

    p = realloc(p, 8 * sizeof *p);
    if (p[3] != 0)
        return 1;
    return p[4]; // error: uninitialised read
}
