"""A Unix socket instead of TCP, between an environment and a host of one user on one machine.

A message over TCP takes twice the time of one over a local socket of Unix, though nothing leaves
the machine. So a host says what it sees of its connection: the addresses of both ends. If that is
what the environment sees, nobody is between them, such as a tunnel, a proxy or a router that
translates addresses; then the environment offers a local socket, whose name it has drawn at random,
in what it answers to a host that has shown its token. Both sides check that the other one's process
belongs to their own user, as the system says. Whoever cannot connect there stays on TCP: names are
those of a network namespace, so other containers and machines do not find it. Only Linux has such
names, which are no files: nothing is left behind by a process that is killed.

>>> here, there = socket.socketpair()
>>> ends(here), offered(here, "")
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

from crs_cc.net.channel import GREETING_S, ConnectionLostError, Way
from crs_cc.net.tls import Connection

_MAPPED: Final = "::ffff:"
"""How a socket of IPv6 names an address of IPv4."""

_PREFIX: Final = "\0crs-"
_CREDENTIALS: Final = struct.Struct("@iII")
"""Process, user and group of `SO_PEERCRED`, see `socket(7)`."""


def ends(connection: Connection) -> str:
    """Return the addresses of both ends of a connection, in an order that both sides agree upon.

    Empty if it is encrypted, as its user has asked for that, where there is no other way, and if
    the connection is gone.
    """
    if sys.platform != "linux" or type(connection) is not socket.socket:
        return ""
    if connection.family not in (socket.AF_INET, socket.AF_INET6):
        return ""
    try:
        both = connection.getsockname()[:2], connection.getpeername()[:2]
    except OSError:
        return ""  # whoever sends or receives next finds out
    return " ".join(sorted(f"{host.removeprefix(_MAPPED)}:{port}" for host, port in both))


class Offer:
    """A local socket to which one host may connect: first for what it sends, then for the rest.

    Attributes:
        name: the name by which the host finds it.
    """

    def __init__(self) -> None:
        """Listen; raise OSError if that cannot be done."""
        self.name = secrets.token_hex(16)
        self._listener = socket.socket(socket.AF_UNIX)
        try:
            self._listener.bind(_PREFIX + self.name)
            self._listener.listen(2)
        except OSError:
            self._listener.close()
            raise

    def taken(self) -> Way:
        """Return the way of a host that says that it has connected.

        Raises:
            ConnectionLostError: it has not.
        """
        end_s = time.monotonic() + GREETING_S
        into = self._accepted(end_s)
        try:
            return Way(into, self._accepted(end_s))
        except ConnectionLostError:
            into.close()
            raise

    def _accepted(self, end_s: float) -> socket.socket:
        """Return the next connection of a process of our user, up to a time."""
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


def offered(connection: Connection, seen: str) -> Offer | None:
    """Return an offer to a host, if the connection is direct.

    Args:
        connection: the connection to the host.
        seen: what the host says of it, see `ends`.
    """
    if not seen or seen != ends(connection):
        return None
    try:
        return Offer()
    except OSError:
        return None  # by a sandbox, or without descriptors: it works as well without


def take(name: str) -> Way | None:
    """Return the way to an environment that has offered it; None if it is not to be had."""
    out = _connected(name)
    into = out and _connected(name)
    if out is None or into is None:
        if out is not None:
            out.close()
        return None
    return Way(into, out)


def _connected(name: str) -> socket.socket | None:
    connection = socket.socket(socket.AF_UNIX)
    try:
        connection.settimeout(GREETING_S)
        connection.connect(_PREFIX + name)
        if _is_own(connection):
            return connection
    except (OSError, ValueError):
        pass
    connection.close()
    return None


def _is_own(connection: socket.socket) -> bool:
    """Return whether the other side is a process of our user."""
    found = connection.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, _CREDENTIALS.size)
    return bool(_CREDENTIALS.unpack(found)[1] == os.geteuid())
