/* Sockets, for the library itself. */
#ifndef CRS_SOCKET_H
#define CRS_SOCKET_H

#include <crs_request.h>
#include <sys/socket.h>

#include <crs/descriptor.h>

/* What the library knows of a socket; the host has all else. */
struct __crs_socket {
    int family, type;
    unsigned options;      /* bits of the numbers of SO_ options that are on */
    struct linger linger;
    double receive_s;      /* how long to wait, infinite for no limit */
    double send_s;
};

/* Returns the open socket of a descriptor; null with errno EBADF or ENOTSOCK. */
struct __crs_open_file *__crs_find_socket(int descriptor);

/* Returns what is known of an open socket. */
struct __crs_socket *__crs_socket_of(struct __crs_open_file *file);

/* Makes a descriptor for the host's socket of a number; closes that if there is none free. */
int __crs_install_socket(int family, int type, int number, int flags);

/* Posts a request about a socket; returns the result, -1 with errno on error. */
int __crs_ask_socket(int code, struct __crs_open_file *file, struct __crs_message *message);

/* The same, but waits until CRS_RECEIVES or CRS_SENDS is possible, as flags and options say. */
int __crs_attempt(int code, struct __crs_open_file *file, struct __crs_message *message,
                  int wanted, int flags);

/* Waits for sockets, see `struct __crs_operations`. */
int __crs_wait_for_sockets(const int *wanted, int count, double wait_s);

/* Puts an address into a request; returns -1 with errno if it is none of the socket's family. */
int __crs_put_address(struct __crs_open_file *file, struct __crs_message *message,
                      const struct sockaddr *address, socklen_t size);

/* Stores the address of a reply, as much as there is room for; a null one is left out. */
void __crs_take_address(struct __crs_open_file *file, const struct __crs_message *message,
                        struct sockaddr *address, socklen_t *size);

/* The operations, of the files that define them. */
int __crs_read_socket(struct __crs_open_file *file, void *bytes, int size);
int __crs_write_socket(struct __crs_open_file *file, const void *bytes, int size);

#endif
