"""Where robots believe to be."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Self

import numpy as np
import numpy.typing as npt

from crs_cc.sim.model import WorldModel

FloatArray = npt.NDArray[np.float64]


@dataclass(slots=True)
class OdometryState:
    """Where each robot believes to be, in the frame of its odometry; shape (robots,) each."""

    x_m: FloatArray
    y_m: FloatArray
    heading_rad: FloatArray
    turret_rad: FloatArray

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Gives the odometry of robots that were just switched on."""
        count = len(world.robots)
        return cls(*(np.zeros(count) for _ in fields(cls)))
