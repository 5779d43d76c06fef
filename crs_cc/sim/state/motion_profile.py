"""The hardware simulator: motion commands become motion of axes, cut into slices of a timestep.

Each axis follows a profile of three phases with constant acceleration: it ramps from the speed it
has to a cruising speed, cruises, and brakes to a standstill (the last two may last no time; a
speed command cruises for ever). A new command replaces the profile from the speed reached. The
way since the command is a closed formula of the time since the command, so slices are differences
of that formula, whatever their length, and their sum is the whole way.

All arrays have one row for each robot and three columns, the vendor's axes: right wheel, left
wheel, nothing for a differential drive; translation, steering, turret for a synchro drive. Wheels
and translation count in metres, steering and turret in radians; times in seconds.

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
from crs_cc.sim.model.axis import AXES
from crs_cc.sim.state.rows import ALL, Rows, take

_NO_WAY: Final = 1e-12  # shorter ways are rounding errors


@dataclass(slots=True)
class Axes:
    """The profiles of all axes and how far along they are; each array has shape (robots, 3).

    Attributes:
        start_s: when the profile began.
        first: speed at its beginning.
        ramp: acceleration of the ramp, with sign.
        ramp_s: how long the ramp takes.
        cruise: speed behind the ramp, with sign.
        cruise_s: how long it lasts; infinite for a speed command.
        brake_s: how long the braking takes.
        begun: the way made since the command before this profile began; 0 but for a move that
            fell short.
        total: the whole way since the command; NaN for a speed command other than 0.
        travelled: the way so far.
        speed: the speed now.
        limit: the highest speed of a move; 0 for a profile that has no goal.
        rate: the acceleration of a move, without sign.
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
        """Return axes that stand still."""
        return cls(*(np.zeros((robots, AXES)) for _ in fields(cls)))

    def end_s(self, rows: Rows = ALL) -> FloatArray:
        """Return when each axis will stand still [s]: infinite when it goes on for ever."""
        end_s = take(self.start_s, rows) + take(self.ramp_s, rows)
        return np.asarray(end_s + take(self.cruise_s, rows) + take(self.brake_s, rows))


def plan_speed(
    axes: Axes,
    rows: Rows,
    now_s: FloatArray,
    target: FloatArray,
    *,
    ramp: FloatArray | float,
    which: BoolArray | bool = True,
) -> None:
    """Lets axes ramp to a speed and keep it.

    Args:
        axes: their profiles; must have been advanced to `now_s`.
        rows: which robots, k of them.
        now_s: when the command comes, shape (k,).
        target: the speed wanted, shape (k, 3).
        ramp: acceleration, greater than 0.
        which: the axes that are meant, shape (k, 3).
    """
    first = take(axes.speed, rows)
    ramp_s = np.abs(target - first) / ramp
    stops = target == 0.0
    _replace(
        axes,
        rows,
        which,
        start_s=np.broadcast_to(now_s[:, None], first.shape),
        first=first,
        ramp=np.sign(target - first) * ramp,
        ramp_s=ramp_s,
        cruise=target,
        cruise_s=np.where(stops, 0.0, np.inf),
        brake_s=np.zeros_like(first),
        begun=np.zeros_like(first),
        limit=np.zeros_like(first),
        rate=np.zeros_like(first),
        total=np.where(stops, first * ramp_s / 2, np.nan),
    )


