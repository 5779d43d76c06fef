"""Ground heights from an image, interpolated bilinearly between the centres of its pixels.

    height = (1 - s)(1 - t) h00 + s (1 - t) h10 + (1 - s) t h01 + s t h11
    gradient = its derivatives by x and y

for a point that is s and t pixels beyond the centre of a pixel. Beyond the centres of the outermost
pixels the ground is level, and outside of the image is the floor.

>>> from crs_cc.sim.model.ground import HeightMap
>>> heights = Heights(HeightMap(0.0, 0.0, 1.0, 3, (0.0, 0.0, 0.0, 0.0, 1.0, 2.0)))
>>> x_m, y_m = np.array([1.5, 1.5, 2.0, 9.0]), np.array([1.5, 1.0, 1.5, 1.0])
>>> height_m, gradient = heights.at(x_m, y_m)
>>> height_m
array([1. , 0.5, 1.5, 0. ])
>>> gradient[:2]
array([1. +1.j, 0.5+1.j])
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core.arrays import BoolArray, ComplexArray, FloatArray, IndexArray
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.ground import HeightMap

_AT_ONCE: Final = 1_000_000  # viewers times pixels in one block; bounds the memory
_SIDES: Final = ((0, -1, 0, 1), (1, 0, 1, 1 + 1j), (0, 1, 1 + 1j, 1j), (-1, 0, 1j, 0))
"""For a side of a pixel: the neighbour behind it, and its ends, with the pixel to their left."""


class Heights:
    """The heights of an image.

    Attributes:
        corner: the lower left corner of the image, x + i y [m].
        pixel_m: the size of a pixel.
        nodes_m: the height of each pixel's centre, from the lowest row upwards, (rows, columns).
    """

    def __init__(self, heightmap: HeightMap) -> None:
        self.corner = complex(heightmap.x_m, heightmap.y_m)
        self.pixel_m = heightmap.pixel_m
        self.nodes_m = np.array(heightmap.heights_m).reshape(-1, heightmap.columns)

    def at(self, x_m: FloatArray, y_m: FloatArray) -> tuple[FloatArray, ComplexArray]:
        """Return the heights [m] at points, and the gradients along x and i y."""
        rows, columns = self.nodes_m.shape
        across, up = (
            (x_m - self.corner.real) / self.pixel_m,
            (y_m - self.corner.imag) / self.pixel_m,
        )
        inside = (across >= 0.0) & (across <= columns) & (up >= 0.0) & (up <= rows)
        column, s, runs = _between(across - 0.5, columns)
        row, t, climbs = _between(up - 0.5, rows)
        h00, h10 = self.nodes_m[row, column], self.nodes_m[row, column + 1]
        h01, h11 = self.nodes_m[row + 1, column], self.nodes_m[row + 1, column + 1]
        height_m = (1 - s) * (1 - t) * h00 + s * (1 - t) * h10 + (1 - s) * t * h01 + s * t * h11
        along_x = ((1 - t) * (h10 - h00) + t * (h11 - h01)) / self.pixel_m
        along_y = ((1 - s) * (h01 - h00) + s * (h11 - h10)) / self.pixel_m
        gradient = np.where(runs, along_x, 0.0) + 1j * np.where(climbs, along_y, 0.0)
        return np.where(inside, height_m, 0.0), np.where(inside, gradient, 0.0)

    def holds(self, place: ComplexArray, margin_m: float) -> BoolArray:
        """Return which points are in the image, or within a margin of it."""
        rows, columns = self.nodes_m.shape
        away = place - self.corner
        x = (away.real >= -margin_m) & (away.real <= columns * self.pixel_m + margin_m)
        return np.asarray(
            x & (away.imag >= -margin_m) & (away.imag <= rows * self.pixel_m + margin_m)
        )

    def steep(self, slope: float) -> tuple[ComplexArray, FloatArray, FloatArray]:
        """Return the squares between four pixels that are steeper than a slope.

        Returns:
            their centres, the heights of their highest corners, and their slopes.
        """
        nodes_m = self.nodes_m
        along_x = np.abs(np.diff(nodes_m, axis=1))
        along_y = np.abs(np.diff(nodes_m, axis=0))
        steps_m = exact.hypot(
            np.maximum(along_x[1:], along_x[:-1]), np.maximum(along_y[:, 1:], along_y[:, :-1])
        )
        row, column = np.nonzero(steps_m > slope * self.pixel_m)
        grid = (column + 1) + 1j * (row + 1)
        middle = np.asarray(self.corner + self.pixel_m * grid, np.complex128)
        corners_m = [nodes_m[row + up, column + right] for up in (0, 1) for right in (0, 1)]
        return middle, np.max(corners_m, axis=0), steps_m[row, column] / self.pixel_m

    def outlines(
        self,
        place: ComplexArray,
        plane: tuple[FloatArray, ComplexArray],
        z_m: FloatArray,
        spread: FloatArray,
        reach_m: float,
    ) -> tuple[IndexArray, ComplexArray, ComplexArray, FloatArray]:
        """Return the sides of all pixels above beams, as if each pixel were level, for viewers.

        Args:
            place: the viewers' positions, (k,).
            plane: the height and the gradient of the ground there.
            z_m: the height of the beams' starts above the ground, (k,).
            spread: the fall of their lower sides with each metre, (k,).
            reach_m: their range.

        Returns:
            pairs of viewer and side, as for `Obstacles.segments_near`.
        """
        some = np.flatnonzero(self.holds(place, reach_m))
        count = max(1, _AT_ONCE // self.nodes_m.size)
        parts = []
        for first in range(0, len(some), count):
            part = some[first : first + count]
            away, away_m = self._away(place[part])
            beam_m = plane[0][part, None, None]
            beam_m = beam_m + exact.dot(plane[1][part, None, None], away)
            falls_m = spread[part, None, None] * away_m
            beam_m += np.maximum(z_m[part, None, None] - falls_m, 0.0)
            viewer, start, end = self._sides((self.nodes_m > beam_m) & (away_m <= reach_m))
            parts.append((part[viewer], start, end))
        viewers = np.concatenate([np.zeros(0, np.intp), *(part[0] for part in parts)])
        start = np.concatenate([np.zeros(0, np.complex128), *(part[1] for part in parts)])
        end = np.concatenate([np.zeros(0, np.complex128), *(part[2] for part in parts)])
        return viewers, start, end, np.full(len(viewers), self.pixel_m)

    def _away(self, place: ComplexArray) -> tuple[ComplexArray, FloatArray]:
        """Return the centres of all pixels relative to points, and their distances."""
        rows, columns = self.nodes_m.shape
        grid = np.arange(columns) + 0.5 + 1j * (np.arange(rows)[:, None] + 0.5)
        away = np.asarray(self.corner + self.pixel_m * grid - place[:, None, None], np.complex128)
        return away, exact.magnitude(away)

    def _sides(self, over: BoolArray) -> tuple[IndexArray, ComplexArray, ComplexArray]:
        """Return the sides between pixels above beams, (k, rows, columns), and other pixels."""
        over = np.pad(over, ((0, 0), (1, 1), (1, 1)))
        found = []
        for right, up, first, last in _SIDES:
            next_over = np.roll(over, (-up, -right), axis=(1, 2))
            viewer, row, column = np.nonzero(over & ~next_over)
            corner = self.corner + self.pixel_m * (column - 1 + 1j * (row - 1))
            ends = [corner + self.pixel_m * end for end in (first, last)]
            found.append((viewer, *(np.asarray(end, np.complex128) for end in ends)))
        viewer, start, end = (np.concatenate(part) for part in zip(*found, strict=True))
        return viewer, start, end


def _between(place: FloatArray, count: int) -> tuple[IndexArray, FloatArray, BoolArray]:
    """Return the node before each point, the fraction after it, and whether it is between two."""
    clipped = np.clip(place, 0.0, count - 1.0)
    before = np.minimum(np.floor(clipped), count - 2.0)
    return before.astype(np.intp), clipped - before, clipped == place
