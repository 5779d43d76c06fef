"""Linux's error numbers, which the C library uses on every host."""

from __future__ import annotations

from typing import Final

EBADF: Final = 9
EAGAIN: Final = 11
EINVAL: Final = 22
EMFILE: Final = 24
EPIPE: Final = 32
EDESTADDRREQ: Final = 89
EMSGSIZE: Final = 90
ESOCKTNOSUPPORT: Final = 94
EOPNOTSUPP: Final = 95
EAFNOSUPPORT: Final = 97
EADDRINUSE: Final = 98
EADDRNOTAVAIL: Final = 99
ECONNRESET: Final = 104
ENOBUFS: Final = 105
EISCONN: Final = 106
ENOTCONN: Final = 107
ETIMEDOUT: Final = 110
ECONNREFUSED: Final = 111
EALREADY: Final = 114
EINPROGRESS: Final = 115


class SocketError(Exception):
    """A request to the network has failed.

    Attributes:
        number: why, as in `errno.h`.
    """

    def __init__(self, number: int) -> None:
        super().__init__(number)
        self.number = number
