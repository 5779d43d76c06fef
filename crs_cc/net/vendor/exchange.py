"""Exchanges with a robot: the requests of a relay and their replies, as bytes and as numbers.

An exchange is a generator that yields requests, receives their replies, and returns their combined
result. It does not depend on time or on connections.

>>> asked = read_laser(3, width=2)
>>> next(asked).code == CODES["LASER_PAGE"]
True
>>> reply = make_request("LASER_PAGE", 2, data=np.array([10, -1, 20, -2, 30, -3], "<i4").tobytes())
>>> reply.message["result"] = 3
>>> try:
...     asked.send(reply.message)
... except StopIteration as end:
...     print(end.value)
[10, -1, 20, -2, 30, -3]
"""

from __future__ import annotations

import math
from collections.abc import Generator, Sequence
from dataclasses import dataclass
from typing import Any, Final, TypeAlias, TypeVar

import numpy as np

from crs_cc.core.arrays import Records
from crs_cc.requests import CODES, DATA_SIZE, LARGEST, MESSAGE

HEAD: Final = MESSAGE.itemsize - DATA_SIZE
"""Bytes of a message before its data."""

_RECORD: Final = 9
"""Numbers of a position: where the robot was, its speeds, and two times (`Nclient.h` 1.29)."""


@dataclass(frozen=True, slots=True, eq=False)
class Request:
    """A request to the robot.

    Attributes:
        code: its code.
        message: its message, of dtype `MESSAGE`.
    """

    code: int
    message: Any

    def encoded(self) -> bytes:
        """Return it as the relay reads it."""
        size = int(self.message["size"])
        message: bytes = self.message.tobytes()
        return self.code.to_bytes(4, "little") + message[: HEAD + size]


@dataclass(frozen=True, slots=True)
class AskUser:
    """A request to the user for a configuration, by clicks; None if there is no user."""


T = TypeVar("T")
Exchange: TypeAlias = Generator[Request | AskUser, Any, T]
"""Yields requests, and receives the reply to each, of dtype `MESSAGE`."""


def make_request(name: str, *numbers: int, data: bytes = b"") -> Request:
    """Return a request by its name, with integers that are clamped to 32 bits and data."""
    message = np.zeros(1, MESSAGE)[0]
    for place, number in enumerate(numbers):
        message["i"][place] = max(-LARGEST - 1, min(number, LARGEST))
    data = data[:DATA_SIZE]
    message["size"] = len(data)
    message["data"][: len(data)] = np.frombuffer(data, np.uint8)
    return Request(CODES[name], message)


class ReplyReader:
    """Assembles replies from the data that a relay writes."""

    def __init__(self) -> None:
        self._content = bytearray()

    def add(self, piece: bytes) -> Records | None:
        """Add a piece; return the reply if it is complete."""
        self._content += piece
        if len(self._content) < HEAD:
            return None
        size = int(np.frombuffer(self._content, "<i4", 1, HEAD - 8)[0])
        if len(self._content) < HEAD + size:
            return None
        reply = np.zeros(1, MESSAGE)
        reply.view(np.uint8)[: HEAD + size] = self._content[: HEAD + size]
        self._content.clear()
        return reply[0]  # type: ignore[no-any-return]


def numbers_in(reply: Any) -> list[int]:
    """Return the 32-bit integers in a reply's data."""
    return reply["data"].view("<i4")[: int(reply["size"]) // 4].tolist()  # type: ignore[no-any-return]


def read_laser(count: int, width: int, *, is_predicted: bool = False) -> Exchange[list[int]]:
    """Return the available laser readings.

    Args:
        count: how many there are.
        width: how many numbers each is to have; a reading that has others is cut or filled with 0.
        is_predicted: whether they are those of a prediction.
    """
    found: list[int] = []
    reading = 0
    while reading < count:
        page = yield make_request("LASER_PAGE", reading, int(is_predicted))
        size, wide = int(page["result"]), int(page["i"][0])
        if size <= 0:
            break
        reading += size
        found += [int(each) for each in page["data"].view("<i4")[: size * wide]]
    wanted = count * width
    return (found + [0] * (wanted - len(found)))[:wanted]


def read_positions(kind: int, count: int) -> Exchange[list[Sequence[int]]]:
    """Return the positions in the last reply of one kind of sensor, or zeros if there are none."""
    found: list[Sequence[int]] = []
    while len(found) < count:
        page = yield make_request("POS_DATA", kind, len(found))
        size = int(page["result"])
        if size <= 0:
            break
        numbers = page["data"].view("<i4")[: size * _RECORD].reshape(-1, _RECORD)
        found += numbers.tolist()
    none: list[Sequence[int]] = [[0] * _RECORD for _ in range(count)]
    return [*found, *none][:count]


def read_poses() -> Exchange[list[int]]:
    """Return the true poses of all robots, three numbers each; twenty fit into a reply."""
    poses: list[int] = []
    robots = math.inf
    while len(poses) < 3 * robots:
        page = yield make_request("GET_RPX", len(poses) // 3)
        robots = int(page["result"])
        if robots <= 0 or not int(page["size"]):
            break
        poses += numbers_in(page)
    return poses
