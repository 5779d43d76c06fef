/* Many blocks of many sizes, kept, changed and given back; the quarantine fills and empties. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define N 64

static unsigned seed = 1;

static unsigned below(unsigned n)
{
    seed = seed * 1103515245u + 12345u;
    return (seed >> 8) % n;
}

int main(void)
{
    unsigned char *block[N] = { 0 };
    unsigned size[N] = { 0 }, round, sum = 0, i;

    for (round = 0; round < 800; round++) {
        unsigned k = below(N), old = size[k];
        switch (below(4)) {
        case 0:
            free(block[k]);
            size[k] = below(6000);
            block[k] = calloc(size[k] + 1, 1);
            break;
        case 1:
            free(block[k]);
            size[k] = below(50);
            block[k] = malloc(size[k] + 1);
            memset(block[k], k, size[k] + 1);
            break;
        case 2:
            size[k] = below(9000);
            block[k] = realloc(block[k], size[k] + 1);
            if (size[k] + 1 > old)
                memset(block[k] + old, 7, size[k] + 1 - old);
            break;
        default:
            for (i = 0; block[k] && i <= size[k]; i += 97)
                sum += block[k][i];
        }
    }
    for (i = 0; i < N; i++)
        free(block[i]);
    printf("%u\n", sum);
    return 0;
}
