"""The memory of the kernel of calm time, see `calm.c`: what it is told, and what it tells.

It has copies of the rows of a world's robots, and tables, one after the other.
"""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, Any, Final

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import ByteArray
from crs_cc.requests import NUM_STATE
from crs_cc.sim.kernels.tables import (
    BATTERY_SIZE,
    BODY_SIZE,
    KIND_SIZE,
    RING_SIZE,
    RINGS,
    ROBOT_SIZE,
)

if TYPE_CHECKING:
    from crs_cc.runtime.kernel_instance import KernelInstance

MOST: Final = 64
"""Robots and bodies at most."""
CODES: Final = 256
"""Codes of requests are smaller."""
ASKED, REFUSED, DONE, FULL, DRAWN, STANDS = range(1, 7)
"""Why the kernel returns, as in `calm.h`."""

TABLES: Final = (
    "records", "rows", "joined", "called", "modes", "mistakes", "beams", "segments", "circles",
    "pieces", "work", "links", "commands", "measures", "most", "volts", "volts_of", "ring_of",
    "rings", "fans", "compass_of", "compasses", "backup", "frames", "answers",
)  # fmt: skip
"""The tables, in their order."""
SENSORS: Final = "sonar", "ring", "compass"
"""Those with random errors, in their order."""
_FIRST, _DEVIATES, _DRAWS = ("{}_first", "{}_deviates", "{}_draws")
_DRAWN: Final = [form.format(name) for name in SENSORS for form in (_FIRST, _DEVIATES, _DRAWS)]

CALM: Final = np.dtype(
    [
        ("verdict", "<i4"), ("ran", "<i4"), ("end_s", "<f8"),
        *((name, "<i8") for name in (*TABLES, *_DRAWN)),
        ("count", "<i8"), ("present", "<i8"), ("segment_count", "<i8"), ("circle_count", "<i8"),
        ("piece_count", "<i8"), ("frame_room", "<i8"), ("answer_room", "<i8"), ("keeps", "<i8"),
        ("until", "<i8"), ("laser_count", "<i8"), ("batteries", "<i8"), ("board_ms", "<i8"),
        ("timestep_s", "<f8"), ("slop_m", "<f8"),
        ("cycle", "<i8"), ("room_m", "<f8"), ("goal_room_m", "<f8"), ("rounds", "<i8"),
        ("ended", "<i8"), ("answer_count", "<i8"), ("batch", "<i8"), ("served", "<i8"),
        ("was_served", "<i8"), ("is_weary", "<i8"),
    ]
)  # fmt: skip
"""`struct calm`."""

ANSWER: Final = np.dtype(
    [
        ("clock_s", "<f8"), ("code", "<i4"), ("robot", "<i4"), ("state", "<i4", NUM_STATE),
        ("batch", "<i4"), ("cycle", "<i8"), ("result", "<i4"), ("arguments", "<i4", 8),
        ("_", "<i4"),
    ]
)  # fmt: skip
"""An answer that is logged: answers with the same batch were given together. Recorders copy the
first four fields as they are, see `recording/gathered_readings.py`."""
FRAME: Final = 7
"""Numbers of a frame: x, y [m], heading, turret [rad]; x, y [m] and heading [rad] believed."""

_NUMBER: Final = 8  # bytes
_KERNEL: Final = 116
_SETUP: Final = struct.Struct("<5i"), 99
_PLACES: Final = struct.Struct("<6i")
_THIRD: Final = 540_000
_CHANGES: Final = "cycle"  # the first of what the kernel changes
_CHANGED: Final = struct.Struct("<qddqqqqqqq")
_TOLD: Final = struct.Struct("<iid")


class CalmKernel:
    """The kernel of calm time in an instance of its own.

    Attributes:
        turn: the address of its `TURN`.
        arena: numbers; at first a `CALM`, then the tables.
        robots, bodies, batteries, kinds, sonars: rows, as of `Kernels`.
    """

    def __init__(self, instance: KernelInstance) -> None:
        """Take an instance that has just been started."""
        place, memory = int(instance.message[0]), instance.memory.data
        form, number = _SETUP
        form.pack_into(memory, place, number, _THIRD, MOST, MOST, MOST)
        instance.resume()
        self.turn, *tables = _PLACES.unpack_from(memory, place)
        sizes = ROBOT_SIZE * MOST, BODY_SIZE * MOST, BATTERY_SIZE * MOST, KIND_SIZE * MOST
        self.robots, self.bodies, self.batteries, self.kinds, self.sonars = (
            instance.memory[begin : begin + size * _NUMBER].data
            for begin, size in zip(tables, (*sizes, RING_SIZE * RINGS), strict=True)
        )
        self._instance, self._place, self._memory = instance, place, memory
        end = self.turn + 3 * _THIRD * _NUMBER
        self.arena: ByteArray = instance.memory[self.turn : end]
        self._bytes = self.arena.data
        self._head = np.frombuffer(self.arena, CALM, 1)
        self._first = CALM.fields[_CHANGES][1]  # type: ignore[index]
        self._end = 0  # of the tables so far

    def lay(self, tables: dict[str, npt.NDArray[Any]], spaces: dict[str, int]) -> None:
        """Lay tables one after the other, and reserve space [numbers] for others."""
        place = -(-CALM.itemsize // _NUMBER)
        drawn = [form.format(name) for name in SENSORS for form in (_FIRST, _DEVIATES)]
        for name in (*TABLES, *drawn):
            self._head[name] = place
            if name in tables:
                content = tables[name].tobytes()
                self._bytes[place * _NUMBER : place * _NUMBER + len(content)] = content
                place += -(-len(content) // _NUMBER)
            else:
                place += spaces.get(name, 0)

    def tell(self, **numbers: float) -> None:
        """Set what the kernel is told."""
        for name, number in numbers.items():
            self._head[name] = number

    def begin(self, until: int, cycle: int, room_m: float, goal_room_m: float) -> None:
        """Set what differs with each call, and what the kernel changes."""
        self._head["until"] = until
        changed = cycle, room_m, goal_room_m, 0, 0, 0, 0, 0, 0, 0
        _CHANGED.pack_into(self._bytes, self._first, *changed)
        _TOLD.pack_into(self._bytes, 0, 0, -1, 0.0)
        struct.pack_into("<i", self._memory, self._place, _KERNEL)

    def outcome(self) -> tuple[int, tuple[Any, ...]]:
        """Return why it has returned, and what it has changed, from `cycle` on."""
        return _TOLD.unpack_from(self._bytes)[0], _CHANGED.unpack_from(self._bytes, self._first)

    def table(self, name: str, count: int, dtype: npt.DTypeLike = np.float64) -> Any:
        """Return a view of the first entries of a table."""
        place = int(self._head[name][0]) * _NUMBER
        return np.ndarray(count, dtype, self._bytes, place)

    def content(self, name: str, count: int) -> bytes:
        """Return the first numbers of a table as bytes."""
        place = int(self._head[name][0]) * _NUMBER
        return bytes(self._bytes[place : place + count * _NUMBER])

    def address(self, name: str) -> int:
        """Return the address of a table in the kernel's memory."""
        return int(self.turn + self._head[name][0].item() * _NUMBER)
