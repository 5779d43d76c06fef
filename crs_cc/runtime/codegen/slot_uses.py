"""The uses of the slots of a function: which parts are accessed, and what is copied."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TypeAlias

from crs_cc.ir.instruction import VARARGS, Slot
from crs_cc.ir.value_type import MEMORY_SIZE, MemoryType

Place: TypeAlias = tuple[Slot, int]
"""A slot and an offset in it."""


class NotReplaceableError(Exception):
    """A slot is used in a way that needs memory; None if there is too much to replace."""

    def __init__(self, slot: Slot | None) -> None:
        super().__init__()
        self.slot = slot


@dataclass(slots=True)
class Uses:
    """The uses of slots: accesses, and copies between them."""

    fields: dict[Slot, dict[int, MemoryType]] = field(default_factory=dict)
    copies: list[tuple[Place, Place, int]] = field(default_factory=list)
    whole: list[tuple[Place, int]] = field(default_factory=list)

    def access(self, slot: Slot, offset: int, memory: MemoryType) -> None:
        """Note an access; all accesses of a field have the same type."""
        if MEMORY_SIZE[memory] < 4 or slot is VARARGS:
            raise NotReplaceableError(slot)
        if self.fields.setdefault(slot, {}).setdefault(offset, memory) != memory:
            raise NotReplaceableError(slot)

    def close(self) -> None:
        """Give both sides of each copy the same fields, and check that none overlap."""
        self._spread()
        for (slot, start), size in self.whole:
            self._fill(slot, start, start + size)
        self._spread()
        for slot, rows in self.fields.items():
            ends = [at + MEMORY_SIZE[rows[at]] for at in sorted(rows)]
            if any(end > at for end, at in zip(ends, sorted(rows)[1:], strict=False)):
                raise NotReplaceableError(slot)
        for (slot, start), size in self.whole:
            inside = self.within(slot, start, size)
            if sum(MEMORY_SIZE[memory] for _, memory in inside) != size:
                raise NotReplaceableError(slot)

    def _spread(self) -> None:
        """Give both sides of each copy the same fields."""
        grown = True
        while grown:
            before = sum(map(len, self.fields.values()))
            for (left, left_at), (right, right_at), size in self.copies:
                self._share(left, left_at, right, right_at, size)
                self._share(right, right_at, left, left_at, size)
            grown = sum(map(len, self.fields.values())) != before

    def _fill(self, slot: Slot, start: int, end: int) -> None:
        """Add fields for parts that are only copied; their type does not matter."""
        for at, memory in [*self.within(slot, start, end - start), (end, "i32")]:
            while start < at:
                is_long = start % 8 == 0 and at - start >= 8
                if at - start < 4 or start % 4:
                    raise NotReplaceableError(slot)
                self.access(slot, start, "i64" if is_long else "i32")
                start += 8 if is_long else 4
            start = at + MEMORY_SIZE[memory]

    def _share(self, source: Slot, start: int, target: Slot, to: int, size: int) -> None:
        for at, memory in self.within(source, start, size):
            self.access(target, at - start + to, memory)

    def within(self, slot: Slot, start: int, size: int) -> list[tuple[int, MemoryType]]:
        """Return the fields in a part of a slot, in order."""
        rows = sorted(self.fields.get(slot, {}).items())
        return [(at, memory) for at, memory in rows if start <= at < start + size]
