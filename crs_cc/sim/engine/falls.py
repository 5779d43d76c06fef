"""Falls: robots whose ground drops away under their centre.

A robot falls when its centre gets lower in a cycle by more than its step and the slope under it
account for. Nothing breaks; the event log reports it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.kernels import exact

if TYPE_CHECKING:
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.events import EventLog


def log_falls(
    constants: RobotConstants,
    log: EventLog,
    time_s: float,
    before_m: FloatArray,
    displacement_m: FloatArray,
) -> None:
    """Log which robots fell in a cycle, and how far.

    Args:
        constants: the robots' constants.
        log: receives the events.
        time_s: the end of the cycle.
        before_m: positions of the robots at its start, (robots, 2).
        displacement_m: their displacements, (robots, 2).
    """
    if constants.inclines is None:
        return
    terrain, after_m = constants.inclines.terrain, before_m + displacement_m
    drop_m = terrain.height_m(*before_m.T) - terrain.height_m(*after_m.T)
    slope = exact.hypot(*terrain.gradient(*before_m.T).T)
    fell = drop_m > constants.drives.step_m + slope * exact.hypot(*displacement_m.T) * 1.001
    for robot in np.flatnonzero(fell).tolist():
        log.say(time_s, "fall", f"fell {drop_m[robot]:.2f} m", robot)
