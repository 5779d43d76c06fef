"""Sensors in contact with or inside an object with sides, which measure 0.

A robot that collides with an object overlaps it slightly, and then a sensor on its shell is behind
the side that it touches. Beams are intersected with sides (`rays`), so such a beam would pass on to
the far side. Circles do not have this problem: `rays` handles beams that start inside them.

Boxes, and walls without their round ends, are rectangles; a point is inside if it is within both
half extents. A polygon is a set of triangles: each is the part of the rectangle over its longest
side to the left of two slants.

Points in the plane are complex numbers, x + i y [m], so that rotations are products.

>>> from crs_cc.sim.model.world import Area, Box, Pose, WorldModel
>>> world = WorldModel("w", Area(0, 0, 9, 9, 0), boxes=(Box("b", Pose(3, 1), 2, 1),))
>>> fan = Fan.of([(0.2, 0.0, 0.0, 0.0, 5.0), (-0.2, 0.0, math.pi, 0.0, 5.0)])
>>> Pieces(Scene(world), fan.start_m).cover(fan, np.array([[1.801, 1.0, 0.0]]))
array([[ True, False]])
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import Final

import numpy as np

from crs_cc.core.arrays import BoolArray, ComplexArray, FloatArray, IndexArray
from crs_cc.sim.geometry import cell_list
from crs_cc.sim.geometry.cell_list import CellList, are_few, blocks, few_pairs, parts
from crs_cc.sim.geometry.obstacles import Grid
from crs_cc.sim.geometry.rays import Fan
from crs_cc.sim.geometry.scene import Scene, own_corners_m, triangles_of
from crs_cc.sim.kernels import exact, surveys
from crs_cc.sim.kernels.program import kernels, pairs
from crs_cc.sim.model.world import Box, Cylinder, Solid, Wall

_NO_THING: Final = -1.0
_SHARE: Final = 8  # one in this many numbers of the kernels' memory is for beams
_ON_M: Final = 1e-9  # a sensor on a side must not be outside here and inside for `rays`


class Pieces:
    """All rectangles and triangles of solids: first fixed ones, then those of movable bodies."""

    def __init__(self, scene: Scene, start_m: float) -> None:
        """Collect the pieces of all solids at their initial poses.

        Args:
            scene: the scene.
            start_m: maximum distance of a sensor from its robot's centre.
        """
        fixed = [piece for solid in scene.fixed_solids for piece in _pieces(solid)]
        moving = [
            (body, piece)
            for body, obj in enumerate(scene.pushables, scene.robots)
            for piece in _pieces(obj)
        ]
        pieces = [*fixed, *(piece for _, piece in moving)]
        self._fixed = len(fixed)
        self._bodies = np.array([body for body, _ in moving], dtype=np.intp)
        first = scene.robots + len(scene.pushables)
        solids = enumerate(scene.fixed_solids, first)
        owners = [number for number, solid in solids for _ in _pieces(solid)]
        self._objects = np.concatenate([np.array(owners, dtype=np.intp), self._bodies])
        self._own_middle = np.array([piece.middle for piece in pieces], dtype=np.complex128)
        self._own_along = np.array([piece.along for piece in pieces], dtype=np.complex128)
        place = np.array([piece.place for piece in pieces], dtype=np.complex128)
        facing = np.array([piece.facing for piece in pieces], dtype=np.complex128)
        self._middle = place + exact.product(facing, self._own_middle)
        self._along = exact.product(facing, self._own_along)
        self._half_length_m = np.array([piece.half_length_m for piece in pieces])
        self._half_width_m = np.array([piece.half_width_m for piece in pieces])
        slants = np.array([piece.slants for piece in pieces], dtype=np.complex128).reshape(-1, 2)
        slants_m = np.array([piece.slants_m for piece in pieces]).reshape(-1, 2)
        self.rows = np.column_stack([
            np.full(len(pieces), -1.0),
            self._objects,
            pairs(self._middle),
            pairs(self._along),
            self._half_length_m,
            self._half_width_m,
            slants.view(np.float64),
            slants_m,
        ])  # fmt: skip
        self._start_m = start_m + _ON_M
        self._grid = self._grid_of_fixed()
        half_m = exact.hypot(self._half_length_m[self._fixed :], self._half_width_m[self._fixed :])
        self._reach_m = self._start_m + float(half_m.max(initial=0.0))
        self._cells: CellList | None = None
        self._places = b""  # of the movable bodies

    def __len__(self) -> int:
        return len(self.rows)

    @property
    def tables(self) -> tuple[FloatArray, FloatArray]:
        """Return the rows of fixed pieces, and of moving ones."""
        return self.rows[: self._fixed], self.rows[self._fixed :]

    def place(self, position_m: FloatArray, angle_rad: FloatArray) -> None:
        """Update the poses of the movable bodies, as for `Scene.moving`."""
        if not len(self._bodies):
            return
        places = position_m[self._bodies].tobytes() + angle_rad[self._bodies].tobytes()
        if places == self._places:
            return
        self._places = places
        x_m, y_m = position_m[self._bodies].T
        facing = exact.turn(angle_rad[self._bodies])
        off_m = exact.product(facing, self._own_middle[self._fixed :])
        self._middle[self._fixed :] = x_m + 1j * y_m + off_m
        self._along[self._fixed :] = exact.product(facing, self._own_along[self._fixed :])
        self._cells = None
        moving = self.rows[self._fixed :]
        moving[:, 2:4] = pairs(self._middle[self._fixed :])
        moving[:, 4:6] = pairs(self._along[self._fixed :])

    def cover(self, fan: Fan, poses: FloatArray, objects: IndexArray | None = None) -> BoolArray:
        """Return which beams of each robot start on or inside an object.

        Args:
            fan: the robots' beams.
            poses: x, y [m] and heading [rad] of each robot, shape (k, 3).
            objects: receives the objects that those beams start in, as in `Scene.names`, shape
                (k, beams); None if they are not needed.

        Returns:
            shape (k, beams), in the order of the list that the fan was made from.
        """
        if are_few(len(poses), len(self.rows)):
            covers = surveys.covers(kernels(), fan.table, poses, self.rows)
        else:
            place = poses[:, 0] + 1j * poses[:, 1]
            covers = np.full((len(poses), len(fan)), _NO_THING)
            for part in self._blocks(place, len(fan)):
                rows = self._rows_near(place[part])
                covers[part] = surveys.covers(kernels(), fan.table, poses[part], rows)
        covered = covers != _NO_THING
        if objects is not None:
            objects[covered] = covers[covered]
        return np.asarray(covered)

    def _rows_near(self, place: ComplexArray) -> FloatArray:
        """Return the rows of pieces near robots, each with its robot."""
        robots, shapes = self._near(place)
        rows = self.rows.take(shapes, axis=0)
        rows[:, 0] = robots
        return rows

    def _blocks(self, place: ComplexArray, beams: int) -> Iterator[slice]:
        """Yield parts of the robots whose pairs and beams are few enough to be listed."""
        counts = np.full(len(place), len(self._objects))
        if counts.sum() > cell_list.PAIRS_IN_BLOCK:
            counts = self._grid.counts(place)
            if len(self._bodies):
                counts = counts + self._cells_of_bodies().counts(place.real, place.imag)
        most = max(1, kernels().room // (_SHARE * max(beams, 1)))
        return (part for block in blocks(counts) for part in parts(block, most))

    def _near(self, place: ComplexArray) -> tuple[IndexArray, IndexArray]:
        """Return pairs of robot and piece, including all in which a sensor can be."""
        robots, shapes = self._grid.near(place)
        count = len(self._bodies)
        if count == 0:
            return robots, shapes
        if pairs := few_pairs(len(place), count):
            others, movers = pairs
        else:
            others, movers = self._cells_of_bodies().near(place.real, place.imag)
            rising = np.lexsort((movers, others))  # as in `few_pairs`: the last object counts
            others, movers = others[rising], movers[rising]
        return np.concatenate([robots, others]), np.concatenate([shapes, movers + self._fixed])

    def _cells_of_bodies(self) -> CellList:
        if self._cells is None:
            middle = self._middle[self._fixed :]
            self._cells = CellList(middle.real, middle.imag, self._reach_m)
        return self._cells

    def _grid_of_fixed(self) -> Grid:
        half_width_m = self._half_width_m[: self._fixed]
        middle = self._middle[: self._fixed]
        half = self._along[: self._fixed] * self._half_length_m[: self._fixed]
        start, end = middle - half, middle + half
        ends_m = np.column_stack([start.real, start.imag, end.real, end.imag])
        return Grid(ends_m, half_width_m, self._start_m)


@dataclass(frozen=True, slots=True)
class _Piece:
    """A rectangle, or a triangle in one.

    Attributes:
        place: position of its object's frame.
        facing: heading of that frame, of length 1.
        middle: the rectangle's centre in that frame.
        along: direction of its length, of length 1.
        half_length_m: half its length.
        half_width_m: half its width.
        slants: outward normals of a triangle's shorter sides, in the rectangle's frame.
        slants_m: distances of these sides from the rectangle's centre.
    """

    place: complex
    facing: complex
    middle: complex
    along: complex
    half_length_m: float
    half_width_m: float
    slants: tuple[complex, complex] = (0j, 0j)
    slants_m: tuple[float, float] = (math.inf, math.inf)


@lru_cache(maxsize=4096)  # recomputed whenever an obstacle is added or removed
def _pieces(solid: Solid) -> tuple[_Piece, ...]:
    """Return the pieces of a solid, without its round parts."""
    if isinstance(solid, Cylinder):
        return ()
    if isinstance(solid, Wall):
        start, end = complex(solid.x1_m, solid.y1_m), complex(solid.x2_m, solid.y2_m)
        along = exact.turn(exact.angle(end - start))
        half_m = exact.magnitude(end - start) / 2
        return (_Piece((start + end) / 2, along, 0j, 1, half_m, solid.thickness_m / 2),)
    place = complex(solid.pose.x_m, solid.pose.y_m)
    facing = complex(exact.turn(solid.pose.heading_rad))
    if isinstance(solid, Box):
        return (_Piece(place, facing, 0j, 1, solid.length_m / 2, solid.width_m / 2),)
    corners = own_corners_m(solid)
    places = corners[:, 0] + 1j * corners[:, 1]
    return tuple(_triangle(place, facing, places[three]) for three in triangles_of(solid))


def _triangle(place: complex, facing: complex, corners: ComplexArray) -> _Piece:
    longest = int(exact.magnitude(np.roll(corners, -1) - corners).argmax())
    start, end, top = np.roll(corners, -longest).tolist()
    length_m = exact.magnitude(end - start)
    along = (end - start) / length_m
    height_m = exact.product(top - start, along.conjugate()).imag
    middle = (start + end) / 2 + 1j * along * height_m / 2
    top = exact.product(top - middle, along.conjugate())
    right, left = length_m / 2 - 1j * height_m / 2, -length_m / 2 - 1j * height_m / 2
    slants = [-1j * (b - a) / exact.magnitude(b - a) for a, b in ((right, top), (top, left))]
    slants_m = [exact.dot(slant, top) for slant in slants]
    return _Piece(
        place, facing, middle, along, length_m / 2, height_m / 2, tuple(slants), tuple(slants_m)
    )
