"""Kernels that find cells of pheromone fields, see `fields.c`.

Fields are described by tables with a row for each: their grids, as `geometry.field_grid` has them,
and for trails their measures, the largest amount and the amount that an integer represents.
"""

from __future__ import annotations

from typing import Final, NamedTuple, TypeAlias

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray, Int64Array
from crs_cc.sim.kernels.program import Kernels, kernels
from crs_cc.sim.kernels.tables import TRAILS

PIECES: Final = 64
"""Pieces at most that a trail in a timestep has, as in `fields.c`."""

Robots: TypeAlias = "int | IndexArray | FloatArray"
"""Robots by their rows in kernels that hold a world, (k,), or how many of the first ones, or by the
poses of their mounts, x, y [m] and heading [rad], (k, 3)."""

_TRAIL: Final = 7  # numbers of one


def antenna_cells(
    own: Kernels, grids: FloatArray, ends_m: FloatArray, robots: Robots
) -> tuple[Int64Array, Int64Array]:
    """Return the tiles at the ends of antennae, and the places in them.

    Args:
        own: the kernels.
        grids: of the fields, (fields, 7).
        ends_m: ahead and to the left of each antenna, (antennae, 2, k), or of those of all robots
            (antennae, 2, 1); NaN for none.
        robots: the robots, k of them.

    Returns:
        the tiles, and the places in them, until the next call of the kernels, (fields, antennae, k)
        each.
    """
    antennae, _, kinds = ends_m.shape
    count = robots if isinstance(robots, int) else len(robots)
    most = (own.room - grids.size - 2 * antennae) // (4 + 2 * antennae * (1 + len(grids)))
    if count <= most:
        tiles, places = _few_cells(own, grids, ends_m, robots, count)
        return tiles, places
    each = np.arange(robots) if isinstance(robots, int) else robots
    found = np.empty((2, len(grids), antennae, count), np.int64)
    for begin in range(0, count, most):
        part = slice(begin, begin + most)
        some, some_m = each[part], ends_m if kinds == 1 else ends_m[:, :, part]
        found[:, :, :, part] = _few_cells(own, grids, some_m, some, len(some))
    return found[0], found[1]


def _few_cells(
    own: Kernels, grids: FloatArray, ends_m: FloatArray, robots: Robots, count: int
) -> Int64Array:
    """Return the same of robots for which there is room, (2, fields, antennae, k)."""
    rows, numbers = None, grids.tobytes() + ends_m.tobytes()
    are_poses = not isinstance(robots, int) and robots.dtype == np.float64
    if not isinstance(robots, int):
        if are_poses:
            numbers += robots.tobytes()
        else:
            rows = robots.astype(np.intp, copy=False)
    sizes = len(grids), len(ends_m), ends_m.shape[2] == 1, are_poses
    return own.antennae(rows, count, numbers, sizes)


class Trails(NamedTuple):
    """What robots lay in a timestep, k of them.

    Attributes:
        position_m: where they are, (k, 2).
        from_m: where they were before, NaN for nowhere, (k, 2).
        moved_m: how far they drove, (k,).
        per_m: the amounts that they lay per metre, (k,).
        field: the fields, (k,).
    """

    position_m: FloatArray
    from_m: FloatArray
    moved_m: FloatArray
    per_m: FloatArray
    field: Int64Array


def trail_cells(
    grids: FloatArray, measures: FloatArray, trails: Trails
) -> tuple[Int64Array, Int64Array]:
    """Return the cells that robots lay trails in, and the integers that they lay.

    Args:
        grids: of the fields, (fields, 7).
        measures: of the fields, (fields, 2).
        trails: what is laid.

    Returns:
        the cells, and the integers, each (k,).
    """
    own, place = kernels(), grids.size + measures.size
    most = (own.room - place) // (_TRAIL + 2 * PIECES)
    cells, laid = [], []
    for begin in range(0, len(trails.field), most):
        some = [column[begin : begin + most] for column in trails]
        count = len(some[0])
        own.lay(grids.tobytes() + measures.tobytes())
        out = place
        for column in some:
            room = own.arena[out : out + column.size].view(column.dtype)
            room[:] = column.reshape(-1)
            out += column.size
        own.call(TRAILS, count, len(grids), out)
        found, number = own.arena[out:].view(np.int64), own.result
        cells.append(found[:number].copy())
        laid.append(found[PIECES * count : PIECES * count + number].copy())
    if len(cells) == 1:
        return cells[0], laid[0]
    return np.concatenate(cells), np.concatenate(laid)
