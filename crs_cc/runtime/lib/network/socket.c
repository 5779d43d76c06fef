/* Sockets as descriptors (POSIX sys/socket.h), and waiting for them. */
#include <errno.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <signal.h>
#include <string.h>

#include <crs/clock.h>
#include <crs/signals.h>
#include <crs/socket.h>

#define TYPE_FLAGS (SOCK_NONBLOCK | SOCK_CLOEXEC)

static struct __crs_socket sockets[CRS_DESCRIPTORS];

static int fail(int number)
{
    errno = number;
    return -1;
}

int __crs_ask_socket(int code, struct __crs_open_file *file, struct __crs_message *message)
{
    int result;

    message->i[0] = file->number;
    result = __crs_request(code, message);
    return result < 0 ? fail(-result) : result;
}

static int simple(int code, struct __crs_open_file *file)
{
    struct __crs_message message;

    return __crs_ask_socket(code, file, &message);
}

/* Its place among the sockets is free for another one. */
static int close_socket(struct __crs_open_file *file)
{
    sockets[file->offset].family = 0;
    return simple(CRS_SOCKET_CLOSE, file);
}

static int poll_socket(struct __crs_open_file *file)
{
    int ready = simple(CRS_SOCKET_POLL, file);

    return ready < 0 ? POLLERR : ready;
}

static int available(struct __crs_open_file *file)
{
    struct __crs_message message;

    message.i[1] = message.i[2] = 0;
    message.i[3] = 1;
    return __crs_ask_socket(CRS_SOCKET_RECEIVE, file, &message) < 0 ? 0 : message.i[3];
}

static const struct __crs_operations operations = {
    __crs_read_socket, __crs_write_socket, close_socket, available, poll_socket,
    __crs_wait_for_sockets,
};

struct __crs_open_file *__crs_find_socket(int descriptor)
{
    struct __crs_open_file *file = __crs_find(descriptor);

    if (file == NULL || file->operations == &operations)
        return file;
    errno = ENOTSOCK;
    return NULL;
}

struct __crs_socket *__crs_socket_of(struct __crs_open_file *file)
{
    return &sockets[file->offset];
}

int __crs_install_socket(int family, int type, int number, int flags)
{
    static const struct __crs_socket fresh = {
        0, 0, 0, {0, 0}, __builtin_inf(), __builtin_inf(),
    };
    struct __crs_open_file closed = {.number = number};
    int descriptor = __crs_install(&operations, number, O_RDWR | flags), i;

    if (descriptor < 0) {
        simple(CRS_SOCKET_CLOSE, &closed);
        return fail(EMFILE);
    }
    for (i = 0; sockets[i].family != 0; i++)
        ;
    sockets[i] = fresh;
    sockets[i].family = family;
    sockets[i].type = type;
    __crs_find(descriptor)->offset = i;
    return descriptor;
}

static int file_flags(int type)
{
    return type & SOCK_NONBLOCK ? O_NONBLOCK : 0;
}

int socket(int domain, int type, int protocol)
{
    struct __crs_message message;
    int number, kind = type & ~TYPE_FLAGS;

    if (protocol != 0 && protocol != (kind == SOCK_STREAM ? IPPROTO_TCP : IPPROTO_UDP))
        return fail(EPROTONOSUPPORT);
    message.i[0] = domain;
    message.i[1] = kind;
    number = __crs_request(CRS_SOCKET_OPEN, &message);
    if (number < 0)
        return fail(-number);
    return __crs_install_socket(domain, kind, number, file_flags(type));
}

int socketpair(int domain, int type, int protocol, int descriptors[2])
{
    struct __crs_message message;
    int first, number, kind = type & ~TYPE_FLAGS;

    if (domain != AF_UNIX || protocol != 0)
        return fail(domain == AF_INET ? EOPNOTSUPP : EAFNOSUPPORT);
    message.i[0] = kind;
    number = __crs_request(CRS_SOCKET_PAIR, &message);
    if (number < 0)
        return fail(-number);
    first = __crs_install_socket(AF_UNIX, kind, number, file_flags(type));
    descriptors[1] = __crs_install_socket(AF_UNIX, kind, message.i[0], file_flags(type));
    descriptors[0] = first;
    if (descriptors[1] >= 0)
        return 0;
    if (first >= 0)
        __crs_close(first);
    return fail(EMFILE);
}

/* An alarm ends the wait; it is set anew, or off, when it has been delivered. */
int __crs_wait_for_sockets(const int *wanted, int count, double wait_s)
{
    struct __crs_message message;
    double alarm_s;

    if (count > CRS_DATA_SIZE / (int)sizeof *wanted)
        return fail(EINVAL);
    if (__crs_after_request != 0) {
        __crs_after_request();
        alarm_s = __crs_alarm_s;
        if (alarm_s < __builtin_inf()) {
            alarm_s -= __crs_now(NULL);
            wait_s = alarm_s < wait_s ? alarm_s : wait_s;
        }
        alarm_s = __crs_alarm_s;
    }
    message.f[0] = wait_s;
    message.size = count * sizeof *wanted;
    memcpy(message.data, wanted, message.size);
    __crs_request(CRS_SOCKET_WAIT, &message);
    if (__crs_after_request == 0)
        return 0;
    __crs_after_request();
    return __crs_alarm_s == alarm_s ? 0 : fail(EINTR);
}

int __crs_attempt(int code, struct __crs_open_file *file, struct __crs_message *message,
                  int wanted, int flags)
{
    struct __crs_socket *socket = __crs_socket_of(file);
    double left_s = wanted == CRS_SENDS ? socket->send_s : socket->receive_s, until_s = left_s;
    int is_waiting = !(file->flags & O_NONBLOCK) && !(flags & MSG_DONTWAIT), result;
    struct __crs_message asked = *message;

    if (is_waiting && left_s < __builtin_inf())
        until_s = __crs_now(NULL) + left_s;
    wanted += 4 * file->number;
    for (;;) {
        result = __crs_ask_socket(code, file, message);
        if (result >= 0 || errno != EAGAIN || !is_waiting)
            return result;
        if (until_s < __builtin_inf() && (left_s = until_s - __crs_now(NULL)) <= 0)
            return fail(EAGAIN);
        if (__crs_wait_for_sockets(&wanted, 1, left_s) < 0 && !__crs_restarts(SIGALRM))
            return -1;
        *message = asked;
    }
}
