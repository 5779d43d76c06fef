"""Objects between the ends of lines, among shapes sorted by grid cell in the memory of kernels.

>>> wall = np.array([[-1.0, 5.0, 2.0, 4.0, 2.0, 0.0, 4.0]])  # a face that lines to the right enter
>>> field = SightField(wall, np.zeros((0, 5)))
>>> lines = np.array([[0.0, 1.0], [0.0, 1.0]]), np.array([[3.0, 1.0], [1.0, 1.0]])
>>> field.count(lines, np.full(2, MANY)).tolist()
[1, 0]
"""

from __future__ import annotations

from typing import Final, TypeAlias

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray, Int32Array
from crs_cc.sim.kernels.program import Kernels
from crs_cc.sim.kernels.sorted_shapes import grid_of, sort_shapes
from crs_cc.sim.kernels.tables import SIGHT

PIECE_M: Final = 2.0
"""The length at most of the pieces that lines are cut into, as in `sight.c`."""
MANY: Final = np.int32(2**31 - 1)
"""More objects than there are."""

_LINES: Final = 45_000  # whose ends and counts are in the memory at once
_WORK: Final = 5 * _LINES + 75_000  # numbers of the arena for them, and to sweep them
_AROUND_M: Final = PIECE_M / 2 + 1e-6  # what a piece meets is so near to its middle
_CELL_M: Final = 1.0
_OBJECT: Final = 1  # the column of a row
_NO_PIECES: Final = np.zeros((0, 14))


Lines: TypeAlias = tuple[FloatArray, FloatArray]


class SightField:
    """Shapes of objects that stay, and of others that move."""

    def __init__(self, segments: FloatArray, circles: FloatArray) -> None:
        """Take the shapes that stay.

        Args:
            segments: rows of segments, see `beams.h`; their robots are of no account.
            circles: rows of circles.
        """
        self._kernels = Kernels(is_arena=True)
        self._fixed = segments, circles
        self._end = 0  # where they end in the memory, if they lie there

    def count(
        self,
        lines: Lines,
        enough: Int32Array,
        moving: tuple[FloatArray, FloatArray] | None = None,
    ) -> IndexArray:
        """Return the number of objects between the ends of each line, shape (k,).

        Args:
            lines: x and y of their starts and of their ends [m], (k, 2) each.
            enough: how many are enough: of more, not all need be counted, (k,).
            moving: rows of segments and circles of objects that move, if any.
        """
        if not self._end:
            self._end = self._lay(*self._fixed, _WORK)
        if self._end:
            counts = self._count(_WORK, lines, enough)
        else:
            counts = self._divided(*self._fixed, lines, enough)
        if moving and (len(moving[0]) or len(moving[1])):
            if self._end and self._lay(*moving, self._end):
                counts += self._count(self._end, lines, enough)
            else:
                counts += self._divided(*moving, lines, enough)
        return counts

    def _lay(self, segments: FloatArray, circles: FloatArray, place: int) -> int:
        """Lay shapes into the memory, from a place on; return where they end, 0 for no room."""
        objects = np.concatenate([segments[:, _OBJECT], circles[:, _OBJECT]])
        _, number = np.unique(objects, return_inverse=True)
        segments, circles = segments.copy(), circles.copy()
        segments[:, _OBJECT], circles[:, _OBJECT] = np.split(number, [len(segments)])
        points = np.concatenate([segments[:, 2:4], segments[:, 4:6], circles[:, 2:4]])
        tables = segments, circles, _NO_PIECES
        size = sort_shapes(self._kernels, place, tables, grid_of(points, _CELL_M), _AROUND_M)
        return place + size if size else 0

    def _count(self, place: int, lines: Lines, enough: Int32Array) -> IndexArray:
        """Return the number of objects that each line meets, of those at an address."""
        found, arena = np.empty(len(enough), dtype=np.intp), self._kernels.arena
        for first in range(0, len(enough), _LINES):
            part = slice(first, first + _LINES)
            count = len(enough[part])
            ends_m, counts = (
                arena[: 4 * count].reshape(-1, 4),
                arena[4 * count :].view(np.int32),
            )
            ends_m[:, :2], ends_m[:, 2:] = lines[0][part], lines[1][part]
            counts[:count] = enough[part]
            self._kernels.call(SIGHT, count, place, 4 * count)
            found[part] = counts[:count]
        return found

    def _divided(
        self, segments: FloatArray, circles: FloatArray, lines: Lines, enough: Int32Array
    ) -> IndexArray:
        """Return the number of objects that each line meets, of more than fit at once."""
        self._end = 0
        if self._lay(segments, circles, _WORK):
            return self._count(_WORK, lines, enough)
        owners = np.unique(np.concatenate([segments[:, _OBJECT], circles[:, _OBJECT]]))
        if len(owners) > 1:
            middle = owners[len(owners) // 2]
            parts = [table[:, _OBJECT] < middle for table in (segments, circles)]
        else:
            parts = [np.arange(len(table)) < len(table) // 2 for table in (segments, circles)]
        few = self._divided(segments[parts[0]], circles[parts[1]], lines, enough)
        more = self._divided(segments[~parts[0]], circles[~parts[1]], lines, enough)
        return few + more if len(owners) > 1 else np.maximum(few, more)
