"""What is wrong with the devices of robots, and what the law of degradation remembers."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import TYPE_CHECKING, Any, Final, Literal, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, Int64Array, Records
from crs_cc.sim.model.degradation import HOLD, Degradation, degradables, delay_depth

if TYPE_CHECKING:
    from crs_cc.sim.model.world import WorldModel


WAITS, ACTS, FADES, OVER = range(4)
"""Phases of a degradation: before its onset, for its duration, while it fades, and then."""

MOTIONS: Final = frozenset({"odometry", "drive", "wheels"})
"""Devices whose values are speeds all along a time, not readings at instants."""

ALL_ELEMENTS: Final = -1
FREE, HOLDS, FIXED = range(3)
_NUMBERS: Final = (
    "bias", "gain", "noise", "step", "delay_s", "dropouts", "onset_s", "recovery_s",
)  # fmt: skip
_FORM: Final = np.dtype(
    [
        ("id", "U64"), ("robot", "i8"), ("device", "i8"), ("element", "i8"),
        ("bias", "f8"), ("gain", "f8"), ("noise", "f8"), ("step", "f8"),
        ("stuck", "i8"), ("stuck_at", "f8"), ("delay_s", "f8"), ("dropouts", "f8"), ("dead", "?"),
        ("onset_s", "f8"), ("duration_s", "f8"), ("recovery_s", "f8"),
        ("serial", "i8"), ("count", "i8"), ("phase", "i8"), ("begin", "i8"), ("depth", "i8"),
    ]
)  # fmt: skip


@dataclass(slots=True)
class DegradationState:
    """All degradations of a world, in the order in which they work; n of them.

    Attributes:
        table: one record for each: what a `Degradation` has, with its robot and device as numbers
            (all elements are -1, for ever is infinite; `stuck` tells whether there is a value,
            0 none, 1 the last one, 2 `stuck_at`), and: `serial`, its number among those that
            its robot ever had; `count`, how often it was asked; `phase`; `begin`, where its part of
            `memory` begins; `depth`, how many values of each element a delay remembers, 0 for none.
        memory: what they remember, one after the other. Each has, for each of its elements: the
            value that it is stuck at, NaN for none yet; then, if it delays: how many values it has
            kept, the sum of ways, `depth` instants for each element, infinite for none yet, and
            `depth` values for each.
        made: how many degradations each robot ever had, (robots,).
        present: which devices have any that is not over, (devices,); never changed in place, so
            that it tells whether the table is another one.
        next_s: when the next one begins, fades or is over; infinite for never.
    """

    table: Records
    memory: FloatArray
    made: Int64Array
    present: BoolArray
    next_s: float

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return the degradations of a world file, none of which has begun."""
        state = cls(
            np.zeros(0, _FORM),
            np.zeros(0),
            np.zeros(len(world.robots), dtype=np.int64),
            np.zeros(len(degradables()), dtype=np.bool_),
            np.inf,
        )
        numbers = {robot.id: number for number, robot in enumerate(world.robots)}
        records = []
        for each in world.degradations:
            robot = numbers[each.robot]
            records.append(record(each, robot, int(state.made[robot])))
            state.made[robot] += 1
        state.append(records)
        return state

    def append(self, records: Sequence[Any]) -> None:
        """Add degradations behind the others, each with an empty memory."""
        self._assemble([*self._pairs(), *((row, empty_memory(row)) for row in records)])

    def remove(self, place: int) -> None:
        """Takes a degradation out."""
        pairs = self._pairs()
        del pairs[place]
        self._assemble(pairs)

    def replace(self, place: int, new: Any) -> None:
        """Puts another degradation in the place of one; it begins with an empty memory."""
        pairs = self._pairs()
        pairs[place] = (new, empty_memory(new))
        self._assemble(pairs)

    def _pairs(self) -> list[tuple[Any, FloatArray]]:
        """Return each degradation with what it remembers."""
        ends = [*self.table["begin"].tolist(), len(self.memory)]
        parts = (self.memory[begin:end] for begin, end in itertools.pairwise(ends))
        return list(zip(self.table, parts, strict=True))

    def _assemble(self, pairs: Sequence[tuple[Any, FloatArray]]) -> None:
        self.table = np.array([row for row, _ in pairs], dtype=_FORM)
        sizes = [len(part) for _, part in pairs]
        self.table["begin"] = np.cumsum([0, *sizes])[:-1]
        self.memory = np.concatenate([np.zeros(0), *(part for _, part in pairs)])
        self.refresh()

    def refresh(self, *, others: bool = True) -> None:
        """Takes note that the table or a phase has changed.

        Args:
            others: whether other degradations than before work from now on.
        """
        table = self.table
        if others:
            present = np.zeros(len(degradables()), dtype=np.bool_)
            present[table["device"][table["phase"] != OVER]] = True
            self.present = present
        self.next_s = float(np.min(turns_s(table), initial=np.inf))


