"""Descriptions of breakpoints."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from crs_cc.debug.breakpoints import Breakpoint

if TYPE_CHECKING:
    from crs_cc.debug.watch import AccessKind

_ACCESSES: Final[dict[AccessKind, str]] = {
    "change": "on change",
    "write": "on write",
    "read": "on read",
    "access": "on read or write",
}


def name_of(one: Breakpoint) -> str:
    """Return the name of a breakpoint.

    >>> name_of(Breakpoint(3, "watchpoint", "speed", temporary=True))
    'Temporary watchpoint 3'
    """
    return f"{'temporary ' * one.temporary}{one.kind} {one.number}".capitalize()


def described(one: Breakpoint) -> str:
    """Return a description of a breakpoint's location."""
    location = one.location.location if one.location else None
    if one.watch is not None:
        if one.kind == "breakpoint":
            return f"if {one.text}"
        option = "-location " * one.watch.is_location
        return f"{option}{one.text}, {_ACCESSES[one.watch.watched.kind]}"
    if one.location is None:
        return one.text
    if location is None:
        return f"{one.text}, a robot function"
    return f"{one.location.function} at {location.file}:{location.line}"
