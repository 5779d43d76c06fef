/* Streams and their buffers (C17 7.21.3). Standard output is line-buffered as on a terminal. */
#include <crs_request.h>
#include <errno.h>

#include <crs/write.h>
#include <crs/stream.h>

static unsigned char input[PUSHBACK + CRS_DATA_SIZE], output[BUFSIZ], errors[CRS_DATA_SIZE];

static FILE standard_error = {2, _IONBF, WRITES, errors, sizeof errors, 0, 0, 0, NULL};
static FILE standard_output = {1, _IOLBF, WRITES, output, sizeof output, 0, 0, 0, &standard_error};
static FILE standard_input = {0, _IOLBF, READS, input, sizeof input, 0, 0, 0, &standard_output};

FILE *stdin = &standard_input;
FILE *stdout = &standard_output;
FILE *stderr = &standard_error;
FILE *__crs_streams = &standard_input;

/* Writes out the first `size` bytes of the buffer. Output that failed is lost, as on Linux. */
static int write_out(FILE *stream, int size)
{
    int result = __crs_write(stream->descriptor, stream->buffer, size);

    if (result < 0)
        stream->flags |= FAILED;
    stream->end -= size;
    __builtin_memmove(stream->buffer, stream->buffer + size, stream->end);
    stream->line_end = 0;
    return result;
}

int __crs_flush(FILE *stream)
{
    return stream->flags & WRITES && stream->end > 0 ? write_out(stream, stream->end) : 0;
}

void __crs_flush_all(void)
{
    FILE *stream;

    for (stream = __crs_streams; stream != NULL; stream = stream->next)
        __crs_flush(stream);
}

int __crs_settle(FILE *stream)
{
    if (stream->mode == _IONBF)
        return __crs_flush(stream);
    return stream->mode == _IOLBF && stream->line_end > 0 ? write_out(stream, stream->line_end) : 0;
}

int __crs_append(FILE *stream, const void *bytes, int size)
{
    const unsigned char *from = bytes;
    int i;

    if (!(stream->flags & WRITES)) {
        stream->flags |= FAILED;
        errno = EBADF;
        return EOF;
    }
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

/* Refills an empty input buffer. What the user is asked must be seen first, so that output that
   waits for the end of its line goes out (C17 7.21.3p3). */
static int refill(FILE *stream)
{
    struct __crs_message message;
    FILE *other;
    int size;

    for (other = __crs_streams; other != NULL; other = other->next)
        if (other->mode == _IOLBF)
            __crs_flush(other);
    message.i[0] = stream->descriptor;
    message.i[1] = stream->mode == _IONBF ? 1 : CRS_DATA_SIZE;
    size = __crs_request(CRS_READ, &message);
    if (size <= 0 || size > CRS_DATA_SIZE) {
        stream->flags |= size == 0 ? AT_END : FAILED;
        if (size != 0)
            errno = EIO;
        return EOF;
    }
    __builtin_memcpy(stream->buffer + PUSHBACK, message.data, size);
    stream->begin = PUSHBACK;
    stream->end = PUSHBACK + size;
    return 0;
}

int __crs_next(FILE *stream)
{
    if (stream->begin == stream->end) {
        if (!(stream->flags & READS)) {
            stream->flags |= FAILED;
            errno = EBADF;
            return EOF;
        }
        if (stream->flags & AT_END || refill(stream) < 0)
            return EOF;
    }
    return stream->buffer[stream->begin++];
}
