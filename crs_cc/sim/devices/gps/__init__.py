"""The GPS receiver.

    reading = position of the robot's middle + normal deviates with the definition's noise

along x and y of the world frame, to the nearest 0.1 inch. It measures when the program asks, at
most at its rate, or by its timer; between two measurements it tells the last one. Degradation
(`gps`): without x or y there is no fix, and the request is refused until the next measurement. All
of it was chosen by us: the CRS report (6.2) wishes for such a device, and has no law for it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core import random_streams
from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.core.time_grid import is_due
from crs_cc.core.units import m_to_tenths_inch
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.devices.timers import read_on_request
from crs_cc.sim.state.timers import GPS

if TYPE_CHECKING:
    from crs_cc.sim.devices.ray_caster import RayCaster
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState


class GpsReceivers:
    """The receivers of all robots that have one.

    Attributes:
        interval_s: the least time between two measurements of each.
    """

    def __init__(self, world: WorldModel, seed: int) -> None:
        found = [gps for robot in world.robots if (gps := robot.model.gps) is not None]
        self.interval_s = np.array([1.0 / gps.rate_hz for gps in found])
        self._noise_m = np.array([gps.noise_m for gps in found])
        self._noise = random_streams.Noise(
            seed, random_streams.GPS, 2, len(world.robots) if self._noise_m.any() else 0
        )

    def read(
        self,
        state: EnvState,
        constants: RobotConstants,
        _around: RayCaster,
        rows: IndexArray,
        at_s: FloatArray,
    ) -> None:
        """Lets receivers measure whose time has come.

        Args:
            state: changed in place.
            constants: the robots' constants.
            rows: robots that have a receiver, k of them, whose axes were turned to `at_s`.
            at_s: when, for each, shape (k,).
        """
        gps, mine = state.gps, constants.gps[rows]
        due = is_due(gps.at_s[mine], at_s, self.interval_s[mine])
        rows, mine, at_s = rows[due], mine[due], at_s[due]
        fix_m = mount_poses(state, constants, rows)[:, :2]
        if self._noise_m.any():
            fix_m += self._noise.rows(rows, gps.count[mine]) * self._noise_m[mine, None]
        fix_m = constants.degradations.alter(state, "gps", rows, fix_m, at_s)
        gps.fix_m[mine], gps.at_s[mine] = fix_m, at_s
        gps.count[mine] += 1

    def get_gps(self, context: RequestContext) -> BoolArray:
        """Answer GPS; refuse robots that have no receiver, or whose receiver has no fix."""
        mine = context.constants.gps[context.rows]
        has = np.asarray(mine >= 0)
        read_on_request(context, self.read, GPS, has)
        fix_m = context.state.gps.fix_m[mine[has]]
        fixed = np.isfinite(fix_m).all(axis=1)
        has[has] = fixed
        tenths = np.rint(m_to_tenths_inch(fix_m[fixed])).astype(np.int32)
        context.put("x", tenths[:, 0], has)
        context.put("y", tenths[:, 1], has)
        return has
