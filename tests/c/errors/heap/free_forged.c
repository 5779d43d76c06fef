/* What looks like a header of the allocator is none. */
#include <stdlib.h>

int main(void)
{
    unsigned *p = malloc(400), i;

    for (i = 0; i < 100; i++)
        p[i] = i % 2 ? 0 : 65;
    free(p + 16); // error: invalid free
    return 0;
}
