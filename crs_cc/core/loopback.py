"""The checks of local servers before they answer: tokens, hosts and origins.

A server listens on the loopback interface, so no other machine reaches it. But each user and each
web page on this machine does: hence a token that only the user knows, and the names of host and
origin, which a foreign page cannot choose (a name of its own that resolves to 127.0.0.1 stands in
`Host`: DNS rebinding). If the system reports the owner of a connection, those of other users are
rejected, see `host_system.is_of_another_user`. A client that sends half a message, or does not
read, is not waited for.

>>> token = new_token()
>>> is_token(token, token), is_token("", token), is_token(token[:-1] + "é", token)
(True, False, False)
>>> is_own_host("127.0.0.1:8000", 8000), is_own_host("localhost:8000", 8000)
(True, True)
>>> is_own_host("evil.example:8000", 8000), is_own_host("127.0.0.1:9", 8000)
(False, False)
>>> is_own_origin("http://localhost:8000", 8000), is_own_origin("https://evil.example", 8000)
(True, False)
"""

from __future__ import annotations

import hmac
import io
import secrets
import socket
import time
from typing import Any, Final

LOOPBACK: Final = "127.0.0.1"
"""The address that servers listen on."""

MIN_TOKEN: Final = 16
"""The fewest characters of a token that the user chooses; chosen by us."""

STALL_S: Final = 5.0
"""How long the other side may do nothing in the middle of a message; chosen by us."""

MESSAGE_S: Final = 30.0
"""How long a message may take as a whole; chosen by us."""

_NAMES: Final = (LOOPBACK, "localhost")


class TooSlowError(ConnectionError):
    """The client has not sent the rest of a message in time."""


def new_token() -> str:
    """Return an unpredictable token of letters, digits, `-` and `_`."""
    return secrets.token_urlsafe(16)


def is_token(given: object, token: str) -> bool:
    """Return whether a client's token is right, in constant time."""
    return isinstance(given, str) and hmac.compare_digest(
        given.encode("utf-8", "replace"), token.encode()
    )


def listen(port: int) -> socket.socket:
    """Return a socket that listens on the loopback interface; port 0 selects a free one.

    Raises:
        OSError: the port is in use.
    """
    return socket.create_server((LOOPBACK, port))


def is_loopback(client: socket.socket) -> bool:
    """Return whether a connection over IPv4 is one between two programs of this machine."""
    return client.family == socket.AF_INET and client.getsockname()[0] == LOOPBACK


def is_own_host(host: str, port: int) -> bool:
    """Return whether a request's `Host` names this server."""
    return host in {f"{name}:{port}" for name in _NAMES}


def is_own_origin(origin: str, port: int) -> bool:
    """Return whether a request's `Origin` is a page of this server."""
    scheme, _, host = origin.partition("://")
    return scheme == "http" and is_own_host(host, port)


class BoundedStream(io.RawIOBase):
    """What a client sends: it may take its time between messages, and not within one.

    While `deadline_s` is set, reading raises `TooSlowError` if nothing comes for `STALL_S`, or
    after that time.

    Attributes:
        deadline_s: until when the current message must be complete, by `time.monotonic`; None
            between messages.
    """

    def __init__(self, client: socket.socket, stall_s: float = STALL_S) -> None:
        self._client = client
        client.settimeout(stall_s)  # of writing, too
        self.deadline_s: float | None = None

    def readable(self) -> bool:
        """Return True: it can be read."""
        return True

    def readinto(self, room: Any, /) -> int:
        """Wait for bytes; return how many were read, 0 at the end.

        Raises:
            TooSlowError: the message takes too long.
        """
        while True:
            if self.deadline_s is not None and time.monotonic() > self.deadline_s:
                raise TooSlowError("a message took too long")
            try:
                return self._client.recv_into(room)
            except TimeoutError:
                if self.deadline_s is not None:
                    raise TooSlowError("a message is incomplete") from None
