"""Light sensor readings."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import FloatArray, Int64Array
from crs_cc.sim.model.beacons import MAX_LIGHT_SENSORS
from crs_cc.sim.model.world import WorldModel


@dataclass(slots=True)
class LightState:
    """Rings of light sensors; arrays have a row for each robot with a ring, n of them.

    Attributes:
        reading: the readings of the maximum number of sensors, before rounding, (n, 32).
        at_s: time of the measurement; negative for none, (n,).
        count: number of measurements, (n,).
    """

    reading: FloatArray
    at_s: FloatArray
    count: Int64Array

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return sensors that have not measured yet."""
        count = sum(robot.model.light_sensors is not None for robot in world.robots)
        reading = np.zeros((count, MAX_LIGHT_SENSORS))
        return cls(reading, np.full(count, -1.0), np.zeros(count, dtype=np.int64))
