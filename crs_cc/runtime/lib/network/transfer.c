/* Sending and receiving (POSIX sys/socket.h). A request has room for a piece of what is sent. */
#include <errno.h>
#include <netinet/in.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

#include <crs/signals.h>
#include <crs/socket.h>

#define SUBNET_BROADCAST 0x0affffff   /* 10.255.255.255 */

static int fail(int number)
{
    errno = number;
    return -1;
}

static int least(size_t size, size_t most)
{
    return size < most ? size : most;
}

/* A broken connection also raises SIGPIPE, whose default is to end the program. */
static int broken(int flags)
{
    if (errno == EPIPE && !(flags & MSG_NOSIGNAL)) {
        __crs_signal(SIGPIPE);
        errno = EPIPE;
    }
    return -1;
}

/* Returns when all bytes are sent, or as many as can be without waiting. */
static ssize_t send_stream(struct __crs_open_file *file, const char *bytes, size_t size, int flags)
{
    struct __crs_message message;
    size_t sent = 0;
    int count;

    do {
        message.i[1] = message.i[2] = message.i[3] = message.i[4] = 0;
        message.size = least(size - sent, CRS_DATA_SIZE);
        memcpy(message.data, bytes + sent, message.size);
        count = __crs_attempt(CRS_SOCKET_SEND, file, &message, CRS_SENDS, flags);
        if (count < 0)
            return sent > 0 ? (ssize_t)sent : broken(flags);
        sent += count;
    } while (sent < size);
    return sent;
}

static int may_broadcast(struct __crs_open_file *file, unsigned address)
{
    if ((address != INADDR_BROADCAST && address != SUBNET_BROADCAST)
        || __crs_socket_of(file)->options >> SO_BROADCAST & 1)
        return 1;
    errno = EACCES;
    return 0;
}

static ssize_t send_datagram(struct __crs_open_file *file, const char *bytes, size_t size,
                             int flags, const struct sockaddr *address, socklen_t address_size)
{
    struct __crs_message message;
    int where[2] = {0, 0};
    size_t sent = 0;

    if (address != NULL) {
        if (address->sa_family == AF_UNIX)
            return fail(EOPNOTSUPP);
        if (__crs_put_address(file, &message, address, address_size) < 0)
            return -1;
        where[0] = message.i[1];
        where[1] = message.i[2];
        if (!may_broadcast(file, where[0]))
            return -1;
    }
    do {
        message.i[1] = where[0];
        message.i[2] = where[1];
        message.i[3] = address != NULL;
        message.size = least(size - sent, CRS_DATA_SIZE);
        message.i[4] = sent + message.size < size;
        memcpy(message.data, bytes + sent, message.size);
        sent += message.size;
        if (__crs_attempt(CRS_SOCKET_SEND, file, &message, CRS_SENDS, flags) < 0)
            return broken(flags);
    } while (sent < size);
    return size;
}

static ssize_t send_all(struct __crs_open_file *file, const void *bytes, size_t size, int flags,
                        const struct sockaddr *address, socklen_t address_size)
{
    if (flags & MSG_OOB)
        return fail(EOPNOTSUPP);
    if (__crs_socket_of(file)->type == SOCK_DGRAM)
        return send_datagram(file, bytes, size, flags, address, address_size);
    return send_stream(file, bytes, size, flags);
}

static ssize_t send_from(int descriptor, const void *bytes, size_t size, int flags,
                         const struct sockaddr *address, socklen_t address_size)
{
    struct __crs_open_file *file = __crs_find_socket(descriptor);

    return file == NULL ? -1 : send_all(file, bytes, size, flags, address, address_size);
}

ssize_t sendto(int descriptor, const void *bytes, size_t size, int flags,
               const struct sockaddr *address, socklen_t address_size)
{
    return send_from(descriptor, bytes, size, flags, address, address_size);
}

ssize_t send(int descriptor, const void *bytes, size_t size, int flags)
{
    return send_from(descriptor, bytes, size, flags, NULL, 0);
}

int __crs_write_socket(struct __crs_open_file *file, const void *bytes, int size)
{
    return send_all(file, bytes, size, 0, NULL, 0);
}

/* Returns what is there, but at least a byte unless it is the end; with MSG_WAITALL all. */
static ssize_t receive_stream(struct __crs_open_file *file, char *bytes, size_t size, int flags)
{
    struct __crs_message message;
    size_t got = 0;
    int count, piece, is_peeking = (flags & MSG_PEEK) != 0;

    while (got < size) {
        message.i[1] = is_peeking ? got : 0;
        piece = message.i[2] = least(size - got, CRS_DATA_SIZE);
        message.i[3] = is_peeking;
        count = __crs_attempt(CRS_SOCKET_RECEIVE, file, &message, CRS_RECEIVES,
                              got > 0 && !(flags & MSG_WAITALL) ? flags | MSG_DONTWAIT : flags);
        if (count < 0 && got == 0)
            return -1;
        if (count <= 0)
            break;
        memcpy(bytes + got, message.data, count);
        got += count;
        if (count < piece && (is_peeking || !(flags & MSG_WAITALL)))
            break;
    }
    return got;
}

