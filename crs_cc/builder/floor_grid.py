"""The floor of a world as a grid of the places that bodies can reach.

What could just be passed counts as passable, and movable objects are ignored: where a body
cannot go by this grid, it cannot go.
"""

from __future__ import annotations

import math
from typing import Final, TypeAlias

import numpy as np
from numpy.typing import NDArray

from crs_cc.builder.extents import bounds_m
from crs_cc.core.arrays import BoolArray, FloatArray
from crs_cc.sim.geometry.placement import distance_from_m
from crs_cc.sim.model.goals import Place
from crs_cc.sim.model.world import Solid, WorldModel, is_pushable

DIAGONAL: Final = math.sqrt(0.5)
"""How far a point may be from the centre of its cell, by the size of the cell."""

Cells: TypeAlias = NDArray[np.bool_]


class FloorGrid:
    """The floor as a grid, and where bodies of each size can move on it.

    Attributes:
        cell_m: the size of its cells.
        x_m: where their centres are.
        y_m: where their centres are.
    """

    def __init__(self, world: WorldModel, cell_m: float) -> None:
        """Prepare the floor of a world."""
        area = world.area
        self.cell_m = cell_m
        self.left_m, self.bottom_m = area.x_min_m + cell_m / 2, area.y_min_m + cell_m / 2
        columns = max(1, round(area.length_m / cell_m))
        rows = max(1, round(area.width_m / cell_m))
        xs = self.left_m + cell_m * np.arange(columns)
        ys = self.bottom_m + cell_m * np.arange(rows)
        self.x_m, self.y_m = np.meshgrid(xs, ys)
        self._solids = [each for each in world.solids() if not is_pushable(each)]
        self._free: dict[float, Cells] = {}

    def around(self, x_m: float, y_m: float, radius_m: float) -> Cells:
        """Return where the centre of a round body can go from a place."""
        column, row = self._cell(x_m, y_m)
        return filled(self._room(radius_m), row, column)

    def holds(self, cells: Cells, x_m: FloatArray, y_m: FloatArray) -> BoolArray:
        """Return which points are in cells."""
        rows, columns = self.x_m.shape
        column = np.clip(np.rint((x_m - self.left_m) / self.cell_m), 0, columns - 1)
        row = np.clip(np.rint((y_m - self.bottom_m) / self.cell_m), 0, rows - 1)
        return np.asarray(cells[row.astype(np.intp), column.astype(np.intp)])

    def _room(self, radius_m: float) -> Cells:
        """Return where there is room for a body, or nearly."""
        if radius_m not in self._free:
            free = np.ones(self.x_m.shape, dtype=np.bool_)
            room_m = radius_m - self.cell_m * DIAGONAL
            for solid in self._solids:
                where = self._window(solid, room_m)
                distances_m = distance_from_m(solid, self.x_m[where], self.y_m[where])
                free[where] &= distances_m >= room_m
            self._free[radius_m] = free
        return self._free[radius_m]

    def _window(self, solid: Solid, margin_m: float) -> tuple[slice, slice]:
        """Return the part of the grid within a distance of a solid."""
        left_m, bottom_m, right_m, top_m = bounds_m(solid)
        first = self._cell(left_m - margin_m, bottom_m - margin_m)
        last = self._cell(right_m + margin_m, top_m + margin_m)
        return slice(first[1], last[1] + 1), slice(first[0], last[0] + 1)

    def _cell(self, x_m: float, y_m: float) -> tuple[int, int]:
        rows, columns = self.x_m.shape
        column = round((x_m - self.left_m) / self.cell_m)
        row = round((y_m - self.bottom_m) / self.cell_m)
        return min(max(column, 0), columns - 1), min(max(row, 0), rows - 1)

    def in_place(self, place: Place) -> Cells:
        """Return the cells that are in a place, or touch it."""
        distances_m = np.hypot(self.x_m - place.x_m, self.y_m - place.y_m)
        return np.asarray(distances_m <= place.radius_m + self.cell_m * DIAGONAL)

    def near(self, name: str, distance_m: float) -> Cells:
        """Return the cells near the surface of a fixed object, or of one of its parts."""
        reach_m = distance_m + self.cell_m * DIAGONAL
        found = np.zeros(self.x_m.shape, dtype=np.bool_)
        for solid in self._solids:
            if solid.id == name or solid.id.startswith(f"{name}."):
                where = self._window(solid, reach_m)
                distances_m = distance_from_m(solid, self.x_m[where], self.y_m[where])
                found[where] |= distances_m <= reach_m
        return found


def filled(free: Cells, row: int, column: int) -> Cells:
    """Return the cells that are connected with one of them, which itself counts as free.

    >>> filled(np.array([[True, True, False, True]]), 0, 0).tolist()
    [[True, True, False, False]]
    """
    rows, columns = free.shape
    open_cells = bytearray(free.tobytes())
    start = row * columns + column
    open_cells[start] = 0
    found = bytearray(len(open_cells))
    work = [start]
    while work:
        cell = work.pop()
        found[cell] = 1
        at = cell % columns
        near = (cell - columns, cell + columns, cell - 1 if at else -1,
                cell + 1 if at + 1 < columns else -1)  # fmt: skip
        for other in near:
            if 0 <= other < rows * columns and open_cells[other]:
                open_cells[other] = 0
                work.append(other)
    return np.frombuffer(found, dtype=np.bool_).reshape(rows, columns)


def edge_of(cells: Cells) -> Cells:
    """Return the cells that have a neighbour which is not among them.

    >>> edge_of(np.ones((3, 3), np.bool_)).astype(int).tolist()
    [[1, 1, 1], [1, 0, 1], [1, 1, 1]]
    """
    around = np.pad(cells, 1)
    inner = around[:-2, 1:-1] & around[2:, 1:-1] & around[1:-1, :-2] & around[1:-1, 2:]
    return np.asarray(cells & ~inner)
