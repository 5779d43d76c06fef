/* Reading and writing several pieces at once (POSIX sys/uio.h). */
#include <sys/uio.h>

#include <crs/descriptor.h>

/* Ends at the first piece that is not filled. */
ssize_t readv(int descriptor, const struct iovec *pieces, int count)
{
    size_t done = 0, filled;
    int i, size;

    for (i = 0; i < count; i++)
        for (filled = 0; filled < pieces[i].iov_len; filled += size) {
            size = __crs_read(descriptor, (char *)pieces[i].iov_base + filled,
                              pieces[i].iov_len - filled);
            if (size < 0)
                return done > 0 ? (ssize_t)done : -1;
            if (size == 0)
                return done;
            done += size;
        }
    return done;
}

ssize_t writev(int descriptor, const struct iovec *pieces, int count)
{
    size_t done = 0;
    int i;

    for (i = 0; i < count; i++) {
        if (__crs_put(descriptor, pieces[i].iov_base, pieces[i].iov_len) < 0)
            return done > 0 ? (ssize_t)done : -1;
        done += pieces[i].iov_len;
    }
    return done;
}
