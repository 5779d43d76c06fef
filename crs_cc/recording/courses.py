"""The predicted odometry at any time of a block, given its frames.

A program that reads `State` is told where its odometry has the robot at that instant, in units of
the vendor. That is what the frames before and after it say, to within the rounding; so readings
need only have the difference. All numbers are whole ones, see `frames`, so each computer expects
the same.

>>> from crs_cc.recording.frames import whole_numbers
>>> true = whole_numbers(np.array([[[0.0], [0.0], [0.0]], [[0.254], [0.0], [0.1]]]))
>>> course = Course(np.array([0, 100_000_000]), true, np.array([0]), true[:1])
>>> course.at(np.array([0, 0]), np.array([50_000, 100_000])).T.tolist()
[[50, 0, 29], [100, 0, 57]]
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core.arrays import IndexArray, Int32Array, Int64Array
from crs_cc.recording.beliefs import COLUMNS, expected, nearest_turn, quotient, signed
from crs_cc.recording.frames import Numbers

_US: Final = 1000  # nanoseconds
_INCH: Final = 254  # a tenth of an inch in tenths of what frames count
_DEGREES: Final = 572_957_795, 10**10  # tenths of degrees in what frames count
_FULL: Final = 3600


class Course:
    """Where robots should believe to be in the time of some frames.

    Attributes:
        begin_ns: the time of the first of the frames.
    """

    def __init__(
        self, times_ns: Int64Array, true: Numbers, known_ns: Int64Array, believed: Numbers
    ) -> None:
        """Expect what frames lead to.

        Args:
            times_ns: the times of frames, at least one.
            true: where everything is in them, robots first, (frames, columns, rows).
            known_ns: the times of those of which beliefs are known, at least one.
            believed: where the robots believe to be in these, (frames, 3, robots).
        """
        self.begin_ns = int(times_ns[0])
        self._times_us = times_ns // _US
        self._robots = believed.shape[2]
        place = np.searchsorted(known_ns, times_ns, side="right") - 1
        np.maximum(place, 0, out=place)
        there = np.searchsorted(times_ns, known_ns)[place]
        now = true[:, :COLUMNS, : self._robots]
        found = signed(expected(believed[place], now[there], now))
        self._believed = np.ascontiguousarray(found.swapaxes(0, 1)).reshape(COLUMNS, -1)

    def at(self, robots: IndexArray, times_us: Int64Array) -> Int32Array:
        """Return x, y [0.1 in], heading [0.1 degrees] that `State` should have, (3, k).

        Args:
            robots: which robots.
            times_us: when, for each.
        """
        times, last = self._times_us, len(self._times_us) - 1
        after = np.searchsorted(times, times_us, side="right").clip(min(1, last), last)
        before = np.maximum(after - 1, 0)
        rows = np.minimum(robots, self._robots - 1)
        # Columns: numpy takes much longer for many short rows.
        begin = self._believed.take(before * self._robots + rows, axis=1)
        way = self._believed.take(after * self._robots + rows, axis=1) - begin
        way[2] = nearest_turn(way[2])
        begin_us = times[before]
        lasts = np.maximum(times[after] - begin_us, 1)
        gone = (times_us - begin_us).clip(-lasts, lasts)
        found = begin + quotient(2 * way * gone + lasts, 2 * lasts)
        found[:2] = quotient(20 * found[:2] + _INCH, 2 * _INCH)
        per, unit = _DEGREES
        found[2] = quotient(found[2] * per + unit // 2, unit)
        found[2] -= _FULL * quotient(found[2], _FULL)
        found[:, robots >= self._robots] = 0
        place: Int32Array = found.astype(np.int32)
        return place
