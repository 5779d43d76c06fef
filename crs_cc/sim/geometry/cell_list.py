"""Neighbour search: near pairs of points, found with points sorted by square cells.

>>> x_m, y_m = np.array([0.0, 0.5, 9.0]), np.array([0.0, 0.5, 9.0])
>>> queries, points = CellList(x_m, y_m, reach_m=1.0).near(np.array([0.1]), np.array([0.1]))
>>> points.tolist()   # 9, 9 is far away
[0, 1]
"""

from __future__ import annotations

import functools
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray

_ROUNDING: Final = 1e-9  # keeps points that are just within reach in the cells that are searched
PAIRS_IN_BLOCK: Final = 1 << 18
"""Pairs that are computed in one block, which bounds memory; see `blocks`."""

_AT_ONCE: Final = 256  # queries whose pairs are listed in one block,
_PAIRS_AT_ONCE: Final = 2_000_000  # or fewer, if that gave more pairs than this
_FEW_PAIRS: Final = 1_000  # fewer pairs than this are not filtered: it would cost more
_SPAN: Final = 2  # cells within reach on each side; smaller cells contain fewer false pairs


def expand(starts: IndexArray, counts: IndexArray) -> tuple[IndexArray, IndexArray]:
    """Return the members of many ranges, concatenated.

    Returns:
        the range of each member, and the member.

    >>> owners, members = expand(np.array([5, 0, 7]), np.array([2, 0, 3]))
    >>> owners.tolist(), members.tolist()
    ([0, 0, 2, 2, 2], [5, 6, 7, 8, 9])
    """
    owners = np.repeat(np.arange(len(counts)), counts)
    ends = np.cumsum(counts)
    members = np.arange(len(owners)) + (starts - ends + counts).take(owners)
    return owners, members


def blocks(counts: IndexArray, most: int | None = None) -> Iterator[slice]:
    """Yield slices of consecutive queries with few enough pairs, at least one query in each.

    Args:
        counts: the number of pairs of each query.
        most: the number of pairs of one slice; by default `PAIRS_IN_BLOCK`.

    >>> [(part.start, part.stop) for part in blocks(np.array([3, 3, 9, 1]), most=6)]
    [(0, 2), (2, 3), (3, 4)]
    """
    most = PAIRS_IN_BLOCK if most is None else most
    if 0 < counts.sum() <= most:
        yield slice(0, len(counts))
        return
    ends, first = np.cumsum(counts), 0
    while first < len(counts):
        done = int(ends[first - 1]) if first else 0
        last = max(first + 1, int(np.searchsorted(ends, done + most, side="right")))
        yield slice(first, last)
        first = last


def parts(whole: slice, most: int) -> Iterator[slice]:
    """Split a slice of queries into slices of limited length.

    >>> [(part.start, part.stop) for part in parts(slice(2, 7), 4)]
    [(2, 6), (6, 7)]
    """
    for first in range(whole.start, whole.stop, most):
        yield slice(first, min(first + most, whole.stop))


def few_pairs(queries: int, points: int) -> tuple[IndexArray, IndexArray] | None:
    """Return all pairs of query and point, or None if there are too many to list them all.

    >>> few_pairs(2, 2)
    (array([0, 0, 1, 1]), array([0, 1, 0, 1]))
    """
    return _all_pairs(queries, points) if are_few(queries, points) else None


def are_few(queries: int, points: int) -> bool:
    """Return whether all pairs of query and point are few enough to be tried."""
    return queries * points <= _FEW_PAIRS


@functools.lru_cache(maxsize=64)
def _all_pairs(queries: int, points: int) -> tuple[IndexArray, IndexArray]:
    """Return all pairs of query and point, read-only."""
    pairs = np.divmod(np.arange(queries * points), max(points, 1))
    for column in pairs:
        column.setflags(write=False)
    return pairs


