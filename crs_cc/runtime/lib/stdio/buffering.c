/* Buffering (C17 7.21.5; setlinebuf, setbuffer, fpurge: BSD). */
#include <crs/stream.h>

int fflush(FILE *stream)
{
    if (stream != NULL)
        return stream->flags & OUTPUT ? __crs_flush(stream) : 0;
    __crs_flush_all();
    return 0;
}

/* The caller's buffer may be used (C17 7.21.5.6p2); it is not, only the mode changes. */
int setvbuf(FILE *stream, char *buffer, int mode, size_t size)
{
    (void)buffer;
    (void)size;
    if (mode < _IOFBF || mode > _IONBF)
        return -1;
    if (__crs_flush(stream) < 0)
        return -1;
    stream->mode = mode;
    return 0;
}

void setbuf(FILE *stream, char *buffer)
{
    setvbuf(stream, buffer, buffer != NULL ? _IOFBF : _IONBF, BUFSIZ);
}

void setbuffer(FILE *stream, char *buffer, size_t size)
{
    setvbuf(stream, buffer, buffer != NULL ? _IOFBF : _IONBF, size);
}

void setlinebuf(FILE *stream)
{
    setvbuf(stream, NULL, _IOLBF, 0);
}
