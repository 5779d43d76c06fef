"""Which sensors lie in or on a box or wall: those have nothing to measure but 0.

A robot that runs into something overlaps it by a hair, and then a sensor on its shell lies behind
the side that it touches. Beams are tried against sides (`rays`), so that one would pass on to the
far side; circles need no such care, as `rays` knows what is inside them. The boxes, and the walls
without their round ends, are rectangles, and a place is in one if it is so along both its axes.

Places in the plane are complex numbers, x + i y [m]: to turn is to multiply.

>>> from crs_cc.sim.model import Area, Box, Pose, WorldModel
>>> world = WorldModel("w", Area(0, 0, 9, 9, 0), boxes=(Box("b", Pose(3, 1), 2, 1),))
>>> fan = Fan.of([(0.2, 0.0, 0.0, 0.0, 5.0), (-0.2, 0.0, math.pi, 0.0, 5.0)])
>>> Rectangles(Scene(world), fan.start_m).cover(fan, np.array([[1.801, 1.0, 0.0]]))
array([[ True, False]])
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np
import numpy.typing as npt

from crs_cc.sim.model import Box, Wall
from crs_cc.sim.neighbours import CellList
from crs_cc.sim.obstacles import Grid
from crs_cc.sim.rays import Fan
from crs_cc.sim.scene import Scene

FloatArray = npt.NDArray[np.float64]
BoolArray = npt.NDArray[np.bool_]
ComplexArray = npt.NDArray[np.complex128]
IndexArray = npt.NDArray[np.intp]

_ON_M: Final = 1e-9  # rounding must not let a sensor on a side be outside here, inside for `rays`
_FEW_PAIRS: Final = 1_000  # robots times rectangles; so few are not worth choosing from


class Rectangles:
    """All boxes and walls of a world: first those that do not move, then those that do."""

    def __init__(self, scene: Scene, start_m: float) -> None:
        """Sorts what does not move, and takes what does for where it starts.

        Args:
            scene: what there is.
            start_m: how far from its robot's place any sensor sits.
        """
        fixed = [_rectangle(solid) for solid in scene.fixed_solids if isinstance(solid, Box | Wall)]
        bodies = list(enumerate(scene.pushables, scene.robots))
        moving = [(body, _rectangle(solid)) for body, solid in bodies if isinstance(solid, Box)]
        table = np.array([*fixed, *(row for _, row in moving)]).reshape(-1, 5)
        self._middle = table[:, 0] + 1j * table[:, 1]
        self._along = np.exp(1j * table[:, 2])
        self._half_length_m, self._half_width_m = table[:, 3].copy(), table[:, 4].copy()
        self._fixed = len(fixed)
        self._bodies = np.array([body for body, _ in moving], dtype=np.intp)
        self._start_m = start_m + _ON_M
        self._grid = self._grid_of_fixed()
        half_m = np.hypot(self._half_length_m[self._fixed :], self._half_width_m[self._fixed :])
        self._reach_m = self._start_m + float(half_m.max(initial=0.0))
        self._cells: CellList | None = None

    def place(self, position_m: FloatArray, angle_rad: FloatArray) -> None:
        """Says where the bodies that move are now: as for `Scene.moving`."""
        x_m, y_m = position_m[self._bodies].T
        self._middle[self._fixed :] = x_m + 1j * y_m
        self._along[self._fixed :] = np.exp(1j * angle_rad[self._bodies])
        self._cells = None

    def cover(self, fan: Fan, poses: FloatArray) -> BoolArray:
        """Tells which beams of each robot start in or on a rectangle.

        Args:
            fan: the robots' beams.
            poses: x, y [m] and heading [rad] of each robot, shape (k, 3).

        Returns:
            shape (k, beams), in the order of the list that the fan was made of.
        """
        covered = np.zeros((len(poses), len(fan)), dtype=np.bool_)
        place = poses[:, 0] + 1j * poses[:, 1]
        robots, shapes = self._near(place)
        # As seen from the rectangle: its middle is 0, x runs along it.
        backturn = np.conjugate(self._along.take(shapes))
        local = (place.take(robots) - self._middle.take(shapes)) * backturn
        close = np.flatnonzero(self._within(local, shapes, self._start_m))
        if not len(close):
            return covered
        robots, shapes = robots.take(close), shapes.take(close)
        facing = np.exp(1j * poses[robots, 2]) * backturn.take(close)
        starts = local.take(close)[:, None] + facing[:, None] * fan.start
        pairs, beams = np.nonzero(self._within(starts, shapes[:, None], _ON_M))
        covered[robots.take(pairs), fan.order.take(beams)] = True
        return covered

    def _within(self, local: ComplexArray, shapes: IndexArray, margin_m: float) -> BoolArray:
        along = np.abs(local.real) <= self._half_length_m.take(shapes) + margin_m
        across = np.abs(local.imag) <= self._half_width_m.take(shapes) + margin_m
        return np.asarray(along & across)

    def _near(self, place: ComplexArray) -> tuple[IndexArray, IndexArray]:
        """Gives pairs of robot and rectangle; among them all that a sensor can lie in."""
        robots, shapes = self._grid.near(place)
        count = len(self._bodies)
        if count == 0:
            return robots, shapes
        if len(place) * count <= _FEW_PAIRS:
            others, movers = np.divmod(np.arange(len(place) * count), count)
        else:
            if self._cells is None:
                middle = self._middle[self._fixed :]
                self._cells = CellList(middle.real, middle.imag, self._reach_m)
            others, movers = self._cells.near(place.real, place.imag)
        return np.concatenate([robots, others]), np.concatenate([shapes, movers + self._fixed])

    def _grid_of_fixed(self) -> Grid:
        half_width_m = self._half_width_m[: self._fixed]
        middle = self._middle[: self._fixed]
        half = self._along[: self._fixed] * self._half_length_m[: self._fixed]
        start, end = middle - half, middle + half
        ends_m = np.column_stack([start.real, start.imag, end.real, end.imag])
        return Grid(ends_m, half_width_m, self._start_m)


def _rectangle(solid: Box | Wall) -> tuple[float, float, float, float, float]:
    """Gives x, y, direction, half the length along it, and half the width."""
    if isinstance(solid, Box):
        pose = solid.pose
        return pose.x_m, pose.y_m, pose.heading_rad, solid.length_m / 2, solid.width_m / 2
    x_m, y_m = solid.x2_m - solid.x1_m, solid.y2_m - solid.y1_m
    middle_x_m, middle_y_m = (solid.x1_m + solid.x2_m) / 2, (solid.y1_m + solid.y2_m) / 2
    half_m = math.hypot(x_m, y_m) / 2
    return middle_x_m, middle_y_m, math.atan2(y_m, x_m), half_m, solid.thickness_m / 2
