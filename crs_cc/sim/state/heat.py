"""The heat of objects."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.model.world import WorldModel


@dataclass(slots=True)
class HeatState:
    """The heat of all objects.

    Attributes:
        left: the heat of each object, in the order of `Scene.names`: robots, movable objects,
            fixed ones, the ground; shape (names,).
    """

    left: FloatArray

    @classmethod
    def at_start(cls, world: WorldModel, scene: Scene) -> Self:
        """Return the heat of each object in the world file; robots that join later have none."""
        left = np.zeros(len(scene.names))
        left[: len(scene.objects)] = [obj.heat for obj in scene.objects]
        left[: scene.robots] *= [robot.join_s <= 0.0 for robot in world.robots]
        return cls(left)
