"""Motion profiles of axes: motion commands become motion, evaluated in slices of a timestep.

Each axis follows a trapezoidal profile of three phases with constant acceleration: it ramps from
its current speed to a cruising speed, cruises, and brakes to a standstill (the last two may have
zero duration; a speed command cruises for ever). A new command replaces the profile, starting at
the current speed. The distance since the command is a closed-form function of the time since the
command, so slices are differences of that function, whatever their length, and add up to the whole
distance.

All arrays have one row for each robot and three columns, the vendor's axes: right wheel, left
wheel, nothing for a differential drive; translation, steering, turret for a synchro drive. Wheels
and translation are in metres, steering and turret in radians; times in seconds.

>>> axes = Axes.standing(robots=1)
>>> plan_move(axes, ALL, np.array([0.0]), np.array([[1.0, -1.0, 0.0]]), limit=0.5, ramp=1.0)
>>> axes.end_s()                         # 0.5 s ramp, 1.5 s cruise, 0.5 s brake
array([[2.5, 2.5, 0. ]])
>>> advance(axes, ALL, np.array([0.5]))
array([[ 0.125, -0.125,  0.   ]])
>>> advance(axes, ALL, np.array([9.0])) + [0.125, -0.125, 0.0]
array([[ 1., -1.,  0.]])
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray
from crs_cc.sim.kernels.program import ROBOTS_AT_ONCE, kernels
from crs_cc.sim.kernels.tables import PROFILES
from crs_cc.sim.model.axis import AXES
from crs_cc.sim.state.rows import ALL, Rows, parts, take

_NO_WAY: Final = 1e-12  # shorter distances are rounding errors


@dataclass(slots=True)
class Axes:
    """The profiles of all axes and their progress; each array has shape (robots, 3).

    Attributes:
        start_s: start of the profile.
        first: initial speed.
        ramp: signed acceleration of the ramp.
        ramp_s: duration of the ramp.
        cruise: signed speed after the ramp.
        cruise_s: duration of the cruise; infinite for a speed command.
        brake_s: duration of the braking.
        begun: distance between the command and the start of this profile; 0 except for a move that
            fell short.
        total: total distance since the command; NaN for a speed command other than 0.
        travelled: distance so far.
        speed: current speed.
        limit: maximum speed of a move; 0 for a profile without a target.
        rate: acceleration of a move, without sign.
    """

    start_s: FloatArray
    first: FloatArray
    ramp: FloatArray
    ramp_s: FloatArray
    cruise: FloatArray
    cruise_s: FloatArray
    brake_s: FloatArray
    begun: FloatArray
    total: FloatArray
    travelled: FloatArray
    speed: FloatArray
    limit: FloatArray
    rate: FloatArray

    @classmethod
    def standing(cls, robots: int) -> Self:
        """Return axes at rest."""
        return cls(*(np.zeros((robots, AXES)) for _ in fields(cls)))

    def profiles(self, rows: Rows) -> list[FloatArray]:
        """Return the columns of some robots that kernels read, see `kernels/drive.c`."""
        columns = (
            self.start_s,
            self.first,
            self.ramp,
            self.ramp_s,
            self.cruise,
            self.cruise_s,
            self.brake_s,
            self.begun,
            self.total,
            self.travelled,
        )
        return [take(column, rows) for column in columns]

    def end_s(self, rows: Rows = ALL) -> FloatArray:
        """Return when each axis will be at rest [s]: infinite for never."""
        end_s = take(self.start_s, rows) + take(self.ramp_s, rows)
        return np.asarray(end_s + take(self.cruise_s, rows) + take(self.brake_s, rows))


def plan_move(
    axes: Axes,
    rows: Rows,
    now_s: FloatArray,
    distance: FloatArray,
    *,
    limit: FloatArray | float,
    ramp: FloatArray | float,
    begun: FloatArray | float = 0.0,
    which: BoolArray | bool = True,
) -> None:
    """Move axes by a distance, forwards or backwards, and stop exactly at its end.

    An axis that is too fast to stop in time brakes, and returns.

    Args:
        axes: their profiles; must have been advanced to `now_s`.
        rows: the robots, k of them.
        now_s: time of the command, shape (k,).
        distance: distance relative to the current position, shape (k, 3).
        limit: maximum speed, greater than 0.
        ramp: acceleration, greater than 0.
        begun: distance since the command before this profile.
        which: the axes to change, shape (k, 3).
    """
    # In the direction `side`, braking at once ends at the target or before it; so the axis has
    # time to reach a peak: from v to p to 0 takes the distance (p^2 - v^2) / 2a + p^2 / 2a.
    first = take(axes.speed, rows)
    spare = distance - first * np.abs(first) / (2 * ramp)
    side = np.where(np.abs(spare) > _NO_WAY, np.sign(spare), np.sign(first))
    speed, ahead = side * first, side * distance
    peak = np.sqrt(np.maximum(ramp * ahead + speed * speed / 2, 0.0))
    peak = np.where(np.abs(spare) > _NO_WAY, np.minimum(peak, limit), speed)
    ramp_s = np.abs(peak - speed) / ramp
    brake_s = peak / ramp
    cruise = ahead - (speed + peak) / 2 * ramp_s - peak * brake_s / 2
    cruises = (cruise > 0.0) & (peak > 0.0)
    _replace(
        axes,
        rows,
        which,
        start_s=now_s[:, None],
        first=first,
        ramp=side * np.sign(peak - speed) * ramp,
        ramp_s=ramp_s,
        cruise=side * peak,
        cruise_s=np.divide(cruise, peak, out=np.zeros_like(peak), where=cruises),
        brake_s=brake_s,
        begun=begun,
        total=begun + distance,
        limit=limit,
        rate=ramp,
    )


def advance(axes: Axes, rows: Rows, to_s: FloatArray) -> FloatArray:
    """Advance axes to a time, not before the last one.

    Args:
        axes: their profiles.
        rows: the robots, k of them.
        to_s: the time of each robot, shape (k,).

    Returns:
        the distance of each axis, shape (k, 3): the slice.
    """
    distance = np.empty((len(to_s), AXES))
    for some, part in parts(rows, len(to_s), ROBOTS_AT_ONCE):
        k = part.stop - part.start
        found = kernels().columns(PROFILES, k, [*axes.profiles(some), to_s[part]])
        end = 10 * AXES * k
        axes.travelled[some] = found[end - AXES * k : end].reshape(-1, AXES)
        distance[part], axes.speed[some] = found[end + k : end + 7 * k].reshape(2, k, AXES)
    return distance


def fall_short(axes: Axes, rows: Rows, now_s: FloatArray, short: FloatArray) -> None:
    """Extend moves by the distance that contacts have blocked.

    Args:
        axes: their profiles; must have been advanced to `now_s`.
        rows: the robots, k of them.
        now_s: the current time, shape (k,).
        short: the distance by which each axis fell short, shape (k, 3).
    """
    moves = (take(axes.limit, rows) > 0.0) & (short != 0.0)
    if moves.any():
        begun = take(axes.travelled, rows) - short
        plan_move(
            axes,
            rows,
            now_s,
            np.where(moves, take(axes.total, rows) - begun, 0.0),
            limit=np.where(moves, take(axes.limit, rows), 1.0),
            ramp=np.where(moves, take(axes.rate, rows), 1.0),
            begun=begun,
            which=moves,
        )


def end_here(axes: Axes, rows: Rows, which: BoolArray) -> None:
    """End moves at the axes' current positions.

    Args:
        axes: their profiles.
        rows: the robots, k of them.
        which: the axes to change, shape (k, 3).
    """
    for gone in (axes.ramp_s, axes.cruise_s, axes.brake_s, axes.limit, axes.speed):
        gone[rows] = np.where(which, 0.0, take(gone, rows))
    axes.total[rows] = np.where(which, take(axes.travelled, rows), take(axes.total, rows))


def _replace(
    axes: Axes, rows: Rows, which: BoolArray | bool, **profile: FloatArray | float
) -> None:
    """Replace the profiles of the selected axes."""
    profile["travelled"] = profile["begun"]
    for name, values in profile.items():
        old: FloatArray = getattr(axes, name)
        old[rows] = values if which is True else np.where(which, values, take(old, rows))
