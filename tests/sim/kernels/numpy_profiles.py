"""Commands of speeds as numpy computes them: the oracle of the kernel."""

from __future__ import annotations

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray
from crs_cc.sim.state.motion_profile import Axes
from crs_cc.sim.state.rows import Rows, take


def plan_speed(
    axes: Axes,
    rows: Rows,
    now_s: FloatArray,
    target: FloatArray,
    *,
    ramp: FloatArray | float,
    which: BoolArray | bool = True,
) -> None:
    """Ramp axes to a speed and keep it.

    Args:
        axes: their profiles; must have been advanced to `now_s`.
        rows: the robots, k of them.
        now_s: time of the command, shape (k,).
        target: target speed, shape (k, 3).
        ramp: acceleration, greater than 0.
        which: the axes to change, shape (k, 3).
    """
    first = take(axes.speed, rows)
    ramp_s = np.abs(target - first) / ramp
    stops = target == 0.0
    profile: dict[str, FloatArray | float] = {
        "start_s": now_s[:, None],
        "first": first,
        "ramp": np.sign(target - first) * ramp,
        "ramp_s": ramp_s,
        "cruise": target,
        "cruise_s": np.where(stops, 0.0, np.inf),
        "brake_s": 0.0,
        "begun": 0.0,
        "limit": 0.0,
        "rate": 0.0,
        "travelled": 0.0,
        "total": np.where(stops, first * ramp_s / 2, np.nan),
    }
    for name, values in profile.items():
        old: FloatArray = getattr(axes, name)
        old[rows] = values if which is True else np.where(which, values, take(old, rows))
