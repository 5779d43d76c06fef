/* Files and the state of streams (C17 7.21.4, 7.21.5, 7.21.9, 7.21.10). A control program has no
   files: opening one fails as on a read-only, empty disk. */
#include <errno.h>

#include <crs/stream.h>

static void *refuse(const char *mode)
{
    errno = *mode == 'r' ? ENOENT : EROFS;
    return NULL;
}

FILE *fopen(const char *name, const char *mode)
{
    (void)name;
    return refuse(mode);
}

FILE *freopen(const char *name, const char *mode, FILE *stream)
{
    (void)name;
    fclose(stream);
    return refuse(mode);
}

FILE *fdopen(int descriptor, const char *mode)
{
    (void)mode;
    if (descriptor == 0)
        return stdin;
    if (descriptor == 1 || descriptor == 2)
        return descriptor == 1 ? stdout : stderr;
    errno = EBADF;
    return NULL;
}

FILE *tmpfile(void)
{
    return refuse("w");
}

int remove(const char *name)
{
    (void)name;
    errno = ENOENT;
    return -1;
}

int rename(const char *from, const char *to)
{
    (void)from;
    (void)to;
    errno = ENOENT;
    return -1;
}

int fclose(FILE *stream)
{
    int result = __crs_flush(stream);

    stream->flags = 0;
    stream->begin = stream->end = 0;
    return result;
}

int fflush(FILE *stream)
{
    if (stream != NULL)
        return __crs_flush(stream);
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

void setlinebuf(FILE *stream)
{
    setvbuf(stream, NULL, _IOLBF, 0);
}

/* The standard streams cannot be positioned, as if they were a terminal or a pipe. */
static int no_position(void)
{
    errno = ESPIPE;
    return -1;
}

int fseek(FILE *stream, long offset, int whence)
{
    (void)stream;
    (void)offset;
    (void)whence;
    return no_position();
}

long ftell(FILE *stream)
{
    (void)stream;
    return no_position();
}

int fgetpos(FILE *stream, fpos_t *position)
{
    (void)stream;
    (void)position;
    return no_position();
}

int fsetpos(FILE *stream, const fpos_t *position)
{
    (void)stream;
    (void)position;
    return no_position();
}

void rewind(FILE *stream)
{
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
