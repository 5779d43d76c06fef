"""Which switches are pressed, and when the last one was."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import Int32Array
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.last_measurement import Moments


@dataclass(slots=True)
class BumperState:
    """The switches of all robots.

    Attributes:
        pressed: which are pressed, bit by bit as in `State[33]`, (robots,).
        hit: when a switch was pressed last that was not pressed before.
    """

    pressed: Int32Array
    hit: Moments

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return switches that nothing presses."""
        count = len(world.robots)
        return cls(np.zeros(count, dtype=np.int32), Moments.never(count))
