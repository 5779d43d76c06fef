"""The inclinometer: how the robot is tilted.

    pitch = atan(rise of the ground ahead) + noise      above 0 with the nose up
    roll  = atan(rise of the ground to the left) + noise      above 0 with the left side up

by metre, under the robot's middle, ahead being where the mount points; to the nearest 0.1 degree,
with normal deviates. It measures when the program asks, at most at its rate; between two
measurements it tells the last one. On level ground both are 0, also at a ledge: robots do not tip.
Speeding up and bumps, which fool real ones, count for nothing. All of it was chosen by us.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt

from crs_cc.sim.instants import is_due
from crs_cc.sim.mount import mount_poses
from crs_cc.sim.noise import TILT, Noise
from crs_cc.units import rad_to_tenths_deg

if TYPE_CHECKING:
    from crs_cc.sim.asked import Asked
    from crs_cc.sim.model import WorldModel

FloatArray = npt.NDArray[np.float64]
IndexArray = npt.NDArray[np.intp]

_MOST: Final = 3600.0  # a degraded one may tell anything


class Inclinometers:
    """The inclinometers of all robots that have one."""

    def __init__(self, world: WorldModel, seed: int) -> None:
        models = [robot.model.inclinometer for robot in world.robots]
        found = [each for each in models if each is not None]
        self._interval_s = np.array([1.0 / each.rate_hz for each in found])
        self._noise_rad = np.array([each.noise_rad for each in found])
        self._noise = Noise(seed, TILT, 2, len(found) if self._noise_rad.any() else 0)

    def tell(self, asked: Asked) -> npt.NDArray[np.bool_]:
        """Answers TILT; refuses robots that have no inclinometer, or whose one tells nothing."""
        has = asked.equipment.inclinometer[asked.rows] >= 0
        rows, at_s = asked.rows[has], asked.at_s[has]
        tilt, mine = asked.state.tilt, asked.equipment.inclinometer[rows]
        due = is_due(tilt.at_s[mine], at_s, self._interval_s[mine])
        self._measure(asked, rows[due], at_s[due])
        told = np.isfinite(tilt.tilt_rad[mine]).all(axis=1)
        has[has] = told
        tenths = np.rint(rad_to_tenths_deg(tilt.tilt_rad[mine[told]]))
        asked.messages["i"][has, :2] = np.clip(tenths, -_MOST, _MOST).astype(np.int32)
        return np.asarray(has)

    def _measure(self, asked: Asked, rows: IndexArray, at_s: FloatArray) -> None:
        tilt, mine = asked.state.tilt, asked.equipment.inclinometer[rows]
        tilt_rad = np.zeros((len(rows), 2))
        if asked.equipment.inclines is not None:
            x_m, y_m, direction = mount_poses(asked.state, asked.equipment, rows).T
            gradient = asked.equipment.inclines.terrain.gradient(x_m, y_m)
            cos, sin = np.cos(direction), np.sin(direction)
            tilt_rad[:, 0] = np.arctan(cos * gradient[:, 0] + sin * gradient[:, 1])
            tilt_rad[:, 1] = np.arctan(cos * gradient[:, 1] - sin * gradient[:, 0])
        if self._noise_rad.any():
            tilt_rad += self._noise.rows(mine, tilt.count[mine]) * self._noise_rad[mine, None]
        tilt_rad = asked.equipment.degradations.alter(asked.state, "tilt", rows, tilt_rad, at_s)
        tilt.tilt_rad[mine], tilt.at_s[mine] = tilt_rad, at_s
        tilt.count[mine] += 1
