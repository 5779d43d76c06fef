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

/* What a call waits for. */
struct wait {
    double input_s;                          /* when the input comes, negative if nobody asks */
    int sockets;                             /* number of descriptors that are no files */
    int wanted[CRS_DESCRIPTORS];             /* each of them, see `struct __crs_operations` */
    const struct __crs_operations *operations;
};

static int is_input(const struct __crs_open_file *file)
{
    return file->number < 0 && (file->flags & O_ACCMODE) == O_RDONLY;
}

static void want(struct wait *wait, const struct __crs_open_file *file, int events)
{
    if (wait->sockets == CRS_DESCRIPTORS)
        return;
    wait->operations = file->operations;
    wait->wanted[wait->sockets++] = 4 * file->number + (events & POLLIN ? CRS_RECEIVES : 0)
                                    + (events & POLLOUT ? CRS_SENDS : 0);
}

/* Returns what is possible at once, of POLLIN and POLLOUT, and of what is always of interest;
   otherwise notes what to wait for. When the input is ready is asked for once. */
static int ready_now(struct __crs_open_file *file, int events, struct wait *wait, int may_block)
{
    int ready;

    if (file->operations != 0) {
        ready = file->operations->poll(file) & (events | POLLERR | POLLHUP);
        if (ready == 0)
            want(wait, file, events);
        return ready;
    }
    if (is_input(file) && wait->input_s < 0)
        __crs_input(&wait->input_s);
    if (!is_input(file) || wait->input_s == 0 || (may_block && wait->input_s > FOREVER_S))
        return events & (POLLIN | POLLOUT);
    return 0;
}

/* Waits until something comes or the time is over; returns what is left of it, negative after a
   signal. */
static double wait_until_ready(struct wait *wait, double wait_s)
{
    double nap_s = wait->input_s >= 0 && wait->input_s < wait_s ? wait->input_s : wait_s;
    double left_s, until_s;

    if (wait->sockets == 0) {
        left_s = __crs_pass(nap_s);
        return left_s > 0 ? -(left_s + wait_s - nap_s) : wait_s - nap_s;
    }
    until_s = __crs_now(0) + wait_s;
    if (wait->operations->wait(wait->wanted, wait->sockets, nap_s) < 0)
        return -1;
    left_s = until_s - __crs_now(0);
    return left_s > 0 ? left_s : 0;
}

/* Removes descriptors that are not ready from a set; returns the rest, -1 if one is not open. */
static int keep_ready(int count, fd_set *set, int events, struct wait *wait, int may_block)
{
    struct __crs_open_file *file;
    int descriptor, ready = 0;

    for (descriptor = 0; set != 0 && descriptor < count; descriptor++) {
        if (!FD_ISSET(descriptor, set))
            continue;
        file = __crs_find(descriptor);
        if (file == 0)
            return -1;
        if (ready_now(file, events, wait, may_block))
            ready++;
        else
            FD_CLR(descriptor, set);
    }
    return ready;
}

static void put_time(struct timeval *time, double left_s)
{
    if (time == 0)
        return;
    left_s = __builtin_fabs(left_s);
    time->tv_sec = (time_t)left_s;
    time->tv_usec = (suseconds_t)((left_s - time->tv_sec) * 1e6);
}

/* Waits once if there are only files, and until the time is over if there are sockets. */
static int wait_for(int count, fd_set *readable, fd_set *writable, fd_set *exceptional,
                    struct timeval *timeout)
{
    double left_s = timeout == 0 ? FOREVER_S : timeout->tv_sec + timeout->tv_usec * 1e-6;
    int readers, writers, may_block = timeout == 0, is_over = 0;
    fd_set readable_before, writable_before;
    struct wait wait;

    if (readable != 0)
        readable_before = *readable;
    if (writable != 0)
        writable_before = *writable;
    if (exceptional != 0)
        FD_ZERO(exceptional);
    for (;;) {
        wait.input_s = -1;
        wait.sockets = 0;
        readers = keep_ready(count, readable, POLLIN, &wait, may_block);
        writers = keep_ready(count, writable, POLLOUT, &wait, 1);
        if (readers < 0 || writers < 0)
            return -1;
        if (readers + writers > 0 || is_over)
            return readers + writers;
        left_s = wait_until_ready(&wait, left_s);
        put_time(timeout, left_s);
        if (left_s < 0) {
            errno = EINTR;
            return -1;
        }
        may_block = 0;
        is_over = left_s <= 0 || wait.sockets == 0;
        if (readable != 0)
            *readable = readable_before;
        if (writable != 0)
            *writable = writable_before;
    }
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

static int mark_ready(struct pollfd *files, nfds_t count, struct wait *wait, int may_block)
{
    struct __crs_open_file *file;
    int ready = 0;
    nfds_t i;

    for (i = 0; i < count; i++) {
        files[i].revents = 0;
        if (files[i].fd < 0)
            continue;
        file = __crs_find(files[i].fd);
        files[i].revents = file == 0 ? POLLNVAL
                                     : ready_now(file, files[i].events, wait, may_block);
        ready += files[i].revents != 0;
    }
    return ready;
}

/* The timeout is in milliseconds, and none when it is negative. */
int poll(struct pollfd *files, nfds_t count, int timeout)
{
    double left_s = timeout < 0 ? FOREVER_S : timeout * 1e-3;
    int ready, may_block = timeout < 0, is_over = 0;
    struct wait wait;

    for (;;) {
        wait.input_s = -1;
        wait.sockets = 0;
        ready = mark_ready(files, count, &wait, may_block);
        if (ready > 0 || is_over)
            return ready;
        left_s = wait_until_ready(&wait, left_s);
        if (left_s < 0) {
            errno = EINTR;
            return -1;
        }
        may_block = 0;
        is_over = left_s <= 0 || wait.sockets == 0;
    }
}
