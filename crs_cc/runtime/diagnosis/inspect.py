"""The call stack of a stopped program, read from its memory."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from typing import Final, overload

import numpy as np
import numpy.typing as npt

from crs_cc.core.arrays import ByteArray
from crs_cc.core.source import Location
from crs_cc.ir.program import Program
from crs_cc.runtime.compiled import Compiled
from crs_cc.runtime.layout import FUNCTION, HEADER_SIZE, NULL_SIZE, RESUME, STACK_TOP, Frame
from crs_cc.runtime.link import ROOT

MAX_ACTIVE: Final = (STACK_TOP - NULL_SIZE) // HEADER_SIZE
_ROOM: Final = 16
"""For so many calls there is room at first."""


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
class StoppedProgram:
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
    stack: Sequence[StackFrame]
    saved: bool = True

    def stack_pointer(self) -> int:
        """Return the lower end of the innermost frame, or of the stack if there is none."""
        if not self.stack:
            return NULL_SIZE
        innermost = self.stack[0]
        return innermost.fp - self.compiled.info(innermost.function).frame.size


class CallStack(Sequence[StackFrame]):
    """The active calls of a program that is stopped again and again, the innermost first.

    Like a view of the memory it is valid until the program goes on. Only calls that have changed
    since the last time are read anew: to compare the words of memory that a call was read from
    takes nanoseconds, to read it takes a microsecond.

    Attributes:
        compiled: the program.
    """

    def __init__(self, compiled: Compiled) -> None:
        self.compiled = compiled
        self._frames: list[StackFrame] = []  # the outermost first
        self._numbers: list[int] = []  # of their functions
        self._places = np.empty((_ROOM, 2), np.intp)  # of their words: the header's, and `entered`
        self._words = np.empty((_ROOM, 2), np.int64)

    def __len__(self) -> int:
        return len(self._frames)

    @overload
    def __getitem__(self, index: int) -> StackFrame: ...

    @overload
    def __getitem__(self, index: slice) -> Sequence[StackFrame]: ...

    def __getitem__(self, index: int | slice) -> StackFrame | Sequence[StackFrame]:
        if isinstance(index, slice):
            return tuple(reversed(self._frames))[index]
        return self._frames[~index]

    def __iter__(self) -> Iterator[StackFrame]:
        return reversed(self._frames)

    def read(self, memory: ByteArray) -> None:
        """Read the active calls from the program's memory."""
        words = memory.view("<i8")
        same = self._unchanged(words)
        calls = _active_calls(memory, self.compiled)
        if same:  # the function of the next call is read from the last unchanged one
            start = self._numbers[same - 1], self._frames[same - 1].fp
            calls = islice(_active_calls(memory, self.compiled, start), 1, None)
        del self._frames[same:], self._numbers[same:]
        for number, frame in islice(calls, MAX_ACTIVE - same):
            self._keep(number, frame, words)

    def _unchanged(self, words: npt.NDArray[np.int64]) -> int:
        """Return how many of the outermost calls have not changed."""
        count = len(self._frames)
        known = self._words[:count].reshape(-1)
        differs = words[self._places[:count].reshape(-1)] != known
        at = int(differs.argmax()) if count else 0
        return at // 2 if count and differs[at] else count

    def _keep(self, number: int, frame: StackFrame, words: npt.NDArray[np.int64]) -> None:
        count = len(self._frames)
        if count == len(self._places):
            self._places = np.concatenate([self._places, np.empty_like(self._places)])
            self._words = np.concatenate([self._words, np.empty_like(self._words)])
        header = (frame.fp + FUNCTION) // 8
        entered = _entered_at(self.compiled.functions[number].frame, frame.fp)
        places = header, header if entered < 0 else entered // 8
        self._places[count] = places
        self._words[count] = words[places[0]], words[places[1]]
        self._frames.append(frame)
        self._numbers.append(number)


def refreshed(known: CallStack | None, memory: ByteArray, compiled: Compiled) -> CallStack:
    """Return the active calls of a stopped program.

    Args:
        known: those at an earlier stop, maybe in another build; they are not valid any more.
        memory: the program's memory.
        compiled: the program.
    """
    stack = known if known is not None and known.compiled is compiled else CallStack(compiled)
    stack.read(memory)
    return stack


def call_stack(
    memory: ByteArray, compiled: Compiled, failed_at: Location | None = None
) -> tuple[StackFrame, ...]:
    """Return the active calls of a stopped program, the innermost first.

    Of a program that has corrupted its stack, as many frames as are valid.

    Args:
        memory: its memory.
        compiled: the program.
        failed_at: the location at which the innermost function failed, if it did.
    """
    found = islice(_active_calls(memory, compiled), MAX_ACTIVE)
    frames = [frame for _, frame in found]
    if failed_at is not None:
        frames[-1] = replace(frames[-1], location=failed_at)
    return tuple(reversed(frames))


def _active_calls(
    memory: ByteArray, compiled: Compiled, start: tuple[int, int] | None = None
) -> Iterator[tuple[int, StackFrame]]:
    """Return active calls with the numbers of their functions, the outermost first.

    Args:
        memory: the program's memory.
        compiled: the program.
        start: the number of the first one's function, and the address of its frame; by default
            those of the outermost.
    """
    number, fp = start or (compiled.numbers[ROOT], STACK_TOP - HEADER_SIZE)
    while True:
        info = compiled.functions[number]
        landing = _word(memory, fp + RESUME)
        location = info.landings.get(landing, info.function.location)
        entered = _entered(memory, info.frame, fp) if landing else -1
        yield number, StackFrame(info.function.name, location, fp, entered)
        if landing not in info.callees:
            return
        fp -= info.frame.size
        if fp < NULL_SIZE:
            return
        callee = info.callees[landing]
        known = compiled.numbers.get(callee) if isinstance(callee, str) else None
        number = _word(memory, fp + FUNCTION) - compiled.first_function if known is None else known
        if not 0 <= number < len(compiled.functions):
            return


def _entered_at(frame: Frame, fp: int) -> int:
    """Return the address of the number of statements begun at a call; -1 if it is not stored."""
    at = fp - frame.size + frame.entered
    return -1 if frame.entered < 0 or at < NULL_SIZE else at


def _entered(memory: ByteArray, frame: Frame, fp: int) -> int:
    at = _entered_at(frame, fp)
    return -1 if at < 0 else int(memory[at : at + 8].view("<i8")[0])


def _word(memory: ByteArray, address: int) -> int:
    return int(memory[address : address + 4].view("<u4")[0])
