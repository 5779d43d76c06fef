/* Options of sockets (POSIX sys/socket.h, netinet/in.h, netinet/tcp.h). Those that change nothing
   here are kept and returned. */
#include <errno.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <string.h>
#include <sys/time.h>

#include <crs/socket.h>

#define BUFFER 65536
#define FLAGS (1U << SO_DEBUG | 1U << SO_REUSEADDR | 1U << SO_BROADCAST | 1U << SO_KEEPALIVE | \
               1U << SO_DONTROUTE | 1U << SO_OOBINLINE | 1U << SO_REUSEPORT)

static int fail(int number)
{
    errno = number;
    return -1;
}

static int set_time(double *wait_s, const struct timeval *time)
{
    if (time->tv_usec < 0 || time->tv_usec > 999999)
        return fail(EDOM);
    *wait_s = time->tv_sec + time->tv_usec * 1e-6;
    if (*wait_s <= 0)
        *wait_s = __builtin_inf();
    return 0;
}

static int set_own(struct __crs_socket *socket, int name, const void *value, socklen_t size)
{
    switch (name) {
    case SO_RCVTIMEO: case SO_SNDTIMEO:
        if (size < sizeof(struct timeval))
            return fail(EINVAL);
        return set_time(name == SO_RCVTIMEO ? &socket->receive_s : &socket->send_s, value);
    case SO_LINGER:
        if (size < sizeof socket->linger)
            return fail(EINVAL);
        memcpy(&socket->linger, value, sizeof socket->linger);
        return 0;
    case SO_SNDBUF: case SO_RCVBUF:
        return 0;
    }
    if (name < 0 || name > 31 || !(FLAGS >> name & 1))
        return fail(ENOPROTOOPT);
    if (*(const int *)value)
        socket->options |= 1U << name;
    else
        socket->options &= ~(1U << name);
    return 0;
}

int setsockopt(int descriptor, int level, int name, const void *value, socklen_t size)
{
    struct __crs_open_file *file = __crs_find_socket(descriptor);

    if (file == NULL)
        return -1;
    if (value == NULL || size < sizeof(int))
        return fail(value == NULL ? EFAULT : EINVAL);
    if (level == SOL_SOCKET)
        return set_own(__crs_socket_of(file), name, value, size);
    return level == IPPROTO_TCP || level == IPPROTO_IP ? 0 : fail(ENOPROTOOPT);
}

static struct timeval timeval_of(double seconds)
{
    struct timeval time = {0, 0};

    if (seconds < __builtin_inf()) {
        time.tv_sec = (time_t)seconds;
        time.tv_usec = (suseconds_t)((seconds - time.tv_sec) * 1e6 + 0.5);
    }
    return time;
}

/* Returns the value of an option that is a whole number; -1 with errno if there is none. */
static int whole_option(struct __crs_open_file *file, int level, int name)
{
    struct __crs_message message;

    if (level != SOL_SOCKET)
        return level == IPPROTO_TCP || level == IPPROTO_IP ? 0 : fail(ENOPROTOOPT);
    switch (name) {
    case SO_ERROR:
        return __crs_ask_socket(CRS_SOCKET_ERROR, file, &message);
    case SO_TYPE:
        return __crs_socket_of(file)->type;
    case SO_SNDBUF: case SO_RCVBUF:
        return BUFFER;
    }
    if (name < 0 || name > 31 || !(FLAGS >> name & 1))
        return fail(ENOPROTOOPT);
    return __crs_socket_of(file)->options >> name & 1;
}

static int put(const void *from, size_t whole, void *value, socklen_t *size)
{
    if (*size > whole)
        *size = whole;
    memcpy(value, from, *size);
    return 0;
}

int getsockopt(int descriptor, int level, int name, void *value, socklen_t *size)
{
    struct __crs_open_file *file = __crs_find_socket(descriptor);
    struct __crs_socket *socket;
    struct timeval time;
    int whole;

    if (file == NULL)
        return -1;
    socket = __crs_socket_of(file);
    if (level == SOL_SOCKET && name == SO_LINGER)
        return put(&socket->linger, sizeof socket->linger, value, size);
    if (level == SOL_SOCKET && (name == SO_RCVTIMEO || name == SO_SNDTIMEO)) {
        time = timeval_of(name == SO_RCVTIMEO ? socket->receive_s : socket->send_s);
        return put(&time, sizeof time, value, size);
    }
    whole = whole_option(file, level, name);
    return whole < 0 ? -1 : put(&whole, sizeof whole, value, size);
}
