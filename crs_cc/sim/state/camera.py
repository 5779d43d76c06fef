"""Images of cameras, and the image that was last reported."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import FloatArray, Int32Array, Int64Array
from crs_cc.sim.model.sensors import MAX_COLUMNS
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.paged_reply import PagedReply

_PIXEL = 2


@dataclass(slots=True)
class CameraState:
    """The cameras; arrays have a row for each robot with a camera, n of them.

    Attributes:
        colour: the colour of each column, 0xRRGGBB, from left to right, (n, 320).
        range: its range [0.1 in], -1 if no object is in range, (n, 320).
        at_s: time of the last image; negative for none, (n,).
        count: number of images, (n,).
        told: contents of the last reply.
    """

    colour: Int32Array
    range: Int32Array
    at_s: FloatArray
    count: Int64Array
    told: PagedReply

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return cameras without an image."""
        count = sum(robot.model.camera is not None for robot in world.robots)
        return cls(
            np.zeros((count, MAX_COLUMNS), dtype=np.int32),
            np.full((count, MAX_COLUMNS), -1, dtype=np.int32),
            np.full(count, -1.0),
            np.zeros(count, dtype=np.int64),
            PagedReply.nothing(count, _PIXEL * MAX_COLUMNS),
        )
