"""Energy used by the motors."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.model.axis import AXES
from crs_cc.sim.model.world import WorldModel


@dataclass(slots=True)
class BatteryState:
    """The motor batteries of all robots; their constant load follows from the time.

    Attributes:
        moved_j: energy used for moving, (robots,).
        speed_mps: the axes' speeds at the last update, (robots, 3).
    """

    moved_j: FloatArray
    speed_mps: FloatArray

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return batteries of robots that have not moved yet."""
        count = len(world.robots)
        return cls(np.zeros(count), np.zeros((count, AXES)))
