/* Sockets (POSIX sys/socket.h), which a simulated robot's program does not have. */
#include <errno.h>
#include <sys/socket.h>

#include <crs/refuse.h>

UNAVAILABLE(int, socket, (int domain, int type, int protocol), -1, EACCES)
UNAVAILABLE(int, socketpair, (int domain, int type, int protocol, int descriptors[2]), -1, EACCES)

/* No descriptor is a socket. */
#define NO_SOCKET(type, name, parameters)   \
    type name parameters                    \
    {                                       \
        errno = ENOTSOCK;                   \
        return -1;                          \
    }

NO_SOCKET(int, bind, (int descriptor, const struct sockaddr *address, socklen_t size))
NO_SOCKET(int, connect, (int descriptor, const struct sockaddr *address, socklen_t size))
NO_SOCKET(int, listen, (int descriptor, int backlog))
NO_SOCKET(int, accept, (int descriptor, struct sockaddr *address, socklen_t *size))
NO_SOCKET(int, getsockname, (int descriptor, struct sockaddr *address, socklen_t *size))
NO_SOCKET(int, getpeername, (int descriptor, struct sockaddr *address, socklen_t *size))
NO_SOCKET(int, getsockopt,
          (int descriptor, int level, int name, void *value, socklen_t *size))
NO_SOCKET(int, setsockopt,
          (int descriptor, int level, int name, const void *value, socklen_t size))
NO_SOCKET(int, shutdown, (int descriptor, int how))
NO_SOCKET(ssize_t, send, (int descriptor, const void *bytes, size_t size, int flags))
NO_SOCKET(ssize_t, sendto,
          (int descriptor, const void *bytes, size_t size, int flags,
           const struct sockaddr *address, socklen_t address_size))
NO_SOCKET(ssize_t, sendmsg, (int descriptor, const struct msghdr *message, int flags))
NO_SOCKET(ssize_t, recv, (int descriptor, void *bytes, size_t size, int flags))
NO_SOCKET(ssize_t, recvfrom,
          (int descriptor, void *bytes, size_t size, int flags,
           struct sockaddr *address, socklen_t *address_size))
NO_SOCKET(ssize_t, recvmsg, (int descriptor, struct msghdr *message, int flags))
