"""The predicted odometry at any time of a block, given its frames.

A program that reads `State` receives the odometry at that time, in the vendor's units. Except for
rounding, it can be interpolated from the frames before and after that time, so readings store only
the difference. All numbers are integers, see `frames`, so the prediction is the same on every
computer.

>>> from crs_cc.recording.frames import quantized
>>> true = quantized(np.array([[[0.0], [0.0], [0.0]], [[0.254], [0.0], [0.1]]]))
>>> prediction = OdometryPrediction(np.array([0, 100_000_000]), true, np.array([0]), true[:1])
>>> prediction.at(np.array([0, 0]), np.array([50_000, 100_000])).T.tolist()
[[50, 0, 29], [100, 0, 57]]
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core.arrays import IndexArray, Int32Array, Int64Array
from crs_cc.recording.frames import Numbers
from crs_cc.recording.odometry import COLUMNS, expected, floor_quotient, signed, wrapped_angle

_US: Final = 1000  # nanoseconds
_INCH: Final = 254  # a tenth of an inch, in tenths of the unit of frames
_DEGREES: Final = 572_957_795, 10**10  # tenths of degrees per unit of frames
_FULL: Final = 3600


class OdometryPrediction:
    """The predicted odometry of robots between some frames.

    Attributes:
        begin_ns: the time of the first of the frames.
    """

    def __init__(
        self, times_ns: Int64Array, true: Numbers, known_ns: Int64Array, odometry: Numbers
    ) -> None:
        """Predict the odometry from frames.

        Args:
            times_ns: the times of frames, at least one.
            true: the true poses in them, robots first, (frames, columns, rows).
            known_ns: the times of the frames with known odometry, at least one.
            odometry: the odometry of the robots in these, (frames, 3, robots).
        """
        self.begin_ns = int(times_ns[0])
        self._times_us = times_ns // _US
        self._robots = odometry.shape[2]
        place = np.searchsorted(known_ns, times_ns, side="right") - 1
        np.maximum(place, 0, out=place)
        there = np.searchsorted(times_ns, known_ns)[place]
        now = true[:, :COLUMNS, : self._robots]
        found = signed(expected(odometry[place], now[there], now))
        self._odometry = np.ascontiguousarray(found.swapaxes(0, 1)).reshape(COLUMNS, -1)

    def at(self, robots: IndexArray, times_us: Int64Array) -> Int32Array:
        """Return the predicted x, y [0.1 in] and heading [0.1 degrees] in `State`, (3, k).

        Args:
            robots: the robots.
            times_us: the time for each.
        """
        times, last = self._times_us, len(self._times_us) - 1
        after = np.searchsorted(times, times_us, side="right").clip(min(1, last), last)
        before = np.maximum(after - 1, 0)
        rows = np.minimum(robots, self._robots - 1)
        # Columns: numpy takes much longer for many short rows.
        begin = self._odometry.take(before * self._robots + rows, axis=1)
        change = self._odometry.take(after * self._robots + rows, axis=1) - begin
        change[2] = wrapped_angle(change[2])
        begin_us = times[before]
        lasts = np.maximum(times[after] - begin_us, 1)
        gone = (times_us - begin_us).clip(-lasts, lasts)
        found = begin + floor_quotient(2 * change * gone + lasts, 2 * lasts)
        found[:2] = floor_quotient(20 * found[:2] + _INCH, 2 * _INCH)
        per, unit = _DEGREES
        found[2] = floor_quotient(found[2] * per + unit // 2, unit)
        found[2] -= _FULL * floor_quotient(found[2], _FULL)
        found[:, robots >= self._robots] = 0
        odometry: Int32Array = found.astype(np.int32)
        return odometry
