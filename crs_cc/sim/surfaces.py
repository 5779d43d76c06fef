"""What the surfaces of all things do to light and sound.

>>> from crs_cc.sim.model import Area, Cylinder, Material, Pose, WorldModel
>>> red = Cylinder("red", Pose(1, 1), 0.1, material=Material((255, 0, 0)))
>>> surfaces = Surfaces.of(Scene(WorldModel("w", Area(0, 0, 9, 9, 0), cylinders=(red,))))
>>> hex(surfaces.colour[0])
'0xff0000'
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np
import numpy.typing as npt

from crs_cc.sim.model import PLAIN
from crs_cc.sim.scene import Scene

FloatArray = npt.NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Surfaces:
    """The surfaces of all things, in the order of `Scene.names`; arrays have shape (things,).

    Attributes:
        colour: what cameras see, 0xRRGGBB.
        sonar: the share of sound that comes back, 0 to 1.
        infrared: the share of infrared light that comes back; not a number where the sensor's
            definition says what it takes surfaces for.
        hushes: whether any of them takes sound away.
    """

    colour: npt.NDArray[np.int32]
    sonar: FloatArray
    infrared: FloatArray
    hushes: bool

    @classmethod
    def of(cls, scene: Scene) -> Self:
        """Gives the surfaces of all things in a scene."""
        things = (*scene.world.robots, *scene.pushables, *scene.fixed_solids)
        materials = [thing.material for thing in things]
        materials += [PLAIN] * (len(scene.names) - len(things))  # of the ground
        sonar = np.array([material.sonar for material in materials], dtype=np.float64)
        infrared = [np.nan if each.infrared is None else each.infrared for each in materials]
        return cls(
            np.array([packed(material.colour) for material in materials], dtype=np.int32),
            sonar,
            np.array(infrared, dtype=np.float64),
            bool((sonar < 1.0).any()),
        )


def packed(colour: tuple[int, int, int]) -> int:
    """Gives a colour as 0xRRGGBB."""
    red, green, blue = colour
    return red << 16 | green << 8 | blue
