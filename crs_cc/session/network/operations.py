"""Socket operations of programs (POSIX `sys/socket.h`). None blocks: EAGAIN means to retry.

Each operation raises `SocketError` when it fails.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from crs_cc.session.network.addresses import ANY
from crs_cc.session.network.errors import (
    EADDRNOTAVAIL,
    EAFNOSUPPORT,
    EAGAIN,
    EALREADY,
    EDESTADDRREQ,
    EINPROGRESS,
    EINVAL,
    EISCONN,
    EMSGSIZE,
    ENOBUFS,
    ENOTCONN,
    EOPNOTSUPP,
    EPIPE,
    ESOCKTNOSUPPORT,
    SocketError,
)
from crs_cc.session.network.sockets import (
    AF_INET,
    AF_UNIX,
    BUFFER,
    DATAGRAM,
    DATAGRAM_HEAD,
    MAX_BACKLOG,
    MAX_DATAGRAM,
    NOWHERE,
    STREAM,
    Endpoint,
    Key,
    Socket,
)

if TYPE_CHECKING:
    from crs_cc.session.network.network import Network

TIMEOUT_S: Final = 127.0
"""How long a connection is tried: Linux's seven tries, 2^7 - 1 s (tcp_syn_retries = 6)."""

MAX_SEGMENTS: Final = 4096
"""A robot of which more are on their way opens no connection; chosen by us."""

_RECEIVE, _SEND, _BOTH = range(3)  # SHUT_RD, SHUT_WR, SHUT_RDWR


def open_socket(network: Network, robot: int, family: int, kind: int) -> Key:
    """Make a socket."""
    if family not in (AF_UNIX, AF_INET):
        raise SocketError(EAFNOSUPPORT)
    if kind not in (STREAM, DATAGRAM):
        raise SocketError(ESOCKTNOSUPPORT)
    return network.add(robot, Socket(family, kind))


def open_pair(network: Network, robot: int, kind: int) -> tuple[Key, Key]:
    """Make two local sockets that are connected."""
    first = open_socket(network, robot, AF_UNIX, kind)
    try:
        second = open_socket(network, robot, AF_UNIX, kind)
    except SocketError:
        network.remove(first, 0.0)
        raise
    for key, other in ((first, second), (second, first)):
        socket = network.socket(key)
        socket.peer, socket.local, socket.remote = other, (ANY, b""), (ANY, b"")
        socket.condition = "connected" if kind == STREAM else "new"
    return first, second


def listen(network: Network, key: Key, backlog: int) -> None:
    """Make a socket listen for connections."""
    socket = network.socket(key)
    if socket.kind != STREAM:
        raise SocketError(EOPNOTSUPP)
    if socket.condition not in ("new", "listening"):
        raise SocketError(EINVAL)
    if socket.local is None:
        network.bind(key, NOWHERE)
    socket.condition, socket.backlog = "listening", min(max(backlog, 1), MAX_BACKLOG)


def connect(network: Network, key: Key, to: Endpoint, at_s: float) -> None:
    """Set where a socket's datagrams go, or begin a connection, which fails with EINPROGRESS."""
    socket = network.socket(key)
    if socket.kind == DATAGRAM:
        socket.local = network.origin(key, to)
        socket.remote = None if to == NOWHERE else to
        return
    if socket.condition == "connected" and socket.until and not socket.error:
        socket.until = 0  # the first query after connecting reports it
        return
    _check_can_connect(socket)
    if sum(each.source[0] == key[0] for each in network.state.segments.values()) >= MAX_SEGMENTS:
        raise SocketError(ENOBUFS)
    if socket.family == AF_INET and not to[1]:
        raise SocketError(EADDRNOTAVAIL)
    socket.local = network.origin(key, to)
    socket.condition, socket.remote = "connecting", to
    network.post(key, "open", None, at_s, to=to, origin=socket.local)
    socket.until = network.cycle_after(at_s, TIMEOUT_S)
    raise SocketError(EINPROGRESS)


def _check_can_connect(socket: Socket) -> None:
    if socket.error:
        raise SocketError(take_error(socket))
    wrong = {"connecting": EALREADY, "connected": EISCONN, "ended": EISCONN, "listening": EINVAL}
    if socket.condition in wrong:
        raise SocketError(wrong[socket.condition])


def accept(network: Network, key: Key) -> Key:
    """Take the first connection that waits."""
    socket = network.socket(key)
    if socket.condition != "listening":
        raise SocketError(EINVAL if socket.kind == STREAM else EOPNOTSUPP)
    if not socket.waiting:
        raise SocketError(EAGAIN)
    network.check_room(key[0])
    number, *rest = socket.waiting
    socket.waiting = tuple(rest)
    return key[0], number


