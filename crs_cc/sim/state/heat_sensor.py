"""Heat sensor readings."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.model.world import WorldModel


@dataclass(slots=True)
class HeatSensorState:
    """The heat sensors; arrays have a row for each robot with a heat sensor, n of them.

    Attributes:
        reading: the measured heat, before rounding, (n,).
        at_s: time of the measurement; negative for none, (n,).
    """

    reading: FloatArray
    at_s: FloatArray

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return sensors that have not measured yet."""
        count = sum(robot.model.heat.range_m > 0.0 for robot in world.robots)
        return cls(np.zeros(count), np.full(count, -1.0))
