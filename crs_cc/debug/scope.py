"""Which variables names mean where a program has stopped, and where these lie.

A name means the variable of the innermost block that has one of that name, whose declaration stands
before the place. Each variable has a `Home`: in the frame of its function or, if it is static, at a
fixed address.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

from crs_cc.ir.names import in_library, plain_name
from crs_cc.ir.program import Data, Program, Register, Variable
from crs_cc.runtime.compiled import Compiled, FunctionInfo
from crs_cc.source import Location

Kind = Literal["parameter", "local", "static", "global"]


@dataclass(frozen=True, slots=True)
class Home:
    """Where a variable lies.

    Attributes:
        variable: the variable.
        kind: "static" is one that a function keeps.
        at: its address; of one in a frame, how far from the frame's lower end.
        in_frame: whether it lies in a frame.
        is_register: whether it lies there only while the program is stopped.
    """

    variable: Variable
    kind: Kind
    at: int
    in_frame: bool = False
    is_register: bool = False


class Scopes:
    """The variables of a program."""

    def __init__(self, program: Program, compiled: Compiled) -> None:
        self._compiled = compiled
        self._statics: dict[str, list[Home]] = {}
        self._globals: list[Home] = []
        for data in program.data.values():
            if data.variable is not None:
                self._enter(data, data.variable)

    def _enter(self, data: Data, variable: Variable) -> None:
        """Enters an object: `wander.c:turn.count` is a function's, `wander.c:count` is not."""
        address, name = self._compiled.addresses[data.name], plain_name(data.name)
        function, dot, _ = name.partition(".")
        if dot:
            self._statics.setdefault(function, []).append(Home(variable, "static", address))
        elif not in_library(variable.location):
            self._globals.append(Home(variable, "global", address))

    def globals_(self) -> list[Home]:
        """Gives the global variables of the user's own files, in the order of their names."""
        return sorted(self._globals, key=lambda each: (each.variable.name, each.variable.location))

    def of(self, function: str) -> list[Home]:
        """Gives all variables of a function, those of the innermost blocks first."""
        info = self._compiled.info(function)
        homes = {(each.variable.name, each.variable.location): each for each in _homes(info)}
        file = info.function.location.file
        statics = [
            each
            for each in self._statics.get(plain_name(function), ())
            if each.variable.location.file == file
        ]
        return sorted([*homes.values(), *statics], key=_order, reverse=True)


def _order(home: Home) -> tuple[Location, Location, Location]:
    """Sorts outer blocks before inner ones, and in a block the last declaration first."""
    place = home.variable.location
    outside = Location(place.file)
    first, last = home.variable.block or (outside, outside)
    return first, last, Location(place.file, -place.line, -place.column)


def _homes(info: FunctionInfo) -> Iterator[Home]:
    """Gives what lies in the frame of a function; of a variable that lies twice the last counts."""
    passed = {each.place for each in info.function.parameters}
    for place, offset in info.frame.offsets.items():
        if place.variable is not None and place.variable.name:
            kind: Kind = "parameter" if place in passed else "local"
            yield Home(place.variable, kind, offset, True, isinstance(place, Register))
