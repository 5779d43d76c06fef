/* Memory of variable-length arrays, and of alloca: a stack of blocks on the heap. */
#include <crs/automatic.h>
#include <stdlib.h>

int __crs_automatic_count;

static struct automatic {
    void *block;
    const char *name;           /* of the variable, for memory inspection */
} *pieces;
static int capacity;

void *__crs_automatic(unsigned size, const char *name)
{
    struct automatic *grown, *piece;

    if (__crs_automatic_count >= capacity) {
        grown = realloc(pieces, (2 * capacity + 8) * sizeof *pieces);
        if (grown == NULL)
            __crs_stop("no memory for local array");
        pieces = grown;
        capacity = 2 * capacity + 8;
    }
    piece = &pieces[__crs_automatic_count];
    piece->block = malloc(size);
    piece->name = name;
    if (piece->block == NULL)
        __crs_stop("no memory for local array");
    __crs_automatic_count++;
    return piece->block;
}

void __crs_release(int count)
{
    while (__crs_automatic_count > count && __crs_automatic_count > 0)
        free(pieces[--__crs_automatic_count].block);
}
