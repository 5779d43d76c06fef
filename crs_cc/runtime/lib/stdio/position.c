/* File positions, and stream status (C17 7.21.9 and 7.21.10). */
#include <errno.h>

#include <crs/descriptor.h>
#include <crs/stream.h>

int fseek(FILE *stream, long offset, int whence)
{
    if (__crs_move(stream, 0, SEEK_CUR) < 0 || __crs_synchronise(stream) < 0)
        return -1;
    if (__crs_move(stream, offset, whence) < 0)
        return -1;
    stream->flags &= ~AT_END;
    return 0;
}

long ftell(FILE *stream)
{
    long place;

    if (stream->flags & OUTPUT && stream->end > 0 && __crs_flush(stream) < 0)
        return -1;
    place = __crs_move(stream, 0, SEEK_CUR);
    return place < 0 ? -1 : place - (stream->end - stream->begin);
}

int fseeko(FILE *stream, off_t offset, int whence)
{
    return fseek(stream, offset, whence);
}

off_t ftello(FILE *stream)
{
    return ftell(stream);
}

int fgetpos(FILE *stream, fpos_t *position)
{
    *position = ftell(stream);
    return *position < 0 ? -1 : 0;
}

int fsetpos(FILE *stream, const fpos_t *position)
{
    return fseek(stream, *position, SEEK_SET);
}

void rewind(FILE *stream)
{
    fseek(stream, 0, SEEK_SET);
    stream->flags &= ~(AT_END | FAILED);
}

void clearerr(FILE *stream)
{
    stream->flags &= ~(AT_END | FAILED);
}

int feof(FILE *stream)
{
    return (stream->flags & AT_END) != 0;
}

int ferror(FILE *stream)
{
    return (stream->flags & FAILED) != 0;
}

int fileno(FILE *stream)
{
    return stream->descriptor;
}