def send(network: Network, key: Key, content: bytes, at_s: float) -> int:
    """Send bytes on a connection; return how many fitted."""
    socket = network.socket(key)
    if socket.error:
        raise SocketError(take_error(socket))
    if socket.cannot_send or socket.condition == "ended":
        raise SocketError(EPIPE)
    if socket.condition == "connecting":
        raise SocketError(EAGAIN)
    if socket.condition != "connected":
        raise SocketError(ENOTCONN)
    fitting = content[: BUFFER - socket.unread]
    if content and not fitting:
        raise SocketError(EAGAIN)
    if fitting:
        socket.unread += len(fitting)
        network.post(key, "data", socket.peer, at_s, content=fitting)
    return len(fitting)


def send_datagram(
    network: Network, key: Key, piece: bytes, to: Endpoint | None, at_s: float, *, has_more: bool
) -> int:
    """Send a datagram, or keep a piece of one until its last piece comes."""
    socket = network.socket(key)
    content, socket.staged = socket.staged + piece, b""
    if socket.error:
        raise SocketError(take_error(socket))
    if socket.cannot_send:
        raise SocketError(EPIPE)
    if len(content) > MAX_DATAGRAM:
        raise SocketError(EMSGSIZE)
    to = to or socket.remote
    if to is None:
        raise SocketError(EDESTADDRREQ)
    if socket.unread >= BUFFER:
        raise SocketError(EAGAIN)
    origin = network.origin(key, to)
    if has_more:
        socket.staged = content
    else:
        socket.unread += len(content) + DATAGRAM_HEAD
        network.post(key, "datagram", socket.peer, at_s, to=to, origin=origin, content=content)
    return len(piece)


def receive(
    network: Network, key: Key, first: int, count: int, *, stays: bool
) -> tuple[bytes, Endpoint, int]:
    """Return received bytes, where they come from, and how many there are in all.

    Args:
        network: the network.
        key: the socket.
        first: the first wanted byte of what has arrived, or of the first datagram.
        count: how many are wanted.
        stays: whether they can be received again. Otherwise all bytes up to the last of them
            are gone, or all of the datagram.
    """
    socket = network.socket(key)
    if first < 0 or count < 0:
        raise SocketError(EINVAL)
    if socket.kind == DATAGRAM:
        return _receive_datagram(socket, first, count, stays=stays)
    there = socket.received
    if not there:
        _check_is_at_end(socket)
    content = there[first : first + count]
    if not stays:
        end = first + len(content)
        socket.received = there[end:]
        if socket.peer is not None:
            freed = network.state.freed
            freed[socket.peer] = freed.get(socket.peer, 0) + end
    return content, socket.remote or NOWHERE, len(there)


def _receive_datagram(
    socket: Socket, first: int, count: int, *, stays: bool
) -> tuple[bytes, Endpoint, int]:
    if socket.error:
        raise SocketError(take_error(socket))
    if not socket.datagrams:
        if socket.cannot_receive:
            return b"", NOWHERE, 0
        raise SocketError(EAGAIN)
    origin, there = socket.datagrams[0]
    if not stays:
        socket.datagrams = socket.datagrams[1:]
    return there[first : first + count], origin, len(there)


def _check_is_at_end(socket: Socket) -> None:
    """Return if nothing more can arrive on a connection, raise `SocketError` otherwise."""
    if socket.at_end or socket.cannot_receive:
        return
    if socket.error:
        raise SocketError(take_error(socket))
    if socket.condition != "ended":
        is_open = socket.condition in ("connected", "connecting")
        raise SocketError(EAGAIN if is_open else ENOTCONN)


def shut_down(network: Network, key: Key, how: int, at_s: float) -> None:
    """Shut down one direction of a connection, or both."""
    socket = network.socket(key)
    if how not in (_RECEIVE, _SEND, _BOTH):
        raise SocketError(EINVAL)
    if socket.condition != "connected" and socket.remote is None:
        raise SocketError(ENOTCONN)
    if how != _SEND:
        socket.cannot_receive = True
    if how != _RECEIVE and not socket.cannot_send:
        socket.cannot_send = True
        if socket.condition == "connected":
            network.post(key, "end", socket.peer, at_s)


def take_error(socket: Socket) -> int:
    """Return the pending error of a socket, and clear it."""
    error, socket.error = socket.error, 0
    return error
