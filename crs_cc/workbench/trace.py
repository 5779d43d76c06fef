"""What robots did and measured at every timestep, so that plots are complete at any speed.

Of the first robots of a run only, and within bounded memory: when it runs out, every second sample
of the older half goes.
"""

from __future__ import annotations

import copy
import math
from bisect import bisect_left, bisect_right
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.sim.devices.sonar.state import sonar_state

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.core.arrays import FloatArray
    from crs_cc.sim.engine.environment import Environment

MAX_ROBOTS: Final = 64
"""Robots that are traced; chosen by us."""

MAX_NUMBERS: Final = 6_000_000
"""Numbers that are kept, 48 MB; chosen by us: four hours of three robots."""

_MOTION: Final = ("pose.x", "pose.y", "pose.heading", "speed", "turn")
_SLACK_S: Final = 1e-9


@dataclass(frozen=True, slots=True)
class Difference:
    """The first difference of a quantity in two runs; NaN for no value.

    Attributes:
        time_s: when.
        robot: of which robot.
        name: of which quantity.
        here: its value in this run.
        there: its value in the other one.
    """

    time_s: float
    robot: int
    name: str
    here: float
    there: float


Samples = tuple[list[float], list[float | None]]
"""Times [s] and values, None for missing ones."""


class Trace:
    """Samples of the motion and the sonars of robots."""

    def __init__(self, most_numbers: int = MAX_NUMBERS) -> None:
        self._most_numbers = most_numbers
        self._numbers = 0
        self._times_s: list[float] = []
        self._samples: list[FloatArray] = []  # (robots, columns) each
        self._names: tuple[str, ...] = ()
        self._base_m: FloatArray = np.zeros(0)
        self._steers = np.zeros(0, bool)

    def add(self, environment: Environment) -> None:
        """Record the current poses and readings of robots, unless this time is known."""
        time_s = environment.time_s
        if self._times_s and time_s <= self._times_s[-1] + _SLACK_S:
            return
        sample = self._sample(environment)
        self._times_s.append(time_s)
        self._samples.append(sample)
        self._numbers += sample.size
        if self._numbers > self._most_numbers:
            self._thin()

    def _sample(self, environment: Environment) -> FloatArray:
        if environment.names is not self._names:
            self._names = environment.names
            drives = [each.model.drive for each in environment.world.robots[:MAX_ROBOTS]]
            self._base_m = np.array([each.wheel_base_m or 1.0 for each in drives])
            self._steers = np.array([each.steering is not None for each in drives], bool)
        state, count = environment.last_state, len(self._base_m)
        first, second = state.drive.axes.speed[:count, 0], state.drive.axes.speed[:count, 1]
        speed_mps = np.where(self._steers, first, (first + second) / 2)
        turn_radps = np.where(self._steers, second, (first - second) / self._base_m)
        echo_m = sonar_state(state).echo_m[:count]
        sample = np.empty((count, len(_MOTION) + echo_m.shape[1]))
        sample[:, 0], sample[:, 1] = state.x_m[:count], state.y_m[:count]
        sample[:, 2] = np.degrees(state.heading_rad[:count]) % 360.0
        sample[:, 3], sample[:, 4] = speed_mps, np.degrees(turn_radps)
        sample[:, len(_MOTION) :] = np.where(np.isfinite(echo_m), echo_m, np.nan)
        sample[~state.presence.present[:count]] = np.nan
        return sample

    def _thin(self) -> None:
        half = len(self._samples) // 2
        self._times_s[:half] = self._times_s[:half:2]
        self._samples[:half] = self._samples[:half:2]
        self._numbers = sum(each.size for each in self._samples)

    def truncate(self, time_s: float) -> None:
        """Discard entries after a time."""
        first = bisect_right(self._times_s, time_s + _SLACK_S)
        self._numbers -= sum(each.size for each in self._samples[first:])
        del self._times_s[first:], self._samples[first:]

    def fork(self) -> Trace:
        """Return an independent copy."""
        other = copy.copy(self)
        other._times_s, other._samples = self._times_s[:], self._samples[:]
        return other

    def first_differences(self, other: Trace) -> list[Difference]:
        """Return when each quantity of each robot first differs from that in another trace."""
        mine = {round(time_s, 6): number for number, time_s in enumerate(self._times_s)}
        found: list[Difference] = []
        seen = np.zeros((0, 0), bool)
        for theirs, time_s in enumerate(other._times_s):
            own = mine.get(round(time_s, 6))
            if own is None or self._samples[own].shape != other._samples[theirs].shape:
                continue
            one, another = self._samples[own], other._samples[theirs]
            if seen.shape != one.shape:
                seen = np.zeros(one.shape, bool)
            differs = (one != another) & ~(np.isnan(one) & np.isnan(another)) & ~seen
            seen |= differs
            for robot, column in np.argwhere(differs).tolist():
                values = float(one[robot, column]), float(another[robot, column])
                found.append(Difference(time_s, robot, _name(column), *values))
        return found

    def motion(self, begin_s: float, end_s: float) -> tuple[FloatArray, FloatArray]:
        """Return the times [s] of a span, and the poses then [m, rad], (times, 3, robots)."""
        first = bisect_left(self._times_s, begin_s - _SLACK_S)
        end = bisect_right(self._times_s, end_s + _SLACK_S)
        robots = max((len(each) for each in self._samples[first:end]), default=0)
        poses = np.full((end - first, 3, robots), np.nan)
        for pose, sample in zip(poses, self._samples[first:end], strict=True):
            pose[:, : len(sample)] = sample[:, :3].T
        poses[:, 2] = np.radians(poses[:, 2])
        return np.array(self._times_s[first:end]), poses

    def samples(
        self, robot: int, name: str, begin_s: float, end_s: float, most: int
    ) -> Samples | None:
        """Return a quantity of a robot over time; None if it is not traced.

        Args:
            robot: the robot.
            name: one of `quantities`.
            begin_s: from when.
            end_s: until when.
            most: the number of samples, about; of more, the least and greatest of each part.
        """
        column = _column(name)
        if column is None or robot >= MAX_ROBOTS:
            return None
        first = bisect_left(self._times_s, begin_s - _SLACK_S)
        end = bisect_right(self._times_s, end_s + _SLACK_S)
        found = [
            sample[robot, column] if robot < len(sample) and column < sample.shape[1] else np.nan
            for sample in self._samples[first:end]
        ]
        return thinned(self._times_s[first:end], np.array(found, dtype=np.float64), most)


