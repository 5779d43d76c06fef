/* Memory management (C17 7.22.3): boundary tags and segregated bins (Knuth, TAOCP 2.5; Wilson et
   al., "Dynamic Storage Allocation", 1995).

   The heap is a row of chunks. A chunk is a header of 8 bytes and the block given to the program;
   its size is a multiple of 16 and every block lies at a multiple of 16. A header holds the chunk's
   own size, whose lowest bit says that it is in use, and the size of the chunk before it, so that
   both neighbours can be found. Two free chunks never touch: freeing joins them.

   Free chunks lie in bins by size: one bin for each size below 512, then four for each power of
   two; a bitmap tells which bins have something. An allocation takes the first chunk that is big
   enough from the smallest bin that can have one. Beyond the last chunk lies memory that was never
   used; it is taken from when no bin can serve, and given back when its neighbour is freed. */
#include <crs_request.h>
#include <errno.h>
#include <stdlib.h>

#include <crs/write.h>

#define HEADER 8
#define IN_USE 1u
#define SMALL 512u
#define BINS 128

struct chunk {
    unsigned int size;          /* of this chunk; lowest bit: in use */
    unsigned int size_before;   /* of the chunk before it, 0 for the first */
    struct chunk *next;         /* these two only while it is free */
    struct chunk *previous;
};

extern char __heap_start[], __heap_end[];

static struct chunk *bins[BINS];
static unsigned int occupied[BINS / 32];
static char *unused;                 /* end of the last chunk; null before the first call */
static unsigned int last_size;       /* size of the last chunk, 0 when there is none */

#define SIZE(chunk) ((chunk)->size & ~IN_USE)
#define AFTER(chunk) ((struct chunk *)((char *)(chunk) + SIZE(chunk)))
#define BEFORE(chunk) ((struct chunk *)((char *)(chunk) - (chunk)->size_before))
#define BLOCK(chunk) ((void *)((char *)(chunk) + HEADER))
#define CHUNK(block) ((struct chunk *)((char *)(block) - HEADER))

static int bin_of(unsigned int size)
{
    int log2;

    if (size < SMALL)
        return size / 16;
    log2 = 31 - __builtin_clz(size);
    return 32 + (log2 - 9) * 4 + (size >> (log2 - 2) & 3);
}

static void add(struct chunk *chunk)
{
    int bin = bin_of(chunk->size);

    chunk->previous = NULL;
    chunk->next = bins[bin];
    if (chunk->next != NULL)
        chunk->next->previous = chunk;
    bins[bin] = chunk;
    occupied[bin / 32] |= 1u << bin % 32;
}

static void take_out(struct chunk *chunk)
{
    int bin = bin_of(chunk->size);

    if (chunk->next != NULL)
        chunk->next->previous = chunk->previous;
    if (chunk->previous != NULL)
        chunk->previous->next = chunk->next;
    else
        bins[bin] = chunk->next;
    if (bins[bin] == NULL)
        occupied[bin / 32] &= ~(1u << bin % 32);
}

/* Writes a chunk's size where both it and its neighbour look for it. */
static void set_size(struct chunk *chunk, unsigned int size, unsigned int in_use)
{
    chunk->size = size | in_use;
    if ((char *)chunk + size == unused)
        last_size = size;
    else
        AFTER(chunk)->size_before = size;
}

/* Finds a free chunk of at least `size` in the bins. Only a chunk's own bin can hold smaller ones;
   there the search ends after a few, so that many chunks of nearly the size cost nothing. */
static struct chunk *find(unsigned int size)
{
    int bin = bin_of(size), word, tries = 16;
    struct chunk *chunk;
    unsigned int bits;

    for (chunk = bins[bin]; chunk != NULL && tries-- > 0; chunk = chunk->next)
        if (chunk->size >= size)
            return chunk;
    if (++bin == BINS)
        return NULL;
    word = bin / 32;
    bits = occupied[word] & ~0u << bin % 32;
    while (bits == 0) {
        if (++word == BINS / 32)
            return NULL;
        bits = occupied[word];
    }
    return bins[word * 32 + __builtin_ctz(bits)];
}

/* Takes a new chunk from the memory that was never used. */
static struct chunk *extend(unsigned int size)
{
    struct chunk *chunk;

    if (unused == NULL)
        unused = __heap_start + (-((unsigned int)__heap_start + HEADER) & 15);
    if (unused > __heap_end || size > (unsigned int)(__heap_end - unused))
        return NULL;
    chunk = (struct chunk *)unused;
    chunk->size_before = last_size;
    unused += size;
    return chunk;
}