class CellList:
    """Points in the plane, sorted by the cells of a square grid.

    The grid has a margin of empty cells. The number of cells is bounded by the number of points:
    for distant points, cells are larger than the reach requires.
    """

    def __init__(self, x_m: FloatArray, y_m: FloatArray, reach_m: float) -> None:
        self._x_m, self._y_m = float(x_m.min(initial=0.0)), float(y_m.min(initial=0.0))
        extent_m = max(x_m.max(initial=0.0) - self._x_m, y_m.max(initial=0.0) - self._y_m)
        sparse_m = float(extent_m) / (4 * math.sqrt(len(x_m)) + 8)
        self._cell_m = max(reach_m / _SPAN, sparse_m) * (1 + _ROUNDING)
        self._side = int(extent_m / self._cell_m) + 1 + 2 * _SPAN
        columns, rows = self._cells(x_m, y_m)
        keys = rows * self._side + columns
        self._order = np.argsort(keys, kind="stable")
        counts = np.bincount(keys, minlength=self._side * self._side)
        self._ends = np.concatenate([[0], np.cumsum(counts)])

    def near(self, x_m: FloatArray, y_m: FloatArray) -> tuple[IndexArray, IndexArray]:
        """Return the query and the point of all pairs within reach, and some more, by query."""
        starts, counts = self._ranges(x_m, y_m)
        owners, members = expand(starts.ravel(), counts.ravel())
        return owners // counts.shape[1], self._order.take(members)

    def counts(self, x_m: FloatArray, y_m: FloatArray) -> IndexArray:
        """Return the number of pairs of each query."""
        return np.asarray(self._ranges(x_m, y_m)[1].sum(axis=1))

    def _ranges(self, x_m: FloatArray, y_m: FloatArray) -> tuple[IndexArray, IndexArray]:
        """Return the ranges of points in the rows of cells around queries, (k, rows)."""
        columns, rows = self._cells(x_m, y_m)
        # Queries beyond the grid are moved to its margin, whose cells are empty too.
        rows = rows[:, None] + np.arange(-_SPAN, _SPAN + 1)
        rows = np.minimum(np.maximum(rows, 0), self._side - 1) * self._side
        first = rows + np.maximum(columns - _SPAN, 0)[:, None]
        last = rows + np.minimum(columns + _SPAN, self._side - 1)[:, None]
        starts = self._ends.take(first)
        return starts, self._ends.take(last + 1) - starts

    def _cells(self, x_m: FloatArray, y_m: FloatArray) -> tuple[IndexArray, IndexArray]:
        last = self._side - 1
        columns = np.floor((x_m - self._x_m) / self._cell_m) + _SPAN
        rows = np.floor((y_m - self._y_m) / self._cell_m) + _SPAN
        columns = np.minimum(np.maximum(columns, 0), last)
        rows = np.minimum(np.maximum(rows, 0), last)
        return columns.astype(np.intp), rows.astype(np.intp)


@dataclass(frozen=True, slots=True)
class Discs:
    """Discs in the plane; each array has shape (discs,)."""

    x_m: FloatArray
    y_m: FloatArray
    radius_m: FloatArray

    def take(self, which: IndexArray) -> Discs:
        """Return a selection of the discs."""
        return Discs(self.x_m[which], self.y_m[which], self.radius_m[which])

    def by_size(self) -> Iterator[IndexArray]:
        """Yield the indices of discs of similar size, size by size."""
        sizes = np.frexp(self.radius_m)[1]
        for size in sorted(set(sizes.tolist())):
            yield np.flatnonzero(sizes == size)


def overlapping(discs: Discs, others: Discs) -> Iterator[tuple[IndexArray, IndexArray]]:
    """Yield blocks of pairs of a disc and another that overlap or touch (up to rounding).

    >>> few = Discs(np.array([0.0, 5.0]), np.zeros(2), np.array([1.0, 0.1]))
    >>> [(int(a), int(b)) for found in overlapping(few, few) for a, b in zip(*found)]
    [(1, 1), (0, 0)]
    """
    for mine in discs.by_size():
        queries = discs.take(mine)
        for theirs in others.by_size():
            points = others.take(theirs)
            reach_m = float(queries.radius_m.max() + points.radius_m.max())
            cells = CellList(points.x_m, points.y_m, reach_m)
            count = max(1, min(_AT_ONCE, _PAIRS_AT_ONCE // len(theirs)))
            for first in range(0, len(mine), count):
                part = slice(first, first + count)
                query, point = cells.near(queries.x_m[part], queries.y_m[part])
                query += first
                x_m = queries.x_m[query] - points.x_m[point]
                y_m = queries.y_m[query] - points.y_m[point]
                near_m = (queries.radius_m[query] + points.radius_m[point]) * (1 + _ROUNDING)
                near = x_m * x_m + y_m * y_m <= near_m * near_m
                yield mine[query[near]], theirs[point[near]]
