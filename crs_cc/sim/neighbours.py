"""Which points lie near which, without looking at all pairs: points sorted by square cells.

>>> x_m, y_m = np.array([0.0, 0.5, 9.0]), np.array([0.0, 0.5, 9.0])
>>> queries, points = CellList(x_m, y_m, reach_m=1.0).near(np.array([0.1]), np.array([0.1]))
>>> points.tolist()   # 9, 9 is far away
[0, 1]
"""

from __future__ import annotations

from typing import Final

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.float64]
IndexArray = npt.NDArray[np.intp]

_SPAN: Final = 2  # cells within reach to each side; more are smaller and hold fewer false pairs
_FAR_CELLS: Final = 1e8  # keeps cell numbers far from overflow, whatever the coordinates


def expand(starts: IndexArray, counts: IndexArray) -> tuple[IndexArray, IndexArray]:
    """Gives the members of many ranges, one after the other.

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


class CellList:
    """Points in the plane, sorted by the square cells of a grid.

    The number of cells costs nothing: only cells with points in them take memory.
    """

    def __init__(self, x_m: FloatArray, y_m: FloatArray, reach_m: float) -> None:
        self._cell_m = reach_m / _SPAN
        columns, rows = self._cells(x_m, y_m)
        self._column0 = int(columns.min(initial=0)) - _SPAN
        self._width = int(columns.max(initial=0)) - self._column0 + 1 + _SPAN
        keys = rows * self._width + (columns - self._column0)
        self._order = np.argsort(keys, kind="stable")
        self._keys = keys[self._order]

    def near(self, x_m: FloatArray, y_m: FloatArray) -> tuple[IndexArray, IndexArray]:
        """Gives pairs of query and point; among them all that lie within the reach.

        Returns:
            the query and the point of each pair, by rising query.
        """
        columns, rows = self._cells(x_m, y_m)
        columns = np.clip(columns - self._column0, 0, self._width - 1)
        rows = rows[:, None] + np.arange(-_SPAN, _SPAN + 1)
        first = rows * self._width + np.maximum(columns - _SPAN, 0)[:, None]
        last = rows * self._width + np.minimum(columns + _SPAN, self._width - 1)[:, None]
        starts = np.searchsorted(self._keys, first.ravel(), side="left")
        counts = np.searchsorted(self._keys, last.ravel(), side="right") - starts
        owners, members = expand(starts, counts)
        return owners // rows.shape[1], self._order.take(members)

    def _cells(self, x_m: FloatArray, y_m: FloatArray) -> tuple[IndexArray, IndexArray]:
        columns = np.clip(np.floor(x_m / self._cell_m), -_FAR_CELLS, _FAR_CELLS)
        rows = np.clip(np.floor(y_m / self._cell_m), -_FAR_CELLS, _FAR_CELLS)
        return columns.astype(np.intp), rows.astype(np.intp)
