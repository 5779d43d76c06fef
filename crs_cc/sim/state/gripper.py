"""Where the fingers of grippers are, and where they are going."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray
from crs_cc.sim.model.world import WorldModel


@dataclass(slots=True)
class GripperState:
    """The grippers; arrays have a row for each robot that has one, n of them.

    Attributes:
        from_m: the distance between the fingers when they were told last to open or to close, (n,).
        since_s: when that was, (n,).
        closing: whether to close, (n,).
        before_m: the distance at the end of the last cycle, (n,).
        width_m: the width of what they hold; 0 when they hold nothing, (n,).
    """

    from_m: FloatArray
    since_s: FloatArray
    closing: BoolArray
    before_m: FloatArray
    width_m: FloatArray

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return grippers that are open."""
        found = [gripper for robot in world.robots if (gripper := robot.model.gripper) is not None]
        open_m = np.array([gripper.opening_m for gripper in found], dtype=np.float64)
        nothing, no = np.zeros(len(found)), np.zeros(len(found), dtype=np.bool_)
        return cls(open_m, nothing, no, open_m.copy(), nothing.copy())
