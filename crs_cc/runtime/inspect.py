"""What a stopped program's memory tells: which functions are active, and where each one is."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
import numpy.typing as npt

from crs_cc.runtime.codegen import HELPERS, Compiled
from crs_cc.runtime.layout import FUNCTION, HEADER_SIZE, NULL_SIZE, RESUME, STACK_TOP
from crs_cc.runtime.link import ROOT
from crs_cc.source import Location

DEEPEST: Final = (STACK_TOP - NULL_SIZE) // HEADER_SIZE


@dataclass(frozen=True, slots=True)
class StackFrame:
    """One active function.

    Attributes:
        function: its name.
        location: where it goes on; of the innermost function of a failed program, its head.
        fp: address of its header and arguments, see `layout`.
    """

    function: str
    location: Location
    fp: int


def call_stack(memory: npt.NDArray[np.uint8], compiled: Compiled) -> list[StackFrame]:
    """Gives the active functions of a program that has come back, the innermost first.

    A program that has damaged its own stack gets as many frames as make sense.
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
    return frames[::-1]


def _word(memory: npt.NDArray[np.uint8], address: int) -> int:
    return int(memory[address : address + 4].view("<u4")[0])
