"""Speeds of the serial links between hosts and robots."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import Int64Array
from crs_cc.sim.model.world import WorldModel


@dataclass(slots=True)
class LinkState:
    """The serial links of all robots.

    Attributes:
        baud: their speeds [bit/s], (robots,).
    """

    baud: Int64Array

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return links with the speeds of the definitions."""
        return cls(np.array([robot.model.link.baud for robot in world.robots], dtype=np.int64))