def _column(name: str) -> int | None:
    if name in _MOTION:
        return _MOTION.index(name)
    device, _, element = name.partition(".")
    is_sonar = device == "sonar" and element.isdecimal() and len(element) < 4
    return len(_MOTION) + int(element) if is_sonar else None


def _name(column: int) -> str:
    return _MOTION[column] if column < len(_MOTION) else f"sonar.{column - len(_MOTION)}"


def thinned(times_s: Sequence[float], values: FloatArray, most: int) -> Samples:
    """Return samples, of more than `most` only the least and the greatest of each part.

    >>> thinned([0.0, 1.0, 2.0, 3.0], np.array([5.0, 1.0, 9.0, np.nan]), 2)
    ([1.0, 2.0], [1.0, 9.0])
    """
    chosen = np.arange(len(values))
    if len(values) > most:
        parts = max(1, most // 2)
        size = -(-len(values) // parts)
        padded = np.full(size * -(-len(values) // size), np.nan)
        padded[: len(values)] = values
        rows = padded.reshape(-1, size)
        least = np.where(np.isnan(rows), np.inf, rows).argmin(axis=1)
        greatest = np.where(np.isnan(rows), -np.inf, rows).argmax(axis=1)
        starts = np.arange(len(rows)) * size
        chosen = np.unique(np.concatenate([starts + least, starts + greatest]))
    found = [None if math.isnan(number) else round(number, 5) for number in values[chosen].tolist()]
    return [round(times_s[each], 6) for each in chosen.tolist()], found
