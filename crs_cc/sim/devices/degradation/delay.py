"""Delayed values: the memory of past values of degradations with a delay.

Each element has a ring buffer of times and values, and stores values at least `delay / (depth - 2)`
apart; so the buffer always reaches back beyond the delay.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.core.time_grid import ROUNDING_S
from crs_cc.sim.devices.degradation.pipeline import Pass
from crs_cc.sim.state.degradation import width_of

_SPARE: Final = 2  # values kept in addition to those that a delay needs
_MIN_AVERAGING_S: Final = 1e-3  # minimum time over which a delayed speed is averaged


@dataclass(frozen=True, slots=True)
class _Rings:
    """Views of the ring buffers of past values: m rows with w elements, `depth` each.

    Attributes:
        memory: the memory of all degradations.
        count_at: index of each element's number of values so far, (m, w).
        sum_at: index of its sum of distances, (m, w).
        times_at: indices of the times, (m, w, depth).
        values_at: indices of the values, (m, w, depth).
        touched: which elements are affected, (m, w).
        apart_s: minimum time between two values that are kept, (m, 1).
    """

    memory: FloatArray
    count_at: IndexArray
    sum_at: IndexArray
    times_at: IndexArray
    values_at: IndexArray
    touched: BoolArray
    apart_s: FloatArray

    @classmethod
    def of(cls, passing: Pass, some: IndexArray, depth: int) -> Self:
        """Return the ring buffers of some rows."""
        width = width_of(passing.row["device"][some], passing.row["element"][some])[:, None]
        begin, slot = passing.of("begin")[some], passing.slot[some]
        times_at = (begin + 3 * width + slot * depth)[..., None] + np.arange(depth)
        return cls(
            passing.kept.memory,
            begin + width + slot,
            begin + 2 * width + slot,
            times_at,
            times_at + (width * depth)[..., None],
            passing.touched[some],
            passing.of("delay_s")[some] / (depth - _SPARE),
        )

    @property
    def begin(self) -> BoolArray:
        """Return which elements have no past values yet."""
        return np.asarray(self.touched & (self.memory[self.count_at] == 0.0))

    def keep(self, values: FloatArray, at_s: FloatArray, which: BoolArray) -> None:
        """Store values with their times, unless the last stored ones are too recent."""
        depth = self.times_at.shape[2]
        count = self.memory[self.count_at].astype(np.intp)
        last = ((count - 1) % depth)[..., None]
        last_s = self.memory[np.take_along_axis(self.times_at, last, axis=2)[..., 0]]
        since_s = at_s - np.where(count > 0, last_s, -np.inf)
        keeps = which & (since_s >= self.apart_s - ROUNDING_S) & (since_s > 0.0)
        turn = (count % depth)[..., None]
        for places, what in ((self.times_at, at_s), (self.values_at, values)):
            place = np.take_along_axis(places, turn, axis=2)[..., 0]
            self.memory[place[keeps]] = np.broadcast_to(what, keeps.shape)[keeps]
        self.memory[self.count_at[keeps]] += 1.0

    def find(self, at_s: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
        """Return times and values of the last stored at or before, and the first after, times.

        A missing one has an infinite time and the value of another one.
        """
        times_s = self.memory[self.times_at]
        since = times_s <= at_s[..., None]
        lower = np.where(since, times_s, -np.inf).argmax(axis=2)[..., None]
        upper = np.where(since, np.inf, times_s).argmin(axis=2)[..., None]
        lower_s = np.take_along_axis(times_s, lower, axis=2)[..., 0]
        upper_s = np.take_along_axis(times_s, upper, axis=2)[..., 0]
        values = [
            self.memory[np.take_along_axis(self.values_at, each, axis=2)[..., 0]]
            for each in (lower, upper)
        ]
        return (
            np.where(lower_s <= at_s, lower_s, -np.inf),
            values[0],
            np.where(upper_s > at_s, upper_s, np.inf),
            values[1],
        )


def delayed(passing: Pass, values: FloatArray) -> FloatArray:
    """Return the readings of `delay` ago, and store these."""
    reported = values.copy()
    for some, depth in _by_depth(passing):
        rings = _Rings.of(passing, some, depth)
        rings.keep(values[some], passing.at_s[some], rings.touched)
        wanted_s = passing.at_s[some] - passing.of("delay_s")[some] + ROUNDING_S
        lower_s, lower, upper_s, upper = rings.find(wanted_s)
        first = np.where(np.isfinite(upper_s), upper, values[some])
        reported[some] = np.where(np.isfinite(lower_s), lower, first)
    return reported


def delayed_speeds(passing: Pass, speeds: FloatArray, from_s: FloatArray) -> FloatArray:
    """Return the speeds of `delay` ago, and store these.

    Args:
        passing: the filter pass; its time is the end of the interval of the speeds.
        speeds: the speeds, (m, w).
        from_s: the start of that interval, (m,).
    """
    reported = speeds.copy()
    for some, depth in _by_depth(passing):
        to_s, since_s = passing.at_s[some], from_s[some, None]
        rings = _Rings.of(passing, some, depth)
        if passing.writes:
            begin = rings.begin
            if begin.any():
                rings.keep(np.zeros_like(speeds[some]), since_s, begin)
            motions = speeds[some] * (to_s - since_s)
            rings.memory[rings.sum_at[rings.touched]] += motions[rings.touched]
            rings.keep(rings.memory[rings.sum_at], to_s, rings.touched)
        for_s = np.maximum(to_s - since_s, _MIN_AVERAGING_S)
        ago_s = to_s - passing.of("delay_s")[some]
        reported[some] = (_sum(rings, ago_s) - _sum(rings, ago_s - for_s)) / for_s
    return reported


def _sum(rings: _Rings, at_s: FloatArray) -> FloatArray:
    """Return the sums of distances at times, linearly interpolated between the stored ones."""
    lower_s, lower, upper_s, upper = rings.find(at_s)
    between = np.isfinite(lower_s) & np.isfinite(upper_s)
    with np.errstate(invalid="ignore"):
        part = np.divide(at_s - lower_s, upper_s - lower_s, out=np.zeros_like(lower), where=between)
    return np.where(np.isfinite(lower_s), lower + part * (upper - lower), upper)


def _by_depth(passing: Pass) -> list[tuple[IndexArray, int]]:
    depths = passing.row["depth"]
    return [
        (np.flatnonzero(depths == depth), int(depth)) for depth in np.unique(depths[depths > 0])
    ]
