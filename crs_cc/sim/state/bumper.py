"""Bumper switches, and the time of the last contact."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import Int32Array
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state.last_measurement import LastMeasurement


@dataclass(slots=True)
class BumperState:
    """The switches of all robots.

    Attributes:
        pressed: the pressed ones, as bits as in `State[33]`, (robots,).
        hit: the last time at which another switch was pressed.
    """

    pressed: Int32Array
    hit: LastMeasurement

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return released switches."""
        count = len(world.robots)
        return cls(np.zeros(count, dtype=np.int32), LastMeasurement.never(count))
