"""Degradations of devices, and the values that they store."""

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
"""Phases of a degradation: before its onset, at full effect, fading, and ended."""

MOTIONS: Final = frozenset({"odometry", "drive", "wheels"})
"""Devices whose values are speeds during an interval, not readings at one time."""

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
    """All degradations of a world, in the order in which they are applied; n of them.

    Attributes:
        table: one record for each: the values of a `Degradation`, with its robot and device as
            numbers (-1 for all elements, infinite for ever; `stuck` is 0 for no value, 1 for the
            last one, 2 for `stuck_at`), and: `serial`, its number among all of its robot so far;
            `count`, the number of its evaluations; `phase`; `begin`, the start of its part of
            `memory`; `depth`, the number of values of each element that a delay stores, 0 for none.
        memory: the stored values, one degradation after the other. Each has, for each of its
            elements: the value that it is stuck at, NaN for none yet; then, with a delay: the
            number of stored values, the sum of displacements, `depth` times for each element,
            infinite for none yet, and `depth` values for each.
        made: number of degradations that each robot ever had, (robots,).
        present: devices with any degradation that has not ended, (devices,); never changed in
            place, so that its identity shows whether the table was changed.
        next_s: the next time at which one begins, fades or ends; infinite for never.
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
        """Append degradations, each with an empty memory."""
        self._assemble([*self._pairs(), *((row, empty_memory(row)) for row in records)])

    def remove(self, place: int) -> None:
        """Remove a degradation."""
        pairs = self._pairs()
        del pairs[place]
        self._assemble(pairs)

    def replace(self, place: int, new: Any) -> None:
        """Replace a degradation; the new one has an empty memory."""
        pairs = self._pairs()
        pairs[place] = (new, empty_memory(new))
        self._assemble(pairs)

    def _pairs(self) -> list[tuple[Any, FloatArray]]:
        """Return each degradation with its stored values."""
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
        """Update the derived values after a change of the table or of a phase.

        Args:
            others: whether the set of active degradations has changed.
        """
        table = self.table
        if others:
            present = np.zeros(len(degradables()), dtype=np.bool_)
            devices: Int64Array = table["device"]
            present[devices[table["phase"] != OVER]] = True
            self.present = present
        self.next_s = float(np.min(turns_s(table), initial=np.inf))


def turns_s(table: Records) -> FloatArray:
    """Return the times at which degradations enter their next phase, infinite for never, (n,)."""
    onset_s: FloatArray = table["onset_s"]
    duration_s: FloatArray = table["duration_s"]
    recovery_s: FloatArray = table["recovery_s"]
    phase: Int64Array = table["phase"]
    end_s = onset_s + duration_s
    never_s = np.full(len(table), np.inf)
    choices = np.stack([onset_s, end_s, end_s + recovery_s, never_s])
    return np.asarray(choices[phase, np.arange(len(table))])


def record(degradation: Degradation, robot: int, serial: int) -> Records:
    """Return a degradation as a record of the table.

    Args:
        degradation: the degradation, validated by `validation_error`.
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
    """Return the degradation of a record; `robot` is the id of its robot."""
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
    """Return the initial memory of a degradation, see `DegradationState`."""
    width = width_of(row["device"], row["element"])
    depth = int(row["depth"])
    held = np.full(width, np.nan)
    if not depth:
        return held
    times_s = np.full(width * depth, np.inf)
    return np.concatenate([held, np.zeros(2 * width), times_s, np.zeros(width * depth)])


def width_of(device: Any, element: Any) -> Any:
    """Return the number of elements for which degradations store values; numbers or arrays."""
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
