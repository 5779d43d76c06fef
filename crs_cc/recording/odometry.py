"""Odometry in recordings, as the difference from a prediction by the true motion.

Odometry changes as the robot moves, rotated by the angle between its coordinate frame and the
world's. So it can be predicted from its last value, the true pose at that time, and the current
true pose. All frames except the first of a group store the difference from this prediction: zero,
or one due to rounding, unless wheels slip or programs change the coordinate frame. All numbers are
integers, see `frames`, so the result is the same on every computer.

>>> true = np.array([[[0.0], [0.0], [1.0]], [[0.5], [0.2], [1.5]], [[1.0], [0.4], [1.5]]])
>>> odometry = true - [[0.0], [0.0], [1.0]]
>>> ((time_ns, data),) = messages([5, 6, 7], odometry, true)
>>> decoder = OdometryDecoder()
>>> for each_ns, values in zip([5, 6, 7], true):
...     decoder.note(each_ns, values)
>>> [(each_ns, values[:, 0].tolist()) for each_ns, values in decoder.frames(time_ns, data)]
[(5, [0.0, 0.0, 0.0]), (6, [0.5, 0.2, 0.5]), (7, [1.0, 0.4, 0.5])]
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Final

import numpy as np

from crs_cc.core.arrays import FloatArray, Int64Array
from crs_cc.recording.frames import (
    DIFFERENCE,
    KEY,
    NOWHERE,
    PER_UNIT,
    Numbers,
    Times,
    dequantized,
    encoded_messages,
    frame_in,
    group_in,
    is_group,
    quantized,
)

COLUMNS: Final = 3
TURN: Final = round(2.0 * np.pi * PER_UNIT)
"""A full turn in the unit of stored headings."""

_EXACT: Final = 2**53  # smaller integers are exact as float64
_BITS: Final = 20  # of the sine and cosine of an angle between frames


def messages(times_ns: Times, odometry: FloatArray, true: FloatArray) -> list[tuple[int, bytes]]:
    """Return messages, each with its time, as `frames.messages` does.

    Args:
        times_ns: the frames' times.
        odometry: x, y [m], heading [rad] of each robot, (frames, 3, robots).
        true: the true poses in the same frames, robots first, (frames, columns, rows).
    """
    return messages_of(times_ns, quantized(odometry), quantized(true))


def messages_of(times_ns: Times, odometry: Numbers, true: Numbers) -> list[tuple[int, bytes]]:
    """Return the messages of quantized frames."""
    now = true[:, :COLUMNS, : odometry.shape[2]]
    steps = odometry.copy()
    steps[1:] -= expected(odometry[:-1], now[:-1], now[1:])
    return encoded_messages(times_ns, steps, (KEY, *[DIFFERENCE] * len(steps)))


def expected(odometry: Numbers, before: Numbers, now: Numbers) -> Numbers:
    """Return the predicted odometry of robots, (..., 3, robots) like all arguments.

    Args:
        odometry: their last odometry.
        before: their true poses at that time.
        now: their current true poses; a robot that is or was absent has not moved.
    """
    whole, was, step = signed(odometry), signed(before), signed(now)
    is_absent = (was[..., 0, :] == NOWHERE) | (step[..., 0, :] == NOWHERE)
    step -= was
    step[..., 2, :] = wrapped_angle(step[..., 2, :])
    step[np.broadcast_to(is_absent[..., None, :], step.shape)] = 0
    x, y = rotated(step[..., 0, :], step[..., 1, :], whole[..., 2, :] - was[..., 2, :])
    whole += np.stack([x, y, step[..., 2, :]], axis=-2)
    return whole.astype(np.uint32)


def wrapped_angle(heading: Int64Array) -> Int64Array:
    """Return angles wrapped to half a turn in either direction.

    >>> wrapped_angle(np.array([31415, 31416, 62832 - 5]))
    array([ 31415, -31416,     -5])
    """
    return heading - TURN * floor_quotient(heading + TURN // 2, TURN)


def floor_quotient(numbers: Int64Array, by: Int64Array | int) -> Int64Array:
    """Return quotients rounded down, like `//` but much faster for small numbers.

    A quotient of integers below 2^53 that is not an integer differs from the nearest one by more
    than the rounding error.

    >>> floor_quotient(np.array([7, -7, 2**60 - 1]), 2).tolist()
    [3, -4, 576460752303423487]
    """
    largest = max(-int(numbers.min(initial=0)), int(numbers.max(initial=0)))
    if largest < _EXACT:
        return np.floor(numbers / by).astype(np.int64)
    whole: Int64Array = numbers // by
    return whole


def rotated(x: Int64Array, y: Int64Array, angle: Int64Array) -> tuple[Int64Array, Int64Array]:
    """Return vectors rotated by angles, all in stored units."""
    angle_rad = angle / PER_UNIT
    cos, sin = (np.rint(of(angle_rad) * 2.0**_BITS).astype(np.int64) for of in (np.cos, np.sin))
    half = 1 << (_BITS - 1)
    return (cos * x - sin * y + half) >> _BITS, (sin * x + cos * y + half) >> _BITS


class OdometryDecoder:
    """Decodes odometry in the order of time."""

    def __init__(self) -> None:
        self._true: dict[int, FloatArray] = {}  # by time [ns]
        self._last: tuple[int, Numbers] | None = None

    def note(self, time_ns: int, values: FloatArray, *, is_key: bool = False) -> None:
        """Store the true poses at a time.

        Args:
            time_ns: the time.
            values: x, y [m], heading [rad], robots first, (columns, rows).
            is_key: whether later messages do not depend on earlier poses.
        """
        if is_key:
            self._true.clear()
            self._last = None
        self._true[time_ns] = values

    def frames(self, time_ns: int, message: bytes) -> Iterator[tuple[int, FloatArray]]:
        """Yield the frames in a message: their times, and x, y [m], heading [rad].

        Raises:
            ValueError: the message is invalid, or data that it depends on is missing.
        """
        if not is_group(message):
            kind, found = frame_in(message)
            yield time_ns, self._next(time_ns, found, is_key=kind == KEY)
            return
        after_ns, steps = group_in(message)
        for number, (each_ns, found) in enumerate(zip(after_ns.tolist(), steps, strict=True)):
            yield time_ns + each_ns, self._next(time_ns + each_ns, found, is_key=number == 0)

    def _next(self, time_ns: int, found: Numbers, *, is_key: bool) -> FloatArray:
        """Return a frame from its contents."""
        if len(found) != COLUMNS:
            raise ValueError("a frame of odometry has an unknown form")
        if not is_key:
            if self._last is None or self._last[1].shape != found.shape:
                raise ValueError("the frame before is missing")
            last_ns, last = self._last
            found = found + expected(last, self._at(last_ns, found), self._at(time_ns, found))
        self._last = time_ns, found
        return dequantized(found)

    def _at(self, time_ns: int, like: Numbers) -> Numbers:
        """Return where the robots are at the time of a frame."""
        values = self._true.get(time_ns)
        if values is None or values.shape[1] < like.shape[1]:
            raise ValueError("the position of a robot is missing")
        return quantized(values[:COLUMNS, : like.shape[1]])


def signed(whole: Numbers) -> Int64Array:
    """Decode stored numbers to signed ones."""
    return whole.view(np.int32).astype(np.int64)
