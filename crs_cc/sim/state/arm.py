"""Positions and targets of arm joints."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray
from crs_cc.sim.model.world import WorldModel


@dataclass(slots=True)
class ArmState:
    """The arms; arrays have a row for each robot with an arm, n of them.

    Attributes:
        from_rad: angles of shoulder and elbow at the last command, (n, 2).
        to_rad: commanded angles, (n, 2).
        since_s: time of the last command, (n,).
        closed: commanded state of the hand: whether it is closed, (n,).
        acts: whether the hand has still to close or open, (n,).
    """

    from_rad: FloatArray
    to_rad: FloatArray
    since_s: FloatArray
    closed: BoolArray
    acts: BoolArray

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return arms that are stretched out as far as their joints allow, with open hands."""
        found = [arm for robot in world.robots if (arm := robot.model.arm) is not None]
        start = [[joint.within(0.0) for joint in (arm.shoulder, arm.elbow)] for arm in found]
        start_rad = np.array(start, dtype=np.float64).reshape(-1, 2)
        no = np.zeros(len(found), dtype=np.bool_)
        return cls(start_rad, start_rad.copy(), np.zeros(len(found)), no, no.copy())