/* Returns as much of a datagram as there is room for; the rest of it is lost. */
static ssize_t receive_datagram(struct __crs_open_file *file, char *bytes, size_t size, int flags,
                                struct sockaddr *address, socklen_t *address_size)
{
    struct __crs_message message;
    int count, length, stays = (flags & MSG_PEEK) != 0;
    size_t got = 0;

    do {
        message.i[1] = got;
        message.i[2] = least(size - got, CRS_DATA_SIZE);
        message.i[3] = stays || size > CRS_DATA_SIZE;
        count = __crs_attempt(CRS_SOCKET_RECEIVE, file, &message, CRS_RECEIVES, flags);
        if (count < 0)
            return -1;
        memcpy(bytes + got, message.data, count);
        got += count;
    } while (count == CRS_DATA_SIZE && got < size);
    length = message.i[3];
    message.size = 0;
    __crs_take_address(file, &message, address, address_size);
    if (!stays && size > CRS_DATA_SIZE) {
        message.i[1] = message.i[2] = message.i[3] = 0;
        __crs_ask_socket(CRS_SOCKET_RECEIVE, file, &message);
    }
    return flags & MSG_TRUNC ? length : (ssize_t)got;
}

static ssize_t receive(struct __crs_open_file *file, void *bytes, size_t size, int flags,
                       struct sockaddr *address, socklen_t *address_size)
{
    if (flags & MSG_OOB)
        return fail(EINVAL);
    if (__crs_socket_of(file)->type == SOCK_DGRAM)
        return receive_datagram(file, bytes, size, flags, address, address_size);
    if (address_size != NULL)
        *address_size = 0;   /* as Linux does: the other end is known */
    return receive_stream(file, bytes, size, flags);
}

static ssize_t receive_at(int descriptor, void *bytes, size_t size, int flags,
                          struct sockaddr *address, socklen_t *address_size)
{
    struct __crs_open_file *file = __crs_find_socket(descriptor);

    return file == NULL ? -1 : receive(file, bytes, size, flags, address, address_size);
}

ssize_t recvfrom(int descriptor, void *bytes, size_t size, int flags,
                 struct sockaddr *address, socklen_t *address_size)
{
    return receive_at(descriptor, bytes, size, flags, address, address_size);
}

ssize_t recv(int descriptor, void *bytes, size_t size, int flags)
{
    return receive_at(descriptor, bytes, size, flags, NULL, NULL);
}

int __crs_read_socket(struct __crs_open_file *file, void *bytes, int size)
{
    return receive(file, bytes, size, 0, NULL, NULL);
}

static size_t whole_size(const struct msghdr *message)
{
    size_t size = 0, i;

    for (i = 0; i < message->msg_iovlen; i++)
        size += message->msg_iov[i].iov_len;
    return size;
}

ssize_t sendmsg(int descriptor, const struct msghdr *message, int flags)
{
    size_t size = whole_size(message), at = 0, i;
    char *bytes = malloc(size + 1);
    ssize_t sent;

    if (bytes == NULL)
        return fail(ENOBUFS);
    for (i = 0; i < message->msg_iovlen; i++) {
        memcpy(bytes + at, message->msg_iov[i].iov_base, message->msg_iov[i].iov_len);
        at += message->msg_iov[i].iov_len;
    }
    sent = send_from(descriptor, bytes, size, flags, message->msg_name, message->msg_namelen);
    free(bytes);
    return sent;
}

ssize_t recvmsg(int descriptor, struct msghdr *message, int flags)
{
    size_t size = whole_size(message), at = 0, i;
    char *bytes = malloc(size + 1);
    ssize_t got;

    if (bytes == NULL)
        return fail(ENOBUFS);
    got = receive_at(descriptor, bytes, size, flags & ~MSG_TRUNC, message->msg_name,
                     message->msg_name == NULL ? NULL : &message->msg_namelen);
    for (i = 0; got > 0 && i < message->msg_iovlen && at < (size_t)got; i++) {
        size_t piece = least(got - at, message->msg_iov[i].iov_len);
        memcpy(message->msg_iov[i].iov_base, bytes + at, piece);
        at += piece;
    }
    message->msg_controllen = 0;
    message->msg_flags = 0;
    free(bytes);
    return got;
}
