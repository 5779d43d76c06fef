"""The Nserver's replies about world and window: obstacles, poses, drawings, predictions.

The client considers any reply to most of these a success, and ignores its elements.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Sequence
from typing import Final, TypeAlias

from crs_cc.net.vendor.exchange import (
    AskUser,
    Exchange,
    Request,
    make_request,
    numbers_in,
    read_poses,
)
from crs_cc.net.vendor.nserver_packets import Packet

_REPLY: Final = 82
_ERROR: Final = Packet(91, (1,))
_MAX_VERTICES: Final = 10
_STATE: Final = 44
_READINGS: Final = 33
"""Elements of a predicted State up to the last sonar; the others are 0."""

_REFRESH: Final = range(150, 160)
_CUT: Final = 100.0
_RADIANS: Final = 1e6

Elements: TypeAlias = Sequence[int]


def answer(packet: Packet, read_laser: Callable[[int], Exchange[list[int]]]) -> Exchange[Packet]:
    """Return the exchange that answers a packet.

    Args:
        packet: the packet.
        read_laser: reads the laser readings of a prediction, in the form that the client expects.
    """
    kind, elements = packet.type, packet.elements
    if kind == 42:
        return (yield from _predict(elements, read_laser))
    if kind == 52:
        return (yield from _move_obstacle(elements))
    if kind in _REFRESH:
        yield make_request("REFRESH", kind - _REFRESH.start)
        return Packet(_REPLY)
    if kind in _SIMPLE:
        request = _SIMPLE[kind](elements)
        if request is not None:
            yield request
        return Packet(_REPLY)
    return (yield from _OTHERS.get(kind, _unknown)(elements))


def _unknown(_elements: Elements) -> Exchange[Packet]:
    return _ERROR
    yield


def _plain(name: str, count: int) -> Callable[[Elements], Request | None]:
    return lambda elements: make_request(name, *elements) if len(elements) == count else None


def _polygon(name: str) -> Callable[[Elements], Request | None]:
    def ask(elements: Elements) -> Request | None:
        return _with_vertices(name, elements, 0)

    return ask


def _with_vertices(name: str, elements: Elements, others: int) -> Request | None:
    """Return a request with a polygon, at the start of the elements; None if it is invalid."""
    count = elements[0] if elements else -1
    if not 0 <= count <= _MAX_VERTICES or len(elements) != 1 + 2 * count + others:
        return None
    end = 1 + 2 * count
    data = struct.pack(f"<{2 * count}i", *elements[1:end])
    return make_request(name, count, *elements[end:], data=data)


def _drawing(shape: int, before: int, between: int) -> Callable[[Elements], Request | None]:
    """Return the command that draws a shape: its numbers, zeros in their place, and the mode."""

    def ask(elements: Elements) -> Request | None:
        if len(elements) != before + 1:
            return None
        return make_request("DRAW", shape, *elements[:-1], *[0] * between, elements[-1])

    return ask


_SIMPLE: Final[dict[int, Callable[[Elements], Request | None]]] = {
    41: _plain("PLACE_ROBOT", 4),
    50: _polygon("ADD_OBSTACLE"),
    51: _polygon("DELETE_OBSTACLE"),
    53: _plain("NEW_WORLD", 0),
    60: _drawing(0, before=4, between=2),
    61: _drawing(1, before=4, between=2),
    62: _drawing(2, before=6, between=0),
    71: _plain("REAL_ROBOT", 0),
    74: _plain("SIMULATED_ROBOT", 0),
}
"""Requests whose replies the client ignores, so that errors have no effect."""


def _move_obstacle(elements: Elements) -> Exchange[Packet]:
    """Move a polygon; the reply has its vertices, moved or not."""
    request = _with_vertices("MOVE_OBSTACLE", elements, 2)
    if request is None:
        return Packet(81, tuple(elements[:-2]))
    reply = yield request
    vertices = numbers_in(reply)[: 2 * elements[0]] if reply["result"] else elements[1:-2]
    return Packet(81, (elements[0], *vertices))


def _predict(
    elements: Elements, read_laser: Callable[[int], Exchange[list[int]]]
) -> Exchange[Packet]:
    """Predict readings; the client takes zeros from a server that cannot."""
    zeros = Packet(92, (0,) * (_STATE + 1))
    if len(elements) != 4:
        return zeros
    reply = yield make_request("PREDICT", *elements)
    if not reply["result"]:
        return zeros
    state = [*numbers_in(reply)[:_READINGS], *[0] * _STATE][:_STATE]
    count = int(reply["i"][0])
    readings = yield from read_laser(count)
    return Packet(92, (*state, count, *readings))


def _get_rpx(_elements: Elements) -> Exchange[Packet]:
    poses = yield from read_poses()
    return Packet(76, (len(poses) // 3, *poses)) if poses else _ERROR


def _motion_check(elements: Elements) -> Exchange[Packet]:
    """Find the first collision on a path, whose numbers are cut to hundredths or millionths."""
    if len(elements) != 8:
        return _ERROR
    kind, *numbers = elements
    angular = _CUT if kind == 0 else _RADIANS
    steps = _CUT, _CUT, angular, angular, _CUT, _CUT, _CUT
    path = [number / step for number, step in zip(numbers, steps, strict=True)]
    if kind == 0:
        path[4:] = 0.0, 0.0, 0.0  # the previous contents
    reply = yield make_request("MOTION_CHECK", kind, data=struct.pack("<7d", *path))
    if not reply["result"]:
        return Packet(401, (0,))
    x, y, normal_rad, _ = reply["f"].tolist()
    return Packet(401, (1, int(x * _CUT), int(y * _CUT), int(normal_rad * _RADIANS)))


def _get_conf(_elements: Elements) -> Exchange[Packet]:
    """Ask the user for a configuration; fail if there is no page."""
    found = yield AskUser()
    return Packet(88, found) if found is not None else _ERROR


_OTHERS: Final[dict[int, Callable[[Elements], Exchange[Packet]]]] = {
    75: _get_rpx,
    200: _get_conf,
    400: _motion_check,
}
