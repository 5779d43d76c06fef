"""Readings: the `State` vectors that programs were given, in the vendor's units.

A message has all readings of about a second, a row for each answer, in the order of time. Of a
vector only those elements are written that differ from the row before of the same robot, or from 0
in its first row; so each message can be read on its own.

>>> states = np.zeros((2, STATE), np.int32)
>>> states[:, 3] = -7
>>> rows = Readings(np.array([2, 2]), np.array([4, 4]), np.array([0.03, 0.1]), states)
>>> data = encode(rows, 0)
>>> again = decode(data, 0)
>>> len(data), again.robots.tolist(), again.clock_s.tolist(), again.states[1, :4].tolist()
(48, [4, 4], [0.03, 0.1], [0, 0, 0, -7])
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array, Int64Array
from crs_cc.recording.mcap_records import NS

HEAD: Final = struct.Struct("<HHII")
"""Version, 0, number of rows, number of elements that changed."""

VERSION: Final = 1
STATE: Final = 45
MAX_ROWS: Final = 1_000_000
_US: Final = 1_000_000
_MASK: Final = -(-STATE // 8)
_ROW: Final = 2 + 4 + 4 + _MASK  # code, robot, microseconds, mask


@dataclass(frozen=True, slots=True)
class Readings:
    """Answers to requests that reply `State`; (k,) each.

    Attributes:
        codes: the requests' codes.
        clock_s: when each program continued.
        states: the vectors (k, 45).
    """

    codes: Int64Array
    robots: IndexArray
    clock_s: FloatArray
    states: Int32Array


def encode(rows: Readings, time_ns: int) -> bytes:
    """Return a message.

    Args:
        rows: the readings.
        time_ns: the message's time, not after any of theirs.
    """
    states = rows.states
    order, is_first = _by_robot(rows.robots)
    sorted_states = states[order]
    before = np.zeros_like(sorted_states)
    before[1:] = sorted_states[:-1]
    before[is_first] = 0
    differs = np.empty(states.shape, np.bool_)
    differs[order] = sorted_states != before
    changed = states[differs]
    after_us = np.rint((rows.clock_s - time_ns / NS) * _US).clip(-(2.0**31), 2.0**31 - 1)
    parts = (
        HEAD.pack(VERSION, 0, len(states), len(changed)),
        rows.codes.astype("<u2").tobytes(),
        rows.robots.astype("<u4").tobytes(),
        after_us.astype("<i4").tobytes(),
        np.packbits(differs, axis=1, bitorder="little").tobytes(),
        changed.astype("<i4").tobytes(),
    )
    return b"".join(parts)


def decode(data: bytes, time_ns: int) -> Readings:
    """Return the readings in a message of a time; raise ValueError if it is no such message."""
    if len(data) < HEAD.size:
        raise ValueError("readings are too short")
    version, _, count, changed = HEAD.unpack_from(data)
    if (
        version != VERSION
        or count > MAX_ROWS
        or len(data) != HEAD.size + count * _ROW + changed * 4
    ):
        raise ValueError("readings have an unknown form")
    at = HEAD.size
    codes = np.frombuffer(data, "<u2", count, at).astype(np.int64)
    robots = np.frombuffer(data, "<u4", count, at + 2 * count).astype(np.intp)
    after_us = np.frombuffer(data, "<i4", count, at + 6 * count)
    masks = np.frombuffer(data, np.uint8, count * _MASK, at + 10 * count).reshape(count, _MASK)
    bits = np.unpackbits(masks, axis=1, count=STATE, bitorder="little")
    differs = bits.view(np.bool_)
    if int(differs.sum()) != changed:
        raise ValueError("readings have an unknown form")
    states = np.zeros((count, STATE), np.int32)
    states[differs] = np.frombuffer(data, "<i4", changed, at + count * _ROW)
    return Readings(codes, robots, time_ns / NS + after_us / _US, _filled(states, differs, robots))


def _filled(states: Int32Array, differs: BoolArray, robots: IndexArray) -> Int32Array:
    """Return the vectors, with what did not differ taken from the row before of the same robot."""
    order, is_first = _by_robot(robots)
    rows = np.arange(len(robots))[:, None]
    written = np.where(differs[order] | is_first[:, None], rows, 0)
    source = np.maximum.accumulate(written, axis=0)
    filled = np.empty_like(states)
    filled[order] = np.take_along_axis(states[order], source, axis=0)
    return filled


def _by_robot(robots: IndexArray) -> tuple[IndexArray, BoolArray]:
    """Return the order of rows by robot, and which in that order are the first of their robot."""
    order = np.argsort(robots, kind="stable")
    by_robot = robots[order]
    is_first = np.ones(len(robots), np.bool_)
    is_first[1:] = by_robot[1:] != by_robot[:-1]
    return order, is_first
