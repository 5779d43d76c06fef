"""The free space around discs, among shapes sorted by grid cell in the memory of kernels.

>>> field = RoomField(np.array([[0.0, 0.0, 9.0, 0.0]]), np.zeros(1), look_m=2.0)
>>> discs = np.array([[1.0, 1.0, 0.25], [2.0, 1.0, 0.25], [8.0, 5.0, 0.25]])
>>> [found.tolist() for found in field.measure(discs, np.array([0, 2]), need_m=1.0)]
[[0.5, 2.0], [0]]
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.sim.kernels.program import Kernels
from crs_cc.sim.kernels.sorted_shapes import grid_of, sort_shapes
from crs_cc.sim.kernels.tables import ROOM

_WORK: Final = 400_000  # numbers of the arena for discs and what is found
_MOST: Final = 40_000
"""Discs, or shapes, that are in the memory at once."""
_NONE: Final = np.zeros((0, 7)), np.zeros((0, 5)), np.zeros((0, 14))


class RoomField:
    """Shapes that stay: the sets of points within a radius of line segments."""

    def __init__(self, ends_m: FloatArray, thick_m: FloatArray, look_m: float) -> None:
        """Sort them.

        Args:
            ends_m: the ends of the segments, (s, 4).
            thick_m: the radii, (s,).
            look_m: the most room that is of interest.
        """
        self._kernels, self._look_m = Kernels(is_arena=True), look_m
        self._thickest_m = float(thick_m.max(initial=0.0))
        self._rows = np.column_stack([np.zeros((len(ends_m), 2)), ends_m, thick_m])
        self._cell_m = look_m + self._thickest_m
        self._grid = grid_of(np.concatenate([ends_m[:, :2], ends_m[:, 2:]]), self._cell_m)
        self._laid, self._end = slice(0), _WORK  # which of them lie in the memory, up to where
        self._blocks = [*self._divided(slice(0, len(ends_m)))] if len(ends_m) else []

    def measure(
        self, discs: FloatArray, which: IndexArray, need_m: float
    ) -> tuple[FloatArray, IndexArray]:
        """Measure the room that some discs have to others, and to the shapes.

        Args:
            discs: x, y and radius of all [m], (n, 3).
            which: those to measure for, (k,).
            need_m: less room than this is near; at most what is of interest.

        Returns:
            the room of each, at most what is of interest, (k,), and the shapes that are near any.
        """
        cell_m = max(self._cell_m, 2 * float(discs[:, 2].max(initial=0.0)))
        asked = np.column_stack([discs[which], which])
        room_m, near = np.full(len(which), self._look_m), [np.zeros(0, np.intp)]
        for block in self._blocks:
            if block != self._laid:
                self._lay(block)
            found = self._ask(asked, room_m, need_m, _WORK, block.stop - block.start)
            near.append(block.start + found)
        for first in range(0, len(discs), _MOST):
            some = discs[first : first + _MOST]
            numbers = np.arange(first, first + len(some))
            circles = np.column_stack([np.zeros(len(some)), numbers, some])
            grid = grid_of(some[:, :2], cell_m)
            sort_shapes(self._kernels, self._end, (_NONE[0], circles, _NONE[2]), grid)
            self._ask(asked, room_m, need_m, self._end, 0)
        return room_m, np.concatenate(near)

    def _ask(
        self, asked: FloatArray, room_m: FloatArray, need_m: float, place: int, segments: int
    ) -> IndexArray:
        """Reduce the room of discs by shapes at a place; return which segments are near."""
        near = np.zeros(segments, dtype=np.bool_)
        for first in range(0, len(asked), _MOST):
            some, room = asked[first : first + _MOST], room_m[first : first + _MOST]
            question = np.array([self._look_m, need_m, self._thickest_m])
            self._kernels.lay(question.tobytes() + some.tobytes() + room.tobytes())
            out = len(question) + some.size
            marks = out + len(room)
            self._kernels.call(ROOM, len(some), out, marks, place)
            room[:] = self._kernels.arena[out:marks]
            near |= self._kernels.arena[marks:].view(np.int32)[:segments] != 0
        return np.flatnonzero(near)

    def _divided(self, block: slice) -> Iterator[slice]:
        """Yield parts of the shapes that have room in the memory, and leave some."""
        few = block.stop - block.start
        if few > 1 and (few > _MOST or not self._lay(block)):
            middle = block.start + few // 2
            yield from self._divided(slice(block.start, middle))
            yield from self._divided(slice(middle, block.stop))
        else:
            yield block

    def _lay(self, block: slice) -> bool:
        """Lay some shapes into the memory; return whether there is room, also for discs."""
        tables = self._rows[block], *_NONE[1:]
        size = sort_shapes(self._kernels, _WORK, tables, self._grid)
        self._laid, self._end = block, _WORK + size
        return 0 < size < self._kernels.room - 2 * _WORK