def turns_s(table: Records) -> FloatArray:
    """Return when degradations come to their next phase, infinite for never, shape (n,)."""
    end_s = table["onset_s"] + table["duration_s"]
    never_s = np.full(len(table), np.inf)
    choices = np.stack([table["onset_s"], end_s, end_s + table["recovery_s"], never_s])
    return np.asarray(choices[table["phase"], np.arange(len(table))])


def record(degradation: Degradation, robot: int, serial: int) -> Records:
    """Return a degradation as a record of the table.

    Args:
        degradation: the degradation, which `complaint` has found nothing wrong with.
        robot: its robot's number.
        serial: its number among those of its robot.
    """
    device, stuck = degradables()[degradation.device], degradation.stuck
    width = device.width if degradation.element is None else 1
    row = np.zeros((), _FORM)
    row["id"], row["robot"], row["serial"] = degradation.id, robot, serial
    row["device"] = number_of(device.name)
    row["element"] = ALL_ELEMENTS if degradation.element is None else degradation.element
    for name in ("dead", *_NUMBERS):
        row[name] = getattr(degradation, name)
    row["duration_s"] = np.inf if degradation.duration_s is None else degradation.duration_s
    if stuck is not None:
        row["stuck"] = HOLDS if stuck == HOLD else FIXED
        row["stuck_at"] = 0.0 if stuck == HOLD else stuck
    if degradation.delay_s:
        row["depth"] = delay_depth(width)
    return row


def degradation_of(row: Any, robot: str) -> Degradation:
    """Return a record as plain data; `robot` is the id of its robot."""
    stuck: float | Literal["hold"] | None = None
    if row["stuck"] != FREE:
        stuck = HOLD if row["stuck"] == HOLDS else float(row["stuck_at"])
    duration_s = float(row["duration_s"])
    values = {name: float(row[name]) for name in _NUMBERS}
    return Degradation(
        robot,
        list(degradables())[row["device"]],
        None if row["element"] == ALL_ELEMENTS else int(row["element"]),
        stuck=stuck,
        dead=bool(row["dead"]),
        duration_s=None if np.isinf(duration_s) else duration_s,
        id=str(row["id"]),
        **values,
    )


def empty_memory(row: Any) -> FloatArray:
    """Return what a degradation remembers at first, see `DegradationState`."""
    width = width_of(row["device"], row["element"])
    depth = int(row["depth"])
    held = np.full(width, np.nan)
    if not depth:
        return held
    times_s = np.full(width * depth, np.inf)
    return np.concatenate([held, np.zeros(2 * width), times_s, np.zeros(width * depth)])


def width_of(device: Any, element: Any) -> Any:
    """Return of how many elements degradations remember values; numbers or arrays."""
    return np.where(element == ALL_ELEMENTS, _widths()[device], 1)


def number_of(device: str) -> int:
    """Return the number of a device in arrays."""
    return _numbers_of_devices()[device]


@cache
def _numbers_of_devices() -> dict[str, int]:
    return {name: number for number, name in enumerate(degradables())}


@cache
def _widths() -> Int64Array:
    return np.array([device.width for device in degradables().values()])
