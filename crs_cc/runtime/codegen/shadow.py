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

ACCESSIBLE: Final = 1
WRITABLE: Final = 2
READABLE: Final = 0x80
"""Bits of a `ByteState`."""


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


def not_all_valid(size: int) -> list[Instr]:
    """Replace states on the stack by whether some byte is not writable and initialised."""
    return [repeated(ByteState.WITH_VALUE, size), (f"{kind(size)}.ne",)]


def any_without(bits: int, size: int) -> list[Instr]:
    """Replace states on the stack by whether some byte lacks some of these bits."""
    mask = repeated(bits, size)
    if size == 1 and bits == READABLE:
        return [("i32.const", 0), ("i32.ge_s",)]
    return [mask, (f"{kind(size)}.and",), mask, (f"{kind(size)}.ne",)]


def unsealing(size: int) -> list[Instr]:
    """Make the states on the stack those of a copy, which may be written."""
    return [repeated(WRITABLE, size), (f"{kind(size)}.or",)]


def fill(base: Instr, offset: int, size: int, state: int) -> list[Instr]:
    """Set the states of `size` bytes at `base + offset`; `base` is an instruction that pushes."""
    if size > inline_ranges.MAX_FILLED:
        at = [base, ("i32.const", offset), ("i32.add",)]
        return [*at, ("i32.const", state), ("i32.const", size), ("memory.fill", SHADOW)]
    return inline_ranges.fill(SHADOW, base, offset, size, state) if size else []


def any_in_range_without(bits: int, base: Instr, size: int) -> list[list[Instr]]:
    """Return tests that push whether some of `size` bytes at an address lacks some of these bits.

    The first word is tested alone: those after it may be beyond the last address, where looking
    them up is a trap that does not say where.
    """
    step, offsets = inline_ranges.words(size)
    first = [base, load(step, offsets[0]), *any_without(bits, step)]
    if len(offsets) == 1:
        return [first]
    code = [base, load(step, offsets[1])]
    for at in offsets[2:]:
        code += [base, load(step, at), (f"{kind(step)}.and",)]
    return [first, [*code, *any_without(bits, step)]]


# Runtime functions called by checked code

_RANGE: Final[FuncType] = (("i32", "i32", "i64"), ("i64",))
FINE: Final = -1
SOME_CONSTANT: Final = -2
"""Results of `inaccessible`, which are negative, if all bytes are accessible."""


def inaccessible() -> Code:
    """`inaccessible(address, size, bits)`: the address of the first byte that lacks the bit.

    If there is none, it is `FINE`, or `SOME_CONSTANT` if some may not be written. `bits` has the
    bit in each byte. It advances by 32 bytes where possible, then by eight. Addresses from 2 GiB on
    belong to no object: 32 bytes there might go beyond the shadow.
    """
    address, left, bits, word, all_states = 0, 1, 2, 3, 4
    join = [("local.get", all_states), ("i64.and",), ("local.set", all_states)]
    four = [("local.get", address), load(8, 0)]
    for offset in (8, 16, 24):
        four += [("local.get", address), load(8, offset), ("i64.and",)]
    body = [
        ("i64.const", -1), ("local.set", all_states),
        ("block",),
        ("local.get", address), ("i32.const", 0), ("i32.lt_s",), ("br_if", 0),
        ("loop",),
        ("local.get", left), ("i32.const", 32), ("i32.lt_u",), ("br_if", 1),
        *four, ("local.tee", word),
        ("local.get", bits), ("i64.and",), ("local.get", bits), ("i64.ne",), ("br_if", 1),
        ("local.get", word), *join,
        ("local.get", address), ("i32.const", 32), ("i32.add",), ("local.set", address),
        ("local.get", left), ("i32.const", 32), ("i32.sub",), ("local.set", left),
        ("br", 0), ("end",), ("end",),
        ("block",), ("loop",),
        ("local.get", left), ("i32.const", 8), ("i32.lt_u",), ("br_if", 1),
        ("local.get", address), load(8, 0), ("local.tee", word),
        ("local.get", bits), ("i64.and",), ("local.get", bits), ("i64.ne",), ("br_if", 1),
        ("local.get", word), *join,
        ("local.get", address), ("i32.const", 8), ("i32.add",), ("local.set", address),
        ("local.get", left), ("i32.const", 8), ("i32.sub",), ("local.set", left),
        ("br", 0), ("end",), ("end",),
        ("loop",),
        ("local.get", left), ("i32.eqz",), ("if",),
        ("i64.const", FINE), ("i64.const", SOME_CONSTANT),
        ("local.get", all_states), repeated(WRITABLE, 8), ("i64.and",),
        repeated(WRITABLE, 8), ("i64.eq",), ("select",), ("return",), ("end",),
        ("local.get", address), ("i32.load8_u", SHADOW, 0), ("i64.extend_i32_u",),
        ("local.tee", word), ("local.get", bits), ("i64.const", 255), ("i64.and",), ("i64.and",),
        ("i64.eqz",), UNLIKELY,
        ("local.get", address), ("i64.extend_i32_u",), ("return",), ("end",),
        ("local.get", word), ("i64.const", -256), ("i64.or",), *join,
        ("local.get", address), ("i32.const", 1), ("i32.add",), ("local.set", address),
        ("local.get", left), ("i32.const", 1), ("i32.sub",), ("local.set", left),
        ("br", 0), ("end",), ("unreachable",),
    ]  # fmt: skip
    return Code("inaccessible", _RANGE, ["i64", "i64"], body)


def unsealed() -> Code:
    """`unsealed(address, size)`: make constant bytes, which were copied there, writable."""
    address, left = 0, 1
    body = [
        ("loop",),
        ("local.get", left), ("if",),
        ("local.get", address), ("local.get", address), load(1, 0), *unsealing(1), store(1, 0),
        ("local.get", address), ("i32.const", 1), ("i32.add",), ("local.set", address),
        ("local.get", left), ("i32.const", 1), ("i32.sub",), ("local.set", left),
        ("br", 1), ("end",), ("end",),
    ]  # fmt: skip
    return Code("unsealed", (("i32", "i32"), ()), [], body)


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
