"""The cells of a world's pheromone fields, and the tiles that they are stored in.

A tile has 8 by 8 cells. Tiles are numbered through all fields, row by row from the lower left
corner of the area; the number of a cell is 64 times that of its tile, plus its place in the tile.

>>> from crs_cc.sim.model.fields import Field
>>> from crs_cc.sim.model.world import Area
>>> grid = FieldGrid(Area(0.0, 0.0, 2.0, 1.0), (Field("a", cell_m=0.1), Field("b", cell_m=0.1)))
>>> x_m, y_m = np.array([0.05, 0.15, 0.85, 0.05, 2.0]), np.array([0.05, 0.15, 0.05, 0.85, 0.0])
>>> grid.cells(np.array([0]), x_m, y_m).tolist(), grid.cells(np.array([1]), x_m, y_m)[:1].tolist()
([0, 9, 64, 192, -1], [384])
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int64Array, all_of
from crs_cc.sim.model.fields import Field
from crs_cc.sim.model.world import Area

SIDE: Final = 8
TILE: Final = SIDE * SIDE
"""Cells of a tile."""

NOWHERE: Final = -1
"""The cell of a place outside of the area, and the tile there."""

_PLACES: Final = np.arange(SIDE)


class FieldGrid:
    """The cells of all fields; arrays have a row for each field.

    Attributes:
        cell_m: side of a cell.
        columns: number of cells along x.
        rows: number of cells along y.
        first_tile: number of the first tile; after the last field, the number of all tiles.
        table: all of this as kernels read it, see `kernels.field_cells`, (fields, 7).
    """

    def __init__(self, area: Area, fields: Sequence[Field]) -> None:
        self._corner_m = area.x_min_m, area.y_min_m
        self.cell_m = np.array([field.cell_m for field in fields])
        self.columns = np.ceil(area.length_m / self.cell_m).astype(np.int64)
        self.rows = np.ceil(area.width_m / self.cell_m).astype(np.int64)
        self._across: Int64Array = -(-self.columns // SIDE)  # tiles in a row of tiles
        self._up: Int64Array = -(-self.rows // SIDE)
        self.first_tile = np.concatenate([[0], np.cumsum(self._across * self._up)])
        self.table = np.empty((len(fields), 7))
        self.table[:, :2], self.table[:, 2] = self._corner_m, self.cell_m
        self.table[:, 3], self.table[:, 4] = self.columns, self.rows
        self.table[:, 5], self.table[:, 6] = self._across, self.first_tile[:-1]

    @property
    def tiles(self) -> int:
        """The number of all tiles."""
        return int(self.first_tile[-1])

    def cells(self, field: IndexArray | int, x_m: FloatArray, y_m: FloatArray) -> Int64Array:
        """Return the cells that places are in, `NOWHERE` outside of the area.

        Args:
            field: the fields, or one for all; the arrays broadcast.
            x_m: the places, world frame.
            y_m: the same.
        """
        cell_m = self.cell_m[field]
        across = (x_m - self._corner_m[0]) / cell_m
        up = (y_m - self._corner_m[1]) / cell_m
        inside = (across >= 0) & (across < self.columns[field])
        inside &= (up >= 0) & (up < self.rows[field])
        are_inside = all_of(inside)
        if not are_inside:
            across, up = np.where(inside, across, 0), np.where(inside, up, 0)
        column, row = across.astype(np.int64), up.astype(np.int64)
        # As tile * TILE + row % SIDE * SIDE + column % SIDE, in fewer passes.
        cell = (column // SIDE) * (TILE - SIDE) + column
        cell += (row // SIDE) * ((self._across[field] - 1) * TILE) + row * SIDE
        cell += self.first_tile[field] * TILE
        return cell if are_inside else np.where(inside, cell, NOWHERE)

    def field(self, cells: Int64Array) -> IndexArray | int:
        """Return the fields of cells, or the only one."""
        if len(self.cell_m) == 1:
            return 0
        return np.searchsorted(self.first_tile, cells // TILE, side="right") - 1

    def place(self, field: int, tiles: Int64Array) -> tuple[Int64Array, Int64Array]:
        """Return row and column of the lower left cells of tiles, each (tiles,)."""
        up, across = np.divmod(tiles - self.first_tile[field], self._across[field])
        return up * SIDE, across * SIDE

    def exist(self, field: int, tiles: Int64Array) -> BoolArray:
        """Return which cells of tiles are in the area: the last ones may not be, (tiles, 8, 8)."""
        row, column = self.place(field, tiles)
        rows = row[:, None] + _PLACES < self.rows[field]
        columns = column[:, None] + _PLACES < self.columns[field]
        return np.asarray(rows[:, :, None] & columns[:, None, :])

    def right(self, field: int, tiles: Int64Array) -> Int64Array:
        """Return the tiles to the right of tiles, `NOWHERE` at the edge."""
        _, column = self.place(field, tiles)
        return np.where(column // SIDE + 1 < self._across[field], tiles + 1, NOWHERE)

    def left(self, field: int, tiles: Int64Array) -> Int64Array:
        """Return the tiles to the left of tiles."""
        _, column = self.place(field, tiles)
        return np.where(column > 0, tiles - 1, NOWHERE)

    def above(self, field: int, tiles: Int64Array) -> Int64Array:
        """Return the tiles above tiles."""
        row, _ = self.place(field, tiles)
        return np.where(row // SIDE + 1 < self._up[field], tiles + self._across[field], NOWHERE)

    def below(self, field: int, tiles: Int64Array) -> Int64Array:
        """Return the tiles below tiles."""
        row, _ = self.place(field, tiles)
        return np.where(row > 0, tiles - self._across[field], NOWHERE)
