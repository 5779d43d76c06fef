"""The spill slots of a function's registers in its frame, used while it is suspended.

In debug builds spill slots are zero while a function runs, and so is the landing in the header. So
a function that has stopped and resumed has the same bytes as one that has not, and leaves the same
on the stack: earlier stops of a debugger change nothing.
"""

from __future__ import annotations

from typing import Final

from crs_cc.ir.instruction import Constant, Register
from crs_cc.runtime.codegen.indices import FP, LABEL, MEMORY, SP
from crs_cc.runtime.codegen.writer import Writer
from crs_cc.runtime.layout import FUNCTION, RESUME, Frame
from crs_cc.runtime.wasm import Instr

MAX_INLINE: Final = 64
"""More bytes than this are cleared by `memory.fill`, which is a call into the host."""

_SIZES: Final = {"i32": 4, "f32": 4, "i64": 8, "f64": 8}


def save(writer: Writer, frame: Frame, saved: list[Register], function: int) -> None:
    """Store registers to their spill slots, and function and landing to the header."""
    for register in saved:
        writer.store_at(SP, frame.offsets[register], register, register.type)
    writer.code += [("local.get", FP), ("local.get", LABEL), ("i32.store", MEMORY, RESUME)]
    writer.store_at(FP, FUNCTION, Constant("i32", function), "i32")


def load(writer: Writer, frame: Frame, saved: list[Register], *, debug: bool) -> None:
    """Load registers from their spill slots; in debug builds, clear these and the header."""
    for register in saved:
        writer.load_at(SP, frame.offsets[register], register.type)
        writer.pop(register)
    if debug:
        writer.code += clear(frame, saved)
        writer.code += [("local.get", FP), ("i64.const", 0), ("i64.store", MEMORY, FUNCTION)]


def clear(frame: Frame, saved: list[Register]) -> list[Instr]:
    """Return the code that clears spill slots."""
    if not saved:
        return []
    start = min(frame.offsets[register] for register in saved)
    end = max(frame.offsets[register] + _SIZES[register.type] for register in saved)
    if end - start > MAX_INLINE:
        at: list[Instr] = [("local.get", SP), ("i32.const", start), ("i32.add",), ("i32.const", 0)]
        return [*at, ("i32.const", end - start), ("memory.fill", MEMORY)]
    code: list[Instr] = []
    while start < end:
        size = 8 if start % 8 == 0 and end - start >= 8 else 4
        kind = f"i{8 * size}"
        code += [("local.get", SP), (f"{kind}.const", 0), (f"{kind}.store", MEMORY, start)]
        start += size
    return code
