"""The clock of the sensor board.

    reading = floor(floor(t / tick) * tick in ms)  modulo 2^32

with t the simulated time that the robot has been in the world, plus the initial time of its clock.
The vendor's header `Nclient.h` 1.29 specifies the unit (ms), the tick of 16.4 ms, and that it
starts at zero when the robot is switched on and overflows after 49 days, which are 2^32 ms. The
time for which a robot has been on is a parameter of its definition. No degradation.

>>> from crs_cc.sim.files.world_xml import empty_world
>>> BoardClock(empty_world()).ms(np.array([0, 0]), np.array([0.0164, 1.0])).tolist()
[16.0, 984.0]
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.sim.kernels import exact

if TYPE_CHECKING:
    from crs_cc.sim.model.robot import RobotModel
    from crs_cc.sim.model.world import WorldModel


class BoardClock:
    """The clocks of all robots of a world."""

    def __init__(self, world: WorldModel) -> None:
        self._table = clock_table([robot.model for robot in world.robots])

    def ms(self, rows: IndexArray, since_s: FloatArray) -> FloatArray:
        """Return the clocks' times [ms], whole numbers from 0 to 2^32 - 1.

        Args:
            rows: which robots, k of them.
            since_s: time that each has been in the world, shape (k,).
        """
        start_s, tick_s = self._table[rows].T
        return np.asarray(exact.board_ms(start_s.T + since_s, tick_s.T))


def clock_table(models: Sequence[RobotModel]) -> FloatArray:
    """Return the initial time and the tick of robots' clocks [s], (robots, 2)."""
    rows = [(model.board.start_s, model.board.tick_s) for model in models]
    return np.array(rows, dtype=np.float64).reshape(-1, 2)
