"""The call stack of a stopped program, read from its memory."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final

from crs_cc.core.arrays import ByteArray
from crs_cc.core.source import Location
from crs_cc.ir.program import Program
from crs_cc.runtime.compiled import Compiled
from crs_cc.runtime.layout import FUNCTION, HEADER_SIZE, NULL_SIZE, RESUME, STACK_TOP, Frame
from crs_cc.runtime.link import ROOT

MOST_ACTIVE: Final = (STACK_TOP - NULL_SIZE) // HEADER_SIZE


@dataclass(frozen=True, slots=True)
class StackFrame:
    """An active call.

    Attributes:
        function: its name.
        location: where it will resume, or where it failed.
        fp: address of its header and arguments, see `layout`.
        entered: number of statements begun when it was entered; -1 if unknown.
    """

    function: str
    location: Location
    fp: int
    entered: int = -1


@dataclass(frozen=True, slots=True)
class Stopped:
    """A suspended or failed program, for inspection.

    Attributes:
        shadow: the states of its bytes; empty in unchecked builds.
        program: its IR.
        compiled: its code and debug information.
        lines: the lines of the user's files, by name.
        stack: its active calls, the innermost first.
        saved: whether registers have been saved to the frames, as always except after a trap.
    """

    memory: ByteArray
    shadow: ByteArray
    program: Program
    compiled: Compiled
    lines: Mapping[str, Sequence[str]]
    stack: tuple[StackFrame, ...]
    saved: bool = True

    def stack_pointer(self) -> int:
        """Return the lower end of the innermost frame, or of the stack if there is none."""
        if not self.stack:
            return NULL_SIZE
        innermost = self.stack[0]
        return innermost.fp - self.compiled.info(innermost.function).frame.size


def call_stack(
    memory: ByteArray, compiled: Compiled, failed_at: Location | None = None
) -> list[StackFrame]:
    """Return the active calls of a stopped program, the innermost first.

    Of a program that has corrupted its stack, as many frames as are valid.

    Args:
        memory: its memory.
        compiled: the program.
        failed_at: the location at which the innermost function failed, if it did.
    """
    numbers = compiled.numbers
    number, fp = numbers[ROOT], STACK_TOP - HEADER_SIZE
    frames: list[StackFrame] = []
    while len(frames) < MOST_ACTIVE:
        info = compiled.functions[number]
        landing = _word(memory, fp + RESUME)
        location = info.landings.get(landing, info.function.location)
        entered = _entered(memory, info.frame, fp) if landing else -1
        frames.append(StackFrame(info.function.name, location, fp, entered))
        if landing not in info.callees:
            break
        fp -= info.frame.size
        if fp < NULL_SIZE:
            break
        callee = info.callees[landing]
        known = numbers.get(callee) if isinstance(callee, str) else None
        number = _word(memory, fp + FUNCTION) - compiled.first_function if known is None else known
        if not 0 <= number < len(compiled.functions):
            break
    if failed_at is not None:
        frames[-1] = replace(frames[-1], location=failed_at)
    return frames[::-1]


def _entered(memory: ByteArray, frame: Frame, fp: int) -> int:
    at = fp - frame.size + frame.entered
    if frame.entered < 0 or at < NULL_SIZE:
        return -1
    return int(memory[at : at + 8].view("<i8")[0])


def _word(memory: ByteArray, address: int) -> int:
    return int(memory[address : address + 4].view("<u4")[0])
