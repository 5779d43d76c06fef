"""The memory of the kernel of calm time, see `calm.c`: its inputs and results.

It has copies of the rows of a world's robots, and tables, one after the other.
"""

from __future__ import annotations

import struct
from typing import TYPE_CHECKING, Any, Final, NamedTuple

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import ByteArray
from crs_cc.requests import NUM_STATE, SLOT, TIMING
from crs_cc.sim.kernels.tables import (
    BATTERY_SIZE,
    BODY_SIZE,
    CALM,
    KIND_SIZE,
    RING_SIZE,
    RINGS,
    ROBOT_SIZE,
    SETUP,
)

if TYPE_CHECKING:
    from crs_cc.runtime.kernel_instance import KernelInstance

MAX_ROWS: Final = 64
"""Robots and bodies at most."""
CODES: Final = 256
"""Codes of requests are smaller."""
RUN, ASKED, REFUSED, DONE, FULL, DRAWN, STANDS = range(7)
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

_HEAD: Final = np.dtype(
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
first four fields as they are, see `recording/reading_buffer.py`."""
FRAME: Final = 7
"""Numbers of a frame: x, y [m], heading, turret [rad]; x, y [m] and heading [rad] believed."""

_NUMBER: Final = 8  # bytes
RECORD_SIZE: Final = (SLOT.itemsize + TIMING.itemsize) // _NUMBER
FACE_SIZE: Final = 6
ROUND_SIZE: Final = 4
BACKUP_SIZE: Final = ROBOT_SIZE + BODY_SIZE + BATTERY_SIZE
"""Numbers of a program's slot and timing; of a face and a round that an echo may come from; and of
a robot that is to be restored. See `calm.h`, `echoes.h` and `calm_motion.c`."""

_SETUP: Final = struct.Struct("<5i")
_PLACES: Final = struct.Struct("<6i")
_THIRD: Final = 540_000
_CHANGED: Final = struct.Struct("<qddqqqqqqq")
_TOLD: Final = struct.Struct("<iid")


class Changed(NamedTuple):
    """The numbers that the kernel changes, as in `calm.h`.

    Attributes:
        cycle: the current cycle.
        room_m: the room that robots have left, see `physics/simulation.py`.
        goal_room_m: the room until a goal has to be judged, see `engine/goals.py`.
        rounds: rounds of programs in this cycle.
        ended: cycles that have ended.
        answers: answers that have been logged and are kept.
        batch: requests that were answered together have the same number.
        served: requests that were answered in this cycle.
        was_served: those of the cycle before.
        is_weary: whether a motor battery may be empty before the end of the next cycle.
    """

    cycle: int
    room_m: float
    goal_room_m: float
    rounds: int = 0
    ended: int = 0
    answers: int = 0
    batch: int = 0
    served: int = 0
    was_served: int = 0
    is_weary: int = 0


class CalmKernel:
    """The kernel of calm time in an instance of its own.

    Attributes:
        turn: the address of its `TURN`.
        arena: numbers; at first `struct calm`, then the tables.
        robots, bodies, batteries, kinds, sonars: rows, as of `Kernels`.
    """

    def __init__(self, instance: KernelInstance) -> None:
        """Take an instance that has just been started."""
        place, memory = int(instance.message[0]), instance.memory.data
        _SETUP.pack_into(memory, place, SETUP, _THIRD, MAX_ROWS, MAX_ROWS, MAX_ROWS)
        instance.resume()
        self.turn, *tables = _PLACES.unpack_from(memory, place)
        sizes = (
            ROBOT_SIZE * MAX_ROWS,
            BODY_SIZE * MAX_ROWS,
            BATTERY_SIZE * MAX_ROWS,
            KIND_SIZE * MAX_ROWS,
        )
        self.robots, self.bodies, self.batteries, self.kinds, self.sonars = (
            instance.memory[begin : begin + size * _NUMBER].data
            for begin, size in zip(tables, (*sizes, RING_SIZE * RINGS), strict=True)
        )
        self._instance = instance  # keeps its memory alive
        self._place, self._memory = place, memory
        end = self.turn + 3 * _THIRD * _NUMBER
        self.arena: ByteArray = instance.memory[self.turn : end]
        self._bytes = self.arena.data
        self._head = np.frombuffer(self.arena, _HEAD, 1)
        self._begins: dict[str, int] = {}  # of tables [bytes]
        self._changed = _HEAD.fields["cycle"][1]  # type: ignore[index]

    def lay(self, tables: dict[str, npt.NDArray[Any]], spaces: dict[str, int]) -> None:
        """Lay tables one after the other, and reserve space [numbers] for others."""
        place = -(-_HEAD.itemsize // _NUMBER)
        drawn = [form.format(name) for name in SENSORS for form in (_FIRST, _DEVIATES)]
        for name in (*TABLES, *drawn):
            self._head[name] = place
            self._begins[name] = place * _NUMBER
            if name in tables:
                content = tables[name].tobytes()
                self._bytes[place * _NUMBER : place * _NUMBER + len(content)] = content
                place += -(-len(content) // _NUMBER)
            else:
                place += spaces.get(name, 0)

    def tell(self, **numbers: float) -> None:
        """Set the input of the kernel."""
        for name, number in numbers.items():
            self._head[name] = number

    def begin(self, until: int, cycle: int, room_m: float, goal_room_m: float) -> None:
        """Set the data that differs with each call, and the data that the kernel changes."""
        self._head["until"] = until
        changed = Changed(cycle, room_m, goal_room_m)
        _CHANGED.pack_into(self._bytes, self._changed, *changed)
        _TOLD.pack_into(self._bytes, 0, 0, -1, 0.0)
        struct.pack_into("<i", self._memory, self._place, CALM)

    def outcome(self) -> tuple[int, Changed]:
        """Return the reason why the kernel returned, and its changes."""
        changed = _CHANGED.unpack_from(self._bytes, self._changed)
        return _TOLD.unpack_from(self._bytes)[0], Changed(*changed)

    def table(self, name: str, count: int, dtype: npt.DTypeLike = np.float64) -> Any:
        """Return a view of the first entries of a table."""
        return np.ndarray(count, dtype, self._bytes, self._begins[name])

    def content(self, name: str, count: int) -> bytes:
        """Return the first numbers of a table as bytes."""
        place = self._begins[name]
        return bytes(self._bytes[place : place + count * _NUMBER])

    def address(self, name: str) -> int:
        """Return the address of a table in the kernel's memory."""
        return int(self.turn) + self._begins[name]
