/* Fills blocks of the heap with what looks like the allocator's headers, and gives parts of them back. */
// ends: invalid free
#include <stdlib.h>

int main(void)
{
    unsigned i, j, *p;

    for (i = 0; i < 64; i++) {
        p = malloc(4096);
        for (j = 0; j < 1024; j++)
            p[j] = j % 8 == 0 ? 0x21 + 16 * i : j % 8 == 1 ? 32 : 0;
    }
    for (j = 16; j < 1024; j += 4)
        free(p + j);
    return 0;
}
