/* Blocks at all alignments, among others, freed in any order. */
#define _GNU_SOURCE
#include <errno.h>
#include <malloc.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define COUNT 60

static unsigned char *blocks[COUNT];
static size_t sizes[COUNT];

static int is_filled(int i)
{
    size_t k;

    for (k = 0; k < sizes[i]; k++)
        if (blocks[i][k] != (unsigned char)(i * 7))
            return 0;
    return 1;
}

int main(void)
{
    int i, round, wrong = 0;
    void *block = NULL;
    size_t alignment;

    for (round = 0; round < 4; round++) {
        for (i = 0; i < COUNT; i++) {
            if (blocks[i] != NULL)
                continue;
            alignment = (size_t)16 << (i + round) % 9;
            sizes[i] = (i * 37 + round * 11) % 300;
            if (i % 3 == 0)
                blocks[i] = malloc(sizes[i]);
            else
                blocks[i] = aligned_alloc(alignment, sizes[i]);
            wrong += blocks[i] == NULL || (i % 3 != 0 && (uintptr_t)blocks[i] % alignment != 0);
            memset(blocks[i], i * 7, sizes[i]);
        }
        for (i = round; i < COUNT; i += 2 + round) {
            wrong += !is_filled(i);
            if (i % 4 == 1)
                blocks[i] = realloc(blocks[i], sizes[i] * 2 + 1);
            wrong += !is_filled(i);
            free(blocks[i]);
            blocks[i] = NULL;
        }
    }
    for (i = 0; i < COUNT; i++)
        wrong += blocks[i] != NULL && !is_filled(i);
    printf("%d\n", wrong);
    printf("%d", posix_memalign(&block, 64, 100));
    printf(" %d %d\n", (uintptr_t)block % 64 == 0, posix_memalign(&block, 24, 8) == EINVAL);
    block = reallocarray(block, 30, 10);
    printf("%d %d\n", block != NULL, reallocarray(NULL, 1 << 20, 1 << 20) == NULL);
    block = valloc(10);
    printf("%d\n", (uintptr_t)block % 4096 == 0);
    free(block);
    return 0;
}
