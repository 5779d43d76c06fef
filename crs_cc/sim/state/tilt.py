"""What inclinometers told last."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import FloatArray, Int64Array
from crs_cc.sim.model.world import WorldModel


@dataclass(slots=True)
class TiltState:
    """The inclinometers; arrays have a row for each robot that has one, n of them.

    Attributes:
        tilt_rad: pitch and roll as they were measured last, (n, 2).
        at_s: when that was; below 0 for never, (n,).
        count: how often they measured, (n,).
    """

    tilt_rad: FloatArray
    at_s: FloatArray
    count: Int64Array

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Gives inclinometers that have not measured yet."""
        count = sum(robot.model.inclinometer is not None for robot in world.robots)
        return cls(np.zeros((count, 2)), np.full(count, -1.0), np.zeros(count, dtype=np.int64))
