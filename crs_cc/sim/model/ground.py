"""What the ground of a world is: constant data, flat unless something lies on it.

Rectangular blocks lie on a floor at height 0: the top of each is a plane that rises along its
heading, or is level. Where several lie on each other, the highest one counts. `terrain` tells
heights and slopes of it, `ground_elements` reads it from a world file.

Units: metres, radians, in the world frame; z upwards from the floor.

>>> ramp = Patch(2.0, 1.0, 0.0, length_m=2.0, width_m=1.0, from_m=0.0, to_m=0.5)
>>> ramp.slope, Ground((ramp,)).is_flat, FLAT.is_flat
(0.25, False, True)
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final


@dataclass(frozen=True, slots=True)
class Patch:
    """A ramp, or a plateau when both its ends are equally high.

    Attributes:
        x_m: its middle.
        y_m: the same.
        heading_rad: the direction in which it rises or falls.
        length_m: its size along its heading, in the plane of the world.
        width_m: its size across.
        from_m: the height of its rear end, 0 or more.
        to_m: the height of its front end, 0 or more.
    """

    x_m: float
    y_m: float
    heading_rad: float
    length_m: float
    width_m: float
    from_m: float
    to_m: float

    @property
    def slope(self) -> float:
        """By how much it rises along its heading with each metre in the plane of the world."""
        return (self.to_m - self.from_m) / self.length_m


@dataclass(frozen=True, slots=True)
class HeightMap:
    """Ground whose height comes from a picture, see `heightmap`.

    Attributes:
        x_m: where the lower left corner of the picture lies.
        y_m: the same.
        pixel_m: the size of a pixel.
        columns: how many pixels a row has, 2 or more.
        heights_m: how high the middle of each pixel is, row after row from the lowest one up.
    """

    x_m: float
    y_m: float
    pixel_m: float
    columns: int
    heights_m: tuple[float, ...]


@dataclass(frozen=True, slots=True)
class Ground:
    """The ground of a world.

    Attributes:
        patches: the ramps and plateaus on the floor.
        heightmap: what lies below them, None for a flat floor.
    """

    patches: tuple[Patch, ...] = ()
    heightmap: HeightMap | None = None

    @property
    def is_flat(self) -> bool:
        """Whether all of it is the floor."""
        return not self.patches and self.heightmap is None


FLAT: Final = Ground()
"""A floor with nothing on it."""
