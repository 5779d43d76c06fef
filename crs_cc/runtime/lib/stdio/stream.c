/* Streams and their buffers (C17 7.21.3). Standard output is line-buffered as on a terminal. */
#include <crs_request.h>
#include <errno.h>

#include <crs/descriptor.h>
#include <crs/stream.h>

static unsigned char input[PUSHBACK + CRS_DATA_SIZE], output[BUFSIZ], errors[CRS_DATA_SIZE];

static FILE standard_error = {2, _IONBF, WRITES | OUTPUT, errors, sizeof errors};
static FILE standard_output = {
    1, _IOLBF, WRITES | OUTPUT, output, sizeof output, 0, 0, 0, &standard_error,
};
static FILE standard_input = {0, _IOLBF, READS, input, sizeof input, 0, 0, 0, &standard_output};

FILE *stdin = &standard_input;
FILE *stdout = &standard_output;
FILE *stderr = &standard_error;
FILE *__crs_streams = &standard_input;

/* Writes out the first `size` bytes of the buffer. Output that failed is lost, as on Linux. */
static int write_out(FILE *stream, int size)
{
    int result = stream->flags & BACKED
                     ? ((struct __crs_backed *)stream)->put(stream, stream->buffer, size)
                     : __crs_put(stream->descriptor, stream->buffer, size);

    if (result < 0)
        stream->flags |= FAILED;
    stream->end -= size;
    __builtin_memmove(stream->buffer, stream->buffer + size, stream->end);
    stream->line_end = 0;
    return result;
}

int __crs_flush(FILE *stream)
{
    return stream->flags & OUTPUT && stream->end > 0 ? write_out(stream, stream->end) : 0;
}

void __crs_flush_all(void)
{
    FILE *stream;

    for (stream = __crs_streams; stream != NULL; stream = stream->next)
        __crs_flush(stream);
}

long __crs_move(FILE *stream, long offset, int whence)
{
    return stream->flags & BACKED ? ((struct __crs_backed *)stream)->seek(stream, offset, whence)
                                  : __crs_seek(stream->descriptor, offset, whence);
}

int __crs_synchronise(FILE *stream)
{
    int result = 0;

    if (stream->flags & OUTPUT)
        return __crs_flush(stream);
    if (stream->begin < stream->end &&
        __crs_move(stream, stream->begin - stream->end, SEEK_CUR) < 0)
        result = EOF;
    stream->begin = stream->end = 0;
    return result;
}

int __crs_settle(FILE *stream)
{
    if (stream->mode == _IONBF)
        return __crs_flush(stream);
    return stream->mode == _IOLBF && stream->line_end > 0 ? write_out(stream, stream->line_end) : 0;
}

/* Makes a stream ready for output or input; returns EOF with errno when it is not meant for it. */
static int turn(FILE *stream, int allowed, int output)
{
    if (!(stream->flags & allowed)) {
        stream->flags |= FAILED;
        errno = EBADF;
        return EOF;
    }
    if ((stream->flags & OUTPUT) != output) {
        __crs_synchronise(stream);
        stream->begin = stream->end = 0;
        stream->flags ^= OUTPUT;
    }
    return 0;
}

int __crs_append(FILE *stream, const void *bytes, int size)
{
    const unsigned char *from = bytes;
    int i;

    if (turn(stream, WRITES, OUTPUT) < 0)
        return EOF;
    while (size > 0) {
        int room = stream->capacity - stream->end;
        int piece = size < room ? size : room;
        __builtin_memcpy(stream->buffer + stream->end, from, piece);
        for (i = piece; stream->mode == _IOLBF && i > 0; i--)
            if (from[i - 1] == '\n') {
                stream->line_end = stream->end + i;
                break;
            }
        stream->end += piece;
        if (stream->end == stream->capacity && __crs_flush(stream) < 0)
            return EOF;
        from += piece;
        size -= piece;
    }
    return 0;
}

/* Refills an empty input buffer. A prompt must be visible before, so line-buffered output that
   is waiting for a newline is flushed (C17 7.21.3p3). */
static int refill(FILE *stream)
{
    FILE *other;
    int size = stream->mode == _IONBF ? 1 : stream->capacity - PUSHBACK;

    for (other = __crs_streams; stream->mode != _IOFBF && other != NULL; other = other->next)
        if (other->mode == _IOLBF)
            __crs_flush(other);
    size = stream->flags & BACKED
               ? ((struct __crs_backed *)stream)->read(stream, stream->buffer + PUSHBACK, size)
               : __crs_read(stream->descriptor, stream->buffer + PUSHBACK, size);
    if (size <= 0) {
        stream->flags |= size == 0 ? AT_END : FAILED;
        return EOF;
    }
    stream->begin = PUSHBACK;
    stream->end = PUSHBACK + size;
    return 0;
}

/* Makes at least one byte of input ready; returns EOF at the end. */
static int fill(FILE *stream)
{
    if (turn(stream, READS, 0) < 0)
        return EOF;
    if (stream->begin < stream->end)
        return 0;
    return stream->flags & AT_END ? EOF : refill(stream);
}

int __crs_next(FILE *stream)
{
    if ((stream->flags & OUTPUT || stream->begin == stream->end) && fill(stream) < 0)
        return EOF;
    return stream->buffer[stream->begin++];
}

size_t __crs_take(FILE *stream, void *bytes, size_t size)
{
    unsigned char *to = bytes;

    while (size > 0 && fill(stream) == 0) {
        size_t piece = stream->end - stream->begin;
        if (piece > size)
            piece = size;
        __builtin_memcpy(to, stream->buffer + stream->begin, piece);
        stream->begin += piece;
        to += piece;
        size -= piece;
    }
    return to - (unsigned char *)bytes;
}
