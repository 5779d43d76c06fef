"""Objects between two points by numpy: the lines that `kernels/sight.c` has to meet, to the bit."""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core import segment
from crs_cc.core.arrays import ComplexArray, FloatArray, IndexArray
from crs_cc.sim.geometry.cell_list import CellList, expand, few_pairs
from crs_cc.sim.geometry.obstacles import Grid
from crs_cc.sim.geometry.scene import Outlines, Scene
from crs_cc.sim.kernels import exact

_PIECE_M: Final = 2.0
_AT_ONCE: Final = 2048  # lines in one block: their pieces stay in the processor's cache


class NumpySight:
    """The outlines of a scene, sorted by position."""

    def __init__(self, scene: Scene) -> None:
        self._scene = scene
        self._robots = scene.robots
        fixed = scene.fixed
        self._fixed = fixed
        circles = fixed.circles
        self._segment_grid = Grid(fixed.segments, np.zeros(len(fixed.segments)), _PIECE_M / 2)
        self._circle_grid = Grid(circles[:, [0, 1, 0, 1]], circles[:, 2], _PIECE_M / 2)

    def between(
        self, position_m: FloatArray, angle_rad: FloatArray, start: ComplexArray, end: ComplexArray
    ) -> IndexArray:
        """Return the number of objects between points.

        Args:
            position_m: the positions of the movable bodies, as for `Scene.moving`.
            angle_rad: their headings.
            start: one point of each pair, shape (k,).
            end: the other one.

        Returns:
            shape (k,).
        """
        counts = np.zeros(len(start), dtype=np.intp)
        moving = self._scene.moving(position_m, angle_rad)
        for first in range(0, len(start), _AT_ONCE):
            part = slice(first, first + _AT_ONCE)
            counts[part] = self._between(moving, start[part], end[part])
        return counts

    def _between(self, moving: Outlines, start: ComplexArray, end: ComplexArray) -> IndexArray:
        pieces = np.maximum(np.ceil(exact.magnitude(end - start) / _PIECE_M), 1).astype(np.intp)
        line, number = expand(np.zeros(len(start), dtype=np.intp), pieces)
        step = ((end - start) / pieces)[line]
        a = start[line] + number * step
        middle = a + step / 2
        fixed, robots = self._fixed, self._robots
        pushable = moving.owners >= robots
        circles, owners = moving.circles[pushable], moving.owners[pushable]
        met = [
            _meet_segments(a, step, *self._segment_grid.near(middle), fixed.segments),
            _meet_circles(a, step, *self._circle_grid.near(middle), fixed.circles),
            _meet_segments(a, step, *_near(middle, moving.segments), moving.segments),
            _meet_circles(a, step, *_near(middle, circles), circles),
        ]
        objects = (fixed.segment_owners, fixed.owners, moving.segment_owners, owners)
        width = len(self._scene.names) + 1
        keys = [
            line[piece] * width + obj[shape]
            for (piece, shape), obj in zip(met, objects, strict=True)
        ]
        return np.bincount(np.unique(np.concatenate(keys)) // width, minlength=len(start))


def _near(middle: ComplexArray, shapes: FloatArray) -> tuple[IndexArray, IndexArray]:
    """Return pairs of piece and movable shape, including all that intersect.

    Args:
        middle: the centres of the pieces.
        shapes: segments, (n, 5), or circles, (n, 3).
    """
    if pairs := few_pairs(len(middle), len(shapes)):
        return pairs
    sides = shapes.shape[1] > 3  # a circle has three columns
    x_m, y_m = (shapes[:, 0:2] + shapes[:, 2:4]).T / 2 if sides else shapes[:, :2].T
    size_m = shapes[:, -1].max() / (2 if sides else 1)
    cells = CellList(x_m.copy(), y_m.copy(), _PIECE_M / 2 + float(size_m))
    return cells.near(middle.real, middle.imag)


def _meet_segments(
    a: ComplexArray, step: ComplexArray, piece: IndexArray, shape: IndexArray, segments: FloatArray
) -> tuple[IndexArray, IndexArray]:
    """Return those pairs of piece and segment that intersect."""
    x1, y1, x2, y2 = (np.ascontiguousarray(column) for column in segments.T[:4])
    a_x, a_y, step_x, step_y = a.real.copy(), a.imag.copy(), step.real.copy(), step.imag.copy()
    start_x, start_y = a_x.take(piece), a_y.take(piece)
    along_x, along_y = step_x.take(piece), step_y.take(piece)
    low_x, low_y = x1.take(shape) - start_x, y1.take(shape) - start_y
    high_x, high_y = x2.take(shape) - start_x, y2.take(shape) - start_y
    crosses = (along_x * low_y > along_y * low_x) != (along_x * high_y > along_y * high_x)
    # Few of them have ends on both sides of the piece's line: only these are tested further.
    some = np.flatnonzero(crosses)
    piece, shape = piece.take(some), shape.take(some)
    low_x, low_y = low_x.take(some), low_y.take(some)
    side_x, side_y = x2.take(shape) - x1.take(shape), y2.take(shape) - y1.take(shape)
    end_x, end_y = low_x - along_x.take(some), low_y - along_y.take(some)
    crosses = (side_x * low_y < side_y * low_x) != (side_x * end_y < side_y * end_x)
    return piece[crosses], shape[crosses]


def _meet_circles(
    a: ComplexArray, step: ComplexArray, piece: IndexArray, shape: IndexArray, circles: FloatArray
) -> tuple[IndexArray, IndexArray]:
    """Return those pairs of piece and circle that intersect."""
    away = circles[shape, 0] + 1j * circles[shape, 1] - a[piece]
    along = step[piece]
    distance_m = segment.distance(away.real, away.imag, along.real, along.imag)
    inside = distance_m < circles[shape, 2]
    return piece[inside], shape[inside]
