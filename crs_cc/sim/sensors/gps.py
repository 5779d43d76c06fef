"""The GPS receiver.

    reading = position of the robot's centre + normal deviates with the definition's noise

in x and y of the world frame, to the nearest 0.1 inch. It measures when the program requests it, at
most at its rate, or on its timer; requests in between return the previous measurement. Degradation
(`gps`): if x or y is dropped there is no fix, and requests fail until the next measurement. The
model was chosen by us: the CRS report (6.2) suggests such a device without specifying it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from crs_cc.sim import noise
from crs_cc.sim.instants import is_due
from crs_cc.sim.mount import mount_poses
from crs_cc.sim.states.timers import GPS
from crs_cc.units import m_to_tenths_inch

if TYPE_CHECKING:
    from crs_cc.sim.asked import Asked
    from crs_cc.sim.equipment import Equipment
    from crs_cc.sim.geometry.surroundings import Surroundings
    from crs_cc.sim.model import WorldModel
    from crs_cc.sim.state import EnvState

FloatArray = npt.NDArray[np.float64]
IndexArray = npt.NDArray[np.intp]


class GpsReceivers:
    """The receivers of all robots that have one.

    Attributes:
        interval_s: the least time between two measurements of each.
    """

    def __init__(self, world: WorldModel, seed: int) -> None:
        found = [gps for robot in world.robots if (gps := robot.model.gps) is not None]
        self.interval_s = np.array([1.0 / gps.rate_hz for gps in found])
        self._noise_m = np.array([gps.noise_m for gps in found])
        self._noise = noise.Noise(
            seed, noise.GPS, 2, len(world.robots) if self._noise_m.any() else 0
        )

    def read(
        self,
        state: EnvState,
        equipment: Equipment,
        _around: Surroundings,
        rows: IndexArray,
        at_s: FloatArray,
    ) -> None:
        """Lets receivers measure whose time has come.

        Args:
            state: changed in place.
            equipment: the robots' constants.
            rows: robots that have a receiver, k of them, whose axes were turned to `at_s`.
            at_s: when, for each, shape (k,).
        """
        gps, mine = state.gps, equipment.gps[rows]
        due = is_due(gps.at_s[mine], at_s, self.interval_s[mine])
        rows, mine, at_s = rows[due], mine[due], at_s[due]
        fix_m = mount_poses(state, equipment, rows)[:, :2]
        if self._noise_m.any():
            fix_m += self._noise.rows(rows, gps.count[mine]) * self._noise_m[mine, None]
        fix_m = equipment.degradations.alter(state, "gps", rows, fix_m, at_s)
        gps.fix_m[mine], gps.at_s[mine] = fix_m, at_s
        gps.count[mine] += 1

    def tell(self, asked: Asked) -> npt.NDArray[np.bool_]:
        """Answers GPS; refuses robots that have no receiver, or whose receiver has no fix."""
        state, equipment, rows = asked.state, asked.equipment, asked.rows
        has = np.asarray(equipment.gps[rows] >= 0)
        measures = has & state.timers.on_request(rows, GPS)
        self.read(state, equipment, asked.around, rows[measures], asked.at_s[measures])
        gps, mine = state.gps, equipment.gps[rows[has]]
        fixed = np.isfinite(gps.fix_m[mine]).all(axis=1)
        has[has] = fixed
        tenths = np.rint(m_to_tenths_inch(gps.fix_m[mine[fixed]]))
        asked.messages["i"][has, :2] = tenths.astype(np.int32)
        return has
