"""What is watched in a robot's memory, as a watching build finds it: the start of memory `marks`.

Up to `RANGES` ranges of bytes lie one behind the other, each with the accesses that count and what
there was of them since somebody cleared it. Before them stand the first address of all bytes among
which they lie, less 7, and how many these are, so that most accesses are found to be elsewhere
where they happen.

All this belongs to who watches and is no state of the program: no snapshot has it.

>>> WATCHED.itemsize
1040
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
        ("ranges", RANGE, (RANGES,)),
    ]
)


def range_offset(field: str) -> int:
    """Gives where a field lies in a range [bytes]."""
    return int(RANGE.fields[field][1])  # type: ignore[index]


def offset(field: str) -> int:
    """Gives where a field lies in the memory `marks` [bytes]."""
    return int(WATCHED.fields[field][1])  # type: ignore[index]
