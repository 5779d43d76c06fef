"""Delivery of data at the start of a timestep: the part of the simulated computers.

Programs take no part in it: a connection is made when there is room for it, whatever the program
that listens is doing.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Final

from crs_cc.session.network.addresses import ANY, BROADCAST
from crs_cc.session.network.errors import ECONNREFUSED, ECONNRESET, EPIPE, ETIMEDOUT
from crs_cc.session.network.operations import TIMEOUT_S
from crs_cc.session.network.sockets import (
    AF_INET,
    AF_UNIX,
    BUFFER,
    DATAGRAM,
    DATAGRAM_HEAD,
    OUTSIDE,
    STREAM,
    Key,
    Segment,
    Socket,
)

if TYPE_CHECKING:
    from crs_cc.session.network.network import Network, OutsideKind

NEVER: Final = 2**62
"""A cycle that no run reaches."""


def deliver(network: Network, cycle: int, time_s: float) -> None:
    """Deliver the segments due at the start of a cycle.

    Args:
        network: the network.
        cycle: the cycle.
        time_s: its start [s].
    """
    state = network.state
    for key, count in state.freed.items():
        if key in state.sockets:
            state.sockets[key].unread -= count
    state.freed.clear()
    due = [number for number, each in state.segments.items() if each.due <= cycle]
    arriving = [(state.segments.pop(number), number) for number in due]
    arriving.sort(key=lambda pair: (pair[0].sent_s, pair[0].source[0], pair[1]))
    for segment, _ in arriving:
        _ARRIVALS[segment.kind](network, segment, time_s)
    for key, socket in list(state.sockets.items()):
        if socket.condition == "connecting" and socket.until <= cycle:
            socket.condition, socket.error = "new", ETIMEDOUT
            _report_outside(network, key, "reset")


def next_cycle(network: Network) -> int:
    """Return the first cycle at whose start something can happen; `NEVER` if nothing can."""
    state = network.state
    if state.freed:
        return 0
    due = [each.due for each in state.segments.values()]
    due += [each.until for each in state.sockets.values() if each.condition == "connecting"]
    return min(due, default=NEVER)


def _open(network: Network, segment: Segment, time_s: float) -> None:
    """Queue a connection at the listening socket, or refuse it if the backlog is full."""
    address, port = segment.to
    machine = network.machine_at(segment.to)
    if machine is not None:
        _open_outside(network, segment, machine, time_s)
        return
    robot = network.robot_at(address, segment.source[0])
    if robot is None:
        if network.addresses.machine_name(address):
            network.post((OUTSIDE, -1), "refused", segment.source, time_s)
        return  # nobody answers
    for key in network.state.owned(robot):
        listener = network.state.sockets[key]
        if listener.condition == "listening" and _is_for(listener, segment):
            if len(listener.waiting) >= listener.backlog:
                break
            remote = segment.origin if listener.family == AF_INET else (ANY, b"")
            made = Socket(
                listener.family, STREAM, "connected", (address, port), remote, segment.source
            )
            other = network.add_waiting(robot, made)
            listener.waiting = (*listener.waiting, other[1])
            network.post(other, "opened", segment.source, time_s)
            return
    network.post((robot, -1), "refused", segment.source, time_s)


def _open_outside(network: Network, segment: Segment, machine: str, time_s: float) -> None:
    """Ask for a connection to a computer of the real network."""
    until = network.cycle_after(time_s, TIMEOUT_S)
    key = network.add_waiting(
        OUTSIDE,
        Socket(
            AF_INET, STREAM, "connecting", segment.to, segment.origin, segment.source, until=until
        ),
    )
    network.on_outside_event(key[1], ("open", machine.encode()))


def _opened(network: Network, segment: Segment, time_s: float) -> None:
    socket = _target(network, segment)
    if socket is None or socket.condition != "connecting":
        network.post((OUTSIDE, -1), "reset", segment.source, time_s)
        return
    socket.condition, socket.peer = "connected", segment.source
    _report_outside(network, segment.target, "opened")


def _refused(network: Network, segment: Segment, _time_s: float) -> None:
    socket = _target(network, segment)
    if socket is not None and socket.condition == "connecting":
        socket.condition, socket.error = "new", ECONNREFUSED
        _report_outside(network, segment.target, "refused")


def _data(network: Network, segment: Segment, time_s: float) -> None:
    socket = _target(network, segment)
    if socket is None or socket.condition != "connected":
        network.post((OUTSIDE, -1), "reset", segment.source, time_s)
    elif segment.target is not None and segment.target[0] == OUTSIDE:
        _report_outside(network, segment.target, "data", segment.content)
        _free(network, segment.source, len(segment.content))
    elif socket.cannot_receive:
        _free(network, segment.source, len(segment.content))
    else:
        socket.received += segment.content


def _end(network: Network, segment: Segment, _time_s: float) -> None:
    socket = _target(network, segment)
    if socket is not None:
        socket.at_end = True
        _report_outside(network, segment.target, "end")


def _reset(network: Network, segment: Segment, _time_s: float) -> None:
    socket = _target(network, segment)
    if socket is not None and socket.condition == "connected":
        socket.condition, socket.error = "ended", EPIPE if socket.at_end else ECONNRESET
        _report_outside(network, segment.target, "reset")


def _datagram(network: Network, segment: Segment, time_s: float) -> None:
    _free(network, segment.source, len(segment.content) + DATAGRAM_HEAD)
    if segment.target is not None:  # of a pair
        found = [segment.target] if segment.target in network.state.sockets else []
    elif segment.to[0] in BROADCAST:
        robots = network.present_robots()
        found = [key for robot in robots for key in _bound(network, robot, segment)]
    else:
        robot = network.robot_at(segment.to[0], segment.source[0])
        if robot is None:
            return
        found = _bound(network, robot, segment)
        if not found:
            network.post((robot, -1), "unreachable", segment.source, time_s, origin=segment.to)
    for key in found:
        socket = network.state.sockets[key]
        taken = sum(len(content) + DATAGRAM_HEAD for _, content in socket.datagrams)
        if taken + len(segment.content) + DATAGRAM_HEAD <= BUFFER and not socket.cannot_receive:
            socket.datagrams = (*socket.datagrams, (segment.origin, segment.content))


def _unreachable(network: Network, segment: Segment, _time_s: float) -> None:
    """Report an unreachable peer to a socket that is connected to one address (as by ICMP)."""
    socket = _target(network, segment)
    if socket is not None and socket.remote == segment.origin:
        socket.error = ECONNREFUSED


def _bound(network: Network, robot: int, segment: Segment) -> list[Key]:
    """Return the socket of a robot at which a datagram arrives, if any, in a list."""
    sockets, found = network.state.sockets, []
    for key in network.state.owned(robot):
        socket = sockets[key]
        is_from_here = socket.remote in (None, segment.origin) and socket.peer is None
        if socket.kind == DATAGRAM and is_from_here and _is_for(socket, segment):
            found.append(key)
    return sorted(found, key=lambda key: sockets[key].remote is None)[:1]


def _is_for(socket: Socket, segment: Segment) -> bool:
    """Return whether what goes to the address of a segment arrives at a socket."""
    if socket.local is None or socket.local[1] != segment.to[1]:
        return False
    is_unix = isinstance(segment.to[1], bytes)
    is_here = socket.local[0] in (ANY, segment.to[0]) or ANY in segment.to[:1]
    return is_unix == (socket.family == AF_UNIX) and (is_here or segment.to[0] in BROADCAST)


def _target(network: Network, segment: Segment) -> Socket | None:
    return None if segment.target is None else network.state.sockets.get(segment.target)


def _free(network: Network, source: Key, count: int) -> None:
    """Make room for the sender."""
    socket = network.state.sockets.get(source)
    if socket is not None:
        socket.unread -= count


def _report_outside(
    network: Network, key: Key | None, event: OutsideKind, content: bytes = b""
) -> None:
    """Report an event of a connection to the real network; remove one that is over."""
    if key is None or key[0] != OUTSIDE:
        return
    network.on_outside_event(key[1], (event, content))
    socket = network.state.sockets[key]
    is_over = event in ("refused", "reset") or (event == "end" and socket.cannot_send)
    if is_over:
        del network.state.sockets[key]


_ARRIVALS: Final[dict[str, Callable[[Network, Segment, float], None]]] = {
    "open": _open,
    "opened": _opened,
    "refused": _refused,
    "data": _data,
    "end": _end,
    "reset": _reset,
    "datagram": _datagram,
    "unreachable": _unreachable,
}
