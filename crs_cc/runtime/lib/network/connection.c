/* Addresses of sockets, and connections (POSIX sys/socket.h). */
#include <byteswap.h>
#include <errno.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <signal.h>
#include <stddef.h>
#include <string.h>
#include <sys/un.h>

#include <crs/signals.h>
#include <crs/socket.h>

#define PATH_AT offsetof(struct sockaddr_un, sun_path)

static int fail(int number)
{
    errno = number;
    return -1;
}

/* A name of a local socket ends at its first null byte, but for one that begins with it. */
static int put_path(struct __crs_message *message, const struct sockaddr_un *address,
                    socklen_t size)
{
    size_t room = size - PATH_AT;
    const char *end;

    if (size <= PATH_AT || size > sizeof *address)
        return fail(EINVAL);
    end = address->sun_path[0] == '\0' ? NULL : memchr(address->sun_path, '\0', room);
    message->size = end == NULL ? room : (size_t)(end - address->sun_path);
    memcpy(message->data, address->sun_path, message->size);
    return 0;
}

int __crs_put_address(struct __crs_open_file *file, struct __crs_message *message,
                      const struct sockaddr *address, socklen_t size)
{
    const struct sockaddr_in *internet = (const struct sockaddr_in *)address;

    message->i[1] = message->i[2] = message->size = 0;
    if (address == NULL)
        return fail(EFAULT);
    if (size < sizeof address->sa_family)
        return fail(EINVAL);
    if (address->sa_family != __crs_socket_of(file)->family)
        return fail(EAFNOSUPPORT);
    if (address->sa_family == AF_UNIX)
        return put_path(message, (const struct sockaddr_un *)address, size);
    if (size < sizeof *internet)
        return fail(EINVAL);
    message->i[1] = bswap_32(internet->sin_addr.s_addr);
    message->i[2] = bswap_16(internet->sin_port);
    return 0;
}

void __crs_take_address(struct __crs_open_file *file, const struct __crs_message *message,
                        struct sockaddr *address, socklen_t *size)
{
    struct sockaddr_un local = {AF_UNIX, {0}};
    struct sockaddr_in internet = {
        AF_INET, bswap_16(message->i[2]), {bswap_32(message->i[1])}, {0},
    };
    int is_local = __crs_socket_of(file)->family == AF_UNIX;
    size_t whole = sizeof internet;

    if (address == NULL || size == NULL)
        return;
    if (is_local) {
        memcpy(local.sun_path, message->data, message->size);
        whole = PATH_AT + message->size;
        if (message->size > 0 && local.sun_path[0] != '\0' && whole < sizeof local)
            whole++;
    }
    memcpy(address, is_local ? (void *)&local : (void *)&internet, *size < whole ? *size : whole);
    *size = whole;
}

/* Posts a request with an address. */
static int by_address(int code, int descriptor, const struct sockaddr *address, socklen_t size)
{
    struct __crs_open_file *file = __crs_find_socket(descriptor);
    struct __crs_message message;

    if (file == NULL || __crs_put_address(file, &message, address, size) < 0)
        return -1;
    return __crs_ask_socket(code, file, &message);
}

int bind(int descriptor, const struct sockaddr *address, socklen_t size)
{
    return by_address(CRS_SOCKET_BIND, descriptor, address, size);
}

int listen(int descriptor, int backlog)
{
    struct __crs_open_file *file = __crs_find_socket(descriptor);
    struct __crs_message message;

    message.i[1] = backlog;
    return file == NULL ? -1 : __crs_ask_socket(CRS_SOCKET_LISTEN, file, &message);
}

/* Stores a socket's own address, or that of the other end. */
static int get_name(int descriptor, int which, struct sockaddr *address, socklen_t *size)
{
    struct __crs_open_file *file = __crs_find_socket(descriptor);
    struct __crs_message message;

    message.i[1] = which;
    if (file == NULL || __crs_ask_socket(CRS_SOCKET_NAME, file, &message) < 0)
        return -1;
    __crs_take_address(file, &message, address, size);
    return 0;
}

static int take_connection(int descriptor, struct sockaddr *address, socklen_t *size, int flags)
{
    struct __crs_open_file *file = __crs_find_socket(descriptor);
    struct __crs_message message;
    int number, made;

    if (file == NULL || (number = __crs_attempt(CRS_SOCKET_ACCEPT, file, &message,
                                                CRS_RECEIVES, 0)) < 0)
        return -1;
    made = __crs_install_socket(__crs_socket_of(file)->family, SOCK_STREAM, number,
                                flags & SOCK_NONBLOCK ? O_NONBLOCK : 0);
    if (made >= 0 && address != NULL)
        get_name(made, 1, address, size);
    return made;
}

int accept4(int descriptor, struct sockaddr *address, socklen_t *size, int flags)
{
    return take_connection(descriptor, address, size, flags);
}

int accept(int descriptor, struct sockaddr *address, socklen_t *size)
{
    return take_connection(descriptor, address, size, 0);
}

/* Waits until a connection is made or has failed: to connect again tells which. After a signal it
   goes on being made. */
static int finish_connecting(struct __crs_open_file *file)
{
    int wanted = 4 * file->number + CRS_SENDS;

    while (file->operations->poll(file) == 0)
        if (__crs_wait_for_sockets(&wanted, 1, __crs_socket_of(file)->send_s) < 0
            && !__crs_restarts(SIGALRM))
            return -1;
    return 0;
}

/* AF_UNSPEC takes away where the datagrams of a socket go. */
int connect(int descriptor, const struct sockaddr *address, socklen_t size)
{
    struct __crs_open_file *file = __crs_find_socket(descriptor);
    struct sockaddr_in nowhere = {AF_INET, 0, {0}, {0}};

    if (file == NULL)
        return -1;
    if (address != NULL && size >= sizeof address->sa_family && address->sa_family == AF_UNSPEC
        && __crs_socket_of(file)->type == SOCK_DGRAM) {
        address = (struct sockaddr *)&nowhere;
        size = sizeof nowhere;
    }
    if (by_address(CRS_SOCKET_CONNECT, descriptor, address, size) == 0)
        return 0;
    if (errno != EINPROGRESS || file->flags & O_NONBLOCK)
        return -1;
    if (finish_connecting(file) < 0)
        return -1;
    return by_address(CRS_SOCKET_CONNECT, descriptor, address, size);
}

int shutdown(int descriptor, int how)
{
    struct __crs_open_file *file = __crs_find_socket(descriptor);
    struct __crs_message message;

    message.i[1] = how;
    return file == NULL ? -1 : __crs_ask_socket(CRS_SOCKET_SHUTDOWN, file, &message);
}

int getsockname(int descriptor, struct sockaddr *address, socklen_t *size)
{
    return get_name(descriptor, 0, address, size);
}

int getpeername(int descriptor, struct sockaddr *address, socklen_t *size)
{
    return get_name(descriptor, 1, address, size);
}
