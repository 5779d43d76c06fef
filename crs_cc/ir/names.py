"""Linker names of static objects, and of the library.

A static object `count` of `wander.c` is `wander.c:count`, one inside function `turn` is
`wander.c:turn.count`.
"""

from __future__ import annotations

from typing import Final

from crs_cc.core.source import Location

LIBRARY: Final = "<library>/"
"""The prefix of the C library's file names."""

REPORT: Final = "__report_"
"""The prefix by which `crs/report.h` maps the names of the CRS report to its own functions."""


def in_library(location: Location) -> bool:
    """Return whether a location is in the C library."""
    return location.file.startswith(LIBRARY)


def plain_name(function: str) -> str:
    """Return a function's name in the source.

    >>> plain_name("wander.c:turn"), plain_name("__report_vm")
    ('turn', 'vm')
    """
    return function.rpartition(":")[2].removeprefix(REPORT)
