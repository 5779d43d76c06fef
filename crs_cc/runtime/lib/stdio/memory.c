/* Streams in memory (POSIX fmemopen, open_memstream); where POSIX is silent, as in glibc. */
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>

#include <crs/stream.h>

/* A stream in memory; a growing one tells its caller where its text is, and how long. */
struct memory {
    struct __crs_backed backed;
    char *bytes;
    size_t capacity, length, position;
    int appends, owns;
    char **told_bytes;
    size_t *told_length;
};

static int memory_read(FILE *stream, void *bytes, int size)
{
    struct memory *memory = (struct memory *)stream;
    size_t left = memory->position < memory->length ? memory->length - memory->position : 0;
    size_t piece = (size_t)size < left ? (size_t)size : left;

    memcpy(bytes, memory->bytes + memory->position, piece);
    memory->position += piece;
    return piece;
}

/* Writes what fits, with a null behind it unless there is one. */
static int fixed_put(FILE *stream, const void *bytes, int size)
{
    struct memory *memory = (struct memory *)stream;
    size_t at = memory->appends ? memory->length : memory->position;
    size_t room = at < memory->capacity ? memory->capacity - at : 0;
    size_t piece = (size_t)size < room ? (size_t)size : room;
    int adds_null = size == 0 || ((const char *)bytes)[size - 1] != 0;

    memcpy(memory->bytes + at, bytes, piece);
    memory->position = at + piece;
    if (memory->position > memory->length) {
        memory->length = memory->position;
        if (adds_null && memory->length < memory->capacity)
            memory->bytes[memory->length] = 0;
        else if (adds_null && !memory->appends)
            memory->bytes[memory->capacity - 1] = 0;
    }
    if (piece < (size_t)size) {
        errno = ENOSPC;
        return -1;
    }
    return 0;
}

static void tell(struct memory *memory)
{
    *memory->told_bytes = memory->bytes;
    *memory->told_length =
        memory->position < memory->length ? memory->position : memory->length;
}

/* Makes room for `needed` bytes and a null; what was not written is zero. */
static int grow(struct memory *memory, size_t needed)
{
    size_t capacity = memory->capacity;
    char *bytes;

    while (capacity <= needed)
        capacity *= 2;
    if (capacity == memory->capacity)
        return 0;
    bytes = realloc(memory->bytes, capacity);
    if (bytes == NULL)
        return -1;
    memset(bytes + memory->capacity, 0, capacity - memory->capacity);
    memory->bytes = bytes;
    memory->capacity = capacity;
    return 0;
}

static int growing_put(FILE *stream, const void *bytes, int size)
{
    struct memory *memory = (struct memory *)stream;

    if (grow(memory, memory->position + size) < 0)
        return -1;
    memcpy(memory->bytes + memory->position, bytes, size);
    memory->position += size;
    if (memory->position > memory->length)
        memory->length = memory->position;
    memory->bytes[memory->position] = 0;
    tell(memory);
    return 0;
}

static long memory_seek(FILE *stream, long offset, int whence)
{
    struct memory *memory = (struct memory *)stream;
    long from = whence == SEEK_SET   ? 0
                : whence == SEEK_CUR ? (long)memory->position
                                     : (long)memory->length;
    long to = from + offset;

    if (to < 0 || (memory->told_bytes == NULL && (size_t)to > memory->capacity)) {
        errno = EINVAL;
        return -1;
    }
    if (memory->told_bytes != NULL && grow(memory, to) < 0)
        return -1;
    memory->position = to;
    return to;
}

static int memory_close(FILE *stream)
{
    struct memory *memory = (struct memory *)stream;

    if (memory->owns)
        free(memory->bytes);
    return 0;
}

static struct memory *make(int flags, int (*put)(FILE *, const void *, int))
{
    struct memory *memory = (struct memory *)__crs_make_stream(-1, flags, sizeof *memory);

    if (memory != NULL) {
        memory->backed.stream.flags |= BACKED;
        memory->backed.put = put;
        memory->backed.read = memory_read;
        memory->backed.seek = memory_seek;
        memory->backed.close = memory_close;
    }
    return memory;
}

FILE *fmemopen(void *bytes, size_t size, const char *mode)
{
    int flags = __crs_open_flags(mode);
    struct memory *memory = flags < 0 ? NULL : make(flags, fixed_put);

    if (memory == NULL)
        return NULL;
    memory->owns = bytes == NULL;
    memory->bytes = bytes == NULL ? calloc(size + 1, 1) : bytes;
    if (memory->bytes == NULL) {
        fclose(&memory->backed.stream);
        return NULL;
    }
    memory->capacity = size;
    memory->appends = (flags & O_APPEND) != 0;
    if (flags & O_TRUNC && flags & O_RDWR && size > 0)
        memory->bytes[0] = 0;
    if (flags & O_APPEND) {
        char *end = memchr(memory->bytes, 0, size);
        memory->position = memory->length = end == NULL ? size : (size_t)(end - memory->bytes);
    } else if (!(flags & O_TRUNC)) {
        memory->length = size;
    }
    return &memory->backed.stream;
}

FILE *open_memstream(char **bytes, size_t *length)
{
    struct memory *memory = make(O_WRONLY, growing_put);

    if (memory == NULL)
        return NULL;
    memory->capacity = 64;
    memory->bytes = calloc(memory->capacity, 1);
    if (memory->bytes == NULL) {
        fclose(&memory->backed.stream);
        return NULL;
    }
    memory->told_bytes = bytes;
    memory->told_length = length;
    tell(memory);
    return &memory->backed.stream;
}
