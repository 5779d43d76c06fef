"""Shapes in the memory of kernels, sorted by grid cell.

>>> grid = grid_of(np.array([[0.0, 0.0], [9.0, 4.0]]), 2.0)
>>> [float(number) for number in grid]
[0.0, 0.0, 2.0, 5.0, 3.0]
>>> drum = np.zeros((0, 7)), np.array([[-1.0, 0.0, 3.0, 1.0, 0.5]]), np.zeros((0, 14))
>>> sort_shapes(Kernels(is_arena=True), 0, drum, grid)
23
"""

from __future__ import annotations

from typing import Final, TypeAlias

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.kernels.program import Kernels
from crs_cc.sim.kernels.tables import SORT

Tables: TypeAlias = tuple[FloatArray, FloatArray, FloatArray]
"""Rows of segments, circles and pieces, see `beams.h`."""

Grid: TypeAlias = tuple[float, ...]
"""x and y of its corner, the size of its cells [m], the numbers of its columns and rows."""

_MOST_CELLS: Final = 128  # along each side of a grid


def grid_of(points_m: FloatArray, cell_m: float) -> Grid:
    """Return a grid over points, with cells of at least a size."""
    corner_m = points_m.min(axis=0) if len(points_m) else np.zeros(2)
    extent_m = points_m.max(axis=0) - corner_m if len(points_m) else np.zeros(2)
    cell_m = max(cell_m, float(extent_m.max()) / _MOST_CELLS)
    size = np.floor(extent_m / cell_m) + 1.0
    return *corner_m, cell_m, *size


def sort_shapes(kernels: Kernels, place: int, tables: Tables, grid: Grid) -> int:
    """Lay shapes into the arena, from a place on, and sort them.

    Return how many numbers they take, with the lists of the cells; 0 if they have no room.
    """
    head = np.array([*map(len, tables), *grid])
    content = b"".join([head.tobytes(), *(table.tobytes() for table in tables)])
    cells, room = int(grid[-1] * grid[-2]), kernels.room - place
    if (len(content) + 4 * (cells + 1 + sum(map(len, tables)))) // 8 >= room:
        return 0
    kernels.lay(content, place)
    kernels.call(SORT, place, room)
    return kernels.result
