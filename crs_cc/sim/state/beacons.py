"""How bright robots shine and how loud they sound."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import FloatArray, Int64Array
from crs_cc.sim.model.world import WorldModel


@dataclass(slots=True)
class BeaconState:
    """Lamps and speakers; arrays have a row for each robot.

    Attributes:
        brightness: how bright its lamp shines, 0 for none, (robots,).
        level: how loud its speaker sounds, 0 for none, (robots,).
        tone: its tone, (robots,).
    """

    brightness: FloatArray
    level: FloatArray
    tone: Int64Array

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return robots that are dark and silent."""
        count = len(world.robots)
        return cls(np.zeros(count), np.zeros(count), np.zeros(count, dtype=np.int64))
