/* Memory management (C17 7.22.3): boundary tags and segregated bins (Knuth, TAOCP 2.5; Wilson et
   al., "Dynamic Storage Allocation", 1995), with a quarantine for freed blocks.

   The heap is a sequence of chunks. A chunk is a header of 32 bytes and the block for the program;
   its size is a multiple of 16 and every block is aligned to 16. Its header holds its own size and
   that of the previous chunk, so that both neighbours can be found. Two free chunks are never
   adjacent: freeing coalesces them.

   Free chunks are in bins by size: one bin for each size below 512, then four for each power of
   two; a bitmap marks the bins that are not empty. An allocation uses the first chunk that is large
   enough from the smallest bin that can have one. The memory after the last chunk was never used;
   it is used if no bin has a chunk, and extended when its neighbour is freed.

   A freed block is first put in quarantine, so that a use after free is detected, the longer it
   stays the better. The oldest leave if there is more than QUARANTINE, all if there is no
   other memory.

   In checked builds C may access only the blocks in use: the functions of this file
   update the shadow memory, and are not checked themselves. runtime/diagnosis/heap.py reads the
   same headers for messages. Everything happens in unchecked builds too, so that a program has
   the same addresses and the same time in both. */
#include <crs_request.h>
#include <errno.h>
#include <stdlib.h>

#include <crs/shadow.h>
#include <crs/write.h>

#define HEADER 32
#define SITES 5                 /* calls that led to the allocation, in the header */
#define IN_USE 1u               /* flags in the size of a chunk: it has a block in use, */
#define WAITING 2u              /* and is in the quarantine */
#define FLAGS 15u
#define SMALLEST (HEADER + 16)
#define SMALL 512u
#define BINS 128
#define QUARANTINE 0x40000u
#define STAYING 0x10000u        /* blocks up to this size always move when they are reallocated */

struct chunk {
    unsigned int size;          /* of this chunk, and its flags */
    unsigned int size_before;   /* of the chunk before it, 0 for the first */
    unsigned int asked;         /* requested bytes */
    int allocated[SITES];
    struct chunk *next;         /* these only while it is not in use */
    struct chunk *previous;
    int freed[SITES];           /* as many as fit */
};

extern char __heap_start[], __heap_end[];

static struct chunk *bins[BINS];
static unsigned int occupied[BINS / 32];
static char *unused;                 /* end of the last chunk; null before the first call */
static unsigned int last_size;       /* size of the last chunk, 0 if there is none */
static struct chunk *oldest, *youngest;  /* of the quarantine, which is chained by `next` */
static unsigned int waiting;         /* bytes in the quarantine */

#define SIZE(chunk) ((chunk)->size & ~FLAGS)
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

/* Allocates a new chunk from the unused memory. */
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

/* Frees the part of a chunk in use after its first `size` bytes. */
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

    if (rest < SMALLEST)
        return;
    tail = (struct chunk *)((char *)chunk + size);
    tail->size_before = size;
    set_size(tail, rest, IN_USE);
    set_size(chunk, size, IN_USE);
    release(tail);
}

/* Returns the chunk size for a block, 0 if it is too large. */
static unsigned int chunk_size(size_t size)
{
    if (size > 0x7fffff00u)
        return 0;
    return size < 16 ? SMALLEST : (size + HEADER + 15) & ~15u;
}

/* Releases the oldest chunks from quarantine until it holds at most `most` bytes. */
static void let_out(unsigned int most)
{
    struct chunk *chunk;

    while (waiting > most) {
        chunk = oldest;
        oldest = chunk->next;
        waiting -= SIZE(chunk);
        release(chunk);
    }
}

/* Finds a chunk, in the bins or beyond them. */
static struct chunk *obtain(unsigned int size)
{
    struct chunk *chunk = find(size);

    if (chunk == NULL) {
        chunk = extend(size);
        if (chunk != NULL)
            set_size(chunk, size, IN_USE);
        return chunk;
    }
    take_out(chunk);
    set_size(chunk, chunk->size, IN_USE);
    cut(chunk, size);
    return chunk;
}

/* Obtains a chunk, if need be from the quarantine; null with errno for a size of 0, too. */
static struct chunk *claim(unsigned int wanted)
{
    struct chunk *chunk = NULL;

    if (wanted != 0) {
        chunk = obtain(wanted);
        if (chunk == NULL && oldest != NULL) {
            let_out(0);
            chunk = obtain(wanted);
        }
    }
    if (chunk == NULL)
        errno = ENOMEM;
    return chunk;
}

static struct chunk *allocate(size_t size)
{
    struct chunk *chunk = claim(chunk_size(size));

    if (chunk != NULL)
        chunk->asked = size;
    return chunk;
}

/* Makes a block of a chunk, whose callers are known; its bytes may be used, but have no value. */
static void *hand_out(struct chunk *chunk)
{
    __crs_mark_unset(BLOCK(chunk), chunk->asked, chunk->allocated[0]);
    return BLOCK(chunk);
}

/* Cuts the front of a chunk in use off, so that its block lies at a multiple of `alignment`. */
static struct chunk *align(struct chunk *chunk, unsigned int alignment)
{
    unsigned int gap = -(unsigned int)BLOCK(chunk) & (alignment - 1), size = SIZE(chunk);
    struct chunk *moved;

