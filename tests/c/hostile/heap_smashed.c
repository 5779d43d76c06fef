/* Writes over the allocator's own data, then goes on using it. */
// ends: failed
#include <stdlib.h>
#include <string.h>

int main(void)
{
    char *blocks[64];
    unsigned i, round;

    for (round = 0;; round++) {
        for (i = 0; i < 64; i++)
            if ((blocks[i] = malloc(i * 8 + 8)))
                memset(blocks[i] - 16, (int) (round * 37 + i), 64);
        for (i = 0; i < 64; i += 2)
            free(blocks[i]);
        free(blocks[0]);
        blocks[1] = realloc(blocks[1], 300);
        free((void *) (round * 8));
    }
}
