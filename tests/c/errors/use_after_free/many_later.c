/* Other blocks come and go between; the freed one is not given out again so soon. */
#include <stdlib.h>

int main(void)
{
    int *p = malloc(40), i;

    p[0] = 1;
    free(p);
    for (i = 0; i < 100; i++)
        free(malloc(40));
    return p[0]; // error: use after free
}
