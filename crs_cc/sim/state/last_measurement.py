"""Times and robot configurations of last measurements, for the vendor's `PosData`.

>>> moments = LastMeasurement.never(2)
>>> moments.note(np.array([1]), np.array([0.5]), np.array([[10, 0, 900, 900, 0, 0, 0]]))
>>> moments.at_s.tolist(), moments.configuration[1, 2]
([-1.0, 0.5], np.int32(900))
>>> have = np.array([0, 1, -1])                        # the third robot has no such instrument
>>> moments.are_due(have, np.full(3, 0.6), np.array([0.2, 0.2])).tolist()
[True, False, False]
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array, Records
from crs_cc.core.time_grid import is_due

CONFIGURATION: Final = 7
"""Size of a configuration: x, y, heading, turret, and the speeds of three axes."""


@dataclass(slots=True)
class LastMeasurement:
    """The last measurement of each of several robots.

    Attributes:
        at_s: its time; negative for none, shape (n,).
        configuration: the robot's pose and speeds then, as in `State[34]` to `[40]`, (n, 7).
    """

    at_s: FloatArray
    configuration: Int32Array

    @classmethod
    def never(cls, count: int) -> Self:
        """Return robots that have not measured yet."""
        return cls(np.full(count, -1.0), np.zeros((count, CONFIGURATION), dtype=np.int32))

    def are_due(self, rows: IndexArray, at_s: FloatArray, interval_s: FloatArray) -> BoolArray:
        """Return which robots have the instrument, and may measure with it again.

        Args:
            rows: the row of each robot here, negative for one without the instrument, (k,).
            at_s: the time of the new measurement, (k,).
            interval_s: minimum interval of measurements, (n,).
        """
        return np.asarray((rows >= 0) & is_due(self.at_s.take(rows), at_s, interval_s.take(rows)))

    def note(
        self, rows: IndexArray, at_s: FloatArray | float, configuration: npt.NDArray[np.integer]
    ) -> None:
        """Record a measurement of some robots."""
        self.at_s[rows] = at_s
        self.configuration[rows] = configuration

    def load_measurements(self, table: Records) -> None:
        """Take over all last measurements from the table of a kernel, see `instruments.h`."""
        self.at_s[:] = table["at_s"]
        self.configuration[:] = table["configuration"][:, :CONFIGURATION]
