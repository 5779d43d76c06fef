"""The inclinometer: how the robot is tilted.

    pitch = atan(rise of the ground ahead) + noise      above 0 with the nose up
    roll  = atan(rise of the ground to the left) + noise      above 0 with the left side up

by metre, under the robot's middle, ahead being where the mount points; to the nearest 0.1 degree,
with normal deviates. It measures when the program asks, at most at its rate, or by its timer;
between two measurements it tells the last one. On level ground both are 0, also at a ledge: robots
do not tip. Speeding up and bumps, which fool real ones, count for nothing. All of it was chosen by
us.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core import random_streams
from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.core.time_grid import is_due
from crs_cc.core.units import rad_to_tenths_deg
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.devices.timers import read_on_request
from crs_cc.sim.state.timers import TILT

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


_MOST: Final = 3600.0  # a degraded one may tell anything


class Inclinometers:
    """The inclinometers of all robots that have one.

    Attributes:
        interval_s: the least time between two measurements of each.
    """

    def __init__(self, world: WorldModel, seed: int) -> None:
        models = [robot.model.inclinometer for robot in world.robots]
        found = [each for each in models if each is not None]
        self.interval_s = np.array([1.0 / each.rate_hz for each in found])
        self._noise_rad = np.array([each.noise_rad for each in found])
        self._noise = random_streams.Noise(
            seed, random_streams.TILT, 2, len(world.robots) if self._noise_rad.any() else 0
        )

    def read(
        self,
        state: EnvState,
        constants: RobotConstants,
        _around: RayCaster,
        rows: IndexArray,
        at_s: FloatArray,
    ) -> None:
        """Lets inclinometers measure whose time has come.

        Args:
            state: changed in place.
            constants: the robots' constants.
            rows: robots that have one, k of them, whose axes were turned to `at_s`.
            at_s: when, for each, shape (k,).
        """
        tilt, mine = state.tilt, constants.inclinometer[rows]
        due = is_due(tilt.at_s[mine], at_s, self.interval_s[mine])
        rows, mine, at_s = rows[due], mine[due], at_s[due]
        tilt_rad = np.zeros((len(rows), 2))
        if constants.inclines is not None:
            x_m, y_m, direction = mount_poses(state, constants, rows).T
            gradient = constants.inclines.terrain.gradient(x_m, y_m)
            cos, sin = np.cos(direction), np.sin(direction)
            tilt_rad[:, 0] = np.arctan(cos * gradient[:, 0] + sin * gradient[:, 1])
            tilt_rad[:, 1] = np.arctan(cos * gradient[:, 1] - sin * gradient[:, 0])
        if self._noise_rad.any():
            tilt_rad += self._noise.rows(rows, tilt.count[mine]) * self._noise_rad[mine, None]
        tilt_rad = constants.degradations.alter(state, "tilt", rows, tilt_rad, at_s)
        tilt.tilt_rad[mine], tilt.at_s[mine] = tilt_rad, at_s
        tilt.count[mine] += 1

    def get_tilt(self, context: RequestContext) -> BoolArray:
        """Answer TILT; refuse robots that have no inclinometer, or whose one tells nothing."""
        mine = context.constants.inclinometer[context.rows]
        has = np.asarray(mine >= 0)
        read_on_request(context, self.read, TILT, has)
        tilt_rad = context.state.tilt.tilt_rad[mine[has]]
        told = np.isfinite(tilt_rad).all(axis=1)
        has[has] = told
        tenths = np.rint(rad_to_tenths_deg(tilt_rad[told]))
        tenths = np.clip(tenths, -_MOST, _MOST).astype(np.int32)
        context.put("pitch", tenths[:, 0], has)
        context.put("roll", tenths[:, 1], has)
        return has
