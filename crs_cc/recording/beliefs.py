"""Odometry in recordings, as the difference from a prediction by the true motion.

Odometry goes on as the robot does, turned by the angle between its frame and the world's: where it
believes to be is told from where it believed to be, where it was then, and where it is now. What is
written is the difference to that, of every frame but the first of a group: zero, or one for
rounding, as long as wheels do not slip and programs do not move the frame. All numbers are whole
ones, see `frames`, so each computer reads the same.

>>> true = np.array([[[0.0], [0.0], [1.0]], [[0.5], [0.2], [1.5]], [[1.0], [0.4], [1.5]]])
>>> believed = true - [[0.0], [0.0], [1.0]]
>>> ((time_ns, data),) = messages([5, 6, 7], believed, true)
>>> decoder = BeliefDecoder()
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
    frame_in,
    group_in,
    is_group,
    values_of,
    whole_numbers,
    written,
)

COLUMNS: Final = 3
TURN: Final = round(2.0 * np.pi * PER_UNIT)
"""A full turn, as headings are written."""

_EXACT: Final = 2**53  # whole numbers below are exact as float64
_BITS: Final = 20  # of the sine and cosine of an angle between frames


def messages(times_ns: Times, believed: FloatArray, true: FloatArray) -> list[tuple[int, bytes]]:
    """Return messages, each with its time, as `frames.messages` does.

    Args:
        times_ns: the frames' times.
        believed: x, y [m], heading [rad] of each robot, (frames, 3, robots).
        true: where everything is in the same frames, robots first, (frames, columns, rows).
    """
    return messages_of(times_ns, whole_numbers(believed), whole_numbers(true))


def messages_of(times_ns: Times, believed: Numbers, true: Numbers) -> list[tuple[int, bytes]]:
    """Return the same of frames whose numbers are whole already."""
    now = true[:, :COLUMNS, : believed.shape[2]]
    steps = believed.copy()
    steps[1:] -= expected(believed[:-1], now[:-1], now[1:])
    return written(times_ns, steps, (KEY, *[DIFFERENCE] * len(steps)))


def expected(believed: Numbers, before: Numbers, now: Numbers) -> Numbers:
    """Return where robots should believe to be, (..., 3, robots) like all arguments.

    Args:
        believed: where they believed to be.
        before: where they were then.
        now: where they are; who is or was nowhere has not moved.
    """
    whole, was, step = signed(believed), signed(before), signed(now)
    is_absent = (was[..., 0, :] == NOWHERE) | (step[..., 0, :] == NOWHERE)
    step -= was
    step[..., 2, :] = nearest_turn(step[..., 2, :])
    step[np.broadcast_to(is_absent[..., None, :], step.shape)] = 0
    x, y = turned(step[..., 0, :], step[..., 1, :], whole[..., 2, :] - was[..., 2, :])
    whole += np.stack([x, y, step[..., 2, :]], axis=-2)
    return whole.astype(np.uint32)


def nearest_turn(heading: Int64Array) -> Int64Array:
    """Return the smallest angles that are the same but for full turns.

    >>> nearest_turn(np.array([31415, 31416, 62832 - 5]))
    array([ 31415, -31416,     -5])
    """
    return heading - TURN * quotient(heading + TURN // 2, TURN)


def quotient(numbers: Int64Array, by: Int64Array | int) -> Int64Array:
    """Return whole quotients, rounded down, like `//` and much faster for small numbers.

    A quotient of whole numbers below 2^53 that is none itself is farther from the next one than it
    is rounded.

    >>> quotient(np.array([7, -7, 2**60 - 1]), 2).tolist()
    [3, -4, 576460752303423487]
    """
    largest = max(-int(numbers.min(initial=0)), int(numbers.max(initial=0)))
    if largest < _EXACT:
        return np.floor(numbers / by).astype(np.int64)
    whole: Int64Array = numbers // by
    return whole


def turned(x: Int64Array, y: Int64Array, angle: Int64Array) -> tuple[Int64Array, Int64Array]:
    """Return vectors turned by angles, all in whole numbers as they are written."""
    angle_rad = angle / PER_UNIT
    cos, sin = (np.rint(of(angle_rad) * 2.0**_BITS).astype(np.int64) for of in (np.cos, np.sin))
    half = 1 << (_BITS - 1)
    return (cos * x - sin * y + half) >> _BITS, (sin * x + cos * y + half) >> _BITS


class BeliefDecoder:
    """Decodes where robots believe to be, in the order of time."""

    def __init__(self) -> None:
        self._true: dict[int, FloatArray] = {}  # by time [ns]
        self._last: tuple[int, Numbers] | None = None

    def note(self, time_ns: int, values: FloatArray, *, is_key: bool = False) -> None:
        """Take note of where everything is.

        Args:
            time_ns: when.
            values: x, y [m], heading [rad], robots first, (columns, rows).
            is_key: whether nothing that follows needs what was noted before.
        """
        if is_key:
            self._true.clear()
            self._last = None
        self._true[time_ns] = values

    def frames(self, time_ns: int, message: bytes) -> Iterator[tuple[int, FloatArray]]:
        """Yield the frames in a message of a time: each its time, and x, y [m], heading [rad].

        Raises:
            ValueError: it is no such message, or what it depends on is missing.
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
        return values_of(found)

    def _at(self, time_ns: int, like: Numbers) -> Numbers:
        """Return where the robots are at the time of a frame."""
        values = self._true.get(time_ns)
        if values is None or values.shape[1] < like.shape[1]:
            raise ValueError("the position of a robot is missing")
        return whole_numbers(values[:COLUMNS, : like.shape[1]])


def signed(whole: Numbers) -> Int64Array:
    """Decode stored numbers to signed ones."""
    return whole.view(np.int32).astype(np.int64)
