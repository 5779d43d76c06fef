"""Which variables names mean where a program has stopped, and where these lie.

A name means the variable of the innermost block that has one of that name, whose declaration stands
before the place. Each variable has a `Home`: in the frame of its function or, if it is static, at a
fixed address.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final, Literal

from crs_cc.debug.memory import Saved
from crs_cc.ir.names import in_library, plain_name
from crs_cc.ir.program import Data, Program, Register, Variable
from crs_cc.runtime.compiled import Compiled, FunctionInfo
from crs_cc.runtime.diagnosis.inspect import StackFrame, Stopped
from crs_cc.runtime.layout import NULL_SIZE, RESUME
from crs_cc.session.library import HEADERS
from crs_cc.source import Location

_SYSTEM: Final = f"{HEADERS}/"
"""What the library's headers declare has its place there."""

Kind = Literal["parameter", "local", "static", "global"]


@dataclass(frozen=True, slots=True)
class Home:
    """Where a variable lies.

    Attributes:
        variable: the variable.
        kind: "static" is one that a function keeps.
        at: its address; of one in a frame, how far from the frame's lower end.
        in_frame: whether it lies in a frame.
        register: the register that it lives in while the program runs.
        flag: where it stands, from the frame's lower end, whether the register has a value.
        passed: where it was passed, from the frame's lower end, if it is a parameter.
    """

    variable: Variable
    kind: Kind
    at: int
    in_frame: bool = False
    register: Register | None = None
    flag: int | None = None
    passed: int | None = None


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
        elif not in_library(variable.location) and not variable.location.file.startswith(_SYSTEM):
            self._globals.append(Home(variable, "global", address))

    def globals_(self) -> list[Home]:
        """Gives the global variables of the user's own files, in the order of their names."""
        return sorted(self._globals, key=lambda each: (each.variable.name, each.variable.location))

    def of(self, function: str) -> list[Home]:
        """Gives all variables of a function, those of the innermost blocks first."""
        info = self._compiled.info(function)
        known = {(each.variable.name, each.variable.location): each for each in homes(info)}
        file = info.function.location.file
        statics = [
            each
            for each in self._statics.get(plain_name(function), ())
            if each.variable.location.file == file
        ]
        return sorted([*known.values(), *statics], key=_order, reverse=True)


def _order(home: Home) -> tuple[Location, Location, Location]:
    """Sorts outer blocks before inner ones, and in a block the last declaration first."""
    place = home.variable.location
    outside = Location(place.file)
    first, last = home.variable.block or (outside, outside)
    return first, last, Location(place.file, -place.line, -place.column)


def homes(info: FunctionInfo) -> Iterator[Home]:
    """Gives what lies in the frames of a function; one that lies twice counts at the last."""
    parameters = zip(info.function.parameters, info.frame.parameters, strict=True)
    passed = {each.place: offset for each, offset in parameters}
    for place, offset in info.frame.offsets.items():
        if place.variable is not None and place.variable.name:
            kind: Kind = "parameter" if place in passed else "local"
            register = place if isinstance(place, Register) else None
            flag = None if register is None else info.flags.get(register)
            at = None if flag is None else info.frame.offsets[flag]
            yield Home(place.variable, kind, offset, True, register, at, passed.get(place))


@dataclass(frozen=True, slots=True)
class Frame:
    """The frame of an active function, in which homes become addresses.

    Attributes:
        sp: its lower end.
        place: where the function stands: variables that are declared behind it have no values.
        unset: the registers that surely have none either.
    """

    sp: int
    place: Location
    unset: frozenset[Register] = frozenset()

    @classmethod
    def of(cls, stopped: Stopped, active: StackFrame | None) -> Frame:
        """Finds the frame; that of no function has nothing in it."""
        if active is None:
            return cls(0, Location(""))
        info = stopped.compiled.info(active.function)
        landing = int(stopped.memory[active.fp + RESUME :][:4].view("<u4")[0])
        stands_there = info.landings.get(landing) == active.location  # or else it has failed
        unset = info.unset.get(landing, frozenset()) if stands_there else frozenset()
        return cls(active.fp - info.frame.size, active.location, unset)

    def address(self, home: Home) -> int:
        """Gives the address of a variable."""
        if not home.in_frame:
            return home.at
        if self.sp < NULL_SIZE and home.passed is not None:  # there was no room for its frame
            return self.sp + home.passed
        return self.sp + home.at

    def saved(self, home: Home) -> Saved | None:
        """Gives a variable that lives in a register; None for all others."""
        if home.register is None:
            return None
        flag = None if home.flag is None else self.sp + home.flag
        variable = home.variable
        is_unset = home.register in self.unset or not variable.is_visible(self.place)
        return Saved(variable.name, variable.ctype, self.address(home), flag, is_unset)
