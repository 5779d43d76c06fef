"""Rows of the table of requests: one for each request, with typed fields and flags."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Final, Literal, TypeAlias

Server: TypeAlias = Literal["host", "network", "robot", "device"]
Link: TypeAlias = Literal["serial", "network", "none"]
DataType: TypeAlias = Literal["bytes", "int32", "float64"]

INFRARED: Final = 1
SONAR: Final = 2
BUMPER: Final = 4
LASER: Final = 8
COMPASS: Final = 16
"""Kinds of sensors, as in the vendor's header: POS_INFRARED to POS_COMPASS (`Nclient.h` 1.29)."""

ALL_SENSORS: Final = INFRARED | SONAR | BUMPER | LASER | COMPASS


@dataclass(frozen=True, slots=True)
class Field:
    """One argument or result of a request.

    Attributes:
        name: its name, an identifier.
        place: its position in the message, as written in Python: `i[0]`, `f[1]`, `size`, `data`,
            `result`.
        unit: its unit; "1" for a number without unit.
        meaning: its description.
        data_type: the type of the elements of `data`.
    """

    name: str
    place: str
    unit: str
    meaning: str
    data_type: DataType = "bytes"

    @property
    def position(self) -> tuple[str, int]:
        """Field of the message, and index in it: ("i", 0) for `i[0]`, ("size", -1) for `size`."""
        array, _, number = self.place.partition("[")
        return array, int(number.rstrip("]") or -1)


@dataclass(frozen=True, eq=False)
class Request:
    """One kind of request.

    Attributes:
        name: its name, `CRS_<name>` in C.
        code: its number.
        server: the part that answers it: the session as the program's host, or as the network; the
            simulated robot, or its simulator; or a device of `crs.h`.
        prototype: the C function that posts it.
        meaning: its effect.
        arguments: the contents of the message when it is posted.
        results: the contents of the message when the program continues.
        link: the link that transmits it: the robot's serial line, the network, or none, which takes
            no time.
        sends_data: whether its data is transmitted, too.
        needs_connection: whether it is refused while the robot is not connected.
        moves: whether it can make the robot move.
        changes_world: whether it can move objects; the program continues at the end of the cycle.
        waits: whether it can make the program wait.
        replies_state: whether the reply is all of `State`.
        sensors: the kinds of sensors whose readings that reply contains, a bit for each.
    """

    name: str
    code: int
    server: Server
    prototype: str
    meaning: str
    arguments: tuple[Field, ...] = ()
    results: tuple[Field, ...] = ()
    link: Link = "none"
    sends_data: bool = False
    needs_connection: bool = False
    moves: bool = False
    changes_world: bool = False
    waits: bool = False
    replies_state: bool = False
    sensors: int = 0

    @cached_property
    def traced(self) -> bool:
        """Whether the reply's message is kept for traces: it has results of its own."""
        if self.server in ("host", "network") or self.replies_state:
            return False
        return any(result.place != "result" for result in self.results)

    @cached_property
    def argument_positions(self) -> dict[str, tuple[str, int]]:
        """Position of each argument in the message, by name."""
        return {argument.name: argument.position for argument in self.arguments}

    @cached_property
    def result_positions(self) -> dict[str, tuple[str, int]]:
        """Position of each result in the message, by name."""
        return {result.name: result.position for result in self.results}


def fields(
    *rows: tuple[str, str, str, str] | tuple[str, str, str, str, DataType],
) -> tuple[Field, ...]:
    """Return fields from rows of name, place, unit, meaning and, for data, its type."""
    return tuple(Field(*row) for row in rows)
