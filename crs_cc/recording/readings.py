"""Readings: the `State` vectors sent to programs, in the vendor's units.

A message has all readings of an interval, with a row for each answer, by robot and then by time. A
vector is stored as its differences from the previous one of the same robot: those of elements that
often change, such as odometry, for all rows, element by element; of other elements, such as sonars,
of which one fires at a time, only those that are not 0, with their rows and elements. Odometry is
stored as the difference from its prediction by the frames of the same block, if there are any, see
`odometry_prediction`. Most numbers are small, and zstd compresses them well. At least every ten
seconds a message starts from zeros, so that a reader need not start at the beginning of the file;
others continue from the previous message.

>>> states = np.zeros((2, STATE), np.int32)
>>> states[:, 3] = -7
>>> rows = Readings(np.array([2, 2]), np.array([4, 4]), np.array([0.03, 0.1]), states)
>>> data = ReadingEncoder().encode(rows, 0)
>>> again = ReadingDecoder().decode(data, 0)
>>> len(data), again.robots.tolist(), again.clock_s.tolist(), again.states[1, :4].tolist()
(47, [4, 4], [0.03, 0.1], [0, 0, 0, -7])
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from typing import Any, Final, NamedTuple

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import FloatArray, IndexArray, Int32Array, Int64Array
from crs_cc.recording.frames import unzigzag, zigzag
from crs_cc.recording.mcap_records import NS
from crs_cc.recording.odometry_prediction import OdometryPrediction

HEAD: Final = struct.Struct("<HHIIQq")
"""Version, number of the message since one that starts from zeros, rows, changes that are stored
individually, a bit for each element that is stored for all rows, the time of the frames from which
odometry is predicted [ns], or `NO_FRAMES`."""

VERSION: Final = 4
NO_FRAMES: Final = -1
ODOMETRY_ELEMENTS: Final = slice(34, 37)
"""The elements with the odometry."""

FREQUENT_ROWS: Final = 5
"""Elements that change in more than one in this many rows are stored for all rows."""

STATE: Final = 45
PERIOD_NS: Final = 10 * NS
"""The period after which differences start from zeros, at the latest."""

MAX_ROWS: Final = 200_000
_US: Final = 1_000_000
_NS_PER_US: Final = 1000
_PLANES: Final = 4  # bytes of a number


class Readings(NamedTuple):
    """Answers to requests that reply `State`; (k,) each.

    Attributes:
        codes: the requests' codes.
        clock_s: when each program continued.
        states: the vectors (k, 45).
    """

    codes: npt.NDArray[np.signedinteger[Any]]
    robots: IndexArray
    clock_s: FloatArray
    states: Int32Array

    def of(self, rows: Any) -> Readings:
        """Return some of the rows."""
        states = self.states[rows] if isinstance(rows, slice) else self.states.take(rows, axis=0)
        return Readings(self.codes[rows], self.robots[rows], self.clock_s[rows], states)


class _LastStates:
    """The last vector of each robot, and the position of a message in its period."""

    def __init__(self) -> None:
        self._period, self._number = -1, 0
        self._robots: IndexArray = np.zeros(0, np.intp)
        self._states: Int32Array = np.zeros((0, STATE), np.int32)

    def begin(self, time_ns: int) -> int:
        """Return the number of the next message, 0 for the first of a period."""
        if time_ns // PERIOD_NS != self._period:
            self.__init__()  # type: ignore[misc]
            self._period = time_ns // PERIOD_NS
        self._number += 1
        return self._number - 1

    def last(self, robots: IndexArray) -> Int32Array:
        """Return the last vectors of robots, zeros for those not known."""
        if not len(self._robots):
            return np.zeros((len(robots), STATE), np.int32)
        place = np.searchsorted(self._robots, robots)
        place[place == len(self._robots)] = 0
        found = np.zeros((len(robots), STATE), np.int32)
        known = self._robots[place] == robots
        found[known] = self._states[place[known]]
        return found

    def keep(self, robots: IndexArray, states: Int32Array) -> None:
        """Store vectors; robots are unique and in ascending order."""
        if len(self._robots) and not np.array_equal(robots, self._robots):
            old = ~np.isin(self._robots, robots)
            robots = np.concatenate([self._robots[old], robots])
            order = np.argsort(robots, kind="stable")
            states = np.concatenate([self._states[old], states])[order]
            robots = robots[order]
        self._robots, self._states = robots, states


class ReadingEncoder:
    """Encodes the readings of a recording in their order."""

    def __init__(self) -> None:
        self._memory = _LastStates()

    def encode(
        self, rows: Readings, time_ns: int, prediction: OdometryPrediction | None = None
    ) -> bytes:
        """Return a message.

        Args:
            rows: the readings, at most `MAX_ROWS`.
            time_ns: the message's time, not after any reading.
            prediction: the predicted odometry, if there are frames.
        """
        number = self._memory.begin(time_ns)
        if (rows.robots[1:] < rows.robots[:-1]).any():
            rows = rows.of(np.argsort(rows.robots, kind="stable"))
        robots, states = rows.robots, rows.states
        first = _firsts(robots)
        changes = _Changes(states, first, self._memory.last(robots[first]))
        ends = np.append(first[1:], len(robots)) - 1
        self._memory.keep(robots[ends], states[ends])
        after_us = np.rint((rows.clock_s - time_ns / NS) * _US).astype(np.int64)
        missed, frames_ns = b"", NO_FRAMES
        if prediction is not None:
            frames_ns = prediction.begin_ns
            off = states[:, ODOMETRY_ELEMENTS].T - prediction.at(robots, _at_us(time_ns, after_us))
            missed = b"".join(map(sparse, off))
            changes.exclude(ODOMETRY_ELEMENTS)
        row, element = changes.positions()
        count = np.bincount(element, minlength=STATE)
        is_often = count * FREQUENT_ROWS > len(states)
        often = np.flatnonzero(is_often).tolist()
        is_seldom = ~is_often[element]
        row, element = row[is_seldom], element[is_seldom]
        bits = sum(1 << column for column in often)
        parts = (
            HEAD.pack(VERSION, number, len(states), len(row), bits, frames_ns),
            rows.codes.astype("<u2").tobytes(),
            packed(_steps(robots)),
            packed(_steps(after_us)),
            *(packed(changes.of(column)) for column in often),
            element.astype(np.uint8).tobytes(),
            packed(_steps(row)),
            packed(changes.at(row, element)),
            missed,
        )
        return b"".join(parts)


class _Changes:
    """Differences between each vector and the previous one of the same robot."""

    def __init__(self, states: Int32Array, first: IndexArray, last: Int32Array) -> None:
        """Compare vectors.

        Args:
            states: the vectors, by robots (k, 45).
            first: the first row of each robot.
            last: the previous vector of each robot.
        """
        self._states, self._first, self._last = states, first, last
        self._differs = np.empty(states.shape, np.bool_)
        np.not_equal(states[1:], states[:-1], out=self._differs[1:])
        self._differs[first] = states[first] != last

    def exclude(self, columns: slice) -> None:
        """Treat elements as unchanged."""
        self._differs[:, columns] = False

    def positions(self) -> tuple[IndexArray, IndexArray]:
        """Return the rows and elements of all changes."""
        row, element = np.divmod(np.flatnonzero(self._differs), STATE)
        return row, element

    def of(self, column: int) -> Int32Array:
        """Return the changes of an element in all rows."""
        values = self._states[:, column]
        changes = np.empty_like(values)
        np.subtract(values[1:], values[:-1], out=changes[1:])
        changes[self._first] = values[self._first] - self._last[:, column]
        return changes

    def at(self, row: IndexArray, element: IndexArray) -> Int32Array:
        """Return the changes at rows and elements."""
        changes: Int32Array = self._states[row, element] - self._states[row - 1, element]
        place = np.searchsorted(self._first, row).clip(max=len(self._first) - 1)
        is_first = self._first[place] == row
        some, column = place[is_first], element[is_first]
        changes[is_first] = self._states[row[is_first], column] - self._last[some, column]
        return changes


class ReadingDecoder:
    """Decodes the readings of a recording in their order."""

    def __init__(self) -> None:
        self._memory = _LastStates()

    def decode(
        self,
        data: bytes,
        time_ns: int,
        prediction_of: Callable[[int], OdometryPrediction] | None = None,
    ) -> Readings | None:
        """Return the readings in a message; None if an earlier message is missing.

        Args:
            data: the message.
            time_ns: its time.
            prediction_of: returns the prediction by the frames of a time [ns]; raises ValueError.

        Raises:
            ValueError: the message is invalid.
        """
        if len(data) < HEAD.size:
            raise ValueError("readings are too short")
        version, number, count, seldom, bits, frames_ns = HEAD.unpack_from(data)
        if version != VERSION or count > MAX_ROWS or bits >> STATE or seldom > count * STATE:
            raise ValueError("readings have an unknown form")
        if number == 0:
            self._memory = _LastStates()
        if number != self._memory.begin(time_ns):
            self._memory = _LastStates()
            return None
        often = [column for column in range(STATE) if bits >> column & 1]
        found = _Numbers(data, HEAD.size)
        codes = found.plain("<u2", count)
        robots, after_us = np.cumsum(found.packed(count)), np.cumsum(found.packed(count))
        by_element = [found.packed(count) for _ in often]
        element = found.plain("u1", seldom)
        row, value = np.cumsum(found.packed(seldom)), found.packed(seldom)
        off = (
            []
            if frames_ns == NO_FRAMES
            else [found.sparse(count) for _ in range(*ODOMETRY_ELEMENTS.indices(STATE))]
        )
        is_valid = found.at == len(data) and _are_within(element, STATE) and _are_within(row, count)
        if not is_valid or not _are_within(robots, 2**32):
            raise ValueError("readings have an unknown form")
        changes = np.zeros((count, STATE), np.int32)
        for column, values in zip(often, by_element, strict=True):
            changes[:, column] = values
        changes[row, element] = value
        odometry = None
        if off and count:
            if prediction_of is None:
                raise ValueError("the frames of readings are missing")
            found_us = _at_us(time_ns, after_us)
            expected = prediction_of(frames_ns).at(robots, found_us)
            odometry = expected + np.stack(off, dtype=np.int32, casting="same_kind")
        states = self._summed(robots, changes, odometry)
        clock_s = time_ns / NS + after_us / _US
        return Readings(codes, robots, clock_s, states).of(np.argsort(clock_s, kind="stable"))

    def _summed(
        self, robots: IndexArray, changes: Int32Array, odometry: Int32Array | None
    ) -> Int32Array:
        """Return the vectors, with the odometry if known, and store the last one of each robot."""
        if not len(robots):
            return changes
        if (np.diff(robots) < 0).any():
            raise ValueError("readings are not in the order of robots")
        first = _firsts(robots)
        changes[first] += self._memory.last(robots[first])
        sums = np.cumsum(changes, axis=0, dtype=np.int32)
        lengths = np.diff(np.append(first, len(robots)))
        before = np.zeros((len(first), STATE), np.int32)
        before[1:] = sums[first[1:] - 1]
        states = sums - np.repeat(before, lengths, axis=0)
        if odometry is not None:
            states[:, ODOMETRY_ELEMENTS] = odometry.T
        ends = first + lengths - 1
        self._memory.keep(robots[ends], states[ends])
        return states


def _at_us(time_ns: int, after_us: Int64Array) -> Int64Array:
    """Return the times of readings [us], computed alike when writing and reading."""
    return time_ns // _NS_PER_US + after_us


def _firsts(robots: IndexArray) -> IndexArray:
    """Return the first row of each robot."""
    is_first = np.ones(len(robots), np.bool_)
    is_first[1:] = robots[1:] != robots[:-1]
    return np.flatnonzero(is_first)


def _steps(values: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Return the differences between consecutive numbers, starting from 0."""
    steps = values.copy()
    steps[1:] -= values[:-1]
    return steps


