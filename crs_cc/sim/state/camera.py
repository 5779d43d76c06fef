"""What cameras saw last, and what of it the program was told."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import FloatArray, Int32Array, Int64Array
from crs_cc.sim.model.sensors import MAX_COLUMNS
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.paged_reply import Told

_PIXEL = 2


@dataclass(slots=True)
class CameraState:
    """The cameras; arrays have a row for each robot that has one, n of them.

    Attributes:
        colour: what each column shows, 0xRRGGBB, from the left to the right, (n, 320).
        range: how far away that is [0.1 in], -1 where nothing is in range, (n, 320).
        at_s: when it looked; below 0 for never, (n,).
        count: how often it looked, (n,).
        told: what the last reply told of.
    """

    colour: Int32Array
    range: Int32Array
    at_s: FloatArray
    count: Int64Array
    told: Told

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return cameras that have seen nothing yet."""
        count = sum(robot.model.camera is not None for robot in world.robots)
        return cls(
            np.zeros((count, MAX_COLUMNS), dtype=np.int32),
            np.full((count, MAX_COLUMNS), -1, dtype=np.int32),
            np.full(count, -1.0),
            np.zeros(count, dtype=np.int64),
            Told.nothing(count, _PIXEL * MAX_COLUMNS),
        )
