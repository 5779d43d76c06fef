"""The robots that are in the world, and when they joined and left."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray
from crs_cc.sim.model.world import WorldModel


@dataclass(slots=True)
class PresenceState:
    """The presence of robots, (robots,) each; arrays are never changed in place.

    A robot has its row from the start to the end of a run, even while it is not in the world: one
    that is to join has neither joined nor left, one that never will has left without having joined.

    Attributes:
        present: whether the robot is in the world.
        joined_s: when it joined, infinite if it has not.
        left_s: when it left, infinite if it has not.
    """

    present: BoolArray
    joined_s: FloatArray
    left_s: FloatArray

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return a world with the robots that are in it from the start."""
        present = np.array([robot.join_s <= 0.0 for robot in world.robots], dtype=np.bool_)
        return cls(present, np.where(present, 0.0, np.inf), np.full(len(present), np.inf))

    def with_another(self) -> Self:
        """Return a copy with one more robot, which has not joined."""
        return type(self)(
            np.append(self.present, False),
            np.append(self.joined_s, np.inf),
            np.append(self.left_s, np.inf),
        )
