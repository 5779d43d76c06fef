"""Beams among many shapes, which lie in the memory of kernels sorted by the cells of a grid.

>>> import math
>>> nothing = np.zeros((0, 7)), np.zeros((0, 5)), np.zeros((0, 14))
>>> drum = nothing[0], np.array([[-1.0, 0.0, 3.0, 1.0, 0.5]]), nothing[2]
>>> field = BeamField(reach_m=5.0, fixed=drum)
>>> field.place(nothing)
True
"""

from __future__ import annotations

from typing import Final, TypeAlias

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.sim.kernels.program import Kernels
from crs_cc.sim.kernels.surveys import viewers_of
from crs_cc.sim.kernels.tables import SORT, SURVEY

Tables: TypeAlias = tuple[FloatArray, FloatArray, FloatArray]
"""Rows of segments, circles and pieces, see `beams.h`."""

_WORK: Final = 400_000  # numbers of the arena for robots and their distances
_HEAD: Final = 8
_MOST_CELLS: Final = 128  # along each side of the grid
_CELLS_PER_REACH: Final = 3


class BeamField:
    """All shapes of a world.

    Attributes:
        fits: whether the fixed ones have room.
    """

    def __init__(self, reach_m: float, fixed: Tables) -> None:
        """Sort the shapes that stay.

        Args:
            reach_m: how far beams reach.
            fixed: the shapes.
        """
        self._kernels = Kernels(is_arena=True)
        segments, circles, _ = fixed
        points = np.concatenate([segments[:, 2:4], segments[:, 4:6], circles[:, 2:4]])
        corner_m = points.min(axis=0) if len(points) else np.zeros(2)
        extent_m = points.max(axis=0) - corner_m if len(points) else np.zeros(2)
        cell_m = max(reach_m / _CELLS_PER_REACH, float(extent_m.max()) / _MOST_CELLS)
        size = np.floor(extent_m / cell_m) + 1.0
        self._grid = *corner_m, cell_m, *size
        size_of_fixed = self._lay(_WORK, fixed)
        self.fits = size_of_fixed > 0
        self._moving = _WORK + size_of_fixed

    def place(self, moving: Tables) -> bool:
        """Sort the shapes that move; return whether they have room."""
        return self.fits and self._lay(self._moving, moving) > 0

    def distances_m(self, fan: FloatArray, poses: FloatArray, own: IndexArray) -> FloatArray:
        """Return the distance that each beam measures, 0 for a start in or on a piece, (k, beams).

        Args:
            fan: the beams, see `geometry.rays`; no more than fit.
            poses: x, y [m] and heading [rad] of each robot, shape (k, 3).
            own: the number of each robot's own body, (k,).
        """
        beams, viewers = int(fan[0]), viewers_of(poses, own)
        most = (_WORK - len(fan)) // (viewers.shape[1] + 2 * beams)
        found = np.empty((len(poses), beams))
        for first in range(0, len(poses) if beams else 0, most):
            some = viewers[first : first + most]
            out = len(fan) + some.size
            self._kernels.lay(fan.tobytes() + some.tobytes())
            self._kernels.call(SURVEY, len(some), len(fan), out, _WORK, self._moving)
            distances_m = self._kernels.arena[out : out + len(some) * beams]
            found[first : first + most] = distances_m.reshape(-1, beams)
        return found

    def _lay(self, place: int, tables: Tables) -> int:
        """Lay shapes into the arena, and sort them; return how many numbers they take, or 0."""
        head = np.array([*map(len, tables), *self._grid])
        content = b"".join([head.tobytes(), *(table.tobytes() for table in tables)])
        cells = int(self._grid[-1] * self._grid[-2])
        room = self._kernels.room - place
        if (len(content) + 4 * (cells + 1 + sum(map(len, tables)))) // 8 >= room:
            return 0
        self._kernels.lay(content, place)
        self._kernels.call(SORT, place, room)
        return self._kernels.result
