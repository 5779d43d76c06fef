"""Watchpoints: in watching builds every access tells where it was, and is compared with ranges.

A watching build is a debug build with the same frames and the same landings, so that a program can
be moved from one to the other wherever it has stopped; only while something is watched it runs in
the slower one. The ranges lie in the memory `marks`, behind the marks, `RANGES` of them:

    bytes 0 to 3     the first address
    bytes 4 to 7     how many bytes, 0 for a range that is not in use
    bytes 8 to 11    which accesses count: `READ`, `WRITE` or both
    bytes 12 to 15   which accesses there were since somebody cleared this

Before them stand the first address of all bytes among which these ranges lie, less 7, and how many
they are: most accesses are elsewhere, and are found to be so where they happen.

The first access that counts marks all statements, so that the program stops before the next one.
A variable that lives in a register is watched at its place in the frame, where it is found when the
program has stopped.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from crs_cc.ir.program import (
    MEMORY_SIZE,
    Copy,
    Fill,
    Instruction,
    Load,
    Operand,
    Register,
    Store,
)
from crs_cc.ir.uses import reads, writes
from crs_cc.requests import slot_offset
from crs_cc.runtime.codegen.indices import (
    ADDRESS,
    MAILBOX,
    MARKS_GLOBAL,
    SLOT_GLOBAL,
    SP,
    SPAN_GLOBAL,
    WATCHED_GLOBAL,
)
from crs_cc.runtime.wasm import UNLIKELY, Code, FuncType, Instr

if TYPE_CHECKING:
    from crs_cc.runtime.codegen.writer import Writer

RANGES: Final = 8
RANGE_SIZE: Final = 16
WATCH_SIZE: Final = 8 + RANGES * RANGE_SIZE
READ, WRITE = 1, 2
"""What an access does."""

_TYPE: Final[FuncType] = (("i32", "i32", "i32"), ())
_SIZES: Final = {"i32": 4, "i64": 8, "f32": 4, "f64": 8}


class Watching:
    """Writes what tells of the accesses of one function."""

    def __init__(self, writer: Writer, watch: int) -> None:
        """Takes the function's writer, and the index of the module's function `watch`."""
        self._writer = writer
        self._watch = watch

    def before(self, it: Instruction) -> None:
        """Tells what an instruction, terminators too, reads."""
        for register in dict.fromkeys(reads(it)):
            self._register(register, READ)
        match it:
            case Load():
                self._writer.address(it.base, it.offset)
                self._compare(MEMORY_SIZE[it.memory], READ)
            case Store():
                self._writer.address(it.base, it.offset)
                self._compare(MEMORY_SIZE[it.memory], WRITE)
            case Copy():
                self._tell(it.source, it.size, READ)
                self._tell(it.target, it.size, WRITE)
            case Fill():
                self._tell(it.target, it.size, WRITE)

    def follow(self, it: Instruction) -> None:
        """Tells which variable an instruction has written."""
        result = writes(it)
        if result is not None:
            self._register(result, WRITE)

    def _register(self, register: Register, access: int) -> None:
        if register.variable is not None:
            at = self._writer.frame.offsets[register]
            self._writer.code += [("local.get", SP), ("i32.const", at), ("i32.add",)]
            self._compare(_SIZES[register.type], access)

    def _compare(self, size: int, access: int) -> None:
        """Tells of an access to the address that was pushed, where it may be a watched one."""
        self._writer.code += [
            ("local.tee", ADDRESS), ("global.get", WATCHED_GLOBAL), ("i32.sub",),
            ("global.get", SPAN_GLOBAL), ("i32.lt_u",), UNLIKELY,
            ("local.get", ADDRESS), ("i32.const", size), ("i32.const", access),
            ("call", self._watch), ("end",),
        ]  # fmt: skip

    def _tell(self, address: Operand, size: Operand, access: int) -> None:
        self._writer.push(address)
        self._writer.push(size)
        self._writer.code += [("i32.const", access), ("call", self._watch)]


def watch(marks: int, statements: int) -> Code:
    """Gives `watch(address, size, access)`, which compares an access with all ranges.

    Args:
        marks: index of the memory of the marks.
        statements: how many statements there are.
    """
    address, size, access, at = range(4)
    first = 2 * statements + 8
    body: list[Instr] = [
        ("i32.const", first), ("local.set", at),
        ("loop",),
        ("local.get", at), ("i32.load", marks, 4), ("if",),
        ("local.get", at), ("i32.load", marks, 8), ("local.get", access), ("i32.and",), ("if",),
        # first < address + size, and address < first + size of the range
        ("local.get", at), ("i64.load32_u", marks, 0),
        ("local.get", address), ("i64.extend_i32_u",),
        ("local.get", size), ("i64.extend_i32_u",), ("i64.add",), ("i64.lt_u",),
        ("local.get", address), ("i64.extend_i32_u",),
        ("local.get", at), ("i64.load32_u", marks, 0),
        ("local.get", at), ("i64.load32_u", marks, 4), ("i64.add",), ("i64.lt_u",),
        ("i32.and",), UNLIKELY,
        ("local.get", at),
        ("local.get", at), ("i32.load", marks, 12), ("local.get", access), ("i32.or",),
        ("i32.store", marks, 12),
        ("i32.const", statements), ("global.set", MARKS_GLOBAL),
        ("global.get", SLOT_GLOBAL), ("i32.const", 1),
        ("i32.store", MAILBOX, slot_offset("stop_before_all")),
        ("global.get", SLOT_GLOBAL), ("i64.const", 0),
        ("i64.store", MAILBOX, slot_offset("stop_from")),
        ("end",), ("end",), ("end",),
        ("local.get", at), ("i32.const", RANGE_SIZE), ("i32.add",), ("local.tee", at),
        ("i32.const", first + RANGES * RANGE_SIZE), ("i32.lt_u",), ("br_if", 0),
        ("end",),
    ]  # fmt: skip
    return Code("watch", _TYPE, ["i32"], body)


def watching_begins(marks: int, statements: int) -> list[Instr]:
    """Gives what `resume` does so that most accesses need not be told of."""
    at = ("i32.const", 2 * statements)
    return [
        at, ("i32.load", marks, 0), ("global.set", WATCHED_GLOBAL),
        at, ("i32.load", marks, 4), ("global.set", SPAN_GLOBAL),
    ]  # fmt: skip
