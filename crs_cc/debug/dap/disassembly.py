"""Disassembly: functions as lines of IR, each with an address.

A client may do arithmetic with addresses. So each line has one, made of
the robot, the function and the line, with a gap before the first line.

>>> CodeAddress.decode(CodeAddress(2, 7, 3).encode())
CodeAddress(robot=2, function=7, line=3)
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Final, Self

from crs_cc.core.source import Location
from crs_cc.debug.dap.arguments import RefusalError
from crs_cc.debug.program import DebugProgram
from crs_cc.ir.program import Function
from crs_cc.ir.text import FunctionText

_ROOM: Final = 2**20  # for the lines of a function, and before and behind them
_FUNCTIONS: Final = 2**20
_MIDDLE: Final = _ROOM // 2
_COMMENT: Final = re.compile(r"\s*; (.*)$")
_PLACE: Final = re.compile(r"(?:(.+):)?(\d+):(\d+)$")


@dataclass(frozen=True, slots=True)
class CodeAddress:
    """The address of a line of code.

    Attributes:
        robot: the robot whose program it is in.
        function: the number of the function.
        line: the number of the line, maybe outside of the function.
    """

    robot: int
    function: int
    line: int

    def reaches(self, line: int) -> bool:
        """Return whether a line number has an address in this function."""
        return 0 <= _MIDDLE + line < _ROOM

    def encode(self) -> int:
        """Return the address as a number."""
        assert self.reaches(self.line)
        return ((self.robot + 1) * _FUNCTIONS + self.function) * _ROOM + _MIDDLE + self.line

    @classmethod
    def decode(cls, number: int) -> Self:
        """Return the address for a number."""
        rest, line = divmod(number, _ROOM)
        robot, function = divmod(rest, _FUNCTIONS)
        return cls(robot - 1, function, line - _MIDDLE)

    @classmethod
    def read(cls, text: str) -> Self:
        """Parse an address from a client; raise RefusalError if it is invalid."""
        if not re.fullmatch(r"0x[0-9a-fA-F]{1,16}", text):
            raise RefusalError(f"'{text[:40]}' is not a code address")
        return cls.decode(int(text, 16))


@dataclass(frozen=True, slots=True)
class CodeLine:
    """A line of code.

    Attributes:
        text: the instruction.
        location: the location in the source; None for headings.
    """

    text: str
    location: Location | None


@lru_cache(maxsize=256)
def code_of(function: Function) -> Sequence[CodeLine]:
    """Return the code of a function."""
    lines: list[CodeLine] = []
    place = function.location
    for line in FunctionText(function).render().splitlines():
        comment = _COMMENT.search(line)
        text = line[: comment.start()] if comment else line
        found = _PLACE.match(comment[1]) if comment else None
        if found is not None:
            place = Location(found[1] or function.location.file, int(found[2]), int(found[3]))
        is_instruction = text.startswith("  ") and bool(lines)
        lines.append(CodeLine(text.rstrip(), place if is_instruction else None))
    return tuple(lines)


def address_of(program: DebugProgram, robot: int, name: str, location: Location) -> int:
    """Return the address of the first instruction for a location in a function."""
    functions = program.executable.program.functions
    rows = code_of(functions[name])
    line = next((n for n, each in enumerate(rows) if each.location == location), 0)
    return CodeAddress(robot, list(functions).index(name), line).encode()
