"""What a stopped program's memory tells: the active functions, where each is, and its variables."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Final

import numpy as np
import numpy.typing as npt

from crs_cc.ir.program import Variable
from crs_cc.ir.types import ArrayType, VoidType
from crs_cc.runtime.codegen import HELPERS, Compiled
from crs_cc.runtime.layout import (
    FUNCTION,
    HEADER_SIZE,
    MEMORY_BYTES,
    NULL_SIZE,
    RESUME,
    STACK_TOP,
)
from crs_cc.runtime.link import ROOT
from crs_cc.runtime.objects import find_object
from crs_cc.runtime.values import Values, place_name
from crs_cc.source import Location

if TYPE_CHECKING:
    from crs_cc.ir.types import CType
    from crs_cc.runtime.executable import Detail
    from crs_cc.runtime.function_code import FunctionInfo

DEEPEST: Final = (STACK_TOP - NULL_SIZE) // HEADER_SIZE


@dataclass(frozen=True, slots=True)
class StackFrame:
    """One active function.

    Attributes:
        function: its name.
        location: where it goes on, or where it failed.
        fp: address of its header and arguments, see `layout`.
    """

    function: str
    location: Location
    fp: int


def call_stack(
    memory: npt.NDArray[np.uint8], compiled: Compiled, failed_at: Location | None = None
) -> list[StackFrame]:
    """Gives the active functions of a program that has come back, the innermost first.

    A program that has damaged its own stack gets as many frames as make sense.

    Args:
        memory: its memory.
        compiled: the program.
        failed_at: where the innermost function failed, if it did.
    """
    numbers = {info.function.name: n for n, info in enumerate(compiled.functions)}
    number, fp = numbers[ROOT], STACK_TOP - HEADER_SIZE
    frames: list[StackFrame] = []
    while len(frames) < DEEPEST:
        info = compiled.functions[number]
        landing = _word(memory, fp + RESUME)
        location = info.landings.get(landing, info.function.location)
        frames.append(StackFrame(info.function.name, location, fp))
        if landing not in info.callees:
            break
        fp -= info.frame.size
        if fp < NULL_SIZE:
            break
        callee = info.callees[landing]
        known = numbers.get(callee) if isinstance(callee, str) else None
        number = _word(memory, fp + FUNCTION) - HELPERS if known is None else known
        if not 0 <= number < len(compiled.functions):
            break
    if failed_at is not None:
        frames[-1] = replace(frames[-1], location=failed_at)
    return frames[::-1]


@dataclass(frozen=True)
class StoppedProgram:
    """A program that has come back, and what is needed to read its memory.

    Attributes:
        memory: its memory, shape (MEMORY_BYTES,).
        detail: the program.
        stack: its active functions, the innermost first.
    """

    memory: npt.NDArray[np.uint8]
    detail: Detail
    stack: tuple[StackFrame, ...]

    def read(self, address: int, size: int) -> bytes:
        """Gives the bytes at an address, as many as are accessible."""
        if address < NULL_SIZE:
            return b""
        return self.memory[address : min(address + size, MEMORY_BYTES)].tobytes()

    @cached_property
    def values(self) -> Values:
        """Gives what writes the values of variables."""
        functions = self.detail.program.functions
        addresses = self.detail.compiled.addresses
        pointers = {addresses[name]: name for name in functions if name in addresses}
        return Values(
            self.read,
            self.name_of_place,
            lambda number: plain_name(pointers[number]) if number in pointers else "",
        )

    @cached_property
    def infos(self) -> dict[str, FunctionInfo]:
        """Gives how the frames of each function look, by its name."""
        return {info.function.name: info for info in self.detail.compiled.functions}

    def name_of_place(self, address: int, target: CType) -> str:
        """Names a variable, or the part of it, that a pointer points to; "" when unknown."""
        found = find_object(address, self.detail.program, self.detail.compiled, self.stack)
        if found is None or found.variable is None or found.distance(address):
            return ""
        offset = address - found.address
        ctype = found.variable.ctype
        if isinstance(ctype, ArrayType) and offset == 0:
            return found.name
        if isinstance(target, VoidType) and offset == 0:
            return f"&{found.name}"
        return "&" + place_name(found.name, ctype, offset, target)

    def arguments(self, frame: StackFrame) -> list[tuple[Variable, bytes]]:
        """Gives the parameters of an active function with the values that were passed."""
        info = self.infos[frame.function]
        found = []
        for parameter, offset in zip(info.function.parameters, info.frame.parameters, strict=True):
            variable = parameter.variable or parameter.place.variable
            if variable is not None:
                address = frame.fp - info.frame.size + offset
                found.append((variable, self.read(address, variable.ctype.size)))
        return found

    def variables(self, frame: StackFrame) -> Iterator[tuple[Variable, bytes]]:
        """Gives the variables of an active function with their present values."""
        info = self.infos[frame.function]
        sp = frame.fp - info.frame.size
        if sp < NULL_SIZE:  # there was no room for its frame
            yield from self.arguments(frame)
            return
        for place, offset in info.frame.offsets.items():
            if place.variable is not None:
                yield place.variable, self.read(sp + offset, place.variable.ctype.size)

    def variable(self, name: str, frame: StackFrame) -> tuple[Variable, bytes] | None:
        """Gives the variable that a name means where an active function is, and its value."""
        place = frame.location
        seen = [
            (variable.location, number, (variable, content))
            for number, (variable, content) in enumerate(self.variables(frame))
            if variable.name == name and variable.location <= place
        ]
        if seen:
            return max(seen)[2]
        static = f"{place.file}:{plain_name(frame.function)}.{name}"
        for wanted in (static, f"{place.file}:{name}", name):
            data = self.detail.program.data.get(wanted)
            if data is not None and data.variable is not None:
                content = self.read(self.detail.compiled.addresses[wanted], data.size)
                return data.variable, content
        return None


def plain_name(function: str) -> str:
    """Gives a function's name as the programmer knows it."""
    return function.rpartition(":")[2]


def _word(memory: npt.NDArray[np.uint8], address: int) -> int:
    return int(memory[address : address + 4].view("<u4")[0])
