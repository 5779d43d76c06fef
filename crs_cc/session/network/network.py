"""The common part of socket operations and deliveries: find, name and remove sockets, send.

What is sent arrives at the start of a timestep: the first that begins after the latency, and not
that in which it was sent. So what a program finds does not depend on which program ran first.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Final, Literal, TypeAlias

import numpy as np

from crs_cc.session.network.addresses import ANY, HOST_NAME, LOOPBACK, Addresses
from crs_cc.session.network.errors import (
    EADDRINUSE,
    EADDRNOTAVAIL,
    EBADF,
    EINVAL,
    EMFILE,
    SocketError,
)
from crs_cc.session.network.sockets import (
    AF_INET,
    MAX_SOCKETS,
    NOWHERE,
    Endpoint,
    Key,
    NetworkState,
    Segment,
    SegmentKind,
    Socket,
)

if TYPE_CHECKING:
    from crs_cc.sim.engine.environment import Environment

OutsideKind: TypeAlias = Literal["open", "opened", "refused", "data", "end", "reset"]
OutsideEvent: TypeAlias = tuple[OutsideKind, bytes]
"""What the network does to a connection of the real network, and its bytes."""

FIRST_PORT: Final = 32_768
PORTS: Final = 28_232
"""The ports that sockets are given that ask for none: Linux's, 32768 to 60999."""

_ROUNDING: Final = 1e-9  # [timesteps]