def plan_move(
    axes: Axes,
    rows: Rows,
    now_s: FloatArray,
    way: FloatArray,
    *,
    limit: FloatArray | float,
    ramp: FloatArray | float,
    begun: FloatArray | float = 0.0,
    which: BoolArray | bool = True,
) -> None:
    """Lets axes go a way, forwards or backwards, and stop exactly at its end.

    An axis that is too fast to stop in time brakes, and comes back.

    Args:
        axes: their profiles; must have been advanced to `now_s`.
        rows: which robots, k of them.
        now_s: when the command comes, shape (k,).
        way: the way relative to here, shape (k, 3).
        limit: highest speed, greater than 0.
        ramp: acceleration, greater than 0.
        begun: the way that was made since the command before this.
        which: the axes that are meant, shape (k, 3).
    """
    # Seen along `side`, braking at once ends at the goal or before it; so the axis has time to
    # reach a peak: from v to p to 0 takes the way (p^2 - v^2) / 2a + p^2 / 2a.
    first = take(axes.speed, rows)
    spare = way - first * np.abs(first) / (2 * ramp)
    side = np.where(np.abs(spare) > _NO_WAY, np.sign(spare), np.sign(first))
    speed, ahead = side * first, side * way
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
        start_s=np.broadcast_to(now_s[:, None], first.shape),
        first=first,
        ramp=side * np.sign(peak - speed) * ramp,
        ramp_s=ramp_s,
        cruise=side * peak,
        cruise_s=np.divide(cruise, peak, out=np.zeros_like(peak), where=cruises),
        brake_s=brake_s,
        begun=np.broadcast_to(begun, first.shape),
        total=begun + way,
        limit=np.broadcast_to(limit, first.shape),
        rate=np.broadcast_to(ramp, first.shape),
    )


def advance(axes: Axes, rows: Rows, to_s: FloatArray) -> FloatArray:
    """Turn axes on to an instant, not before the last one.

    Args:
        axes: their profiles.
        rows: which robots, k of them.
        to_s: the instant of each robot, shape (k,).

    Returns:
        the way that each axis went, shape (k, 3): the slice.
    """
    since_s = to_s[:, None] - take(axes.start_s, rows)
    ramp_s, cruise_s, brake_s = (
        take(axes.ramp_s, rows),
        take(axes.cruise_s, rows),
        take(axes.brake_s, rows),
    )
    stands = since_s >= ramp_s + cruise_s + brake_s
    travelled: FloatArray = take(axes.total, rows)
    speed = np.zeros_like(travelled)
    if not stands.all():
        first, ramp, cruise = take(axes.first, rows), take(axes.ramp, rows), take(axes.cruise, rows)
        ramping_s = np.minimum(since_s, ramp_s)
        behind_s = np.maximum(since_s - ramp_s, 0.0)
        cruising_s = np.minimum(behind_s, cruise_s)
        braking_s = np.minimum(behind_s - cruising_s, brake_s)
        slowing = np.divide(cruise, brake_s, out=np.zeros_like(brake_s), where=brake_s > 0.0)
        way = take(axes.begun, rows) + (first + ramp * ramping_s / 2) * ramping_s
        way += cruise * (cruising_s + braking_s) - slowing * braking_s * braking_s / 2
        now = np.where(since_s < ramp_s, first + ramp * ramping_s, cruise) - slowing * braking_s
        travelled = np.where(stands, travelled, way)
        speed = np.where(stands, 0.0, now)
    slice_ = travelled - take(axes.travelled, rows)
    axes.travelled[rows] = travelled
    axes.speed[rows] = speed
    return np.asarray(slice_)


def fall_short(axes: Axes, rows: Rows, now_s: FloatArray, short: FloatArray) -> None:
    """Lets moves go on until they have made up for what was held back of them.

    Args:
        axes: their profiles; must have been advanced to `now_s`.
        rows: which robots, k of them.
        now_s: the present, shape (k,).
        short: by how much each axis did not go as far as it was turned, shape (k, 3).
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
    """End moves where their axes are, as if that were the goal.

    Args:
        axes: their profiles.
        rows: which robots, k of them.
        which: the axes that are meant, shape (k, 3).
    """
    for gone in (axes.ramp_s, axes.cruise_s, axes.brake_s, axes.limit, axes.speed):
        gone[rows] = np.where(which, 0.0, take(gone, rows))
    axes.total[rows] = np.where(which, take(axes.travelled, rows), take(axes.total, rows))


def _replace(axes: Axes, rows: Rows, which: BoolArray | bool, **profile: FloatArray) -> None:
    """Write new profiles over the old ones of the axes that are meant."""
    profile["travelled"] = profile["begun"]
    for name, values in profile.items():
        old: FloatArray = getattr(axes, name)
        old[rows] = np.where(which, values, take(old, rows))
