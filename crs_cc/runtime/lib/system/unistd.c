/* Files by descriptors (POSIX unistd.h and fcntl.h). */
#include <crs_request.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <string.h>
#include <unistd.h>

#include <crs/descriptor.h>

int open(const char *name, int flags, ...)
{
    return __crs_open(name, flags & ~O_TMPFILE);
}

int creat(const char *name, mode_t mode)
{
    (void)mode;
    return __crs_open(name, O_WRONLY | O_CREAT | O_TRUNC);
}

int close(int descriptor)
{
    return __crs_close(descriptor);
}

/* A file returns all requested bytes, a stream those available. */
static ssize_t take(int descriptor, void *bytes, size_t size)
{
    struct __crs_open_file *file = __crs_find(descriptor);
    char *to = bytes;
    int piece;

    if (file == NULL)
        return -1;
    if (file->operations != NULL)
        return __crs_read(descriptor, bytes, size);
    do {
        piece = __crs_read(descriptor, to, size < CRS_DATA_SIZE ? size : CRS_DATA_SIZE);
        if (piece < 0)
            return -1;
        to += piece;
        size -= piece;
    } while (file->number >= 0 && piece > 0 && size > 0);
    return to - (char *)bytes;
}

ssize_t read(int descriptor, void *bytes, size_t size)
{
    return take(descriptor, bytes, size);
}

ssize_t write(int descriptor, const void *bytes, size_t size)
{
    struct __crs_open_file *file = __crs_find(descriptor);

    if (file != NULL && file->operations != NULL)
        return file->operations->write(file, bytes, size);
    return __crs_put(descriptor, bytes, size) < 0 ? -1 : (ssize_t)size;
}

off_t lseek(int descriptor, off_t offset, int whence)
{
    return __crs_seek(descriptor, offset, whence);
}

ssize_t pread(int descriptor, void *bytes, size_t size, off_t offset)
{
    off_t before = __crs_seek(descriptor, 0, SEEK_CUR);
    ssize_t result;

    if (before < 0 || __crs_seek(descriptor, offset, SEEK_SET) < 0)
        return -1;
    result = take(descriptor, bytes, size);
    __crs_seek(descriptor, before, SEEK_SET);
    return result;
}

ssize_t pwrite(int descriptor, const void *bytes, size_t size, off_t offset)
{
    off_t before = __crs_seek(descriptor, 0, SEEK_CUR);
    ssize_t result;

    if (before < 0 || __crs_seek(descriptor, offset, SEEK_SET) < 0)
        return -1;
    result = __crs_put(descriptor, bytes, size) < 0 ? -1 : (ssize_t)size;
    __crs_seek(descriptor, before, SEEK_SET);
    return result;
}

static int resize(int descriptor, off_t size)
{
    if (size < 0) {
        errno = EINVAL;
        return -1;
    }
    return __crs_resize(descriptor, size) < 0 ? -1 : 0;
}

int ftruncate(int descriptor, off_t size)
{
    return resize(descriptor, size);
}

int truncate(const char *name, off_t size)
{
    int descriptor = __crs_open(name, O_WRONLY), result;

    if (descriptor < 0)
        return -1;
    result = resize(descriptor, size);
    __crs_close(descriptor);
    return result;
}

int dup(int descriptor)
{
    return __crs_duplicate(descriptor, 0);
}

int dup2(int descriptor, int wanted)
{
    if (__crs_find(descriptor) == NULL)
        return -1;
    if (wanted == descriptor)
        return wanted;
    if (wanted >= 0 && wanted < CRS_DESCRIPTORS)
        __crs_close(wanted);
    return __crs_duplicate(descriptor, wanted);
}

int fcntl(int descriptor, int command, ...)
{
    struct __crs_open_file *file = __crs_find(descriptor);
    va_list arguments;
    int argument;

    if (file == NULL)
        return -1;
    va_start(arguments, command);
    argument = command == F_DUPFD || command == F_SETFL ? va_arg(arguments, int) : 0;
    va_end(arguments);
    switch (command) {
    case F_DUPFD:
        return __crs_duplicate(descriptor, argument);
    case F_GETFL:
        return file->flags & ~(O_CREAT | O_EXCL | O_TRUNC);
    case F_SETFL:
        file->flags = (file->flags & O_ACCMODE) | (argument & ~O_ACCMODE);
        return 0;
    case F_GETFD: case F_SETFD:
        return 0;
    }
    errno = EINVAL;
    return -1;
}

/* Writes reach the host immediately. */
int fsync(int descriptor)
{
    return __crs_find(descriptor) == NULL ? -1 : 0;
}

int fdatasync(int descriptor)
{
    return __crs_find(descriptor) == NULL ? -1 : 0;
}

void sync(void)
{
}

/* The streams are never a terminal, whatever the host does with them. */
int isatty(int descriptor)
{
    if (__crs_find(descriptor) != NULL)
        errno = ENOTTY;
    return 0;
}

char *ttyname(int descriptor)
{
    if (__crs_find(descriptor) != NULL)
        errno = ENOTTY;
    return NULL;
}

int unlink(const char *name)
{
    return __crs_by_name(CRS_FILE_REMOVE, name, 0);
}
