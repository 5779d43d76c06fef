"""Lamps and speakers of robots."""

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
        brightness: brightness of its lamp, 0 for off, (robots,).
        level: level of its speaker, 0 for off, (robots,).
        tone: tone of its speaker, (robots,).
    """

    brightness: FloatArray
    level: FloatArray
    tone: Int64Array

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return lamps and speakers that are off."""
        count = len(world.robots)
        return cls(np.zeros(count), np.zeros(count), np.zeros(count, dtype=np.int64))
