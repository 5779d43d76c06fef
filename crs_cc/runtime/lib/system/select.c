/* Waiting for input (POSIX select and poll). Files and output are always ready. Nobody types at a
   simulated robot while time passes, so a wait for standard input with a timeout is a sleep;
   without one, the input is there. */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/select.h>

#include <crs/clock.h>
#include <crs/descriptor.h>

static int is_input(int descriptor)
{
    struct __crs_open_file *file = __crs_find(descriptor);

    return file != 0 && file->number < 0 && (file->flags & O_ACCMODE) == O_RDONLY;
}

/* Removes descriptors that are not ready from a set; returns the rest, -1 if one is not open. */
static int keep_ready(int count, fd_set *set, int input_too)
{
    int descriptor, ready = 0;

    for (descriptor = 0; set != 0 && descriptor < count; descriptor++) {
        if (!FD_ISSET(descriptor, set))
            continue;
        if (__crs_find(descriptor) == 0)
            return -1;
        if (input_too || !is_input(descriptor))
            ready++;
        else
            FD_CLR(descriptor, set);
    }
    return ready;
}

int select(int count, fd_set *readable, fd_set *writable, fd_set *exceptional,
           struct timeval *timeout)
{
    int readers = keep_ready(count, readable, timeout == 0);
    int writers = keep_ready(count, writable, 1);
    double left_s;

    if (readers < 0 || writers < 0)
        return -1;
    if (exceptional != 0)
        FD_ZERO(exceptional);
    if (readers + writers > 0)
        return readers + writers;
    left_s = __crs_pass(timeout == 0 ? 1e9 : timeout->tv_sec + timeout->tv_usec * 1e-6);
    if (timeout != 0) {
        timeout->tv_sec = (time_t)left_s;
        timeout->tv_usec = (suseconds_t)((left_s - timeout->tv_sec) * 1e6);
    }
    if (left_s == 0)
        return 0;
    errno = EINTR;
    return -1;
}

/* The timeout is in milliseconds, and none when it is negative. */
int poll(struct pollfd *files, nfds_t count, int timeout)
{
    int ready = 0;
    nfds_t i;

    for (i = 0; i < count; i++) {
        files[i].revents = 0;
        if (files[i].fd < 0)
            continue;
        if (__crs_find(files[i].fd) == 0)
            files[i].revents = POLLNVAL;
        else if (timeout < 0 || !is_input(files[i].fd))
            files[i].revents = files[i].events & (POLLIN | POLLOUT);
        ready += files[i].revents != 0;
    }
    if (ready > 0 || __crs_pass(timeout < 0 ? 1e9 : timeout * 1e-3) == 0)
        return ready;
    errno = EINTR;
    return -1;
}
