"""How names are spelled where the source has none for the whole program.

A static object `count` of `wander.c` is `wander.c:count`, one inside function `turn`
`wander.c:turn.count`. The C library's own files stand in no folder of the user's.
"""

from __future__ import annotations

from typing import Final

from crs_cc.core.source import Location

LIBRARY: Final = "<library>/"
"""The names of the C library's files begin with it."""

REPORT: Final = "__report_"
"""What `crs/report.h` puts before the names of the CRS report, which mean its own functions."""


def in_library(location: Location) -> bool:
    """Return whether a place is in the C library."""
    return location.file.startswith(LIBRARY)


def plain_name(function: str) -> str:
    """Return a function's name as the programmer knows it.

    >>> plain_name("wander.c:turn"), plain_name("__report_vm")
    ('turn', 'vm')
    """
    return function.rpartition(":")[2].removeprefix(REPORT)
