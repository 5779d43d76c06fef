"""The hardware simulator: motion commands become wheel motion, cut into slices of a timestep.

Each wheel follows a profile of three phases with constant acceleration: it ramps from the speed it
has to a cruising speed, cruises, and brakes to a standstill (the last two may last no time; a
speed command cruises for ever). A new command replaces the profile from the speed reached. The
way since the command is a closed formula of the time since the command, so slices are differences
of that formula, whatever their length, and their sum is the whole way.

All arrays have one row for each robot and two columns: right wheel (the vendor's axis 1), left
wheel (axis 2). Metres and seconds.

>>> wheels = Wheels.standing(robots=1)
>>> plan_move(wheels, ALL, np.array([0.0]), np.array([[1.0, -1.0]]), limit_mps=0.5, ramp_mps2=1.0)
>>> wheels.end_s()                       # 0.5 s ramp, 1.5 s cruise, 0.5 s brake
array([[2.5, 2.5]])
>>> advance(wheels, ALL, np.array([0.5]))
array([[ 0.125, -0.125]])
>>> advance(wheels, ALL, np.array([9.0])) + [0.125, -0.125]
array([[ 1., -1.]])
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Final, Self, TypeAlias

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]
BoolArray = npt.NDArray[np.bool_]
Rows: TypeAlias = "npt.NDArray[np.intp] | slice"
"""Which robots: their indices, or `ALL`."""

ALL: Final = slice(None)

_NO_WAY_M: Final = 1e-12  # shorter ways are rounding errors


@dataclass(slots=True)
class Wheels:
    """The profiles of all wheels and how far along they are; each array has shape (robots, 2).

    Attributes:
        start_s: when the profile began.
        first_mps: speed at its beginning.
        ramp_mps2: acceleration of the ramp, with sign.
        ramp_s: how long the ramp takes.
        cruise_mps: speed behind the ramp, with sign.
        cruise_s: how long it lasts; infinite for a speed command.
        brake_s: how long the braking takes.
        total_m: the whole way; NaN for a speed command other than 0.
        travelled_m: the way so far.
        speed_mps: the speed now.
    """

    start_s: FloatArray
    first_mps: FloatArray
    ramp_mps2: FloatArray
    ramp_s: FloatArray
    cruise_mps: FloatArray
    cruise_s: FloatArray
    brake_s: FloatArray
    total_m: FloatArray
    travelled_m: FloatArray
    speed_mps: FloatArray

    @classmethod
    def standing(cls, robots: int) -> Self:
        """Gives wheels that stand still."""
        return cls(*(np.zeros((robots, 2)) for _ in fields(cls)))

    def end_s(self, rows: Rows = ALL) -> FloatArray:
        """Gives when each wheel will stand still [s]: infinite when it goes on for ever."""
        end_s = self.start_s[rows] + self.ramp_s[rows]
        return np.asarray(end_s + self.cruise_s[rows] + self.brake_s[rows])


def plan_speed(
    wheels: Wheels,
    rows: Rows,
    now_s: FloatArray,
    target_mps: FloatArray,
    *,
    ramp_mps2: FloatArray | float,
    which: BoolArray | bool = True,
) -> None:
    """Lets wheels ramp to a speed and keep it.

    Args:
        wheels: their profiles; must have been advanced to `now_s`.
        rows: which robots, k of them.
        now_s: when the command comes, shape (k,).
        target_mps: the speed wanted, shape (k, 2).
        ramp_mps2: acceleration, greater than 0.
        which: the wheels that are meant, shape (k, 2).
    """
    first_mps = wheels.speed_mps[rows]
    ramp_s = np.abs(target_mps - first_mps) / ramp_mps2
    stops = target_mps == 0.0
    _replace(
        wheels,
        rows,
        which,
        start_s=np.broadcast_to(now_s[:, None], first_mps.shape),
        first_mps=first_mps,
        ramp_mps2=np.sign(target_mps - first_mps) * ramp_mps2,
        ramp_s=ramp_s,
        cruise_mps=target_mps,
        cruise_s=np.where(stops, 0.0, np.inf),
        brake_s=np.zeros_like(first_mps),
        total_m=np.where(stops, first_mps * ramp_s / 2, np.nan),
    )


def plan_move(
    wheels: Wheels,
    rows: Rows,
    now_s: FloatArray,
    way_m: FloatArray,
    *,
    limit_mps: FloatArray | float,
    ramp_mps2: FloatArray | float,
    which: BoolArray | bool = True,
) -> None:
    """Lets wheels go a way, forwards or backwards, and stop exactly at its end.

    A wheel that is too fast to stop in time brakes, and comes back.

    Args:
        wheels: their profiles; must have been advanced to `now_s`.
        rows: which robots, k of them.
        now_s: when the command comes, shape (k,).
        way_m: the way relative to here, shape (k, 2).
        limit_mps: highest speed, greater than 0.
        ramp_mps2: acceleration, greater than 0.
        which: the wheels that are meant, shape (k, 2).
    """
    # Seen along `side`, braking at once ends at the goal or before it; so the wheel has time to
    # reach a peak: from v to p to 0 takes the way (p^2 - v^2) / 2a + p^2 / 2a.
    first_mps = wheels.speed_mps[rows]
    spare_m = way_m - first_mps * np.abs(first_mps) / (2 * ramp_mps2)
    side = np.where(np.abs(spare_m) > _NO_WAY_M, np.sign(spare_m), np.sign(first_mps))
    speed, way = side * first_mps, side * way_m
    peak = np.sqrt(np.maximum(ramp_mps2 * way + speed * speed / 2, 0.0))
    peak = np.where(np.abs(spare_m) > _NO_WAY_M, np.minimum(peak, limit_mps), speed)
    ramp_s = np.abs(peak - speed) / ramp_mps2
    brake_s = peak / ramp_mps2
    cruise_m = way - (speed + peak) / 2 * ramp_s - peak * brake_s / 2
    cruises = (cruise_m > 0.0) & (peak > 0.0)
    _replace(
        wheels,
        rows,
        which,
        start_s=np.broadcast_to(now_s[:, None], first_mps.shape),
        first_mps=first_mps,
        ramp_mps2=side * np.sign(peak - speed) * ramp_mps2,
        ramp_s=ramp_s,
        cruise_mps=side * peak,
        cruise_s=np.divide(cruise_m, peak, out=np.zeros_like(peak), where=cruises),
        brake_s=brake_s,
        total_m=way_m,
    )


def advance(wheels: Wheels, rows: Rows, to_s: FloatArray) -> FloatArray:
    """Turns wheels on to an instant, not before the last one.

    Args:
        wheels: their profiles.
        rows: which robots, k of them.
        to_s: the instant of each robot, shape (k,).

    Returns:
        the way that each wheel went [m], shape (k, 2): the slice.
    """
    since_s = to_s[:, None] - wheels.start_s[rows]
    ramp_s, cruise_s, brake_s = wheels.ramp_s[rows], wheels.cruise_s[rows], wheels.brake_s[rows]
    first_mps, cruise_mps = wheels.first_mps[rows], wheels.cruise_mps[rows]
    ramp_mps2 = wheels.ramp_mps2[rows]
    ramping_s = np.minimum(since_s, ramp_s)
    cruising_s = np.minimum(np.maximum(since_s - ramp_s, 0.0), cruise_s)
    braking_s = np.minimum(np.maximum(since_s - ramp_s - cruise_s, 0.0), brake_s)
    slowing = np.divide(cruise_mps, brake_s, out=np.zeros_like(brake_s), where=brake_s > 0.0)
    travelled_m = (first_mps + ramp_mps2 * ramping_s / 2) * ramping_s
    travelled_m += cruise_mps * (cruising_s + braking_s) - slowing * braking_s * braking_s / 2
    speed_mps = np.where(since_s < ramp_s, first_mps + ramp_mps2 * ramping_s, cruise_mps)
    speed_mps -= slowing * braking_s
    stands = since_s >= ramp_s + cruise_s + brake_s
    travelled_m = np.where(stands, wheels.total_m[rows], travelled_m)
    slice_m = travelled_m - wheels.travelled_m[rows]
    wheels.travelled_m[rows] = travelled_m
    wheels.speed_mps[rows] = np.where(stands, 0.0, speed_mps)
    return np.asarray(slice_m)


def _replace(wheels: Wheels, rows: Rows, which: BoolArray | bool, **profile: FloatArray) -> None:
    """Writes new profiles over the old ones of the wheels that are meant."""
    profile["travelled_m"] = np.zeros_like(profile["total_m"])
    for name, values in profile.items():
        old: FloatArray = getattr(wheels, name)
        old[rows] = np.where(which, values, old[rows])
