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

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray
from crs_cc.sim.kernels.program import Kernels
from crs_cc.sim.kernels.sorted_shapes import grid_of, sort_shapes
from crs_cc.sim.kernels.tables import ROOM

_WORK: Final = 400_000  # numbers of the arena for discs and what is found
_MAX_DISCS: Final = 40_000
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
        room_m, near = np.empty(len(which)), np.zeros(len(self._rows), dtype=np.bool_)
        for first in range(0, len(which), _MAX_DISCS):
            some = which[first : first + _MAX_DISCS]
            room_m[first : first + _MAX_DISCS] = self._measure_some(discs, some, need_m, near)
        return room_m, np.flatnonzero(near)

    def _measure_some(
        self, discs: FloatArray, which: IndexArray, need_m: float, near: BoolArray
    ) -> FloatArray:
        """Return the room of as many discs as have a place at once; mark the shapes near them."""
        kernels, count = self._kernels, len(which)
        asked = np.empty((count, 4))
        asked[:, :3], asked[:, 3] = discs[which], which
        question = np.array([self._look_m, need_m, self._thickest_m])
        room_m = np.full(count, self._look_m)
        kernels.lay(question.tobytes() + asked.tobytes() + room_m.tobytes())
        out = len(question) + asked.size
        marks = out + count
        for block in self._blocks:
            if block != self._laid:
                self._lay(block)
            kernels.call(ROOM, count, out, marks, _WORK)
            found = kernels.arena[marks:].view(np.int32)[: block.stop - block.start]
            near[block] |= found != 0
        for first in range(0, len(discs), _MAX_DISCS):
            self._sort(discs[first : first + _MAX_DISCS], first)
            kernels.call(ROOM, count, out, marks, self._end)
        return kernels.arena[out:marks].copy()

    def _sort(self, discs: FloatArray, first: int) -> None:
        """Lay some discs, numbered from `first` on, behind the shapes."""
        circles = np.zeros((len(discs), 5))
        circles[:, 1], circles[:, 2:] = np.arange(first, first + len(discs)), discs
        cell_m = max(self._cell_m, 2 * float(np.maximum.reduce(discs[:, 2], initial=0.0)))
        grid = grid_of(discs[:, :2], cell_m, len(discs))
        sort_shapes(self._kernels, self._end, (_NONE[0], circles, _NONE[2]), grid)

    def _divided(self, block: slice) -> Iterator[slice]:
        """Yield parts of the shapes that have room in the memory, and leave some."""
        few = block.stop - block.start
        if few > 1 and (few > _MAX_DISCS or not self._lay(block)):
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
