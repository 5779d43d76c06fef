"""What is watched in a robot's memory, as a watching build finds it: the start of memory `marks`.

Up to `RANGES` ranges of bytes lie one behind the other, each with the accesses that count and what
there was of them since somebody cleared it. Before them stand the first address of all bytes among
which they lie, less 7, and how many these are, so that most accesses are found to be elsewhere
where they happen; the same for those on the stack, so that a function knows whether its frame is
concerned; and which of 64 grains they touch, into which all memory is divided again and again.

All this belongs to who watches and is no state of the program: no snapshot has it.

>>> WATCHED.itemsize
1056
>>> hex(grains(0x1008, 4)), hex(grains(0x1010, 16)), hex(grains(0, 4096))
('0x1', '0x3', '0xffffffffffffffff')
"""

from __future__ import annotations

from typing import Final

import numpy as np

RANGES: Final = 16
CALLERS: Final = 8
READ, WRITE, ENTER, RETURN = 1, 2, 4, 8
"""Kinds of access; the last two are those of a function that is entered, or ends, to the first byte
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
        ("hits", "<u4"),  # which of them there were
        ("since", "<i8"),  # statements that must have begun before one counts
        ("place", "<u4"),  # the last: which access of the user's files, from 1; 0 in the library
        ("reserved", "<u4"),
        ("callers", "<u4", (CALLERS,)),  # of the library's: numbers of the calls, see `sites`
    ]
)
WATCHED: Final = np.dtype(
    [
        ("first", "<u4"),
        ("span", "<u4"),
        ("pending", "<u4"),  # 1: stop before the next statement
        ("end", "<u4"),  # where in the memory the ranges that are in use end
        ("lowest", "<u4"),  # the first address on the stack
        ("highest", "<u4"),  # where those on the stack end
        ("grains", "<u8"),  # bit n: grain n of every 64 is touched
        ("ranges", RANGE, (RANGES,)),
    ]
)


def grains(first: int, size: int) -> int:
    """Return the grains that an access touches if it touches some bytes, and is not a copy."""
    start, last = first - LONGEST + 1 >> GRAIN, first + size - 1 >> GRAIN
    bits = 0
    for grain in range(start, min(last, start + 63) + 1):
        bits |= 1 << grain % 64
    return bits


def range_offset(field: str) -> int:
    """Return where a field lies in a range [bytes]."""
    return int(RANGE.fields[field][1])  # type: ignore[index]


def offset(field: str) -> int:
    """Return where a field lies in the memory `marks` [bytes]."""
    return int(WATCHED.fields[field][1])  # type: ignore[index]
