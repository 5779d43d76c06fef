"""Microphone readings."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import FloatArray, Int64Array
from crs_cc.sim.model.beacons import TONES
from crs_cc.sim.model.world import WorldModel


@dataclass(slots=True)
class SoundState:
    """Microphones; arrays have a row for each robot with microphones, n of them.

    Attributes:
        level: the level of each tone, before rounding, (n, 8).
        bearing_rad: the direction of the loudest one, (n,).
        at_s: time of the measurement; negative for none, (n,).
        count: number of measurements, (n,).
    """

    level: FloatArray
    bearing_rad: FloatArray
    at_s: FloatArray
    count: Int64Array

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return microphones that have not measured yet."""
        count = sum(robot.model.microphones is not None for robot in world.robots)
        never, none = np.full(count, -1.0), np.zeros(count, dtype=np.int64)
        return cls(np.zeros((count, TONES)), np.zeros(count), never, none)
