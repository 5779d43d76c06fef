"""The inclinometer: pitch and roll of the robot.

    pitch = atan(slope of the ground in forward direction) + noise    positive with the nose up
    roll  = atan(slope of the ground to the left) + noise      positive with the left side up

under the robot's centre, where forward is the direction of the mount; to the nearest 0.1 degree,
with normal deviates. It measures when the program requests it, at most at its rate, or on its
timer; requests in between return the previous measurement. On level ground both are 0, also at a
ledge: robots do not tip over. Acceleration and bumps, which disturb real inclinometers, have no
effect. The model was chosen by us.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt

from crs_cc.sim import noise
from crs_cc.sim.instants import is_due
from crs_cc.sim.mount import mount_poses
from crs_cc.sim.states.timers import TILT
from crs_cc.units import rad_to_tenths_deg

if TYPE_CHECKING:
    from crs_cc.sim.asked import Asked
    from crs_cc.sim.equipment import Equipment
    from crs_cc.sim.geometry.surroundings import Surroundings
    from crs_cc.sim.model import WorldModel
    from crs_cc.sim.state import EnvState

FloatArray = npt.NDArray[np.float64]
IndexArray = npt.NDArray[np.intp]

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
        self._noise = noise.Noise(
            seed, noise.TILT, 2, len(world.robots) if self._noise_rad.any() else 0
        )

    def read(
        self,
        state: EnvState,
        equipment: Equipment,
        _around: Surroundings,
        rows: IndexArray,
        at_s: FloatArray,
    ) -> None:
        """Lets inclinometers measure whose time has come.

        Args:
            state: changed in place.
            equipment: the robots' constants.
            rows: robots that have one, k of them, whose axes were turned to `at_s`.
            at_s: when, for each, shape (k,).
        """
        tilt, mine = state.tilt, equipment.inclinometer[rows]
        due = is_due(tilt.at_s[mine], at_s, self.interval_s[mine])
        rows, mine, at_s = rows[due], mine[due], at_s[due]
        tilt_rad = np.zeros((len(rows), 2))
        if equipment.inclines is not None:
            x_m, y_m, direction = mount_poses(state, equipment, rows).T
            gradient = equipment.inclines.terrain.gradient(x_m, y_m)
            cos, sin = np.cos(direction), np.sin(direction)
            tilt_rad[:, 0] = np.arctan(cos * gradient[:, 0] + sin * gradient[:, 1])
            tilt_rad[:, 1] = np.arctan(cos * gradient[:, 1] - sin * gradient[:, 0])
        if self._noise_rad.any():
            tilt_rad += self._noise.rows(rows, tilt.count[mine]) * self._noise_rad[mine, None]
        tilt_rad = equipment.degradations.alter(state, "tilt", rows, tilt_rad, at_s)
        tilt.tilt_rad[mine], tilt.at_s[mine] = tilt_rad, at_s
        tilt.count[mine] += 1

    def tell(self, asked: Asked) -> npt.NDArray[np.bool_]:
        """Answers TILT; refuses robots that have no inclinometer, or whose one tells nothing."""
        state, equipment, rows = asked.state, asked.equipment, asked.rows
        has = np.asarray(equipment.inclinometer[rows] >= 0)
        measures = has & state.timers.on_request(rows, TILT)
        self.read(state, equipment, asked.around, rows[measures], asked.at_s[measures])
        tilt_rad = state.tilt.tilt_rad[equipment.inclinometer[rows[has]]]
        told = np.isfinite(tilt_rad).all(axis=1)
        has[has] = told
        tenths = np.rint(rad_to_tenths_deg(tilt_rad[told]))
        asked.messages["i"][has, :2] = np.clip(tenths, -_MOST, _MOST).astype(np.int32)
        return has
