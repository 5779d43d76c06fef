"""Shapes in the memory of kernels, sorted by grid cell.

>>> grid = grid_of(np.array([[0.0, 0.0], [9.0, 4.0]]), 2.0)
>>> [float(number) for number in grid]
[0.0, 0.0, 2.0, 5.0, 3.0]
>>> drum = np.zeros((0, 7)), np.array([[-1.0, 0.0, 3.0, 1.0, 0.5]]), np.zeros((0, 14))
>>> sort_shapes(Kernels(is_arena=True), 0, drum, grid)
24
"""

from __future__ import annotations

import math
import struct
from typing import Final, TypeAlias

import numpy as np

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.kernels.program import Kernels
from crs_cc.sim.kernels.tables import SORT

Tables: TypeAlias = tuple[FloatArray, FloatArray, FloatArray]
"""Rows of segments, circles and pieces, see `beams.h`."""

Grid: TypeAlias = tuple[float, ...]
"""x and y of its corner, the size of its cells [m], the numbers of its columns and rows."""

_MAX_CELLS: Final = 128  # along each side of a grid, see `survey.c`
_HEAD: Final = struct.Struct("<9d")


def grid_of(points_m: FloatArray, cell_m: float, most: int = _MAX_CELLS * _MAX_CELLS) -> Grid:
    """Return a grid over points.

    Args:
        points_m: the points, (k, 2).
        cell_m: the least size of its cells.
        most: about how many cells it may have.
    """
    if not len(points_m):
        return 0.0, 0.0, cell_m, 1.0, 1.0
    left_m, low_m = np.minimum.reduce(points_m).tolist()
    right_m, high_m = np.maximum.reduce(points_m).tolist()
    wide_m, tall_m = right_m - left_m, high_m - low_m
    size_m = max(cell_m, max(wide_m, tall_m) / _MAX_CELLS, math.sqrt(wide_m * tall_m / most))
    return left_m, low_m, size_m, wide_m // size_m + 1.0, tall_m // size_m + 1.0


def sort_shapes(
    kernels: Kernels, place: int, tables: Tables, grid: Grid, around_m: float = 0.0
) -> int:
    """Lay shapes into the arena, from a place on, and sort them.

    Return how many numbers they take, with the lists of the cells; 0 if they have no room. A cell
    lists the shapes that are `around_m` or less from a point of it, and some more.
    """
    counts = tuple(map(len, tables))
    content = b"".join(
        [_HEAD.pack(*counts, *grid, around_m), *[table.tobytes() for table in tables]]
    )
    cells, room = int(grid[-1] * grid[-2]), kernels.room - place
    if (len(content) + 4 * (cells + 1 + sum(counts))) // 8 >= room:
        return 0
    kernels.lay(content, place)
    kernels.call(SORT, place, room)
    return kernels.result