/* Makes a free chunk of what lies behind the first `size` bytes of a chunk in use. */
static void release(struct chunk *chunk)
{
    struct chunk *after = AFTER(chunk), *before;
    unsigned int size = SIZE(chunk);

    if ((char *)after != unused && !(after->size & IN_USE)) {
        take_out(after);
        size += after->size;
    }
    if (chunk->size_before != 0 && !((before = BEFORE(chunk))->size & IN_USE)) {
        take_out(before);
        size += before->size;
        chunk = before;
    }
    if ((char *)chunk + size == unused) {
        unused = (char *)chunk;
        last_size = chunk->size_before;
        return;
    }
    set_size(chunk, size, 0);
    add(chunk);
}

/* Cuts a chunk in use down to `size` when the rest can be a chunk. */
static void cut(struct chunk *chunk, unsigned int size)
{
    unsigned int rest = SIZE(chunk) - size;
    struct chunk *tail;

    if (rest < 16)
        return;
    tail = (struct chunk *)((char *)chunk + size);
    tail->size_before = size;
    set_size(tail, rest, IN_USE);
    set_size(chunk, size, IN_USE);
    release(tail);
}

/* Gives the chunk size for a block, 0 when there is none so large. */
static unsigned int chunk_size(size_t size)
{
    return size > 0x7fffffe0u ? 0 : (size + HEADER + 15) & ~15u;
}

void *malloc(size_t size)
{
    unsigned int wanted = chunk_size(size);
    struct chunk *chunk = wanted == 0 ? NULL : find(wanted);

    if (chunk != NULL) {
        take_out(chunk);
        set_size(chunk, chunk->size, IN_USE);
        cut(chunk, wanted);
        return BLOCK(chunk);
    }
    chunk = wanted == 0 ? NULL : extend(wanted);
    if (chunk == NULL) {
        errno = ENOMEM;
        return NULL;
    }
    set_size(chunk, wanted, IN_USE);
    return BLOCK(chunk);
}

/* Stops the program when a pointer was not given by malloc, or was freed before, or when its
   neighbour's header was written over. */
static void check(struct chunk *chunk, const char *function)
{
    char *start = (char *)chunk;
    unsigned int size;

    if (((unsigned int)start + HEADER) % 16 == 0 && start >= __heap_start && start < unused) {
        size = SIZE(chunk);
        if ((chunk->size & IN_USE) && size >= 16 && size <= (unsigned int)(unused - start) &&
            (start + size == unused ? last_size : AFTER(chunk)->size_before) == size)
            return;
    }
    __crs_complain(function, ": invalid pointer or damaged heap\n");
    __crs_stop("abort called");
}

void free(void *block)
{
    if (block == NULL)
        return;
    check(CHUNK(block), "free()");
    release(CHUNK(block));
}

void *calloc(size_t count, size_t size)
{
    void *block;

    if (size != 0 && count > 0xffffffffu / size) {
        errno = ENOMEM;
        return NULL;
    }
    block = malloc(count * size);
    if (block != NULL)
        __builtin_memset(block, 0, count * size);
    return block;
}

/* Grows a chunk in use over a free neighbour or unused memory; gives 1 when it has the size. */
static int grow(struct chunk *chunk, unsigned int wanted)
{
    struct chunk *after = AFTER(chunk);
    unsigned int size = SIZE(chunk);

    if ((char *)after == unused) {
        if (wanted - size > (unsigned int)(__heap_end - unused))
            return 0;
        unused += wanted - size;
    } else {
        if ((after->size & IN_USE) || size + after->size < wanted)
            return 0;
        take_out(after);
        wanted = size + after->size;
    }
    set_size(chunk, wanted, IN_USE);
    return 1;
}

void *realloc(void *block, size_t size)
{
    unsigned int wanted = chunk_size(size);
    struct chunk *chunk = CHUNK(block);
    void *copy;

    if (block == NULL)
        return malloc(size);
    check(chunk, "realloc()");
    if (size == 0) {
        release(chunk);
        return NULL;
    }
    if (wanted != 0 && (SIZE(chunk) >= wanted || grow(chunk, wanted))) {
        cut(chunk, wanted);
        return block;
    }
    copy = malloc(size);
    if (copy != NULL) {
        __builtin_memcpy(copy, block, SIZE(chunk) - HEADER);
        release(chunk);
    }
    return copy;
}
