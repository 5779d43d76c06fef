"""Compass readings."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import BoolArray, Int32Array, Int64Array
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.last_measurement import LastMeasurement


@dataclass(slots=True)
class CompassState:
    """The compasses; arrays have a row for each robot with a compass, n of them.

    Attributes:
        on: whether they are on, (n,).
        calibrated: whether they have been calibrated, (n,).
        reading: last reading [0.1 deg], (n,).
        count: number of measurements, (n,).
        measured: time and configuration of the last measurement.
    """

    on: BoolArray
    calibrated: BoolArray
    reading: Int32Array
    count: Int64Array
    measured: LastMeasurement

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return compasses that have not measured yet."""
        found = [model for robot in world.robots if (model := robot.model.compass) is not None]
        count = len(found)
        return cls(
            np.array([compass.is_on for compass in found], dtype=np.bool_),
            np.zeros(count, dtype=np.bool_),
            np.zeros(count, dtype=np.int32),
            np.zeros(count, dtype=np.int64),
            LastMeasurement.never(count),
        )
