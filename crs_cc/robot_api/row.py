"""What the tables of the vendor's API are made of."""

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
"""Refreshes what the mask in use lets through."""


@dataclass(frozen=True, slots=True)
class Function:
    """One function of the client library.

    Attributes:
        prototype: as the header declares it.
        does: what it does and gives, where that is more than TRUE, or FALSE when it failed.
        units: of its arguments, in their order, those that have one.
        refreshes: what of the globals is new behind it.
        posts: the requests it posts, by name; their bytes are its time on the line.
        waits: what it waits for, besides the line.
        under_ndirect: what is otherwise under Ndirect; empty when nothing is.
        source: where that is known from, keys of `SOURCES`.
        chosen: what nobody tells and we chose.
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
    """Functions that belong together.

    Attributes:
        title: what they are about.
        functions: the functions.
    """

    title: str
    functions: tuple[Function, ...]


@dataclass(frozen=True, slots=True)
class Name:
    """A constant, a place in State, or a global variable.

    Attributes:
        name: its name; several that count up as `STATE_IR_0 .. STATE_IR_15`.
        value: its value, that of the first; of a variable its type.
        meaning: what it is, with its unit.
    """

    name: str
    value: str
    meaning: str
