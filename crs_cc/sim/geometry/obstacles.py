"""Outlines within reach of a robot, found with a uniform grid.

Each cell of the grid lists every fixed shape within reach of any point of the cell, so that one
look-up finds all that a robot there can measure. Movable shapes are sorted again in each timestep
(`cell_list.CellList`).
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cached_property
from typing import Final

import numpy as np

from crs_cc.core import segment
from crs_cc.core.arrays import ComplexArray, FloatArray, IndexArray
from crs_cc.sim.geometry import cell_list
from crs_cc.sim.geometry.cell_list import CellList, are_few, blocks, expand, few_pairs
from crs_cc.sim.geometry.scene import Outlines
from crs_cc.sim.kernels import exact

_MAX_CELLS: Final = 128  # along each side of the grid
_CELLS_PER_REACH: Final = 8
_SHAPES_AT_ONCE: Final = 64  # while the grid is built
_MAX_LISTED: Final = 8_000_000  # limit of pairs of cell and shape; above it, cells are enlarged
_SLACK_M: Final = 1e-6


class Obstacles:
    """All outlines that beams can hit at one time.

    Points are complex numbers, x + i y [m].
    """

    def __init__(self, fixed: Outlines, moving: Outlines, reach_m: float, start_m: float) -> None:
        """Sort the fixed outlines.

        Args:
            fixed: the fixed outlines.
            moving: the movable outlines at their current poses.
            reach_m: the maximum distance from its centre at which a robot measures.
            start_m: the maximum distance from its centre at which a robot's beam starts.
        """
        circles = fixed.circles
        self._reach_m = reach_m
        self._fixed = _Places(fixed)
        self._fixed_owners = fixed.owners, fixed.segment_owners
        flat = np.zeros(len(fixed.segments))
        self._segment_grid = Grid(fixed.segments, flat, reach_m, behind_m=start_m)
        self._circle_grid = Grid(circles[:, [0, 1, 0, 1]], circles[:, 2], reach_m)
        self._moving = _Places(moving)
        self.place(moving)

    def place(self, moving: Outlines) -> None:
        """Update the movable outlines."""
        self._moving.move(moving)
        self._owners, self._segment_owners = moving.owners, moving.segment_owners
        self._segment_cells: CellList | None = None
        self._circle_cells: CellList | None = None

    def blocks(
        self, place: ComplexArray, more: IndexArray | None = None
    ) -> Iterator[tuple[slice, Obstacles]]:
        """Yield parts of the robots whose pairs are few enough, each with the outlines for it.

        Args:
            place: the robots' positions.
            more: the number of pairs of each robot besides, if any.
        """
        most = self._segment_grid.count + self._circle_grid.count
        most += len(self._moving.segment_rows) + len(self._moving.circle_rows)
        most += 0 if more is None else int(more.max(initial=0))
        if len(place) * most <= cell_list.PAIRS_IN_BLOCK:
            yield slice(0, len(place)), self
            return
        counts = self._counts(place)
        for part in blocks(counts if more is None else counts + more):
            yield part, self

    def _counts(self, place: ComplexArray) -> IndexArray:
        """Return the maximum number of pairs of each robot."""
        counts = self._segment_grid.counts(place) + self._circle_grid.counts(place)
        if len(self._moving.segment_rows):
            counts = counts + self._cells_of_segments().counts(place.real, place.imag)
        if len(self._moving.circle_rows):
            counts = counts + self._cells_of_circles().counts(place.real, place.imag)
        return np.asarray(counts)

    @property
    def count(self) -> int:
        """Return the number of all outlines."""
        return sum(len(table) for table in self.tables())

    def rows(self) -> tuple[FloatArray, FloatArray]:
        """Return all segments and all circles, as `kernels/rays.c` reads them."""
        segments, moving_segments, circles, moving_circles = self.tables()
        return np.concatenate([segments, moving_segments]), np.concatenate(
            [circles, moving_circles]
        )

    def tables(self) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
        """Return the rows of segments, fixed and moving, and those of circles, as in `rows`."""
        fixed, moving = self._fixed, self._moving
        return fixed.segment_rows, moving.segment_rows, fixed.circle_rows, moving.circle_rows

    def segments_near(
        self, place: ComplexArray
    ) -> tuple[IndexArray, ComplexArray, ComplexArray, FloatArray]:
        """Return pairs of robot and segment, including all within reach.

        Args:
            place: the robots' positions.

        Returns:
            the robots, and both ends and the length [m] of the segments.
        """
        robots, shapes = self._segment_grid.near(place)
        found = self._fixed.segments(shapes)
        if len(self._moving.segment_rows) == 0:
            return robots, *found
        others, movers = self._moving_segments(place)
        more = self._moving.segments(movers)
        start, end, length_m = (np.concatenate(pair) for pair in zip(found, more, strict=True))
        return np.concatenate([robots, others]), start, end, length_m

    def circles_near(
        self, place: ComplexArray, own: IndexArray
    ) -> tuple[IndexArray, ComplexArray, FloatArray]:
        """Return pairs of robot and circle, except its own, including all within reach.

        Args:
            place: the robots' positions.
            own: the body of each robot.

        Returns:
            the robots, and centre and radius [m] of the circles.
        """
        robots, shapes = self._circle_grid.near(place)
        others, movers = self._moving_circles(place, own)
        fixed, moving = self._fixed.circles(shapes), self._moving.circles(movers)
        middle, radius_m = (np.concatenate(pair) for pair in zip(fixed, moving, strict=True))
        return np.concatenate([robots, others]), middle, radius_m

    def segment_rows(self, place: ComplexArray) -> FloatArray:
        """Return what `segments_near` returns, with objects, as `kernels/rays.c` reads it."""
        fixed, moving, count = self._fixed.segment_rows, self._moving.segment_rows, len(place)
        if not are_few(count, len(fixed)):
            fixed = _paired(fixed, *self._segment_grid.near(place))
        if len(moving) == 0:
            return fixed
        if not are_few(count, len(moving)):
            moving = _paired(moving, *self._moving_segments(place))
        return np.concatenate([fixed, moving])

    def circle_rows(self, place: ComplexArray, own: IndexArray) -> FloatArray:
        """Return what `circles_near` returns, with objects, as `kernels/rays.c` reads it.

        Bodies of robots may be among them.
        """
        fixed, moving, count = self._fixed.circle_rows, self._moving.circle_rows, len(place)
        if not are_few(count, len(fixed)):
            fixed = _paired(fixed, *self._circle_grid.near(place))
        if not are_few(count, len(moving)):
            moving = _paired(moving, *self._moving_circles(place, own))
        return np.concatenate([fixed, moving])

    def segment_objects(self, place: ComplexArray) -> IndexArray:
        """Return the object, as in `Scene.names`, of each pair of `segments_near`."""
        _, shapes = self._segment_grid.near(place)
        _, movers = self._moving_segments(place)
        fixed, moving = self._fixed_owners[1].take(shapes), self._segment_owners.take(movers)
        return np.concatenate([fixed, moving])

    def circle_objects(self, place: ComplexArray, own: IndexArray) -> IndexArray:
        """Return the object, as in `Scene.names`, of each pair of `circles_near`."""
        _, shapes = self._circle_grid.near(place)
        _, movers = self._moving_circles(place, own)
        return np.concatenate([self._fixed_owners[0].take(shapes), self._owners.take(movers)])

    def segments_and_objects(
        self, place: ComplexArray
    ) -> tuple[tuple[IndexArray, ComplexArray, ComplexArray, FloatArray], IndexArray]:
        """Return `segments_near` and `segment_objects`."""
        return self.segments_near(place), self.segment_objects(place)

    def circles_and_objects(
        self, place: ComplexArray, own: IndexArray
    ) -> tuple[tuple[IndexArray, ComplexArray, FloatArray], IndexArray]:
        """Return `circles_near` and `circle_objects`."""
        return self.circles_near(place, own), self.circle_objects(place, own)

    def _moving_segments(self, place: ComplexArray) -> tuple[IndexArray, IndexArray]:
        moving = self._moving
        if pairs := few_pairs(len(place), len(moving.segment_rows)):
            return pairs
        return self._cells_of_segments().near(place.real, place.imag)

    def _cells_of_segments(self) -> CellList:
        moving = self._moving
        if self._segment_cells is None:
            middle = (moving.start + moving.end) / 2
            reach_m = self._reach_m + float(moving.length_m.max()) / 2
            self._segment_cells = CellList(middle.real, middle.imag, reach_m)
        return self._segment_cells

    def _cells_of_circles(self) -> CellList:
        moving = self._moving
        if self._circle_cells is None:
            reach_m = self._reach_m + float(moving.radius_m.max())
            self._circle_cells = CellList(moving.middle.real, moving.middle.imag, reach_m)
        return self._circle_cells

    def _moving_circles(
        self, place: ComplexArray, own: IndexArray
    ) -> tuple[IndexArray, IndexArray]:
        moving = self._moving
        if pairs := few_pairs(len(place), len(moving.circle_rows)):
            others, movers = pairs
        else:
            others, movers = self._cells_of_circles().near(place.real, place.imag)
        middle, radius_m = moving.circles(movers)
        away = middle - place.take(others)
        within = exact.dot(away, away) <= np.square(radius_m + self._reach_m)
        within &= self._owners.take(movers) != own.take(others)
        near = np.flatnonzero(within)
        return others.take(near), movers.take(near)


_DERIVED: Final = "start", "end", "length_m", "middle", "radius_m"


class _Places:
    """Outlines as rows for kernels, and with points as complex numbers.

    Attributes:
        segment_rows: -1, object, x and y of both ends and length [m] of each segment.
        circle_rows: -1, object, x, y and radius [m] of each circle.
    """

    def __init__(self, outlines: Outlines) -> None:
        segments, circles = outlines.segments, outlines.circles
        self._segments = segments
        self.segment_rows = np.empty((len(segments), 7))
        self.segment_rows[:, 0], self.segment_rows[:, 1] = -1.0, outlines.segment_owners
        self.segment_rows[:, 2:] = segments
        self.circle_rows = np.empty((len(circles), 5))
        self.circle_rows[:, 0], self.circle_rows[:, 1] = -1.0, outlines.owners
        self.circle_rows[:, 2:] = circles

    def move(self, outlines: Outlines) -> None:
        """Update the places of the same outlines."""
        if outlines.segments is not self._segments:
            self._segments = outlines.segments
            self.segment_rows[:, 2:] = outlines.segments
        self.circle_rows[:, 2:] = outlines.circles
        for name in _DERIVED:
            self.__dict__.pop(name, None)

    @cached_property
    def start(self) -> ComplexArray:
        """The start of each segment."""
        return self.segment_rows[:, 2] + 1j * self.segment_rows[:, 3]

    @cached_property
    def end(self) -> ComplexArray:
        """The end of each segment."""
        return self.segment_rows[:, 4] + 1j * self.segment_rows[:, 5]

    @cached_property
    def length_m(self) -> FloatArray:
        """The length of each segment."""
        return self.segment_rows[:, 6].copy()

    @cached_property
    def middle(self) -> ComplexArray:
        """The centre of each circle."""
        return self.circle_rows[:, 2] + 1j * self.circle_rows[:, 3]

    @cached_property
    def radius_m(self) -> FloatArray:
        """The radius of each circle."""
        return self.circle_rows[:, 4].copy()

    def segments(self, which: IndexArray) -> tuple[ComplexArray, ComplexArray, FloatArray]:
        return self.start.take(which), self.end.take(which), self.length_m.take(which)

    def circles(self, which: IndexArray) -> tuple[ComplexArray, FloatArray]:
        return self.middle.take(which), self.radius_m.take(which)


def _paired(rows: FloatArray, viewers: IndexArray, shapes: IndexArray) -> FloatArray:
    """Return the rows of shapes, each with its viewer."""
    found = rows.take(shapes, axis=0)
    found[:, 0] = viewers
    return found


class Grid:
    """Fixed shapes, listed by the cells from which they are within reach.

    A shape is the set of points within a radius of a line segment. If `behind_m` is given, shapes
    are omitted for points further than that to the left of their segment. The list is made when it
    is first needed: where robots and shapes are few, that is never.

    Attributes:
        count: the number of shapes.
    """

    def __init__(
        self,
        ends_m: FloatArray,
        radius_m: FloatArray,
        reach_m: float,
        behind_m: float = math.inf,
    ) -> None:
        self.count = len(ends_m)
        self._shapes = ends_m, radius_m, reach_m, behind_m

    @cached_property
    def _list(self) -> _ListByCell:
        return _ListByCell(*self._shapes)

    def near(self, place: ComplexArray) -> tuple[IndexArray, IndexArray]:
        """Return pairs of point and shape, including all within reach."""
        return few_pairs(len(place), self.count) or self._list.near(place)

    def counts(self, place: ComplexArray) -> IndexArray:
        """Return the number of shapes within reach of the cell of each point."""
        return self._list.counts(place)


class _ListByCell:
    """The list of a `Grid`."""

    def __init__(
        self, ends_m: FloatArray, radius_m: FloatArray, reach_m: float, behind_m: float
    ) -> None:
        count = len(ends_m)
        self._behind_m = behind_m
        around_m = (radius_m + reach_m + _SLACK_M)[:, None]
        low = np.minimum(ends_m[:, 0:2], ends_m[:, 2:4]) - around_m
        high = np.maximum(ends_m[:, 0:2], ends_m[:, 2:4]) + around_m
        self._corner_m = low.min(axis=0, initial=np.inf) if count else np.zeros(2)
        extent_m = high.max(axis=0) - self._corner_m if count else np.zeros(2)
        self._cell_m = max(reach_m / _CELLS_PER_REACH, float(extent_m.max()) / _MAX_CELLS, 1e-3)
        while self._listed(low, high) > _MAX_LISTED and self._cell_m < extent_m.max():
            self._cell_m *= 2
        self._size = np.floor(extent_m / self._cell_m).astype(np.intp) + 1
        found = [
            self._cells_of(np.arange(first, min(first + _SHAPES_AT_ONCE, count)), ends_m,
                           around_m, low, high)
            for first in range(0, count, _SHAPES_AT_ONCE)
        ]  # fmt: skip
        nothing = np.zeros(0, dtype=np.intp)
        cells = np.concatenate([nothing, *(cells for cells, _ in found)])
        shapes = np.concatenate([nothing, *(shapes for _, shapes in found)])
        self._shapes = shapes[np.argsort(cells, kind="stable")]
        # One more cell represents all points outside of the grid.
        self._counts = np.bincount(cells, minlength=int(self._size.prod()) + 1)
        self._starts = np.cumsum(self._counts) - self._counts

    def near(self, place: ComplexArray) -> tuple[IndexArray, IndexArray]:
        cell = self._cell(place)
        points, members = expand(self._starts.take(cell), self._counts.take(cell))
        return points, self._shapes.take(members)

    def counts(self, place: ComplexArray) -> IndexArray:
        return np.asarray(self._counts.take(self._cell(place)))

    def _cell(self, place: ComplexArray) -> IndexArray:
        """Return the cell of each point; that after the last one is outside of the grid."""
        column = np.floor((place.real - self._corner_m[0]) / self._cell_m)
        row = np.floor((place.imag - self._corner_m[1]) / self._cell_m)
        columns, rows = self._size
        inside = (column >= 0) & (column < columns) & (row >= 0) & (row < rows)
        cell = np.where(inside, row * columns + column, columns * rows)
        return np.asarray(cell, dtype=np.intp)

    def _listed(self, low: FloatArray, high: FloatArray) -> int:
        """Return an upper bound of the number of pairs of cell and shape."""
        first, last = (np.floor((ends - self._corner_m) / self._cell_m) for ends in (low, high))
        return int((last - first + 1.0).prod(axis=1).sum())

    def _cells_of(
        self,
        shapes: IndexArray,
        ends_m: FloatArray,
        around_m: FloatArray,
        low: FloatArray,
        high: FloatArray,
    ) -> tuple[IndexArray, IndexArray]:
        """Return the cells from which shapes are within reach, in pairs with the shapes."""
        first = ((low[shapes] - self._corner_m) / self._cell_m).astype(np.intp)
        last = np.minimum(((high[shapes] - self._corner_m) / self._cell_m), self._size - 1)
        span = last.astype(np.intp) - first + 1
        owner, number = expand(np.zeros(len(shapes), dtype=np.intp), span.prod(axis=1))
        column = first[owner, 0] + number % span[owner, 0]
        row = first[owner, 1] + number // span[owner, 0]
        x = self._corner_m[0] + (column + 0.5) * self._cell_m
        y = self._corner_m[1] + (row + 0.5) * self._cell_m
        corner_m = self._cell_m * math.sqrt(0.5)
        distance_m, left_m = _to_segments(x, y, ends_m[shapes[owner]])
        near = distance_m <= around_m[shapes[owner], 0] + corner_m
        near &= left_m <= self._behind_m + corner_m
        return (row * self._size[0] + column)[near], shapes[owner[near]]


def _to_segments(x: FloatArray, y: FloatArray, ends: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the distances from points to segments, and their offsets to the left of the lines."""
    across_x, across_y = x - ends[:, 0], y - ends[:, 1]
    along_x, along_y = ends[:, 2] - ends[:, 0], ends[:, 3] - ends[:, 1]
    length = exact.hypot(along_x, along_y)
    length[length == 0.0] = 1.0
    left = (along_x * across_y - along_y * across_x) / length
    return segment.distance(across_x, across_y, along_x, along_y), left
