/* Opening and closing streams (C17 7.21.4 and 7.21.5; fdopen: POSIX). */
#include <crs_request.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>

#include <crs/descriptor.h>
#include <crs/stream.h>

int __crs_open_flags(const char *mode)
{
    int flags = *mode == 'r' ? 0 : *mode == 'w' ? O_CREAT | O_TRUNC : O_CREAT | O_APPEND;

    if (*mode == 0 || strchr("rwa", *mode) == NULL) {
        errno = EINVAL;
        return -1;
    }
    if (strchr(mode, 'x') != NULL)
        flags |= O_EXCL;
    if (strchr(mode, '+') != NULL)
        return flags | O_RDWR;
    return flags | (*mode == 'r' ? O_RDONLY : O_WRONLY);
}

/* Returns a stream's flags for those of open. */
static int stream_flags(int flags)
{
    flags &= O_ACCMODE;
    return flags == O_RDONLY ? READS : flags == O_WRONLY ? WRITES | OUTPUT : READS | WRITES;
}

FILE *__crs_make_stream(int descriptor, int flags, size_t size)
{
    FILE *stream = malloc(size + BUFSIZ);

    if (stream == NULL)
        return NULL;
    __builtin_memset(stream, 0, size);
    stream->descriptor = descriptor;
    stream->mode = _IOFBF;
    stream->flags = stream_flags(flags) | OWNED;
    stream->buffer = (unsigned char *)stream + size;
    stream->capacity = BUFSIZ;
    stream->next = __crs_streams;
    __crs_streams = stream;
    return stream;
}

/* Puts a stream around a descriptor that was just opened, and closes it when that fails. */
static FILE *around(int descriptor, int flags)
{
    FILE *stream = descriptor < 0 ? NULL : __crs_make_stream(descriptor, flags, sizeof(FILE));

    if (descriptor >= 0 && stream == NULL)
        __crs_close(descriptor);
    return stream;
}

FILE *fopen(const char *name, const char *mode)
{
    int flags = __crs_open_flags(mode);

    return flags < 0 ? NULL : around(__crs_open(name, flags), flags);
}

FILE *fdopen(int descriptor, const char *mode)
{
    int flags = __crs_open_flags(mode);

    if (flags < 0 || __crs_find(descriptor) == NULL)
        return NULL;
    return __crs_make_stream(descriptor, flags, sizeof(FILE));
}

FILE *tmpfile(void)
{
    return around(__crs_open("", O_RDWR | O_TMPFILE), O_RDWR);
}

static int close_descriptor(FILE *stream)
{
    int result = __crs_flush(stream);

    if (stream->flags & BACKED ? ((struct __crs_backed *)stream)->close(stream) < 0
                               : __crs_close(stream->descriptor) < 0)
        result = EOF;
    stream->begin = stream->end = stream->line_end = 0;
    stream->flags &= OWNED;
    return result;
}

/* The standard streams stay in the list, closed, since a program may still name them. */
int fclose(FILE *stream)
{
    int result = close_descriptor(stream);
    FILE **link;

    if (!(stream->flags & OWNED))
        return result;
    for (link = &__crs_streams; *link != NULL && *link != stream; link = &(*link)->next)
        ;
    if (*link != NULL)
        *link = stream->next;
    free(stream);
    return result;
}

/* Without a name the mode changes, as far as the descriptor allows it (C17 7.21.5.4p3). */
FILE *freopen(const char *name, const char *mode, FILE *stream)
{
    int flags = __crs_open_flags(mode);

    if (flags < 0)
        return NULL;
    if (name == NULL) {
        __crs_synchronise(stream);
        stream->flags = (stream->flags & OWNED) | stream_flags(flags);
        return stream;
    }
    close_descriptor(stream);
    stream->descriptor = __crs_open(name, flags);
    if (stream->descriptor < 0)
        return NULL;
    stream->flags |= stream_flags(flags);
    stream->mode = _IOFBF;
    return stream;
}
