"""Odometry: the estimated poses of robots."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.model.axis import AXES
from crs_cc.sim.model.world import WorldModel


@dataclass(slots=True)
class OdometryState:
    """The estimated pose of each robot, in the frame of its odometry; shape (robots,) each.

    Attributes:
        x_m: its position.
        y_m: its position.
        heading_rad: the direction of its wheels.
        turret_rad: the direction of its turret; 0 without one.
        shaft: true position of each encoder's shaft, in the unit of its axis, (robots, 3).
        reported: position by the counts of the encoder, (robots, 3).
    """

    x_m: FloatArray
    y_m: FloatArray
    heading_rad: FloatArray
    turret_rad: FloatArray
    shaft: FloatArray
    reported: FloatArray

    @classmethod
    def at_start(cls, world: WorldModel) -> Self:
        """Return the odometry of robots that were just switched on."""
        count = len(world.robots)
        shaft = np.zeros((count, AXES))
        x_m, y_m, heading_rad, turret_rad = np.zeros((4, count))
        return cls(x_m, y_m, heading_rad, turret_rad, shaft, shaft.copy())
