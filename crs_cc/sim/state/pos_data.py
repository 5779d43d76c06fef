"""Positions and times of sensor readings, as reported in replies."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import IndexArray, Int32Array
from crs_cc.sim.model.world import WorldModel

NUMBERS: Final = 9
"""Numbers of the vendor's `PosData`: a configuration, and two times (`Nclient.h` 1.29)."""

PLACES: Final = {
    1: slice(0, 16),  # infrared sensors
    2: slice(16, 32),  # sonars
    4: slice(32, 33),  # bumpers
    8: slice(33, 34),  # laser
    16: slice(34, 35),  # compass
}
"""Indices of the sensors of each kind, by the vendor's bits POS_INFRARED to POS_COMPASS."""

_SENSORS: Final = 35


@dataclass(slots=True)
class PosDataState:
    """The data reported to programs that have requested it.

    Attributes:
        row: the row of each robot in `reported`, -1 for one that has not requested it, (robots,).
        reported: the vendor's `PosData` of each sensor, (rows, 35, 9).
    """

    row: IndexArray
    reported: Int32Array

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return a state without requests."""
        nobody = np.full(len(world.robots), -1, dtype=np.intp)
        return cls(nobody, np.zeros((0, _SENSORS, NUMBERS), dtype=np.int32))

    def attach(self, robots: IndexArray) -> None:
        """Add rows for robots that request the data."""
        new = robots[self.row[robots] < 0]
        self.row[new] = len(self.reported) + np.arange(len(new))
        room = np.zeros((len(new), _SENSORS, NUMBERS), dtype=np.int32)
        self.reported = np.concatenate([self.reported, room])
