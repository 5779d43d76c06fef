"""Watched ranges of a robot's memory, as watching builds read them: the start of memory `marks`.

Up to `RANGES` ranges of bytes are stored in sequence, each with the kinds of access that count and
those that have occurred since it was cleared. They are preceded by the bounds of all ranges (the
first address minus 7, and the size), so that most accesses are ruled out inline; by the same
for those on the stack, so that a function can test once whether its frame is
concerned; and by a bitmap of the grains that they touch, modulo 64 (a Bloom filter).

All this belongs to the debugger and is not state of the program: no snapshot includes it.

>>> WATCHED.itemsize
4136
>>> hex(grains(0x1008, 4)), hex(grains(0x1010, 16)), hex(grains(0, 4096))
('0x1', '0x3', '0xffffffffffffffff')
"""

from __future__ import annotations

from typing import Final

import numpy as np

RANGES: Final = 64
CALLERS: Final = 8
READ, WRITE, ENTER, RETURN = 1, 2, 4, 8
"""Kinds of access; the last two are function entry and exit, as accesses to the first byte
of its header (`layout`)."""

LONGEST: Final = 8
"""The longest access apart from copies [bytes]."""

GRAIN: Final = 4
"""A grain is 2**GRAIN bytes; chosen by us."""

RANGE: Final = np.dtype(
    [
        ("first", "<u4"),  # the first address
        ("size", "<u4"),  # how many bytes
        ("kinds", "<u4"),  # which accesses count
        ("hits", "<u4"),  # which of them have occurred
        ("since", "<i8"),  # number of statements begun from which accesses count
        ("place", "<u4"),  # the last access in the user's files, from 1; 0 in the library
        ("reserved", "<u4"),
        ("callers", "<u4", (CALLERS,)),  # for the library: numbers of the call sites
    ]
)
WATCHED: Final = np.dtype(
    [
        ("first", "<u4"),
        ("span", "<u4"),
        ("pending", "<u4"),  # 1: stop before the next statement
        ("end", "<u4"),  # end of the ranges in use
        ("lowest", "<u4"),  # the first address on the stack
        ("highest", "<u4"),  # end of those on the stack
        ("grains", "<u8"),  # bit n: grain n modulo 64 is touched
        ("statement", "<i8"),  # how many sites were passed when the last statement began
        ("ranges", RANGE, (RANGES,)),
    ]
)


def grains(first: int, size: int) -> int:
    """Return the bitmap of grains in which an access to these bytes can start, copies excluded."""
    start, last = first - LONGEST + 1 >> GRAIN, first + size - 1 >> GRAIN
    bits = 0
    for grain in range(start, min(last, start + 63) + 1):
        bits |= 1 << grain % 64
    return bits


def range_offset(field: str) -> int:
    """Return the offset of a field in a range [bytes]."""
    return int(RANGE.fields[field][1])  # type: ignore[index]


def offset(field: str) -> int:
    """Return the offset of a field in the memory `marks` [bytes]."""
    return int(WATCHED.fields[field][1])  # type: ignore[index]
