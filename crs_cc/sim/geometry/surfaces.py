"""Reflectance of all objects for light and sound.

A surface that reflects a share R of the sound is heard up to R ** (1/4) times as far as one that
reflects all of it: the power of an echo falls with the fourth power of the distance, as sound
spreads in both directions, and the detection threshold is constant. That is the radar equation,
solved for the range (M. I. Skolnik, "Introduction to Radar Systems", 1980, 1.2), with the share in
place of the cross section.

>>> from crs_cc.sim.model.world import Area, Cylinder, Material, Pose, WorldModel
>>> red = Cylinder("red", Pose(1, 1), 0.1, material=Material((255, 0, 0)))
>>> surfaces = Surfaces.of(Scene(WorldModel("w", Area(0, 0, 9, 9, 0), cylinders=(red,))))
>>> hex(surfaces.colour[0])
'0xff0000'
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from crs_cc.core.arrays import FloatArray, Int32Array
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.model.world import PLAIN


@dataclass(frozen=True, slots=True)
class Surfaces:
    """The surfaces of all objects, in the order of `Scene.names`; arrays have shape (objects,).

    Attributes:
        colour: the colour, 0xRRGGBB.
        infrared: reflectance for infrared light, NaN for the value that the sensor's definition
            assumes; None if that holds for all.
        echo_range: the distance at which each is heard, relative to a hard one; None if all are
            hard.
    """

    colour: Int32Array
    infrared: FloatArray | None
    echo_range: FloatArray | None

    @classmethod
    def of(cls, scene: Scene) -> Self:
        """Return the surfaces of all objects in a scene."""
        materials = [obj.material for obj in scene.objects]
        materials += [PLAIN] * (len(scene.names) - len(scene.objects))  # of the ground
        sonar = np.array([material.sonar for material in materials], dtype=np.float64)
        shares = [np.nan if each.infrared is None else each.infrared for each in materials]
        infrared = np.array(shares, dtype=np.float64)
        return cls(
            np.array([packed(material.colour) for material in materials], dtype=np.int32),
            None if np.isnan(infrared).all() else infrared,
            np.sqrt(np.sqrt(sonar)) if (sonar < 1.0).any() else None,
        )


def packed(colour: tuple[int, int, int]) -> int:
    """Return a colour as 0xRRGGBB."""
    red, green, blue = colour
    return red << 16 | green << 8 | blue
