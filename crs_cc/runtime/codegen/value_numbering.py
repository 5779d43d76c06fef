"""Value numbering of addresses: which registers differ by known constants, within a block.

Every value is represented by a root and an offset: registers with the same root differ by a
constant. Registers computed equally from the same values have the same root, so `a[i]`, `a[i + 1]`
and a second `a[i]` are known to be adjacent.

>>> from crs_cc.ir.instruction import Binary, Constant, Register
>>> from crs_cc.core.source import Location
>>> a, i, b = (Register(n, "i32") for n in range(3))
>>> places = ValueNumbers()
>>> before = places.of(a, 4)
>>> places.update(Binary(Location("x.c"), b, "i32.add", a, Constant("i32", 4)))
>>> places.of(b, 0) == before
True
"""

from __future__ import annotations

from collections.abc import Container
from typing import Final, TypeAlias

from crs_cc.ir.instruction import (
    Address,
    Base,
    Binary,
    Block,
    Branch,
    Call,
    Constant,
    Instruction,
    Jump,
    Move,
    Operand,
    Register,
    Slot,
    Switch,
)
from crs_cc.ir.liveness import writes
from crs_cc.ir.program import Function

Root: TypeAlias = "int | Slot | str"
"""An unknown value, by number; a slot; a global object."""

_PURE: Final = frozenset({"i32.add", "i32.sub", "i32.mul", "i32.shl", "i32.and"})


class ValueNumbers:
    """The known values of registers at one point of a block."""

    def __init__(self) -> None:
        self._origins: dict[Register, tuple[Root | None, int]] = {}
        self._computed: dict[tuple[object, ...], int] = {}
        self._count = 0

    def copy(self) -> ValueNumbers:
        """Return a copy of the values, to continue from another point."""
        same = ValueNumbers()
        same._origins, same._computed = self._origins.copy(), self._computed.copy()
        same._count = self._count
        return same

    def of(self, base: Base, offset: int) -> tuple[Root | None, int]:
        """Return the root and offset of an address; a constant has no root."""
        if not isinstance(base, Register):
            return base, offset
        root, distance = self._origin(base)
        return root, distance + offset

    def update(self, it: Instruction) -> None:
        """Update the values after an instruction."""
        target = writes(it)
        if target is None or target.type != "i32":
            return
        match it:
            case Move(source=source):
                self._origins[target] = self._origin(source)
            case Address(base=base, offset=offset):
                self._origins[target] = self.of(base, offset)
            case Binary(op=op) if op in _PURE:
                self._origins[target] = self._result(it)
            case _:
                self._origins[target] = self._new(), 0

    def value(self, operand: Operand) -> tuple[Root | None, int]:
        """Return the root and offset of a value."""
        return self._origin(operand)

    def _origin(self, operand: Operand) -> tuple[Root | None, int]:
        if isinstance(operand, Constant):
            return None, int(operand.value)
        found = self._origins.get(operand)
        if found is None:
            found = self._origins[operand] = self._new(), 0
        return found

    def _new(self) -> int:
        self._count += 1
        return self._count

    def _result(self, it: Binary) -> tuple[Root | None, int]:
        (left, left_offset), (right, right_offset) = self._origin(it.left), self._origin(it.right)
        if it.op == "i32.add" and (left is None or right is None):
            return left if right is None else right, left_offset + right_offset
        if it.op == "i32.sub" and right is None:
            return left, left_offset - right_offset
        shift = 0
        if it.op == "i32.add":  # reassociate constants
            shift = left_offset + right_offset
            left_offset = right_offset = 0
        key = (it.op, left, left_offset, right, right_offset)
        if key not in self._computed:
            self._computed[key] = self._new()
        return self._computed[key], shift


class KnownBytes:
    """The bytes known to be accessible, or also initialised."""

    def __init__(self) -> None:
        self._ranges: dict[tuple[Root | None, bool], list[tuple[int, int]]] = {}

    def copy(self) -> KnownBytes:
        """Return a copy of the ranges, to continue from another point."""
        same = KnownBytes()
        same._ranges = self._ranges.copy()
        return same

    def forget_values(self) -> None:
        """Discard the initialised bytes; keep the accessible ones."""
        self._ranges = {key: rows for key, rows in self._ranges.items() if not key[1]}

    def forget_value(self, place: tuple[Root | None, int]) -> None:
        """Discard the initialised bytes of the object at a location."""
        self._ranges.pop((place[0], True), None)

    def forget(self, root: Root) -> None:
        """Discard the facts about an object."""
        for valued in (False, True):
            self._ranges.pop((root, valued), None)

    def add(self, place: tuple[Root | None, int], size: int, *, valued: bool) -> None:
        """Note that `size` bytes at a location are accessible; with `valued`, also initialised."""
        root, start = place
        self._add(root, start, start + size, valued=False)
        if valued:
            self._add(root, start, start + size, valued=True)

    def add_all(
        self, place: tuple[Root | None, int], others: KnownBytes, their: tuple[Root | None, int]
    ) -> None:
        """Add what others know of the bytes at a location, which is known here by another name."""
        (root, start), (their_root, their_start) = place, their
        for valued in (False, True):
            for low, high in others._ranges.get((their_root, valued), ()):
                shift = start - their_start
                self._add(root, low + shift, high + shift, valued=valued)

    def _add(self, root: Root | None, start: int, end: int, *, valued: bool) -> None:
        kept = []
        for low, high in self._ranges.get((root, valued), ()):
            if high < start or end < low:
                kept.append((low, high))
            else:
                start, end = min(low, start), max(high, end)
        self._ranges[root, valued] = [*kept, (start, end)]

    def has(self, place: tuple[Root | None, int], size: int, *, valued: bool) -> bool:
        """Return whether `size` bytes at a location are known to be accessible, or initialised."""
        root, start = place
        rows = self._ranges.get((root, valued), ())
        return any(low <= start and start + size <= high for low, high in rows)


def sole_predecessors(
    function: Function, headers: Container[Block], inlined: Container[Call]
) -> dict[Block, Block]:
    """Return the only predecessor of each block at whose start no more can have happened.

    Nothing happens on an edge but in a loop header, where a program may stop, and behind calls that
    are not inlined.
    """
    found: dict[Block, Block | None] = {function.blocks[0]: None}
    for block in function.blocks:
        end = block.terminator
        continues = isinstance(end, Jump | Branch | Switch)
        only = block if continues or (isinstance(end, Call) and end in inlined) else None
        for target in block.successors():
            found[target] = None if target in found or target in headers else only
    return {block: only for block, only in found.items() if only is not None}
