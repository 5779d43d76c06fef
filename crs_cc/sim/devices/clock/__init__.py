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

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray

if TYPE_CHECKING:
    from crs_cc.sim.model.world import WorldModel


_WRAP: Final = 2.0**32
_ROUNDING: Final = 1e-9  # ticks; a time that is on a tick but for rounding counts as on it


class BoardClock:
    """The clocks of all robots of a world."""

    def __init__(self, world: WorldModel) -> None:
        boards = [robot.model.board for robot in world.robots]
        self._start_s = np.array([board.start_s for board in boards])
        self._tick_s = np.array([board.tick_s for board in boards])

    def ms(self, rows: IndexArray, since_s: FloatArray) -> FloatArray:
        """Return the clocks' times [ms], whole numbers from 0 to 2^32 - 1.

        Args:
            rows: which robots, k of them.
            since_s: time that each has been in the world, shape (k,).
        """
        tick_s = self._tick_s[rows]
        ticks = np.floor((self._start_s[rows] + since_s) / tick_s + _ROUNDING)
        return np.asarray(np.floor(ticks * tick_s * 1e3 + _ROUNDING) % _WRAP)
