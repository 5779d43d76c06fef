"""The ground of a world, flat by default.

Rectangular blocks lie on a floor at height 0: the top of each is a plane that rises along its
heading, or is level. Where several overlap, the highest one determines the height. `terrain`
computes heights and slopes, `ground_elements` reads the blocks from a world file.

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
    """A ramp, or a plateau if both its ends have the same height.

    Attributes:
        x_m: its centre.
        y_m: its centre.
        heading_rad: the direction in which it rises or falls.
        length_m: its size along its heading, in the horizontal plane.
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
        """The rise along its heading for each metre in the horizontal plane."""
        return (self.to_m - self.from_m) / self.length_m


@dataclass(frozen=True, slots=True)
class HeightMap:
    """Ground whose height comes from an image, see `heightmap`.

    Attributes:
        x_m: the lower left corner of the image.
        y_m: the lower left corner of the image.
        pixel_m: the size of a pixel.
        columns: pixels in a row, 2 or more.
        heights_m: height at the centre of each pixel, row by row from the lowest one up.
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
        heightmap: the ground below them; None for a flat floor.
    """

    patches: tuple[Patch, ...] = ()
    heightmap: HeightMap | None = None

    @property
    def is_flat(self) -> bool:
        """True if the ground is a flat floor."""
        return not self.patches and self.heightmap is None


FLAT: Final = Ground()
"""A flat floor."""
