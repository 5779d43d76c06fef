"""Beams among many shapes, which are sorted by grid cell in the memory of kernels.

>>> import math
>>> nothing = np.zeros((0, 7)), np.zeros((0, 5)), np.zeros((0, 14))
>>> drum = nothing[0], np.array([[-1.0, 0.0, 3.0, 1.0, 0.5]]), nothing[2]
>>> field = BeamField(reach_m=5.0, fixed=drum)
>>> field.place(nothing)
True
"""

from __future__ import annotations

import functools
from typing import Final, NamedTuple

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.runtime.workers import run_all
from crs_cc.sim.kernels.program import Kernels
from crs_cc.sim.kernels.sorted_shapes import Tables, grid_of, sort_shapes
from crs_cc.sim.kernels.surveys import viewers_of
from crs_cc.sim.kernels.tables import SURVEY

ROBOTS_PER_THREAD: Final = 128
"""The minimum number of robots per thread, which take some tenths of a millisecond."""

_WORK: Final = 400_000  # numbers of the arena for robots and their distances
_CELLS_PER_REACH: Final = 3


class _Places(NamedTuple):
    """The positions of shapes in the arena.

    Attributes:
        outlines: the place of segments and circles, 0 if there are none.
        pieces: that of pieces.
        end: that of what comes next, 0 if they have no room.
    """

    outlines: int
    pieces: int
    end: int


_NO_PLACES: Final = _Places(0, 0, 0)


class BeamField:
    """All shapes of a world.

    Robots do not affect each other's distances, so several threads can measure those of some robots
    each, among shapes in the memory of instances of their own.

    Attributes:
        fits: whether the fixed ones have room.
    """

    def __init__(self, reach_m: float, fixed: Tables, threads: int = 1) -> None:
        """Sort the shapes that stay.

        Args:
            reach_m: how far beams reach.
            fixed: the shapes.
            threads: how many threads may measure at the same time; no result depends on it.
        """
        self._reach_m, self._fixed, self._threads = reach_m, fixed, threads
        self._moving, self._time = fixed, 0  # until shapes are placed
        self._sorted = [_Sorted(reach_m, fixed)]
        self.fits = self._sorted[0].fits

    def place(self, moving: Tables) -> bool:
        """Sort the shapes that move; return whether they have room."""
        self._moving, self._time = moving, self._time + 1
        return self.fits and self._sorted[0].place(moving, self._time)

    def distances_m(self, fan: FloatArray, poses: FloatArray, own: IndexArray) -> FloatArray:
        """Return the distance that each beam measures, 0 for a start in or on a piece, (k, beams).

        Args:
            fan: the beams, see `geometry.rays`; no more than fit.
            poses: x, y [m] and heading [rad] of each robot, shape (k, 3).
            own: the number of each robot's own body, (k,).
        """
        found, viewers = np.empty((len(poses), int(fan[0]))), viewers_of(poses, own)
        if not found.size:
            return found
        parts = max(1, min(self._threads, len(poses) // ROBOTS_PER_THREAD))
        if parts == 1:
            self._sorted[0].measure(fan, viewers, found)
            return found
        while len(self._sorted) < parts:
            self._sorted.append(_Sorted(self._reach_m, self._fixed))
        shares = zip(np.array_split(viewers, parts), np.array_split(found, parts), strict=True)
        measure = functools.partial(self._measure, fan)
        run_all([functools.partial(measure, *each) for each in enumerate(shares)])
        return found

    def _measure(self, fan: FloatArray, part: int, share: tuple[FloatArray, FloatArray]) -> None:
        """Measure a share of all distances, in a thread."""
        shapes = self._sorted[part]
        if shapes.time != self._time:
            shapes.place(self._moving, self._time)
        shapes.measure(fan, *share)


class _Sorted:
    """All shapes in the memory of one instance of the kernels.

    Attributes:
        fits: whether the fixed ones have room.
        time: a number of the last time when shapes were placed.
    """

    def __init__(self, reach_m: float, fixed: Tables) -> None:
        self._kernels = Kernels(is_arena=True)
        segments, circles, _ = fixed
        points = np.concatenate([segments[:, 2:4], segments[:, 4:6], circles[:, 2:4]])
        self._grid = grid_of(points, reach_m / _CELLS_PER_REACH)
        self._fixed, self._moving = self._lay_apart(_WORK, fixed), _NO_PLACES
        self.fits, self.time = self._fixed.end > 0, 0

    def place(self, moving: Tables, time: int) -> bool:
        """Sort the shapes that move; return whether they have room."""
        self._moving, self.time = self._lay_apart(self._fixed.end, moving), time
        return self._moving.end > 0

    def measure(self, fan: FloatArray, viewers: FloatArray, found: FloatArray) -> None:
        """Measure the distances of robots, by as many as have room at a time, see `viewers_of`."""
        beams = found.shape[1]
        most = (_WORK - len(fan)) // (viewers.shape[1] + 2 * beams)
        for first in range(0, len(viewers), most):
            some = viewers[first : first + most]
            out = len(fan) + some.size
            self._kernels.lay(fan.tobytes() + some.tobytes())
            fields = *self._fixed[:2], *self._moving[:2]
            self._kernels.call_aside(SURVEY, len(some), len(fan), out, *fields)
            distances_m = self._kernels.arena[out : out + len(some) * beams]
            found[first : first + most] = distances_m.reshape(-1, beams)

    def _lay_apart(self, place: int, tables: Tables) -> _Places:
        """Lay outlines and pieces into the arena, as these have to be nearer to matter."""
        segments, circles, pieces = tables
        places = []
        for some in ((segments, circles, pieces[:0]), (segments[:0], circles[:0], pieces)):
            if not any(map(len, some)):
                places.append(0)
                continue
            size = sort_shapes(self._kernels, place, some, self._grid)
            if not size:
                return _NO_PLACES
            places.append(place)
            place += size
        return _Places(places[0], places[1], place)
