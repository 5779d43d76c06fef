"""The requests to the network of a run: sockets, and the names of computers.

None of them waits but `SOCKET_WAIT`: those that cannot be answered yet are refused with EAGAIN, and
the C library waits and asks again. Internet addresses are numbers in the order of their bytes.
"""

from __future__ import annotations

from typing import Final

from crs_cc.requests.request import Field, Request, fields

_NUMBER: Final = fields(("number", "i[0]", "1", "the socket's number"))
_ZERO: Final = fields(("zero", "result", "1", "0, or -errno"))
_ADDRESS: Final = fields(
    ("address", "i[1]", "1", "internet address"), ("port", "i[2]", "1", "port"),
)  # fmt: skip
_PATH: Final = fields(
    ("size", "size", "byte", "length of the name, 0 for none"),
    ("name", "data", "1", "the name of a local socket"),
)


def _request(
    name: str, code: int, prototype: str, meaning: str,
    arguments: tuple[Field, ...] = _NUMBER, *, results: tuple[Field, ...] = _ZERO,
) -> Request:  # fmt: skip
    return Request(name, code, "network", prototype, meaning, arguments, results)


NETWORK_REQUESTS: Final = (
    _request(
        "SOCKET_OPEN", 20, "int socket(int domain, int type, int protocol)", "makes a socket",
        fields(("family", "i[0]", "1", "AF_UNIX or AF_INET"),
               ("type", "i[1]", "1", "SOCK_STREAM or SOCK_DGRAM")),
        results=fields(("number", "result", "1", "its number, or -errno")),
    ),
    _request(
        "SOCKET_PAIR", 21, "int socketpair(int domain, int type, int protocol, int descriptors[2])",
        "makes two local sockets that are connected",
        fields(("type", "i[0]", "1", "SOCK_STREAM or SOCK_DGRAM")),
        results=fields(("number", "result", "1", "the first one's number, or -errno"),
               ("other", "i[0]", "1", "the second one's number")),
    ),
    _request("SOCKET_CLOSE", 22, "int close(int fd)", "closes a socket"),
    _request(
        "SOCKET_BIND", 23,
        "int bind(int descriptor, const struct sockaddr *address, socklen_t size)",
        "names a socket", (*_NUMBER, *_ADDRESS, *_PATH),
    ),
    _request(
        "SOCKET_LISTEN", 24, "int listen(int descriptor, int backlog)",
        "makes a socket accept connections",
        (*_NUMBER, *fields(("backlog", "i[1]", "1", "how many may wait"))),
    ),
    _request(
        "SOCKET_CONNECT", 25,
        "int connect(int descriptor, const struct sockaddr *address, socklen_t size)",
        "begins a connection, or sets where datagrams go", (*_NUMBER, *_ADDRESS, *_PATH),
        results=fields(("zero", "result", "1", "0 for datagrams, or -errno; EINPROGRESS: begun")),
    ),
    _request(
        "SOCKET_ACCEPT", 26,
        "int accept(int descriptor, struct sockaddr *address, socklen_t *size)",
        "takes the first connection that waits",
        results=fields(("number", "result", "1", "the new socket's number, or -errno")),
    ),
    _request(
        "SOCKET_SEND", 27,
        "ssize_t send(int descriptor, const void *bytes, size_t size, int flags)",
        "sends bytes, or a piece of a datagram",
        (*_NUMBER, *_ADDRESS,
         *fields(("is_addressed", "i[3]", "1", "1 if there is an address"),
                 ("has_more", "i[4]", "1", "1 if the datagram has more pieces"),
                 ("size", "size", "byte", "bytes"), ("bytes", "data", "1", "the bytes"))),
        results=fields(("count", "result", "byte", "bytes sent, or -errno")),
    ),
    _request(
        "SOCKET_RECEIVE", 28, "ssize_t recv(int descriptor, void *bytes, size_t size, int flags)",
        "receives bytes, or a piece of a datagram",
        (*_NUMBER,
         *fields(("first", "i[1]", "byte", "first requested byte of what has arrived"),
                 ("count", "i[2]", "byte", "requested bytes"),
                 ("stays", "i[3]", "1", "1 to leave it there"))),
        results=(
            *fields(("count", "result", "byte", "bytes, 0 at the end, or -errno")), *_ADDRESS,
            *fields(("length", "i[3]", "byte", "of the whole datagram, or of all that can be read"),
                    ("size", "size", "byte", "bytes"), ("bytes", "data", "1", "the bytes")),
        ),
    ),
    _request(
        "SOCKET_SHUTDOWN", 29, "int shutdown(int descriptor, int how)",
        "ends one direction of a connection, or both",
        (*_NUMBER, *fields(("how", "i[1]", "1", "SHUT_RD, SHUT_WR or SHUT_RDWR"))),
    ),
    _request(
        "SOCKET_NAME", 30,
        "int getsockname(int descriptor, struct sockaddr *address, socklen_t *size)",
        "returns a socket's own address, or that of the other end",
        (*_NUMBER, *fields(("which", "i[1]", "1", "0 its own, 1 the other end's"))),
        results=(*_ZERO, *_ADDRESS, *_PATH),
    ),
    _request(
        "SOCKET_ERROR", 31,
        "int getsockopt(int descriptor, int level, int name, void *value, socklen_t *size)",
        "returns what has gone wrong since it was last asked for",
        results=fields(("error", "result", "1", "errno, 0 for nothing, -errno if it failed")),
    ),
    _request(
        "SOCKET_POLL", 32, "int poll(struct pollfd *files, nfds_t count, int timeout)",
        "returns what can be done with a socket at once",
        results=fields(("ready", "result", "1", "POLLIN, POLLOUT, POLLERR, POLLHUP; or -errno")),
    ),
    _request(
        "SOCKET_WAIT", 33, "int poll(struct pollfd *files, nfds_t count, int timeout)",
        "waits until a socket may be ready, or a time is over",
        fields(("timeout_s", "f[0]", "s", "maximum waiting time"),
               ("size", "size", "byte", "bytes"),
               ("sockets", "data", "1", "4 number + 1 to receive, + 2 to send; of each", "int32")),
    ),
    _request(
        "NETWORK_ADDRESS", 34, "struct hostent *gethostbyname(const char *name)",
        "returns the internet address of a computer",
        fields(("size", "size", "byte", "length of its name, 0 for one's own"),
               ("name", "data", "1", "its name")),
        results=fields(("found", "result", "1", "1, or 0 if there is none"),
               ("address", "i[1]", "1", "internet address")),
    ),
    _request(
        "NETWORK_NAME", 35,
        "struct hostent *gethostbyaddr(const void *address, socklen_t size, int family)",
        "returns the name of a computer", fields(("address", "i[1]", "1", "internet address")),
        results=fields(("count", "result", "byte", "length of its name, 0 if there is none"),
               ("size", "size", "byte", "the same"), ("name", "data", "1", "its name")),
    ),
)  # fmt: skip
"""All requests to the network."""
