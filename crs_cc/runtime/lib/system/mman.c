/* Memory by the page (POSIX sys/mman.h): blocks of the heap. A file's pages are a copy, which is
   never written back: to write to a file through shared pages is refused, as on a device that has
   no memory to map. */
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>

#include <crs/descriptor.h>

void *__crs_allocate_aligned(unsigned int alignment, size_t size);    /* in malloc.c */

#define PAGE 4096

static struct mapping {
    struct mapping *next;
    void *pages;
    size_t size;    /* in whole pages */
} *mappings;

static int fail(int number)
{
    errno = number;
    return -1;
}

/* Reads a file from `offset` to its end, at most `size` bytes, and leaves its position alone. */
static int read_file(char *pages, size_t size, int descriptor, off_t offset)
{
    off_t before = __crs_seek(descriptor, 0, SEEK_CUR);
    int got;

    if (before < 0 || __crs_seek(descriptor, offset, SEEK_SET) < 0)
        return fail(ENODEV);
    do {
        got = __crs_read(descriptor, pages, size);
        if (got > 0) {
            pages += got;
            size -= got;
        }
    } while (got > 0 && size > 0);
    __crs_seek(descriptor, before, SEEK_SET);
    return got < 0 ? -1 : 0;
}

/* Returns 0 if a mapping of a file is possible. */
static int check_file(int protection, int flags, int descriptor)
{
    struct __crs_open_file *file = __crs_find(descriptor);

    if (file == NULL)
        return -1;
    if ((file->flags & O_ACCMODE) == O_WRONLY)
        return fail(EACCES);
    if ((flags & MAP_SHARED) && (protection & PROT_WRITE))
        return fail(ENODEV);
    return 0;
}

void *mmap(void *wish, size_t size, int protection, int flags, int descriptor, off_t offset)
{
    struct mapping *new;
    int from_file = !(flags & MAP_ANONYMOUS);

    (void)wish;
    if (size == 0 || offset % PAGE != 0 || !(flags & MAP_SHARED) == !(flags & MAP_PRIVATE)) {
        errno = EINVAL;
        return MAP_FAILED;
    }
    if (flags & MAP_FIXED || size > 0xffffffffu - PAGE) {
        errno = ENOMEM;
        return MAP_FAILED;
    }
    if (from_file && check_file(protection, flags, descriptor) < 0)
        return MAP_FAILED;
    new = malloc(sizeof *new);
    if (new == NULL)
        return MAP_FAILED;
    new->size = (size + PAGE - 1) / PAGE * PAGE;
    new->pages = __crs_allocate_aligned(PAGE, new->size);
    if (new->pages != NULL) {
        __builtin_memset(new->pages, 0, new->size);
        if (!from_file || read_file(new->pages, size, descriptor, offset) == 0) {
            new->next = mappings;
            mappings = new;
            return new->pages;
        }
        free(new->pages);
    }
    free(new);
    return MAP_FAILED;
}

/* Frees a whole mapping; a part of one stays until the program ends. */
int munmap(void *address, size_t size)
{
    struct mapping **link, *found;

    if (size == 0 || (size_t)address % PAGE != 0)
        return fail(EINVAL);
    for (link = &mappings; *link != NULL; link = &(*link)->next) {
        found = *link;
        if (found->pages == address && size > found->size - PAGE && size <= found->size) {
            *link = found->next;
            free(found->pages);
            free(found);
            break;
        }
    }
    return 0;
}

int msync(void *address, size_t size, int flags)
{
    (void)address;
    (void)size;
    (void)flags;
    return 0;
}

int mprotect(void *address, size_t size, int protection)
{
    (void)address;
    (void)size;
    (void)protection;
    return 0;
}

int madvise(void *address, size_t size, int advice)
{
    (void)address;
    (void)size;
    (void)advice;
    return 0;
}

int mlock(const void *address, size_t size)
{
    (void)address;
    (void)size;
    return 0;
}

int munlock(const void *address, size_t size)
{
    (void)address;
    (void)size;
    return 0;
}

int mlockall(int flags)
{
    (void)flags;
    return 0;
}

int munlockall(void)
{
    return 0;
}
