"""The columns of the request tables."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Server = Literal["host", "robot", "device"]


@dataclass(frozen=True, slots=True)
class Argument:
    """An argument or result of a request.

    Attributes:
        place: its position in the message, written as in Python: `i[0]`, `f[1]`, `data`, `result`.
        name: its description.
        unit: its unit; "1" for a number without unit.
    """

    place: str
    name: str
    unit: str = "1"


@dataclass(frozen=True, slots=True)
class RequestCode:
    """A kind of request.

    Attributes:
        name: its name, `CRS_<name>` in C.
        code: its number.
        server: the part that serves it: the session as the program's host; the simulated robot, or
            the simulator that it lives in; or a device of `crs.h`, which needs no connection.
        prototype: the C function that posts it.
        meaning: its effect.
        arguments: contents of the message when it is posted.
        results: contents of the message when the program resumes.
        tells_state: whether the reply is all of `State`.
    """

    name: str
    code: int
    server: Server
    prototype: str
    meaning: str
    arguments: tuple[Argument, ...] = ()
    results: tuple[Argument, ...] = ()
    tells_state: bool = False


def arguments(*rows: tuple[str, str, str]) -> tuple[Argument, ...]:
    """Return arguments or results from rows of place, name and unit."""
    return tuple(Argument(*row) for row in rows)
