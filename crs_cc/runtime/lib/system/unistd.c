/* What a control program can have of POSIX unistd.h. */
#include <crs_request.h>
#include <errno.h>
#include <unistd.h>

#include <crs/write.h>

ssize_t read(int descriptor, void *bytes, size_t size)
{
    struct __crs_message message;
    int result;

    if (descriptor != 0) {
        errno = EBADF;
        return -1;
    }
    if (size == 0)
        return 0;
    message.i[0] = descriptor;
    message.i[1] = size < CRS_DATA_SIZE ? size : CRS_DATA_SIZE;
    result = __crs_request(CRS_READ, &message);
    if (result < 0) {
        errno = EIO;
        return -1;
    }
    __builtin_memcpy(bytes, message.data, result);
    return result;
}

ssize_t write(int descriptor, const void *bytes, size_t size)
{
    if (descriptor != 1 && descriptor != 2) {
        errno = EBADF;
        return -1;
    }
    return __crs_write(descriptor, bytes, size) < 0 ? -1 : (ssize_t)size;
}

/* The streams are never a terminal, whatever the host does with them. */
int isatty(int descriptor)
{
    errno = descriptor >= 0 && descriptor <= 2 ? ENOTTY : EBADF;
    return 0;
}

/* A program is the only one of its machine. */
pid_t getpid(void)
{
    return 1;
}
