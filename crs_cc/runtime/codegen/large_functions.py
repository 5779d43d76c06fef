"""Code of large functions: registers live in the frame, so that compiling takes linear time.

The host's register allocator joins the values of a local at every meeting of control flow, and the
time that it takes grows with the square of their number. In a large function each register that is
live across blocks has a home in the frame, where it is read and written; the locals that every
function has are globals instead. No value is then live from one block to the next.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Final

from crs_cc.ir.instruction import Call, Register, Request, SetJump, Statement
from crs_cc.ir.program import Function
from crs_cc.ir.value_type import ValueType
from crs_cc.runtime.codegen import jumps
from crs_cc.runtime.codegen.indices import ADDRESS, FUEL, LABEL, MEMORY, SITE, SP
from crs_cc.runtime.codegen.memory_instructions import LOADS, STORES
from crs_cc.runtime.codegen.registers import Registers
from crs_cc.runtime.wasm import Instr

MAX_BLOCKS: Final = 1000
"""Functions with more blocks are large."""

MAX_CHECKED: Final = 3000
MAX_IN_BLOCK: Final = 500
"""Limits on the instructions of checked functions and of their blocks.

Where a check fails, all registers are saved. The host computes their values there anew from what
was loaded, so that a hundred sums before a check are computed twice.
"""

MAX_WAYS: Final = 100_000
"""The limit on registers times places to resume; each of the former is joined at all the latter."""

_FIRST: Final = jumps.JUMP_SITE + 1

REPLACED: Final[dict[int, int]] = {
    local: _FIRST + number for number, local in enumerate((FUEL, LABEL, SITE, ADDRESS))
}
"""The global that replaces each local; a call leaves none of those with a value still needed."""

END: Final = _FIRST + len(REPLACED)
"""The first global after those."""

GLOBALS: Final[list[tuple[ValueType, int]]] = [
    ("i64", 0), ("i32", 0), ("i32", 0), ("i32", 0),
]  # fmt: skip


def homes_of(
    function: Function, registers: Registers, *, checked: bool, steps: bool
) -> dict[Register, Register]:
    """Return the registers that have a home, each with the one that stands for it in the frame.

    Args:
        function: the function.
        registers: its registers by lifetime.
        checked: whether it has checks.
        steps: whether the function can be resumed at every statement and return.
    """
    resumptions = len(registers.headers)
    for block in function.blocks:
        resumptions += isinstance(block.terminator, Call | Request | SetJump)
        if steps:
            resumptions += isinstance(block.terminator, Call)
            resumptions += sum(isinstance(each, Statement) for each in block.instructions)
    ways = resumptions * len(registers.lasting)
    sizes = [len(block.instructions) for block in function.blocks] if checked else [0]
    is_long = sum(sizes) > MAX_CHECKED or max(sizes) > MAX_IN_BLOCK
    if not is_long and len(function.blocks) <= MAX_BLOCKS and ways <= MAX_WAYS:
        return {}
    return {register: Register(-1, register.type) for register in registers.lasting}


def move_locals(
    body: Sequence[Instr],
    homes: Mapping[int, tuple[ValueType, int]],
    local_types: list[ValueType],
) -> list[Instr]:
    """Return the code of a function with its locals in the frame and in globals.

    Args:
        body: the code; it sets `SP` once.
        homes: the type of each local that has a home, and the home's offset from `SP`.
        local_types: the types of the locals after the parameters; new ones are appended.
    """
    scratch: dict[ValueType, int] = {}
    for kind in dict.fromkeys(kind for kind, _ in homes.values()):
        local_types.append(kind)
        scratch[kind] = len(local_types) + 1
    start = body.index(("local.set", SP)) + 1
    code = [*body[:start], ("local.get", FUEL), ("global.set", REPLACED[FUEL])]
    for instr in body[start:]:
        if not instr[0].startswith("local."):
            code.append(instr)
        elif instr[1] in REPLACED:
            code += _global(instr[0], REPLACED[instr[1]])
        elif instr[1] in homes:
            kind, offset = homes[instr[1]]
            code += _home(instr[0], kind, offset, scratch[kind])
        else:
            code.append(instr)
    return code


def _global(access: str, number: int) -> list[Instr]:
    if access == "local.tee":
        return [("global.set", number), ("global.get", number)]
    return [(access.replace("local", "global"), number)]


def _home(access: str, kind: ValueType, offset: int, scratch: int) -> list[Instr]:
    read: list[Instr] = [("local.get", SP), (LOADS[kind], MEMORY, offset)]
    if access == "local.get":
        return read
    write: list[Instr] = [("local.set", scratch), ("local.get", SP), ("local.get", scratch)]
    write.append((STORES[kind], MEMORY, offset))
    return write if access == "local.set" else write + read
