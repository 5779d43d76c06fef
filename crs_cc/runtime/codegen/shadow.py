"""The shadow memory: the state of each byte of a program's memory.

A checked program has a second memory that C cannot address, with a byte for each byte of the
first: a `ByteState`. It spans the address space, 4 GiB, though only the part for the first
memory is ever written; so any pointer can be looked up without a range check, and a wild one
finds zero, inaccessible. The states are chosen so that one comparison suffices:

    all bytes may be read          the shadow bytes, as one number, are -1
    all bytes may be written       each shadow byte has its lowest bit set

Untouched pages of the shadow take no host memory. Everything below the stack pointer is always
inaccessible: a function makes its slots accessible at entry, and inaccessible
at exit.
"""

from __future__ import annotations

from typing import Final

from crs_cc.ir.instruction import ByteState
from crs_cc.ir.value_type import ValueType
from crs_cc.runtime.codegen import inline_ranges
from crs_cc.runtime.codegen.indices import MEMORY, SHADOW
from crs_cc.runtime.layout import RESULT
from crs_cc.runtime.sites import FRAME_BITS, FRAME_UNIT, SITE_BITS
from crs_cc.runtime.wasm import UNLIKELY, Code, FuncType, Instr

PAGES: Final = 65536


def kind(size: int) -> ValueType:
    """Return the integer type that holds the states of `size` bytes."""
    return "i64" if size == 8 else "i32"


def load(size: int, offset: int) -> Instr:
    """Replace an address on the stack by the states of its bytes, sign-extended."""
    return (inline_ranges.LOADS[size], SHADOW, offset)


def store(size: int, offset: int) -> Instr:
    """Set the states of the bytes at an address; address and states are on the stack."""
    return (inline_ranges.STORES[size], SHADOW, offset)


def repeated(state: int, size: int) -> Instr:
    """Push the states of `size` bytes that are all in the same state."""
    return (f"{kind(size)}.const", int.from_bytes([state] * size, "little", signed=True))


def not_readable(size: int) -> list[Instr]:
    """Replace states on the stack by whether some byte is inaccessible or uninitialised."""
    return [repeated(ByteState.WITH_VALUE, size), (f"{kind(size)}.ne",)]


def not_accessible(size: int) -> list[Instr]:
    """Replace states on the stack by whether some byte is inaccessible."""
    lowest = repeated(ByteState.WITHOUT_VALUE, size)
    return [lowest, (f"{kind(size)}.and",), lowest, (f"{kind(size)}.ne",)]


def fill(base: Instr, offset: int, size: int, state: int) -> list[Instr]:
    """Set the states of `size` bytes at `base + offset`; `base` is an instruction that pushes."""
    if size > inline_ranges.MOST_FILLED:
        at = [base, ("i32.const", offset), ("i32.add",)]
        return [*at, ("i32.const", state), ("i32.const", size), ("memory.fill", SHADOW)]
    return inline_ranges.fill(SHADOW, base, offset, size, state) if size else []


def some_inaccessible(base: Instr, size: int) -> list[list[Instr]]:
    """Return tests that push whether some of `size` bytes at an address is inaccessible.

    The first word is tested alone: those after it may be beyond the last address, where looking
    them up is a trap that does not say where.
    """
    step, offsets = inline_ranges.words(size)
    first = [base, load(step, offsets[0]), *not_accessible(step)]
    if len(offsets) == 1:
        return [first]
    code = [base, load(step, offsets[1])]
    for at in offsets[2:]:
        code += [base, load(step, at), (f"{kind(step)}.and",)]
    return [first, [*code, *not_accessible(step)]]


# Runtime functions called by checked code

_RANGE: Final[FuncType] = (("i32", "i32"), ("i64",))
FINE: Final = -1
"""The result of `inaccessible` if all bytes are accessible."""


def inaccessible() -> Code:
    """`inaccessible(address, size)`: the address of the first inaccessible byte, or `FINE`.

    It advances by eight bytes where possible.
    """
    address, left = 0, 1
    body = [
        ("block",), ("loop",),
        ("local.get", left), ("i32.const", 8), ("i32.lt_u",), ("br_if", 1),
        ("local.get", address), load(8, 0), *not_accessible(8), ("br_if", 1),
        ("local.get", address), ("i32.const", 8), ("i32.add",), ("local.set", address),
        ("local.get", left), ("i32.const", 8), ("i32.sub",), ("local.set", left),
        ("br", 0), ("end",), ("end",),
        ("loop",),
        ("local.get", left), ("i32.eqz",), ("if",), ("i64.const", FINE), ("return",), ("end",),
        ("local.get", address), load(1, 0), ("i32.eqz",), UNLIKELY,
        ("local.get", address), ("i64.extend_i32_u",), ("return",), ("end",),
        ("local.get", address), ("i32.const", 1), ("i32.add",), ("local.set", address),
        ("local.get", left), ("i32.const", 1), ("i32.sub",), ("local.set", left),
        ("br", 0), ("end",), ("unreachable",),
    ]  # fmt: skip
    return Code("inaccessible", _RANGE, [], body)


def callers() -> Code:
    """`callers(fp, target, count)`: store the numbers of `count` call sites, see `sites`."""
    fp, target, count, word = 0, 1, 2, 3
    frame = (1 << FRAME_BITS) - 1
    body = [
        ("loop",),
        ("local.get", target),
        ("local.get", fp), ("i64.load", MEMORY, RESULT), ("local.tee", word),
        ("i32.wrap_i64",), ("i32.const", (1 << SITE_BITS) - 1), ("i32.and",),
        ("i32.store", MEMORY, 0),
        ("local.get", word), ("i64.const", SITE_BITS), ("i64.shr_u",), ("i32.wrap_i64",),
        ("i32.const", frame), ("i32.and",), ("i32.const", FRAME_UNIT), ("i32.mul",),
        ("local.get", fp), ("i32.add",), ("local.set", fp),
        ("local.get", target), ("i32.const", 4), ("i32.add",), ("local.set", target),
        ("local.get", count), ("i32.const", 1), ("i32.sub",), ("local.tee", count),
        ("br_if", 0), ("end",),
    ]  # fmt: skip
    return Code("callers", (("i32", "i32", "i32"), ()), ["i64"], body)
