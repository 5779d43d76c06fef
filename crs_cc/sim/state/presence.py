"""Which robots are in the world, and since when."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray
from crs_cc.sim.model.world import WorldModel


@dataclass(slots=True)
class PresenceState:
    """Who is there, (robots,) each; arrays are never changed in place.

    A robot has its row from the start to the end of a run, wherever it is: one that is to join has
    neither joined nor left, one that never will has left without having joined.

    Attributes:
        present: whether the robot is in the world.
        joined_s: when it joined, infinite for one that has not.
        left_s: when it left, infinite for one that has not.
    """

    present: BoolArray
    joined_s: FloatArray
    left_s: FloatArray

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return a world with those robots that are there from the start."""
        present = np.array([robot.join_s <= 0.0 for robot in world.robots], dtype=np.bool_)
        return cls(present, np.where(present, 0.0, np.inf), np.full(len(present), np.inf))

    def with_another(self) -> Self:
        """Return the same with a further robot, which has not joined."""
        return type(self)(
            np.append(self.present, False),
            np.append(self.joined_s, np.inf),
            np.append(self.left_s, np.inf),
        )
