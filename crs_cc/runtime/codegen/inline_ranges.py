"""Short ranges of memory, of constant size, copied and filled without a call into the host.

Ranges are taken in words, the last of which may overlap the one before it.

>>> words(20)
(8, [0, 8, 12])
>>> words(3)
(2, [0, 1])
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Final, NamedTuple

from crs_cc.ir.instruction import Constant, Operand
from crs_cc.runtime.wasm import Instr


class Place(NamedTuple):
    """An address in a memory: the value that `base` pushes, plus `offset`."""

    memory: int
    base: Instr
    offset: int = 0


MAX_COPIED: Final = 64
"""Larger ranges are copied by `memory.copy` [bytes]."""
MAX_FILLED: Final = 256
"""Larger ranges are filled by `memory.fill` [bytes]."""

LOADS: Final = {1: "i32.load8_s", 2: "i32.load16_s", 4: "i32.load", 8: "i64.load"}
STORES: Final = {1: "i32.store8", 2: "i32.store16", 4: "i32.store", 8: "i64.store"}


def short(size: Operand, most: int) -> int:
    """Return the size of a short range; 0 if it is empty, long or unknown."""
    if isinstance(size, Constant) and 0 < size.value <= most:
        return int(size.value)
    return 0


def words(size: int) -> tuple[int, list[int]]:
    """Return the size of the words of a range, and their offsets; none of an empty one."""
    if not size:
        return 1, []
    step = next(each for each in (8, 4, 2, 1) if each <= size)
    offsets = list(range(0, size - step + 1, step))
    if size % step:
        offsets.append(size - step)
    return step, offsets


def copy(
    memory: int,
    target: Instr,
    source: Instr,
    size: int,
    offset: int = 0,
    *,
    change: Callable[[int], list[Instr]] | None = None,
) -> list[Instr]:
    """Copy a range, which may overlap itself: all of it is loaded first.

    Args:
        memory: index of the memory.
        target: pushes the address to copy to, less `offset`.
        source: pushes the address to copy from.
        size: number of bytes.
        offset: added to the target's address.
        change: returns the code that changes a word of some size on its way.
    """
    step, offsets = words(size)
    changed = change(step) if change else []
    code: list[Instr] = []
    for at in offsets:
        code += [target, source, (LOADS[step], memory, at), *changed]
    return code + [(STORES[step], memory, offset + at) for at in reversed(offsets)]


def fill(memory: int, target: Instr, offset: int, size: int, byte: int) -> list[Instr]:
    """Set all bytes of a range at `target` + `offset` to a constant."""
    step, offsets = words(size)
    kind = "i64" if step == 8 else "i32"
    word = (f"{kind}.const", int.from_bytes([byte & 0xFF] * step, "little", signed=True))
    code: list[Instr] = []
    for at in offsets:
        code += [target, word, (STORES[step], memory, offset + at)]
    return code


def copy_between(to: Place, source: Place, size: int) -> list[Instr]:
    """Copy a multiple of 16 bytes from one memory to another."""
    code: list[Instr] = []
    for at in range(0, size, 16):
        code += [to.base, source.base, ("v128.load", source.memory, source.offset + at)]
        code.append(("v128.store", to.memory, to.offset + at))
    return code


def fill_wide(memory: int, target: Instr, size: int, byte: int) -> list[Instr]:
    """Set a multiple of 16 bytes at `target` to a constant."""
    word = ("v128.const", int.from_bytes([byte & 0xFF] * 16, "little"))
    code: list[Instr] = []
    for at in range(0, size, 16):
        code += [target, word, ("v128.store", memory, at)]
    return code


def some_clear(memory: int, source: Instr, size: int, mask: int) -> list[Instr]:
    """Push whether, in some byte of a multiple of 16 at `source`, no bit of the mask is set."""
    code: list[Instr] = [("v128.const", int.from_bytes([mask] * 16, "little"))]
    for at in range(0, size, 16):
        code += [source, ("v128.load", memory, at), ("v128.and",)]
    return [*code, ("i8x16.all_true",), ("i32.eqz",)]
