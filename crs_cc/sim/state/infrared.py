"""Infrared sensor readings."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, Int64Array
from crs_cc.sim.model.sensors import MAX_INFRARED
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.last_measurement import LastMeasurement

FARTHEST: Final = 15
"""The largest reading, four bits on the link (vendor source `Ndirect.c` 2.7): nothing is near."""


@dataclass(slots=True)
class InfraredState:
    """The infrared rings; arrays have a row for each robot with a ring, n of them.

    Attributes:
        on: the active sensors, (n, 16).
        share: weight of the previous reading in the next one, 0 to 1, (n,).
        level: each reading before rounding, 0 to 15, (n, 16).
        count: number of measurements, (n,).
        measured: time and configuration of the last measurement.
    """

    on: BoolArray
    share: FloatArray
    level: FloatArray
    count: Int64Array
    measured: LastMeasurement

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return sensors that have not measured yet."""
        rings = [ring for robot in world.robots if (ring := robot.model.infrared) is not None]
        on = np.zeros((len(rings), MAX_INFRARED), dtype=np.bool_)
        for row, ring in zip(on, rings, strict=True):
            row[list(ring.order)] = True
        return cls(
            on,
            np.array([ring.share for ring in rings], dtype=np.float64),
            np.full((len(rings), MAX_INFRARED), float(FARTHEST)),
            np.zeros(len(rings), dtype=np.int64),
            LastMeasurement.never(len(rings)),
        )
