"""What the tables of request codes are made of."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Server = Literal["host", "robot", "device"]


@dataclass(frozen=True, slots=True)
class Argument:
    """One argument or result of a request.

    Attributes:
        place: where in the message it lies, as written in Python: `i[0]`, `f[1]`, `data`, `result`.
        name: what it is.
        unit: its unit; "1" for a number without unit.
    """

    place: str
    name: str
    unit: str = "1"


@dataclass(frozen=True, slots=True)
class RequestCode:
    """One kind of request.

    Attributes:
        name: its name, `CRS_<name>` in C.
        code: its number.
        server: who answers it: the session as the program's host; the simulated robot, or
            the simulator that it lives in; or a device of `crs.h`, which needs no connection.
        prototype: the C function that posts it.
        meaning: what it does.
        arguments: what the message holds when it is posted.
        results: what the message holds when the program goes on.
        tells_state: whether that is all of `State`.
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
    """Return arguments or results: each place, name and unit."""
    return tuple(Argument(*row) for row in rows)