    if (gap == 0)
        return chunk;
    if (gap < SMALLEST)
        gap += alignment;
    moved = (struct chunk *)((char *)chunk + gap);
    moved->size_before = gap;
    set_size(moved, size - gap, IN_USE);
    set_size(chunk, gap, IN_USE);
    release(chunk);
    return moved;
}

void *__crs_allocate_aligned(unsigned int alignment, size_t size)
{
    unsigned int wanted = chunk_size(size);
    struct chunk *chunk;

    if (wanted == 0 || alignment > 0x40000000u) {
        errno = ENOMEM;
        return NULL;
    }
    if (alignment > 16)
        wanted += alignment + SMALLEST;
    chunk = claim(wanted);
    if (chunk == NULL)
        return NULL;
    if (alignment > 16) {
        chunk = align(chunk, alignment);
        cut(chunk, chunk_size(size));
    }
    chunk->asked = size;
    __crs_callers(chunk->allocated, SITES);
    return hand_out(chunk);
}

void *malloc(size_t size)
{
    struct chunk *chunk = allocate(size);

    if (chunk == NULL)
        return NULL;
    __crs_callers(chunk->allocated, SITES);
    return hand_out(chunk);
}

void *calloc(size_t count, size_t size)
{
    struct chunk *chunk;

    if (size != 0 && count > 0xffffffffu / size) {
        errno = ENOMEM;
        return NULL;
    }
    chunk = allocate(count * size);
    if (chunk == NULL)
        return NULL;
    __crs_callers(chunk->allocated, SITES);
    return __builtin_memset(BLOCK(chunk), 0, count * size);
}

/* Returns whether malloc returned a pointer: the header before it must fit its neighbours. */
static int is_block(void *block)
{
    struct chunk *chunk = CHUNK(block);
    char *start = (char *)chunk;
    unsigned int size;

    if ((unsigned int)start % 16 != 0 || start < __heap_start || start >= unused)
        return 0;
    size = SIZE(chunk);
    if (__crs_state(start) != CRS_INACCESSIBLE || !(chunk->size & IN_USE) || size < SMALLEST ||
        size > (unsigned int)(unused - start) || chunk->asked > size - HEADER)
        return 0;
    if (chunk->size_before > (unsigned int)(start - __heap_start) ||
        (chunk->size_before != 0 && SIZE(BEFORE(chunk)) != chunk->size_before))
        return 0;
    return (start + size == unused ? last_size : AFTER(chunk)->size_before) == size;
}

/* Stops the program when a pointer is not that of a block in use. */
static void check(void *block)
{
    if (!is_block(block))
        __crs_stop("invalid free", block);
    if (CHUNK(block)->size & WAITING)
        __crs_stop("double free", block);
}

/* Puts a chunk in use into the quarantine. */
static void retire(struct chunk *chunk)
{
    unsigned int size = SIZE(chunk);

    __crs_mark(BLOCK(chunk), size - HEADER, CRS_INACCESSIBLE);
    chunk->size |= WAITING;
    chunk->next = NULL;
    if (oldest == NULL)
        oldest = chunk;
    else
        youngest->next = chunk;
    youngest = chunk;
    waiting += size;
    if (waiting > QUARANTINE)
        let_out(QUARANTINE);
}

/* Size of the call stack of its release that a chunk can store. */
#define ROOM(chunk) (SIZE(chunk) >= sizeof(struct chunk))

void free(void *block)
{
    struct chunk *chunk = CHUNK(block);

    if (block == NULL)
        return;
    check(block);
    if (ROOM(chunk))
        __crs_callers(chunk->freed, SITES);
    else
        __crs_callers(chunk->freed, 2);
    retire(chunk);
}

/* Grows a chunk in use over a free neighbour or unused memory; returns 1 when it has the size. */
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

/* Changes the number of usable bytes of a chunk. */
static void ask(struct chunk *chunk, unsigned int size)
{
    char *block = BLOCK(chunk);

    if (size < chunk->asked)
        __crs_mark(block + size, chunk->asked - size, CRS_INACCESSIBLE);
    else
        __crs_mark_unset(block + chunk->asked, size - chunk->asked, chunk->allocated[0]);
    chunk->asked = size;
}

/* Returns whether a block gets a new address with its new size, so that every use of the old one
   is found. Only large blocks that change little may stay, or programs that grow them by small
   steps would take forever. */
static int moves(struct chunk *chunk, size_t size)
{
    return size <= STAYING || size / 5 > chunk->asked / 4 || size < chunk->asked / 2;
}

void *realloc(void *block, size_t size)
{
    unsigned int wanted = chunk_size(size);
    struct chunk *chunk = CHUNK(block), *copy = NULL;
    int before = errno;

    if (block == NULL)
        return malloc(size);
    check(block);
    if (size == 0) {
        free(block);
        return NULL;
    }
    if (moves(chunk, size))
        copy = allocate(size);
    if (copy == NULL && wanted != 0 && (SIZE(chunk) >= wanted || grow(chunk, wanted))) {
        ask(chunk, size);
        cut(chunk, wanted);
        errno = before;
        return block;
    }
    if (copy == NULL)
        copy = allocate(size);
    if (copy == NULL)
        return NULL;
    __crs_callers(copy->allocated, SITES);
    hand_out(copy);
    __builtin_memcpy(BLOCK(copy), block, size < chunk->asked ? size : chunk->asked);
    free(block);
    return BLOCK(copy);
}
