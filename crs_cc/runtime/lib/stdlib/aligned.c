/* Blocks at larger alignments (C17 7.22.3.1; posix_memalign: POSIX; the others: BSD and GNU). */
#include <errno.h>
#include <stdlib.h>

void *__crs_allocate_aligned(unsigned int alignment, size_t size);    /* in malloc.c */

#define PAGE 4096

static int is_power(size_t alignment)
{
    return alignment != 0 && (alignment & (alignment - 1)) == 0;
}

static void *allocate(size_t alignment, size_t size)
{
    if (!is_power(alignment)) {
        errno = EINVAL;
        return NULL;
    }
    return __crs_allocate_aligned(alignment, size);
}

void *aligned_alloc(size_t alignment, size_t size)
{
    return allocate(alignment, size);
}

void *memalign(size_t alignment, size_t size)
{
    return allocate(alignment, size);
}

void *valloc(size_t size)
{
    return allocate(PAGE, size);
}

/* Returns the error itself, and leaves errno alone. */
int posix_memalign(void **block, size_t alignment, size_t size)
{
    int before = errno;
    void *found;

    if (!is_power(alignment) || alignment < sizeof(void *))
        return EINVAL;
    found = allocate(alignment, size);
    errno = before;
    if (found == NULL)
        return ENOMEM;
    *block = found;
    return 0;
}

void *reallocarray(void *block, size_t count, size_t size)
{
    if (size != 0 && count > 0xffffffffu / size) {
        errno = ENOMEM;
        return NULL;
    }
    return realloc(block, count * size);
}

void cfree(void *block)
{
    free(block);
}
