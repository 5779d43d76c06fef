"""Unix domain sockets instead of TCP, between an environment and a host of one user on one machine.

A message over TCP takes twice as long as one over a Unix domain socket, even on the same machine.
So a host sends the addresses of both ends of its connection. If the environment sees the same
addresses, there is no tunnel, proxy or address translation in between; after checking the host's
token, it then offers a local socket with a random name. Both sides check that the other process
belongs to the same user, by the credentials that the system reports. A host that cannot connect
there stays on TCP: the names belong to a network namespace, so other containers and machines do not
have them. They are abstract names, which only Linux has, and no files, so a killed process leaves
nothing behind.

>>> here, there = socket.socketpair()
>>> endpoints(here), local_listener_for(here, "")
('', None)
"""

from __future__ import annotations

import contextlib
import os
import secrets
import socket
import struct
import sys
import time
from typing import Final, Self

from crs_cc.net.channel import HANDSHAKE_TIMEOUT_S, ConnectionLostError, SocketPair
from crs_cc.net.tls import Connection

_MAPPED: Final = "::ffff:"
"""How a socket of IPv6 names an address of IPv4."""

_PREFIX: Final = "\0crs-"
_CREDENTIALS: Final = struct.Struct("@iII")
"""Process, user and group of `SO_PEERCRED`, see `socket(7)`."""


def endpoints(connection: Connection) -> str:
    """Return the addresses of both ends of a connection, in the same order on both sides.

    Empty for an encrypted connection, which the user has asked for; where there are no such
    sockets; and for a closed connection.
    """
    if sys.platform != "linux" or type(connection) is not socket.socket:
        return ""
    if connection.family not in (socket.AF_INET, socket.AF_INET6):
        return ""
    try:
        both = connection.getsockname()[:2], connection.getpeername()[:2]
    except OSError:
        return ""  # the next send or receive reports it
    return " ".join(sorted(f"{host.removeprefix(_MAPPED)}:{port}" for host, port in both))


class LocalListener:
    """A local socket for one host, which connects twice: first to send, then to receive.

    Attributes:
        name: the name of the socket, without its prefix.
    """

    def __init__(self) -> None:
        """Listen; raise OSError if that fails."""
        self.name = secrets.token_hex(16)
        self._listener = socket.socket(socket.AF_UNIX)
        try:
            self._listener.bind(_PREFIX + self.name)
            self._listener.listen(2)
        except OSError:
            self._listener.close()
            raise

    def accept(self) -> SocketPair:
        """Accept the connections of a host that has announced them.

        Raises:
            ConnectionLostError: it is not.
        """
        end_s = time.monotonic() + HANDSHAKE_TIMEOUT_S
        receiver = self._accept_one(end_s)
        try:
            return SocketPair(receiver, self._accept_one(end_s))
        except ConnectionLostError:
            receiver.close()
            raise

    def _accept_one(self, end_s: float) -> socket.socket:
        """Accept the next connection from a process of the same user, up to a time."""
        while (left_s := end_s - time.monotonic()) > 0.0:
            self._listener.settimeout(left_s)
            with contextlib.suppress(OSError):
                connection, _ = self._listener.accept()
                if _is_own(connection):
                    return connection
                connection.close()
        raise ConnectionLostError("it did not connect to the local socket as announced")

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._listener.close()


def local_listener_for(connection: Connection, seen: str) -> LocalListener | None:
    """Return a local listener for a host if its connection is direct, else None.

    Args:
        connection: the connection to the host.
        seen: the addresses that the host has sent, see `endpoints`.
    """
    if not seen or seen != endpoints(connection):
        return None
    try:
        return LocalListener()
    except OSError:
        return None  # forbidden by a sandbox, or out of descriptors: TCP works as well


def connect_local(name: str) -> SocketPair | None:
    """Connect to the local socket that an environment offers; return None if that fails."""
    sender = _connect_one(name)
    receiver = sender and _connect_one(name)
    if sender is None or receiver is None:
        if sender is not None:
            sender.close()
        return None
    return SocketPair(receiver, sender)


def _connect_one(name: str) -> socket.socket | None:
    connection = socket.socket(socket.AF_UNIX)
    try:
        connection.settimeout(HANDSHAKE_TIMEOUT_S)
        connection.connect(_PREFIX + name)
        if _is_own(connection):
            return connection
    except (OSError, ValueError):
        pass
    connection.close()
    return None


def _is_own(connection: socket.socket) -> bool:
    """Return whether the other side is a process of the same user."""
    found = connection.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, _CREDENTIALS.size)
    return bool(_CREDENTIALS.unpack(found)[1] == os.geteuid())
