"""How hot things are."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.model.world import WorldModel


@dataclass(slots=True)
class HeatState:
    """How hot all things are.

    Attributes:
        left: the heat of each thing, in the order of `Scene.names`: robots, what can be pushed,
            what cannot, the ground; shape (names,).
    """

    left: FloatArray

    @classmethod
    def at_start(cls, world: WorldModel, scene: Scene) -> Self:
        """Return the heat that the world file gives to each thing; robots to come have none yet."""
        left = np.zeros(len(scene.names))
        left[: len(scene.things)] = [thing.heat for thing in scene.things]
        left[: scene.robots] *= [robot.join_s <= 0.0 for robot in world.robots]
        return cls(left)
