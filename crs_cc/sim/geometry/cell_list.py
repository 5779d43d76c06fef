"""Which points lie near which, without looking at all pairs: points sorted by square cells.

>>> x_m, y_m = np.array([0.0, 0.5, 9.0]), np.array([0.0, 0.5, 9.0])
>>> queries, points = CellList(x_m, y_m, reach_m=1.0).near(np.array([0.1]), np.array([0.1]))
>>> points.tolist()   # 9, 9 is far away
[0, 1]
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray

_ROUNDING: Final = 1e-9  # lets no point that is just within reach fall into a cell beyond
_AT_ONCE: Final = 256  # queries for which pairs are listed together,
_PAIRS_AT_ONCE: Final = 2_000_000  # or fewer, if they might be near to so many points
_FEW_PAIRS: Final = 1_000  # so few are not worth choosing from
_SPAN: Final = 2  # cells within reach to each side; more are smaller and hold fewer false pairs


def expand(starts: IndexArray, counts: IndexArray) -> tuple[IndexArray, IndexArray]:
    """Return the members of many ranges, one after the other.

    Returns:
        which range each member belongs to, and the member itself.

    >>> owners, members = expand(np.array([5, 0, 7]), np.array([2, 0, 3]))
    >>> owners.tolist(), members.tolist()
    ([0, 0, 2, 2, 2], [5, 6, 7, 8, 9])
    """
    owners = np.repeat(np.arange(len(counts)), counts)
    ends = np.cumsum(counts)
    members = np.arange(len(owners)) + (starts - ends + counts).take(owners)
    return owners, members


def few_pairs(queries: int, points: int) -> tuple[IndexArray, IndexArray] | None:
    """Return all pairs of query and point, None where these are many: then cells find the near ones.

    >>> few_pairs(2, 2)
    (array([0, 0, 1, 1]), array([0, 1, 0, 1]))
    """
    if queries * points > _FEW_PAIRS:
        return None
    return np.divmod(np.arange(queries * points), max(points, 1))


class CellList:
    """Points in the plane, sorted by the square cells of a grid around them.

    The grid has a margin of empty cells. There are never many more cells than points: if the points
    lie far apart, cells are larger than the reach asks for.
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
        counts = np.bincount(keys, minlength=self._side**2)
        self._ends = np.concatenate([[0], np.cumsum(counts)])

    def near(self, x_m: FloatArray, y_m: FloatArray) -> tuple[IndexArray, IndexArray]:
        """Return pairs of query and point; among them all that lie within the reach.

        Returns:
            the query and the point of each pair, by rising query.
        """
        columns, rows = self._cells(x_m, y_m)
        # Cells beyond the margin are taken for the margin's, which have nothing in them either.
        rows = rows[:, None] + np.arange(-_SPAN, _SPAN + 1)
        rows = np.minimum(np.maximum(rows, 0), self._side - 1) * self._side
        first = rows + np.maximum(columns - _SPAN, 0)[:, None]
        last = rows + np.minimum(columns + _SPAN, self._side - 1)[:, None]
        starts = self._ends.take(first.ravel())
        counts = self._ends.take(last.ravel() + 1) - starts
        owners, members = expand(starts, counts)
        return owners // rows.shape[1], self._order.take(members)

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
        """Return some of them."""
        return Discs(self.x_m[which], self.y_m[which], self.radius_m[which])

    def by_size(self) -> Iterator[IndexArray]:
        """Return the numbers of those that are about equally large, size after size."""
        sizes = np.frexp(self.radius_m)[1]
        for size in np.unique(sizes):
            yield np.flatnonzero(sizes == size)


def overlapping(discs: Discs, others: Discs) -> Iterator[tuple[IndexArray, IndexArray]]:
    """Return pairs of a disc and another one that overlap, or touch but for rounding, bit by bit.

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
