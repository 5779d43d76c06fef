"""Watchpoints: in watching builds every access is compared with the watched ranges.

A watching build is a debug build with the same frames and the same landings, so that a program can
be moved from one to the other wherever it has stopped; it runs in the slower one only while there
are watchpoints. The ranges are stored before the marks, see `runtime.watch_ranges`.

An access outside the watched ranges is ruled out quickly: for its variables, a function tests once
whether its frame overlaps a range; other addresses are compared with the bounds of
all ranges, and in `watch` with the grains that they touch.

The first access that counts stops the program before its next statement, regardless of the
breakpoints, and does not change them: stepping and watching are independent of each
other. A variable in a register is watched at its spill slot in the frame, where it is
when the program has stopped. The user's functions report their headers at entry and
exit, including `longjmp`, so that a watchpoint on a local variable lasts as long as its frame.

Each access in the user's files has a number, see `accesses`; for one in the library the calls that
led there are recorded (in checked builds).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from crs_cc.ir.instruction import (
    VARARGS,
    Base,
    Call,
    Constant,
    Copy,
    Fill,
    Instruction,
    Load,
    Operand,
    Register,
    SetJump,
    Slot,
    Statement,
    Store,
)
from crs_cc.ir.liveness import all_instructions, reads, writes
from crs_cc.ir.names import in_library
from crs_cc.ir.program import Program
from crs_cc.ir.value_type import MEMORY_SIZE
from crs_cc.runtime.codegen.indices import (
    ADDRESS,
    BEGUN_GLOBAL,
    FP,
    MARKS_GLOBAL,
    MEMORY,
    SP,
    SPAN_GLOBAL,
    WATCHED_GLOBAL,
)
from crs_cc.runtime.layout import RESULT
from crs_cc.runtime.sites import FRAME_BITS, FRAME_UNIT, SITE_BITS, StatementSite
from crs_cc.runtime.wasm import UNLIKELY, Code, FuncType, Instr
from crs_cc.runtime.watch_ranges import (
    CALLERS,
    ENTER,
    GRAIN,
    LONGEST,
    RANGE,
    READ,
    RETURN,
    WRITE,
    offset,
    range_offset,
)

if TYPE_CHECKING:
    from crs_cc.runtime.codegen.writer import Writer

_TYPE: Final[FuncType] = (("i32", "i32", "i32", "i32", "i32"), ())
_SIZES: Final = {"i32": 4, "i64": 8, "f32": 4, "f64": 8}


def accesses(program: Program) -> list[StatementSite]:
    """Return the statement of every numbered access, starting with number 1."""
    return [
        StatementSite(function.name, instruction.location)
        for function in program.functions.values()
        if not in_library(function.location)
        for block in function.blocks
        for instruction in all_instructions(block)
        if not isinstance(instruction, Statement)
    ]


class Watchpoints:
    """Writes the reports of the accesses of one function."""

    def __init__(self, writer: Writer, watch: int, marks: int, *, library: bool) -> None:
        """Set the writer, the indices of `watch` and the marks, and whether this is the library."""
        self._writer = writer
        self._watch = watch
        self._marks = marks
        self._library = library
        self._place = 0
        writer.local_types.append("i32")
        self._concerned = len(writer.local_types) + 1

    def test_frame(self) -> list[Instr]:
        """Return the code that tests whether the frame or the arguments are watched."""
        zero = ("i32.const", 0)
        return [
            ("local.get", SP), zero, ("i32.load", self._marks, offset("highest")), ("i32.lt_u",),
            ("local.get", SP), ("i32.const", self._writer.frame.varargs), ("i32.add",),
            zero, ("i32.load", self._marks, offset("lowest")), ("i32.gt_u",),
            ("i32.and",), ("local.set", self._concerned),
        ]  # fmt: skip

    def before(self, it: Instruction) -> None:
        """Report the reads and memory writes of an instruction, terminators included."""
        if not self._library:
            self._writer.names.accesses += 1
            self._place = self._writer.names.accesses
        for register in dict.fromkeys(reads(it)):
            self._register(register, READ)
        match it:
            case Load() | Store():
                access = READ if isinstance(it, Load) else WRITE
                self._access(it.base, it.offset, MEMORY_SIZE[it.memory], access)
            case Copy():
                self._report(it.source, it.size, READ)
                self._report(it.target, it.size, WRITE)
            case Fill():
                self._report(it.target, it.size, WRITE)
            case SetJump():
                self._report(it.buffer, Constant("i32", _SIZES["i32"]), WRITE)
            case Call():
                for each in (each for each in it.arguments if each.memory is None):
                    self._report(each.value, Constant("i32", each.size), READ)

    def after(self, it: Instruction) -> None:
        """Report the variable that an instruction has written."""
        result = writes(it)
        if result is not None:
            self._register(result, WRITE)

    def entering(self) -> list[Instr]:
        """Return the code that reports the start of the frame."""
        return [] if self._library else self._in_frame([("local.get", FP)], 1, ENTER)

    def returning(self) -> list[Instr]:
        """Return the code that reports the end of the frame."""
        return [] if self._library else self._in_frame([("local.get", FP)], 1, RETURN)

    def _register(self, register: Register, access: int) -> None:
        if register.variable is not None:
            at = self._writer.frame.offsets[register]
            place = [("local.get", SP), ("i32.const", at), ("i32.add",)]
            self._writer.code += self._in_frame(place, _SIZES[register.type], access)

    def _in_frame(self, place: list[Instr], size: int, access: int) -> list[Instr]:
        """Return the code that reports an access to the frame."""
        told = self._report_code(access)
        test: list[Instr] = [("local.get", self._concerned), UNLIKELY]
        return [*test, *place, ("i32.const", size), *told, ("end",)]

    def _access(self, base: Base, at: int, size: int, access: int) -> None:
        """Report an access that may be to a watched range."""
        writer = self._writer
        if isinstance(base, Slot) and base is not VARARGS:
            place = [
                ("local.get", SP),
                ("i32.const", writer.frame.offsets[base] + at),
                ("i32.add",),
            ]
            writer.code += self._in_frame(place, size, access)
            return
        writer.address(base, at)
        writer.code += [
            ("local.tee", ADDRESS), ("global.get", WATCHED_GLOBAL), ("i32.sub",),
            ("global.get", SPAN_GLOBAL), ("i32.lt_u",), UNLIKELY,
            ("local.get", ADDRESS), ("i32.const", size), *self._report_code(access), ("end",),
        ]  # fmt: skip

    def _report(self, address: Operand, size: Operand, access: int) -> None:
        self._writer.push(address)
        self._writer.push(size)
        self._writer.code += self._report_code(access)

    def _report_code(self, access: int) -> list[Instr]:
        place = [("i32.const", access), ("i32.const", self._place), ("local.get", FP)]
        return [*place, ("call", self._watch)]


def watch(marks: int, statements: int, *, checked: bool) -> Code:
    """Return `watch(address, size, access, place, fp)`, which compares an access with all ranges.

    Args:
        marks: index of the memory of the marks.
        statements: number of statements.
        checked: whether headers hold call words, see `sites`.
    """
    address, size, access, place, fp, at = range(6)

    def get(field: str) -> list[Instr]:
        return [("local.get", at), ("i32.load", marks, range_offset(field))]

    body: list[Instr] = [
        ("local.get", size), ("i32.const", LONGEST), ("i32.le_u",),
        ("i32.const", 0), ("i64.load", marks, offset("grains")),
        ("local.get", address), ("i32.const", GRAIN), ("i32.shr_u",), ("i64.extend_i32_u",),
        ("i64.shr_u",), ("i32.wrap_i64",), ("i32.const", 1), ("i32.and",), ("i32.eqz",),
        ("i32.and",), ("if",), ("return",), ("end",),
        ("i32.const", offset("ranges")), ("local.set", at),
        ("loop",),
        ("local.get", at), ("i32.const", 0), ("i32.load", marks, offset("end")), ("i32.ge_u",),
        ("if",), ("return",), ("end",),
        *get("kinds"), ("local.get", access), ("i32.and",), ("if",),
        ("global.get", BEGUN_GLOBAL),
        ("local.get", at), ("i64.load", marks, range_offset("since")), ("i64.ge_s",),
        # first < address + size, and address < first + size of the range
        ("local.get", at), ("i64.load32_u", marks, range_offset("first")),
        ("local.get", address), ("i64.extend_i32_u",),
        ("local.get", size), ("i64.extend_i32_u",), ("i64.add",), ("i64.lt_u",),
        ("local.get", address), ("i64.extend_i32_u",),
        ("local.get", at), ("i64.load32_u", marks, range_offset("first")),
        ("local.get", at), ("i64.load32_u", marks, range_offset("size")),
        ("i64.add",), ("i64.lt_u",),
        ("i32.and",), ("i32.and",), UNLIKELY,
        ("local.get", at), *get("hits"), ("local.get", access), ("i32.or",),
        ("i32.store", marks, range_offset("hits")),
        ("local.get", at), ("local.get", place), ("i32.store", marks, range_offset("place")),
        *(_callers(marks, place, fp, at) if checked else []),
        ("i32.const", 0), ("i32.const", 1), ("i32.store", marks, offset("pending")),
        ("i32.const", statements), ("global.set", MARKS_GLOBAL),
        ("end",), ("end",),
        ("local.get", at), ("i32.const", RANGE.itemsize), ("i32.add",), ("local.set", at),
        ("br", 0), ("end",),
    ]  # fmt: skip
    return Code("watch", _TYPE, ["i32", "i32", "i64", "i32"], body)


def _callers(marks: int, place: int, fp: int, at: int) -> list[Instr]:
    """Record the calls that led to an access in the library; the outermost header has none."""
    target, word, header = at + 1, at + 2, at + 3
    return [
        ("local.get", place), ("i32.eqz",), ("if",),
        ("local.get", fp), ("local.set", header),
        ("local.get", at), ("local.set", target),
        ("loop",),
        ("local.get", target),
        ("local.get", header), ("i64.load", MEMORY, RESULT), ("local.tee", word),
        ("i32.wrap_i64",), ("i32.const", (1 << SITE_BITS) - 1), ("i32.and",),
        ("i32.store", marks, range_offset("callers")),
        ("local.get", word), ("i64.const", SITE_BITS), ("i64.shr_u",), ("i32.wrap_i64",),
        ("i32.const", (1 << FRAME_BITS) - 1), ("i32.and",), ("i32.const", FRAME_UNIT), ("i32.mul",),
        ("local.get", header), ("i32.add",), ("local.set", header),
        ("local.get", target), ("i32.const", 4), ("i32.add",), ("local.tee", target),
        ("local.get", at), ("i32.const", 4 * CALLERS), ("i32.add",), ("i32.lt_u",),
        ("br_if", 0), ("end",), ("end",),
    ]  # fmt: skip


def update_bounds(marks: int, statements: int) -> list[Instr]:
    """Return the code of `resume` that updates the bounds of all ranges."""
    at = ("i32.const", 0)
    return [
        at, ("i32.load", marks, offset("first")), ("global.set", WATCHED_GLOBAL),
        at, ("i32.load", marks, offset("span")), ("global.set", SPAN_GLOBAL),
        at, ("i32.load", marks, offset("pending")), ("if",),
        ("i32.const", statements), ("global.set", MARKS_GLOBAL), ("end",),
    ]  # fmt: skip


def is_pending(marks: int) -> list[Instr]:
    """Add pending watchpoints to the test whether to stop before a statement."""
    return [("i32.const", 0), ("i32.load", marks, offset("pending")), ("i32.or",)]


def stops(marks: int) -> list[Instr]:
    """Return the code of a stop before a statement."""
    return [("i32.const", 0), ("i32.const", 0), ("i32.store", marks, offset("pending"))]
