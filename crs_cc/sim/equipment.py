"""What the robots of a world are made of, as arrays: constants for the vectorised parts."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np
import numpy.typing as npt

from crs_cc.sim.model import WorldModel
from crs_cc.sim.things import Things

FloatArray = npt.NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Equipment:
    """Constants of all robots; each array has shape (robots,), those of `things` apart.

    Attributes:
        timestep_s: the world's timestep [s].
        wheel_base_m: distance between the wheels.
        speed_limit_mps: the fastest that a wheel can run.
        ramp_limit_mps2: the fastest that its speed can change.
        heat_range_m: how far the heat sensor senses, 0 where there is none.
        tag_range_m: how far heat is taken away.
        things: the shapes of all things.
    """

    timestep_s: float
    wheel_base_m: FloatArray
    speed_limit_mps: FloatArray
    ramp_limit_mps2: FloatArray
    heat_range_m: FloatArray
    tag_range_m: FloatArray
    things: Things

    @classmethod
    def of(cls, world: WorldModel) -> Self:
        """Gives the equipment of a world's robots."""
        models = [robot.model for robot in world.robots]
        return cls(
            world.timestep_s,
            np.array([model.drive.wheel_base_m for model in models]),
            np.array([model.drive.speed_limit_mps for model in models]),
            np.array([model.drive.acceleration_limit_mps2 for model in models]),
            np.array([model.heat.range_m for model in models]),
            np.array([model.heat.tag_range_m for model in models]),
            Things.of(world),
        )
