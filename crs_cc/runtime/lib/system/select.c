/* Waiting for input (POSIX select, pselect and poll). Files and output are always ready, and so is
   the standard input if it is a file or a pipe. The host knows when somebody types; without a
   timeout the programs wait in their next read if he does not know either. */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/select.h>
#include <time.h>

#include <crs/clock.h>
#include <crs/descriptor.h>
#include <crs/signals.h>

#define FOREVER_S 1e9

static int is_input(int descriptor)
{
    struct __crs_open_file *file = __crs_find(descriptor);

    return file != 0 && file->number < 0 && (file->flags & O_ACCMODE) == O_RDONLY;
}

/* Removes descriptors that are not ready from a set; returns the rest, -1 if one is not open.
   When the input is ready, in seconds, is asked for once and kept in *input_s, negative
   before that. */
static int keep_ready(int count, fd_set *set, double *input_s, int may_block)
{
    int descriptor, ready = 0;

    for (descriptor = 0; set != 0 && descriptor < count; descriptor++) {
        if (!FD_ISSET(descriptor, set))
            continue;
        if (__crs_find(descriptor) == 0)
            return -1;
        if (is_input(descriptor) && *input_s < 0)
            __crs_input(input_s);
        if (!is_input(descriptor) || *input_s == 0 || (may_block && *input_s > FOREVER_S))
            ready++;
        else
            FD_CLR(descriptor, set);
    }
    return ready;
}

/* Sleeps until the input comes or the time is over; returns what is left, negative after a
   signal. */
static double sleep_for(double wait_s, double input_s)
{
    double nap_s = input_s >= 0 && input_s < wait_s ? input_s : wait_s;
    double left_s = __crs_pass(nap_s);

    return left_s > 0 ? -(left_s + wait_s - nap_s) : wait_s - nap_s;
}

static int wait_for(int count, fd_set *readable, fd_set *writable, fd_set *exceptional,
                    struct timeval *timeout)
{
    fd_set wanted;
    double input_s = -1, left_s;
    int readers, writers;

    if (readable != 0)
        wanted = *readable;
    readers = keep_ready(count, readable, &input_s, timeout == 0);
    writers = keep_ready(count, writable, &input_s, 1);
    if (readers < 0 || writers < 0)
        return -1;
    if (exceptional != 0)
        FD_ZERO(exceptional);
    if (readers + writers > 0)
        return readers + writers;
    left_s = sleep_for(timeout == 0 ? FOREVER_S : timeout->tv_sec + timeout->tv_usec * 1e-6,
                       input_s);
    if (timeout != 0) {
        timeout->tv_sec = (time_t)__builtin_fabs(left_s);
        timeout->tv_usec = (suseconds_t)((__builtin_fabs(left_s) - timeout->tv_sec) * 1e6);
    }
    if (left_s < 0) {
        errno = EINTR;
        return -1;
    }
    if (input_s < 0 || readable == 0)
        return 0;
    *readable = wanted;
    input_s = -1;
    return keep_ready(count, readable, &input_s, 0);
}

int select(int count, fd_set *readable, fd_set *writable, fd_set *exceptional,
           struct timeval *timeout)
{
    return wait_for(count, readable, writable, exceptional, timeout);
}

int pselect(int count, fd_set *readable, fd_set *writable, fd_set *exceptional,
            const struct timespec *timeout, const sigset_t *mask)
{
    struct timeval wait;
    sigset_t before = 0;
    int ready;

    if (timeout != 0) {
        wait.tv_sec = timeout->tv_sec;
        wait.tv_usec = timeout->tv_nsec / 1000;
    }
    if (mask != 0)
        before = __crs_swap_mask(*mask);
    ready = wait_for(count, readable, writable, exceptional, timeout == 0 ? 0 : &wait);
    if (mask != 0)
        __crs_swap_mask(before);
    return ready;
}

static int mark_ready(struct pollfd *files, nfds_t count, double *input_s, int may_block)
{
    int ready = 0;
    nfds_t i;

    for (i = 0; i < count; i++) {
        files[i].revents = 0;
        if (files[i].fd < 0)
            continue;
        if (is_input(files[i].fd) && *input_s < 0)
            __crs_input(input_s);
        if (__crs_find(files[i].fd) == 0)
            files[i].revents = POLLNVAL;
        else if (!is_input(files[i].fd) || *input_s == 0 || (may_block && *input_s > FOREVER_S))
            files[i].revents = files[i].events & (POLLIN | POLLOUT);
        ready += files[i].revents != 0;
    }
    return ready;
}

/* The timeout is in milliseconds, and none when it is negative. */
int poll(struct pollfd *files, nfds_t count, int timeout)
{
    double input_s = -1;
    int ready = mark_ready(files, count, &input_s, timeout < 0);

    if (ready > 0)
        return ready;
    if (sleep_for(timeout < 0 ? FOREVER_S : timeout * 1e-3, input_s) < 0) {
        errno = EINTR;
        return -1;
    }
    input_s = -1;
    return mark_ready(files, count, &input_s, 0);
}