class Network:
    """The network of a run.

    Attributes:
        state: all that changes.
        on_outside_event: called with each event of a connection of the real network and its
            number.
    """

    def __init__(self, environment: Environment) -> None:
        """Make a network without sockets of the robots of an environment."""
        self.state = NetworkState()
        self.on_outside_event: Callable[[int, OutsideEvent], None] = lambda _number, _event: None
        self._environment = environment

    @property
    def addresses(self) -> Addresses:
        """Its computers; to keep them would be a reference cycle."""
        world = self._environment.world
        return Addresses(lambda: [robot.id for robot in world.robots], lambda: self.machine_names)

    @property
    def machine_names(self) -> list[str]:
        """The names of the computers of the real network, in the order of their addresses."""
        names = dict.fromkeys(machine.name for machine in self.state.machines)
        return [name for name in names if name != HOST_NAME]

    def present_robots(self) -> list[int]:
        """Return the robots that are in the world."""
        return np.flatnonzero(self._environment.present).tolist()

    def robot_at(self, address: int, sender: int) -> int | None:
        """Return the robot in the world that a sender reaches at an address; None for none."""
        robot = self.addresses.robot(address, sender)
        return robot if robot is not None and self._environment.present[robot] else None

    def machine_at(self, endpoint: Endpoint) -> str | None:
        """Return name and port of a reachable computer of the real network; None for none."""
        name = self.addresses.machine_name(endpoint[0])
        for machine in self.state.machines:
            if (machine.name, machine.port) == (name, endpoint[1]):
                return f"{name}:{machine.port}"
        return None

    # -- sockets -------------------------------------------------------------------------------

    def socket(self, key: Key) -> Socket:
        """Return a socket; raise `SocketError` if there is none."""
        found = self.state.sockets.get(key)
        if found is None:
            raise SocketError(EBADF)
        return found

    def add(self, robot: int, socket: Socket) -> Key:
        """Add a socket of a program; raise `SocketError` if it has too many."""
        self.check_room(robot)
        return self.add_waiting(robot, socket)

    def check_room(self, robot: int) -> None:
        """Raise `SocketError` if a program has too many sockets besides those to be accepted."""
        own = [self.state.sockets[key] for key in self.state.owned(robot)]
        if len(own) - sum(len(each.waiting) for each in own) >= MAX_SOCKETS:
            raise SocketError(EMFILE)

    def add_waiting(self, robot: int, socket: Socket) -> Key:
        """Add a socket that is no program's yet, or one of the real network."""
        number = self.state.numbers.get(robot, 0)
        self.state.numbers[robot] = number + 1
        self.state.sockets[robot, number] = socket
        return robot, number

    def remove(self, key: Key, at_s: float) -> None:
        """Remove a socket, and notify the other end and the ends of pending connections."""
        socket = self.state.sockets.pop(key)
        for number in socket.waiting:
            self.remove((key[0], number), at_s)
        if socket.peer is None or socket.condition != "connected":
            return
        if socket.received:  # unread data at closing is an error (RFC 2525, 2.17)
            self.post(key, "reset", socket.peer, at_s)
        elif not socket.cannot_send:
            self.post(key, "end", socket.peer, at_s)

    # -- addresses -----------------------------------------------------------------------------

    def bind(self, key: Key, endpoint: Endpoint) -> None:
        """Give a socket its address; raise `SocketError` if that is taken, or not the robot's."""
        socket, (address, port) = self.socket(key), endpoint
        if socket.local is not None:
            raise SocketError(EINVAL)
        if socket.family == AF_INET:
            if not self.addresses.is_own(address, key[0]):
                raise SocketError(EADDRNOTAVAIL)
            if not isinstance(port, int) or not 0 <= port <= 0xFFFF:
                raise SocketError(EINVAL)
        if port == 0:
            port = self._free_port(key)
        elif self._is_taken(key, (address, port)):
            raise SocketError(EADDRINUSE)
        socket.local = address, port

    def origin(self, key: Key, remote: Endpoint) -> Endpoint:
        """Return the address from which a socket sends to another; it is given a port first."""
        socket, robot = self.socket(key), key[0]
        if socket.family != AF_INET:
            return socket.local or (ANY, b"")
        if socket.local is None:
            self.bind(key, NOWHERE)
        address, port = socket.local or NOWHERE
        if address == ANY:
            is_loopback = remote[0] >> 24 == LOOPBACK >> 24
            address = LOOPBACK if is_loopback else self.addresses.own(robot)
        return address, port

    def _is_taken(self, key: Key, endpoint: Endpoint) -> bool:
        """Return whether an address is that of another socket; accepted ones do not count."""
        family, kind = self.socket(key).family, self.socket(key).kind
        for other in self.state.owned(key[0]):
            socket = self.state.sockets[other]
            local = socket.local
            is_of_kind = (socket.family, socket.kind) == (family, kind)
            if not is_of_kind or local is None or socket.peer is not None:
                continue
            if local[1] == endpoint[1] and (ANY in (local[0], endpoint[0]) or local == endpoint):
                return True
        return False

    def _free_port(self, key: Key) -> int:
        given = self.state.ports
        for _ in range(PORTS):
            count = given.get(key[0], 0)
            given[key[0]] = (count + 1) % PORTS
            if not self._is_taken(key, (ANY, FIRST_PORT + count)):
                return FIRST_PORT + count
        raise SocketError(EADDRINUSE)  # not reached: there are fewer sockets than ports

    # -- segments ------------------------------------------------------------------------------

    def post(
        self, source: Key, kind: SegmentKind, target: Key | None, at_s: float,
        *, to: Endpoint = NOWHERE, origin: Endpoint = NOWHERE, content: bytes = b"",
    ) -> None:  # fmt: skip
        """Send a segment, see `Segment`, at a time."""
        state, socket = self.state, self.state.sockets.get(source)
        due = self.cycle_after(at_s, self._environment.world.communication.network_latency_s)
        last = None if socket is None else state.segments.get(socket.last)
        if last is not None and kind == last.kind == "data" and last.due == due:
            assert socket is not None
            state.segments[socket.last] = replace(last, content=last.content + content)
            return
        if socket is not None:
            socket.last = state.sent
        sent = Segment(due, at_s, source, kind, target, to, origin, content)
        state.segments[state.sent] = sent
        state.sent += 1

    def cycle_after(self, at_s: float, wait_s: float) -> int:
        """Return the first cycle after this one that begins a time after an instant, or later."""
        environment = self._environment
        first = math.ceil((at_s + wait_s) / environment.timestep_s - _ROUNDING)
        return max(environment.cycle + 1, first)
