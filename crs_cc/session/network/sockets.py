"""Sockets and segments: the state of the network, as plain records with immutable values."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Final, Literal, TypeAlias

AF_UNIX: Final = 1
AF_INET: Final = 2
STREAM: Final = 1
DATAGRAM: Final = 2
"""Families and types, as in `sys/socket.h`."""

POLLIN: Final = 1
POLLOUT: Final = 4
POLLERR: Final = 8
POLLHUP: Final = 16
"""What can be done with a socket, as in `poll.h`."""

BUFFER: Final = 65_536
"""The most bytes that are sent on a connection and not yet received, and that wait in a datagram
socket; chosen by us: the largest TCP window without scaling (RFC 9293) and one more."""

MAX_DATAGRAM: Final = 16_384
"""Longer ones are refused; chosen by us."""

MAX_SOCKETS: Final = 60
"""Sockets of a program: its other descriptors need some of the 64, too."""

DATAGRAM_HEAD: Final = 28
"""What a datagram takes of a buffer besides its bytes: heads of IP and UDP [bytes]."""

MAX_BACKLOG: Final = 32
"""Connections that may wait to be accepted; chosen by us."""

OUTSIDE: Final = -1
"""Stands for a robot's number in what belongs to the real network."""

Endpoint: TypeAlias = tuple[int, int | bytes]
"""Internet address and port; the latter is the name of a local socket."""

Key: TypeAlias = tuple[int, int]
"""Robot, and the number of its socket, which is never used again."""

Condition: TypeAlias = Literal["new", "listening", "connecting", "connected", "ended"]

NOWHERE: Final[Endpoint] = (0, 0)


@dataclass(slots=True)
class Socket:
    """One end of a connection, or where connections or datagrams arrive.

    Attributes:
        family: its family.
        kind: its type.
        condition: its state; datagram sockets stay `new`.
        local: its own address; None until it has one.
        remote: the other end's address, or where datagrams go; None for none.
        peer: the other end of a connection; None for none.
        backlog: how many connections may wait.
        waiting: the numbers of connections that wait to be accepted.
        received: bytes that have arrived on a connection.
        datagrams: those that have arrived, with their senders.
        staged: the first pieces of a datagram that is being sent.
        unread: bytes sent that the other end has not received yet; of datagrams, that have not
            arrived yet, with their heads.
        last: the number of the segment that it has sent last; -1 for none.
        until: the cycle at whose start it stops trying to connect; kept until its program has
            asked whether it is connected.
        at_end: whether the other end sends no more.
        cannot_send: whether this end sends no more.
        cannot_receive: whether this end receives no more.
        error: what has gone wrong, as in `errno.h`; 0 for nothing.
    """

    family: int
    kind: int
    condition: Condition = "new"
    local: Endpoint | None = None
    remote: Endpoint | None = None
    peer: Key | None = None
    backlog: int = 0
    waiting: tuple[int, ...] = ()
    received: bytes = b""
    datagrams: tuple[tuple[Endpoint, bytes], ...] = ()
    staged: bytes = b""
    unread: int = 0
    last: int = -1
    until: int = 0
    at_end: bool = False
    cannot_send: bool = False
    cannot_receive: bool = False
    error: int = 0

    @property
    def ready(self) -> int:
        """What can be done with it at once, as bits of `poll.h`."""
        ready = POLLERR if self.error else 0
        if self.kind == DATAGRAM:
            ready |= POLLIN if self.datagrams or self.error or self.cannot_receive else 0
            return ready | (POLLOUT if self.unread < BUFFER else 0)
        if self.condition == "ended":
            return ready | POLLIN | POLLOUT | POLLHUP
        if self.condition == "new":
            return ready | POLLOUT | POLLHUP | (POLLIN if self.error else 0)
        if self.waiting or self.received or self.at_end or self.cannot_receive:
            ready |= POLLIN
        if self.condition == "connected" and (self.unread < BUFFER or self.cannot_send):
            ready |= POLLOUT
        if self.at_end and self.cannot_send:
            ready |= POLLHUP
        return ready


SegmentKind: TypeAlias = Literal[
    "open", "opened", "refused", "data", "end", "reset", "datagram", "unreachable"
]


@dataclass(frozen=True, slots=True)
class Segment:
    """A segment in transit.

    Attributes:
        due: the cycle at whose start it arrives.
        sent_s: when it was sent [s].
        source: the socket that sent it.
        kind: what it is.
        target: the socket that it goes to; None if its address decides.
        to: the address that it goes to.
        origin: the address that it comes from.
        content: its bytes.
    """

    due: int
    sent_s: float
    source: Key
    kind: SegmentKind
    target: Key | None
    to: Endpoint = NOWHERE
    origin: Endpoint = NOWHERE
    content: bytes = b""


@dataclass(frozen=True, slots=True)
class Wait:
    """A program that waits for its sockets.

    Attributes:
        sockets: for each, 4 times its number, plus 1 to receive and 2 to send.
        until_s: when it stops waiting [s].
    """

    sockets: tuple[int, ...]
    until_s: float


@dataclass(frozen=True, slots=True)
class Machine:
    """A computer of the real network that programs can reach.

    Attributes:
        name: its name.
        port: its port that leads there.
    """

    name: str
    port: int


@dataclass(slots=True)
class NetworkState:
    """All that changes in the network.

    Attributes:
        sockets: every socket.
        segments: what is on its way, by number, in the order in which it was sent.
        sent: how many segments have been sent.
        freed: by sender, bytes that have been received since the timestep began.
        waits: the programs that wait, by robot.
        numbers: the number of each robot's next socket.
        ports: by robot, how many ports it has been given.
        machines: the computers of the real network, in the order of their addresses.
    """

    sockets: dict[Key, Socket] = field(default_factory=dict)
    segments: dict[int, Segment] = field(default_factory=dict)
    sent: int = 0
    freed: dict[Key, int] = field(default_factory=dict)
    waits: dict[int, Wait] = field(default_factory=dict)
    numbers: dict[int, int] = field(default_factory=dict)
    ports: dict[int, int] = field(default_factory=dict)
    machines: tuple[Machine, ...] = ()

    def copy(self) -> NetworkState:
        """Return a copy that shares nothing that changes."""
        sockets = {key: replace(socket) for key, socket in self.sockets.items()}
        sending = dict(self.segments), self.sent, dict(self.freed)
        robots = dict(self.waits), dict(self.numbers), dict(self.ports)
        return NetworkState(sockets, *sending, *robots, self.machines)

    def owned(self, robot: int) -> list[Key]:
        """Return the sockets of a robot, in the order of their numbers."""
        return sorted(key for key in self.sockets if key[0] == robot)
