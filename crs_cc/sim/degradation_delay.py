"""Delayed values: what degradations with a delay remember of the past, and how it is found again.

Each element has a ring of instants and values, and keeps values at least `delay / (depth - 2)`
apart; so the ring always reaches back beyond the delay.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np
import numpy.typing as npt

from crs_cc.sim.degradation_pass import Pass
from crs_cc.sim.states.degradation import width_of

FloatArray = npt.NDArray[np.float64]
BoolArray = npt.NDArray[np.bool_]
IndexArray = npt.NDArray[np.intp]

_ROUNDING_S: Final = 1e-9
_SPARE: Final = 2  # so many more values are kept than a delay needs
_LEAST_S: Final = 1e-3  # the shortest time over which a speed of long ago is taken


def delayed(step: Pass, values: FloatArray) -> FloatArray:
    """Gives readings of as long ago as the delay says, and remembers these."""
    delayed = values.copy()
    for some, depth in _by_depth(step):
        times_at, values_at = _rings(step, some, depth)
        _remember(step, some, depth, (values[some], step.at_s[some]))
        times_s, old = step.kept.memory[times_at], step.kept.memory[values_at]
        wanted_s = step.at_s[some] - step.of("delay_s")[some] + _ROUNDING_S
        good = times_s <= wanted_s[..., None]
        newest = np.where(good, times_s, -np.inf).argmax(axis=2)
        pick = np.where(good.any(axis=2), newest, times_s.argmin(axis=2))
        found = np.take_along_axis(old, pick[..., None], axis=2)[..., 0]
        delayed[some] = np.where(np.isinf(times_s).all(axis=2), values[some], found)
    return delayed


def delayed_speeds(step: Pass, speeds: FloatArray, from_s: FloatArray) -> FloatArray:
    """Gives the speeds of as long ago as the delay says, and remembers these."""
    delayed = speeds.copy()
    for some, depth in _by_depth(step):
        memory, to_s, since_s = step.kept.memory, step.at_s[some], from_s[some, None]
        sum_at = _sums(step, some)
        if step.writes:
            first = step.touched[some] & np.isinf(memory[_rings(step, some, depth)[0]]).all(axis=2)
            began = np.broadcast_to(since_s, first.shape)
            _remember(step, some, depth, (np.zeros_like(speeds[some]), began), first)
            memory[sum_at[step.touched[some]]] += (speeds[some] * (to_s - since_s))[
                step.touched[some]
            ]
            _remember(step, some, depth, (memory[sum_at], to_s))
        times_at, values_at = _rings(step, some, depth)
        ring = memory[times_at], memory[values_at]
        for_s = np.maximum(to_s - since_s, _LEAST_S)
        ago_s = to_s - step.of("delay_s")[some]
        way = _between(ring, ago_s) - _between(ring, ago_s - for_s)
        delayed[some] = way / for_s
    return delayed


def _between(ring: tuple[FloatArray, FloatArray], at_s: FloatArray) -> FloatArray:
    """Gives the sum of ways at instants, along straight lines between those that were kept."""
    order = np.argsort(ring[0], axis=2, kind="stable")
    times_s = np.take_along_axis(ring[0], order, axis=2)
    sums = np.take_along_axis(ring[1], order, axis=2)
    count = np.isfinite(times_s).sum(axis=2)
    upper = np.minimum((times_s <= at_s[..., None]).sum(axis=2), count - 1)
    lower, upper = np.maximum(upper - 1, 0)[..., None], np.maximum(upper, 0)[..., None]
    t0, t1 = (np.take_along_axis(times_s, each, axis=2)[..., 0] for each in (lower, upper))
    w0, w1 = (np.take_along_axis(sums, each, axis=2)[..., 0] for each in (lower, upper))
    with np.errstate(invalid="ignore"):
        part = np.divide(at_s - t0, t1 - t0, out=np.zeros_like(w0), where=t1 > t0)
    return np.asarray(w0 + (w1 - w0) * np.clip(part, 0.0, 1.0))


def _by_depth(step: Pass) -> list[tuple[IndexArray, int]]:
    depths = step.row["depth"]
    return [
        (np.flatnonzero(depths == depth), int(depth)) for depth in np.unique(depths[depths > 0])
    ]


def _widths(step: Pass, some: IndexArray) -> Any:
    return width_of(step.row["device"][some], step.row["element"][some])[:, None]


def _sums(step: Pass, some: IndexArray) -> IndexArray:
    place = step.of("begin")[some] + 2 * _widths(step, some) + step.slot[some]
    return np.asarray(place)


def _rings(step: Pass, some: IndexArray, depth: int) -> tuple[IndexArray, IndexArray]:
    """Gives where the instants and the values of each element are kept, shape (m, w, depth)."""
    width = _widths(step, some)
    times_at = step.of("begin")[some] + 3 * width + step.slot[some] * depth
    times_at = times_at[..., None] + np.arange(depth)
    return times_at, times_at + (width * depth)[..., None]


def _remember(
    step: Pass,
    some: IndexArray,
    depth: int,
    what: tuple[FloatArray, FloatArray],
    which: BoolArray | None = None,
) -> None:
    """Keeps values with their instants, unless the last ones that were kept are too near."""
    memory = step.kept.memory
    times_at, values_at = _rings(step, some, depth)
    values, at_s = what
    at_s = np.broadcast_to(at_s, values.shape)
    times_s = memory[times_at]
    last_s = np.where(np.isinf(times_s), -np.inf, times_s).max(axis=2)
    apart_s = step.of("delay_s")[some] / (depth - _SPARE)
    keeps = step.touched[some] & (at_s - last_s >= apart_s - _ROUNDING_S) & (at_s > last_s)
    if which is not None:
        keeps &= which
    count_at = step.of("begin")[some] + _widths(step, some) + step.slot[some]
    turn = (memory[count_at].astype(np.intp) % depth)[..., None]
    where_s = np.take_along_axis(times_at, turn, axis=2)[..., 0]
    where = np.take_along_axis(values_at, turn, axis=2)[..., 0]
    memory[where_s[keeps]] = at_s[keeps]
    memory[where[keeps]] = values[keeps]
    memory[count_at[keeps]] += 1.0
