"""The compass.

    reading = direction of the mount + offset + (deviation * sin(direction) until it is calibrated)

in 0.1 degree, 0 to 3599 (vendor header `Nclient.h` 1.29). The direction is that of the turret, or
of a robot without one, in the world frame: counter-clockwise from the world's x axis, like all
angles of the robot; the offset of a definition sets another north. `conf_cp` switches it on and
off: while it is off, the reading does not change, initially 0. `conf_cp(2)` calibrates it: the
turret makes one turn, as slowly as the definition specifies (about three minutes, vendor header).
Meanwhile the program continues; it should wait and not move the turret. Then the deviation, which
is caused by iron on the robot, is removed. On a robot without a turret nothing turns. All numbers
except the format were chosen by us.

It measures when a reply contains its reading, at most ten times a second (vendor header), or on its
timer (`timers`). A normal deviate with the definition's noise is added. Degradation (`compass`): if
a value is dropped, the reading does not change.
"""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.core.random_streams import COMPASS, Noise
from crs_cc.core.units import rad_to_tenths_deg
from crs_cc.sim.devices import drive
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.devices.timers import read_on_request
from crs_cc.sim.devices.vendor_state import configuration
from crs_cc.sim.state import timers

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


OFF: Final = 0
CALIBRATE: Final = 2
"""Modes of `conf_cp`; 1 switches it on (vendor header `Nclient.h` 1.29)."""

_TURN: Final = 2 * math.pi
_FULL_TURN: Final = 3600


class Compasses:
    """The compasses of all robots that have one.

    Attributes:
        interval_s: minimum time between two measurements of each.
    """

    def __init__(self, world: WorldModel, seed: int) -> None:
        found = [model for robot in world.robots if (model := robot.model.compass) is not None]
        self.interval_s = np.array([1.0 / compass.rate_hz for compass in found])
        self._offset_rad = np.array([compass.offset_rad for compass in found])
        self._deviation_rad = np.array([compass.deviation_rad for compass in found])
        self._noise_rad = np.array([compass.noise_rad for compass in found])
        self._noise = Noise(seed, COMPASS, 1, len(world.robots) if self._noise_rad.any() else 0)

    def read(
        self,
        state: EnvState,
        constants: RobotConstants,
        _around: RayCaster,
        rows: IndexArray,
        at_s: FloatArray,
    ) -> None:
        """Measure with the compasses that are on and may measure again.

        Args:
            state: changed in place.
            constants: the robots' constants.
            rows: which robots, k of them, whose axes were turned to `at_s`.
            at_s: when, for each, shape (k,).
        """
        compass = state.compass
        mine = constants.compass[rows]
        due = compass.measured.are_due(mine, at_s, self.interval_s) & compass.on[mine]
        if not due.any():
            return
        rows, mine = rows[due], mine[due]
        angle_rad = mount_poses(state, constants, rows)[:, 2]
        deviation_rad = np.where(compass.calibrated[mine], 0.0, self._deviation_rad[mine])
        angle_rad += self._offset_rad[mine] + deviation_rad * np.sin(angle_rad)
        if self._noise_rad.any():
            deviates = self._noise.rows(rows, compass.count[mine])[:, 0]
            angle_rad += deviates * self._noise_rad[mine]
        angle_rad = constants.degradations.alter(
            state, "compass", rows, angle_rad[:, None], at_s[due]
        )[:, 0]
        reported = np.isfinite(angle_rad)
        tenths = np.rint(rad_to_tenths_deg(angle_rad[reported])).astype(np.int32)
        compass.reading[mine[reported]] = tenths % _FULL_TURN
        compass.count[mine] += 1
        compass.measured.note(mine, at_s[due], configuration(state, constants, rows))

    def get_cp(self, context: RequestContext) -> BoolArray:
        """Answer GET_CP: measure, for `State`; refuse robots without a compass."""
        has = np.asarray(context.constants.compass[context.rows] >= 0)
        read_on_request(context, self.read, timers.COMPASS, has)
        return has


def conf_cp(context: RequestContext) -> BoolArray:
    """Switch the compass on or off; refuse unknown modes."""
    state, constants = context.state, context.constants
    mode, mine = context["mode"], constants.compass[context.rows]
    good: BoolArray = (mine >= 0) & (mode >= OFF) & (mode <= CALIBRATE)
    rows, mode, mine = context.rows[good], mode[good], mine[good]
    state.compass.on[mine] = mode != OFF
    calibrates = mode == CALIBRATE
    state.compass.calibrated[mine[calibrates]] = True
    turns = calibrates & constants.drives.turret[rows]
    if turns.any():
        rows, speed = rows[turns], _TURN / constants.calibration_s[rows[turns]]
        drive.turn_turret(state, rows, _TURN, speed)
    return good
