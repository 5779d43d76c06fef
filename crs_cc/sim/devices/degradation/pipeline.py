"""The effects of degradations on values, except delay."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.core.quantity import ANGLE
from crs_cc.sim.model.degradation import degradables
from crs_cc.sim.state.degradation import ALL_ELEMENTS, FIXED, FREE, HOLDS, DegradationState

_FINEST: Final = 1e-9  # rounding to smaller steps changes nothing
_MAX_VALUE: Final = 1e6
_TURN: Final = 2 * np.pi


@dataclass(slots=True)
class Pass:
    """One pass of values through one layer; m rows of w elements.

    Attributes:
        kept: the memory of all degradations.
        row: the record of each, (m,).
        slot: the number of each element in the memory, (m, w).
        touched: which elements are affected, (m, w).
        s: the severity, (m, 1).
        at_s: the time, (m, 1).
        writes: whether the memory is updated.
    """

    kept: DegradationState
    row: Any
    slot: IndexArray
    touched: BoolArray
    s: FloatArray
    at_s: FloatArray
    writes: bool

    def of(self, name: str) -> Any:
        """Return a column of the records, (m, 1)."""
        return self.row[name][:, None]


def pass_of(
    kept: DegradationState,
    row: Any,
    columns: IndexArray,
    s: FloatArray,
    at_s: FloatArray,
    *,
    writes: bool = True,
) -> Pass:
    """Return the pass of values through one layer.

    Args:
        kept: the memory of all degradations.
        row: the record of each, (m,).
        columns: the element of each value, (m, w).
        s: the severity, (m,).
        at_s: the time, (m,).
        writes: whether the memory is updated.
    """
    whole = (row["element"] == ALL_ELEMENTS)[:, None]
    touched = whole | (columns == row["element"][:, None])
    slot = np.where(whole, columns, 0)
    return Pass(kept, row, slot, touched, s[:, None], at_s[:, None], writes)


def distorted(passing: Pass, values: FloatArray, normal: FloatArray) -> FloatArray:
    """Return values with gain, bias, noise and rounding; values that are not finite stay."""
    with np.errstate(invalid="ignore"):
        new = values * (1.0 + passing.s * (passing.of("gain") - 1.0))
        new += passing.s * passing.of("bias") + passing.s * passing.of("noise") * normal
        size = passing.s * passing.of("step")
        rounds = size > _FINEST
        size = np.where(rounds, size, 1.0)
        new = np.where(rounds, np.rint(new / size) * size, new)
    changes = np.isfinite(values) & (passing.s > 0.0)
    return np.where(changes, np.clip(new, -_MAX_VALUE, _MAX_VALUE), values)


def stuck_at(passing: Pass, values: FloatArray, before: BoolArray, number: int) -> FloatArray:
    """Freeze stuck values; `before` marks the rows from before the onset, (m, 1)."""
    stuck = passing.of("stuck")
    if not stuck.any():
        return values
    memory, place = passing.kept.memory, passing.of("begin") + passing.slot
    held = memory[place]
    none_yet = np.isnan(held)
    if passing.writes:
        fresh = passing.touched & (stuck == HOLDS) & ~np.isnan(values) & (before | none_yet)
        memory[place[fresh]] = values[fresh]
    held = np.where(none_yet, values, held)
    held = np.where(stuck == FIXED, passing.of("stuck_at"), held)
    return np.where(stuck == FREE, values, mix(passing.s, values, held, number))


def mix(s: FloatArray, values: FloatArray, others: FloatArray, number: int) -> FloatArray:
    """Return the interpolation of two values, for directions along the shorter arc."""
    if _is_circular(number):
        others = values + (others - values + np.pi) % _TURN - np.pi
    with np.errstate(invalid="ignore"):
        between = (1.0 - s) * values + s * others
    return np.where(s >= 1.0, others, np.where(s <= 0.0, values, between))


@cache
def _is_circular(number: int) -> bool:
    """Return whether a device's values are directions."""
    return list(degradables().values())[number].kind is ANGLE
