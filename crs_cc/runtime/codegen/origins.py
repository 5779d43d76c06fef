"""Where bytes without value come from: a number in their states, which copies keep.

Two bits of a state say that a byte is accessible and has no value, five are free: in the four bytes
of a word they are a number of 20 bits. It is that of the call which allocated a heap block, or,
counted down from the greatest, that of a variable. Nothing is written but what is written anyway.
A word that was copied to another place in its word, or narrowed, has no origin; nor have the
variables of the library.

>>> hex(pattern(0x12345))
'0xb236b17'
>>> number_of(pattern(0x12345).to_bytes(4, "little")) == 0x12345
True
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

UNKNOWN: Final = 0
GREATEST: Final = (1 << 20) - 1
_PART, _SHIFT, _WORD = 31, 2, 4
_PLAIN: Final = int.from_bytes([ByteState.WITHOUT_VALUE] * _WORD, "little")


def pattern(number: int) -> int:
    """Return the states of the bytes of a word without value, as a number."""
    parts = ((number >> 5 * at & _PART) << _SHIFT + 8 * at for at in range(_WORD))
    return _PLAIN + sum(parts)


def number_of(states: bytes) -> int:
    """Return the number of the origin of a word; 0 if it is not known."""
    if len(states) != _WORD or any(state >> 7 or not state & 1 for state in states):
        return UNKNOWN
    return sum((state >> _SHIFT & _PART) << 5 * at for at, state in enumerate(states))


def begin(slot: Slot, offset: int, place: Location, names: Symbols) -> list[Instr]:
    """Make a slot at SP + `offset` accessible, without value, in a function at some location."""
    sp: Instr = ("local.get", SP)
    if slot.variable is None or in_library(place) or slot.size < _WORD:
        return shadow.fill(sp, offset, slot.size, ByteState.WITHOUT_VALUE)
    number = GREATEST - names.origin_number(slot.variable)
    if slot.size > inline_ranges.MOST_FILLED:
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
    if variable is None or size < _WORD or in_library(it.location):
        return shadow.repeated(ByteState.WITHOUT_VALUE, size)
    return _states(GREATEST - names.origin_number(variable), 0, size)


def _states(number: int, address: int, size: int) -> Instr:
    """Push the states of `size` bytes at an address."""
    word = pattern(number).to_bytes(_WORD, "little")
    states = bytes(word[(address + at) % _WORD] for at in range(size))
    return (f"{shadow.kind(size)}.const", int.from_bytes(states, "little", signed=True))


def unset() -> Code:
    """`unset(address, size, number)`: make bytes accessible, without value."""
    address, size, number, word = 0, 1, 2, 3
    body: list[Instr] = [("i32.const", _PLAIN)]
    for at in range(_WORD):
        body += [("local.get", number), ("i32.const", 5 * at), ("i32.shr_u",)]
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
