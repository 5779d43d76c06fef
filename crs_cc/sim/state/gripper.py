"""Positions and targets of gripper fingers."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray
from crs_cc.sim.model.world import WorldModel


@dataclass(slots=True)
class GripperState:
    """The grippers; arrays have a row for each robot with a gripper, n of them.

    Attributes:
        from_m: distance between the fingers at the last command to open or close, (n,).
        since_s: time of that command, (n,).
        closing: whether it was to close, (n,).
        before_m: the distance at the end of the last cycle, (n,).
        width_m: the width of the held object; 0 for none, (n,).
    """

    from_m: FloatArray
    since_s: FloatArray
    closing: BoolArray
    before_m: FloatArray
    width_m: FloatArray

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return open grippers."""
        found = [gripper for robot in world.robots if (gripper := robot.model.gripper) is not None]
        open_m = np.array([gripper.opening_m for gripper in found], dtype=np.float64)
        nothing, no = np.zeros(len(found)), np.zeros(len(found), dtype=np.bool_)
        return cls(open_m, nothing, no, open_m.copy(), nothing.copy())
