"""Height and gradient of the ground.

    height(p)   = max(0, from + (to - from) (u + length / 2) / length)  of all patches at p
    gradient(p) = ((to - from) / length) (cos heading, sin heading)  of the highest patch

where u is the distance of p ahead of the patch's centre, and 0 is replaced with the height of the
height map, if there is one (`heightmap`). The gradient is in the world frame and points uphill; on
the floor, and on plateaus, it is 0. Of patches of equal height, the first one of the world file
counts. The edge of a patch belongs to it.

>>> from crs_cc.sim.model.ground import Patch, Ground
>>> ramp = Patch(2.0, 1.0, 0.0, length_m=2.0, width_m=1.0, from_m=0.0, to_m=0.5)
>>> terrain = Terrain(Ground((ramp, Patch(3.5, 1.0, 0.0, 1.0, 1.0, 0.5, 0.5))))
>>> x_m, y_m = np.array([0.5, 1.0, 2.0, 3.5, 2.0]), np.array([1.0, 1.0, 1.2, 1.0, 1.6])
>>> terrain.height_m(x_m, y_m)
array([0.  , 0.  , 0.25, 0.5 , 0.  ])
>>> terrain.gradient(x_m, y_m).tolist()
[[0.0, 0.0], [0.25, 0.0], [0.25, 0.0], [0.0, 0.0], [0.0, 0.0]]
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core.arrays import ComplexArray, FloatArray, IndexArray
from crs_cc.sim.geometry.heightmap import Heights
from crs_cc.sim.geometry.obstacles import Grid
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.ground import Ground

_ON_M: Final = 1e-9  # rounding must not leave a gap between patches that touch


class Terrain:
    """The ground of a world.

    Attributes:
        middle: the centre of each patch, x + i y [m], shape (patches,).
        along: the direction in which it rises or falls, of length 1.
        half_length_m: half its size in that direction.
        half_width_m: half its size across.
        middle_m: the height of its centre.
        slope: its rise with each metre in that direction.
        heights: the ground below the patches, None for the floor.
    """

    def __init__(self, ground: Ground) -> None:
        patches = ground.patches
        headings_rad = [patch.heading_rad for patch in patches]
        self.middle = np.array([complex(patch.x_m, patch.y_m) for patch in patches], np.complex128)
        self.along = exact.turn(np.array(headings_rad, dtype=np.float64))
        self.half_length_m = np.array([patch.length_m / 2 for patch in patches])
        self.half_width_m = np.array([patch.width_m / 2 for patch in patches])
        self.middle_m = np.array([(patch.from_m + patch.to_m) / 2 for patch in patches])
        self.slope = np.array([patch.slope for patch in patches])
        self._patches = self.grid(_ON_M)
        self.heights = None if ground.heightmap is None else Heights(ground.heightmap)

    def grid(self, reach_m: float) -> Grid:
        """Return the patches, sorted by the places from which they are within reach."""
        half = self.along * self.half_length_m
        ends = [self.middle - half, self.middle + half]
        columns = [part for end in ends for part in (end.real, end.imag)]
        return Grid(np.column_stack(columns), self.half_width_m, reach_m)

    def corners_m(self) -> FloatArray:
        """Return the corners of all patches, counter-clockwise, (patches, 4, 2)."""
        return corners_m(self.middle, self.along, self.half_length_m, self.half_width_m)

    def local(self, place: ComplexArray, patch: IndexArray) -> ComplexArray:
        """Transform points to the frames of patches, shape (n,)."""
        return exact.product(place - self.middle.take(patch), self.along.take(patch).conj())

    def height_m(self, x_m: FloatArray, y_m: FloatArray) -> FloatArray:
        """Return the height of the ground at points in the world frame [m], shape (n,)."""
        place = x_m + 1j * y_m
        return self._on(place)[0]

    def gradient(self, x_m: FloatArray, y_m: FloatArray) -> FloatArray:
        """Return the gradient of the ground along x and y at points [m/m], shape (n, 2)."""
        place = x_m + 1j * y_m
        gradient = np.zeros(len(place), dtype=np.complex128)
        if self.heights is not None:
            gradient = self.heights.at(x_m, y_m)[1]
        height_m, point, patch, patch_m = self._on(place)
        top = np.flatnonzero(patch_m == height_m.take(point))[::-1]  # the first one wins
        steep = patch.take(top)
        gradient[point.take(top)] = self.slope.take(steep) * self.along.take(steep)
        return np.column_stack([gradient.real, gradient.imag])

    def _on(self, place: ComplexArray) -> tuple[FloatArray, IndexArray, IndexArray, FloatArray]:
        """Return the heights of points, and pairs of a point and a patch there, with its height."""
        height_m = np.zeros(len(place))
        if self.heights is not None:
            height_m = self.heights.at(place.real, place.imag)[0]
        point, patch = self._patches.near(place)
        local = self.local(place.take(point), patch)
        inside = np.abs(local.real) <= self.half_length_m.take(patch) + _ON_M
        inside &= np.abs(local.imag) <= self.half_width_m.take(patch) + _ON_M
        kept = np.flatnonzero(inside)
        point, patch = point.take(kept), patch.take(kept)
        patch_m = self.middle_m.take(patch) + self.slope.take(patch) * local.real.take(kept)
        np.maximum.at(height_m, point, patch_m)
        return height_m, point, patch, patch_m


def corners_m(
    middle: ComplexArray, along: ComplexArray, half_length_m: FloatArray, half_width_m: FloatArray
) -> FloatArray:
    """Return the corners of rectangles, given as patches are, counter-clockwise, (n, 4, 2)."""
    ahead, left = along * half_length_m, 1j * along * half_width_m
    corners = [-ahead - left, ahead - left, ahead + left, left - ahead]
    places = middle[:, None] + np.column_stack(corners)
    return np.stack([places.real, places.imag], axis=2)