def packed(values: npt.NDArray[Any]) -> bytes:
    """Return numbers in byte planes: the lowest bytes of all, then the second ones, ...

    High bytes that are 0 in all numbers are omitted; the number of bytes per number comes first.

    >>> packed(np.array([1, -2, 3])).hex()
    '01020306'
    """
    u = zigzag(values.astype(np.int32))
    count = max(1, -(-int(u.max(initial=0)).bit_length() // 8))
    planes = ((u >> 8 * plane).astype(np.uint8).tobytes() for plane in range(count))
    return bytes([count]) + b"".join(planes)


def sparse(values: npt.NDArray[Any]) -> bytes:
    """Return mostly zero numbers: a bit for each that is not 0, followed by these, `packed`.

    >>> sparse(np.array([0, 0, 0, -1, 0, 0, 0, 0, 2])).hex()
    '0801010104'
    """
    is_there = values != 0
    return np.packbits(is_there, bitorder="little").tobytes() + packed(values[is_there])


class _Numbers:
    """Reads arrays in sequence, and raises ValueError at the end of the data.

    Attributes:
        at: the offset of the next array.
    """

    def __init__(self, data: bytes, at: int) -> None:
        self._data, self.at = data, at

    def plain(self, form: str, count: int) -> Int64Array:
        """Return numbers of a numpy type."""
        size = np.dtype(form).itemsize * count
        return np.frombuffer(self._take(size), form).astype(np.int64)

    def packed(self, count: int) -> Int64Array:
        """Decode numbers that were encoded by `packed`."""
        planes = self._take(1)[0]
        if not 1 <= planes <= _PLANES:
            raise ValueError("readings have an unknown form")
        content = np.frombuffer(self._take(planes * count), np.uint8).reshape(planes, count)
        u = np.zeros((count, _PLANES), np.uint8)
        u[:, :planes] = content.T
        return unzigzag(u.view("<u4").ravel()).view(np.int32).astype(np.int64)

    def sparse(self, count: int) -> Int64Array:
        """Decode numbers that were encoded by `sparse`."""
        bits = np.frombuffer(self._take(-(-count // 8)), np.uint8)
        is_there = np.unpackbits(bits, count=count, bitorder="little").astype(np.bool_)
        values = np.zeros(count, np.int64)
        values[is_there] = self.packed(int(is_there.sum()))
        return values

    def _take(self, size: int) -> bytes:
        if size > len(self._data) - self.at:
            raise ValueError("readings are too short")
        self.at += size
        return self._data[self.at - size : self.at]


def _are_within(values: Int64Array, end: int) -> bool:
    """Return whether numbers are from 0 up to an end, exclusive."""
    return not len(values) or bool(values.min() >= 0 and values.max() < end)
