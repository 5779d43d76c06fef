"""The origins of uninitialised bytes: a number in their states, which copies preserve.

Two bits of a state say that a byte is accessible and has no value, five are free: in the four bytes
of a word they are a number of 20 bits. It is that of the call which allocated a heap block, or,
from `FIRST_VARIABLE` on, that of a variable. Nothing is written but what is written anyway.

The first byte has the lowest five bits. Each of the others has five more, exclusive or the lowest:
so a byte of a small number is the same wherever it is in its word, and copies of single bytes
still say where they come from, see `diagnosis.origin`. A byte whose five bits are zero has no
origin, as the variables of the library have none.

>>> hex(pattern(0x12345))
'0x1f377f17'
>>> [part_of(0x12345, at) for at in range(4)], [part_of(7, at) for at in range(4)]
([5, 31, 13, 7], [7, 7, 7, 7])
"""

from __future__ import annotations

from typing import Final

from crs_cc.core.source import Location
from crs_cc.ir.instruction import ByteState, Register, Slot, Store
from crs_cc.ir.names import in_library
from crs_cc.ir.value_type import MEMORY_SIZE
from crs_cc.runtime.codegen import inline_ranges, shadow
from crs_cc.runtime.codegen.indices import SHADOW, SP, UNSET
from crs_cc.runtime.codegen.symbols import Symbols
from crs_cc.runtime.wasm import Code, Instr

FIRST_VARIABLE: Final = (1 << 19) + 1
WORD: Final = 4
_PART, _SHIFT = 31, 2
_PLAIN: Final = int.from_bytes([ByteState.WITHOUT_VALUE] * WORD, "little")


def pattern(number: int) -> int:
    """Return the states of the bytes of a word without value, as a number."""
    return _PLAIN + sum(part_of(number, at) << _SHIFT + 8 * at for at in range(WORD))


def part_of(number: int, at: int) -> int:
    """Return the part of a number that the byte at a place in its word has."""
    return (number >> 5 * at ^ (number if at else 0)) & _PART


def part_in(state: int) -> int | None:
    """Return the part of a number in the state of a byte; None if the byte has a value."""
    return state >> _SHIFT & _PART if state & 1 and not state >> 7 else None


def begin(slot: Slot, offset: int, location: Location, names: Symbols) -> list[Instr]:
    """Make a slot at SP + `offset` accessible, without value, in a function at some location."""
    sp: Instr = ("local.get", SP)
    if slot.variable is None or in_library(location):
        return shadow.fill(sp, offset, slot.size, ByteState.WITHOUT_VALUE)
    number = FIRST_VARIABLE + names.origin_number(slot.variable)
    if slot.size > inline_ranges.MAX_FILLED:
        at: list[Instr] = [sp, ("i32.const", offset), ("i32.add",)]
        return [*at, ("i32.const", slot.size), ("i32.const", number), ("call", UNSET)]
    code: list[Instr] = []
    step, starts = inline_ranges.words(slot.size)
    for start in starts:
        code += [sp, _states(number, offset + start, step)]
        code.append((inline_ranges.STORES[step], SHADOW, offset + start))
    return code


def states_of(it: Store, names: Symbols) -> Instr:
    """Push the states that a store writes if its value is none: those of a variable, if known."""
    size = MEMORY_SIZE[it.memory]
    variable = it.source.variable if isinstance(it.source, Register) else None
    if variable is None or in_library(it.location):
        return shadow.repeated(ByteState.WITHOUT_VALUE, size)
    number = FIRST_VARIABLE + names.origin_number(variable)
    if size < WORD:  # where in its word it is stored is not known
        number &= _PART
    return _states(number, 0, size)


def _states(number: int, address: int, size: int) -> Instr:
    """Push the states of `size` bytes at an address."""
    word = pattern(number).to_bytes(WORD, "little")
    states = bytes(word[(address + at) % WORD] for at in range(size))
    return (f"{shadow.kind(size)}.const", int.from_bytes(states, "little", signed=True))


def unset() -> Code:
    """`unset(address, size, number)`: make bytes accessible, without value."""
    address, size, number, word = 0, 1, 2, 3
    body: list[Instr] = [("i32.const", _PLAIN)]
    for at in range(WORD):
        body += [("local.get", number), ("i32.const", 5 * at), ("i32.shr_u",)]
        body += [("local.get", number), ("i32.xor",)] if at else []
        body += [("i32.const", _PART), ("i32.and",), ("i32.const", _SHIFT + 8 * at)]
        body += [("i32.shl",), ("i32.or",)]
    body += [
        ("local.get", address), ("i32.const", 8), ("i32.mul",), ("i32.rotr",),
        ("i64.extend_i32_u",), ("local.tee", word),
        ("local.get", word), ("i64.const", 32), ("i64.shl",), ("i64.or",), ("local.set", word),
        ("block",), ("loop",),
        ("local.get", size), ("i32.const", 8), ("i32.lt_u",), ("br_if", 1),
        ("local.get", address), ("local.get", word), shadow.store(8, 0),
        ("local.get", address), ("i32.const", 8), ("i32.add",), ("local.set", address),
        ("local.get", size), ("i32.const", 8), ("i32.sub",), ("local.set", size),
        ("br", 0), ("end",), ("end",),
        ("loop",),
        ("local.get", size), ("if",),
        ("local.get", address), ("local.get", word), ("i32.wrap_i64",), shadow.store(1, 0),
        ("local.get", word), ("i64.const", 8), ("i64.shr_u",), ("local.set", word),
        ("local.get", address), ("i32.const", 1), ("i32.add",), ("local.set", address),
        ("local.get", size), ("i32.const", 1), ("i32.sub",), ("local.set", size),
        ("br", 1), ("end",), ("end",),
    ]  # fmt: skip
    return Code("unset", (("i32", "i32", "i32"), ()), ["i64"], body)
