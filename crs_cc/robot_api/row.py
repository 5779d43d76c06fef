"""Rows of the tables of the vendor's API."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

HEADER: Final = "header"
SOURCE: Final = "source"
OURS: Final = "ours"

SOURCES: Final = {
    HEADER: "the vendor's header Nclient.h 1.29",
    SOURCE: "the vendor's Nclient.c and Ndirect.c 2.7",
    "York": "the Scout server of York University",
    "RWI": "RWI's programs for the Scout",
    "CARMEN": "CARMEN's driver for the Scout",
    "Player": "Player's driver for the Nomad 200",
    OURS: "chosen by us, undocumented",
}
"""Sources of what is known about a function."""

ALL: Final = "State"
"""The active mask selects what is refreshed."""


@dataclass(frozen=True, slots=True)
class Function:
    """One function of the client library.

    Attributes:
        prototype: as the header declares it.
        does: its effect, and its result unless that is TRUE, or FALSE on failure.
        units: the units of its arguments, in order.
        refreshes: the global variables that it updates.
        posts: the requests that it posts, by name; their bytes determine its time on the line.
        waits: the event that it waits for, besides the line.
        under_ndirect: differences under Ndirect; empty for none.
        source: the sources, keys of `SOURCES`.
        chosen: undocumented behaviour that was chosen by us.
        declared: whether the vendor's header declares it.
    """

    prototype: str
    does: str
    units: str = ""
    refreshes: str = ""
    posts: tuple[str, ...] = ()
    waits: str = ""
    under_ndirect: str = ""
    source: tuple[str, ...] = (HEADER,)
    chosen: str = ""
    declared: bool = True

    @property
    def name(self) -> str:
        """The function's name."""
        return self.prototype.partition("(")[0].split()[-1].lstrip("*")


@dataclass(frozen=True, slots=True)
class Group:
    """A group of related functions."""

    title: str
    functions: tuple[Function, ...]


@dataclass(frozen=True, slots=True)
class Name:
    """A constant, an index into State, or a global variable.

    Attributes:
        name: its name; a range of consecutive values as `STATE_IR_0 .. STATE_IR_15`.
        value: its value, or the first one; of a variable its type.
        meaning: its description, with its unit.
    """

    name: str
    value: str
    meaning: str
