"""The user's objects that a program does not use, and that the linker has therefore omitted.

Expressions may use them, and change them: each has an address above all memory of the program, and
its content is what the source gives it with all changes of the user's up to now. So they follow
the run wherever it goes, and take nothing of it: no program can reach them.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Final

from crs_cc.debug.data.expression_memory import ALIGN, EvaluationError
from crs_cc.debug.data.scope import Storage, is_own
from crs_cc.debug.timeline.change import UNLINKED, MemoryPatch
from crs_cc.ir.names import plain_name
from crs_cc.ir.program import Data
from crs_cc.ir.types import CType
from crs_cc.runtime.diagnosis.variables import target_name

Edits = Callable[[], Sequence[MemoryPatch]]
"""Returns the changes of such objects up to now."""
AddressOf = Callable[[str], int]
"""Returns the address of anything by its linker's name: what the content of an object may hold."""

_GAP: Final = 64
"""Between two objects [bytes], so that one past the end of an object is in no other."""


def no_edits() -> Sequence[MemoryPatch]:
    """Return no changes."""
    return ()


class UnusedObjects:
    """The contents of the objects during an evaluation.

    Attributes:
        addresses: by the linker's names, their addresses.
        is_used: whether the evaluation has used any of them.
    """

    def __init__(self, data: Mapping[str, Data], edits: Edits = no_edits) -> None:
        """Give the objects addresses."""
        self._data = data
        self._edits = edits
        self.is_used = False
        self.addresses: dict[str, int] = {}
        at = UNLINKED
        for name, each in data.items():
            self.addresses[name] = at
            at += -(-(each.size + _GAP) // ALIGN) * ALIGN
        self._names = list(self.addresses)
        self._starts = list(self.addresses.values())
        self._contents: dict[str, bytearray] = {}
        self._first: dict[str, bytes] = {}  # what the changed ones were at first

    def begin(self) -> None:
        """Start an evaluation: what others have changed is undone, or in the history by now."""
        self.is_used = False
        self._contents.clear()
        self._first.clear()

    def read(self, address: int, size: int, address_of: AddressOf) -> bytes:
        """Return bytes; raise EvaluationError if they are not in an object."""
        name, at = self._find(address, size)
        return bytes(self._content(name, address_of)[at : at + size])

    def peek(self, address: int, size: int, address_of: AddressOf) -> bytes:
        """Return bytes, as many as are in the object at an address."""
        number = bisect_right(self._starts, address) - 1
        if number < 0:
            return b""
        whole = self._content(self._names[number], address_of)
        return bytes(whole[address - self._starts[number] :][:size])

    def write(self, address: int, content: bytes, address_of: AddressOf) -> None:
        """Change bytes; raise EvaluationError if they are not in an object."""
        name, at = self._find(address, len(content))
        whole = self._content(name, address_of)
        self._first.setdefault(name, bytes(whole))
        whole[at : at + len(content)] = content

    def patches(self) -> tuple[MemoryPatch, ...]:
        """Return the changes since `begin`."""
        found = []
        for name, before in self._first.items():
            now = self._contents[name]
            changed = [at for at, byte in enumerate(before) if byte != now[at]]
            if changed:
                part = slice(changed[0], changed[-1] + 1)
                found.append(MemoryPatch(self.addresses[name] + changed[0], bytes(now[part])))
        return tuple(found)

    def name_of(self, address: int, target: CType) -> str:
        """Return the name of a pointer's target, an object or part of it; "" if unknown."""
        number = bisect_right(self._starts, address) - 1
        data = self._data[self._names[number]] if number >= 0 else None
        if data is None or data.variable is None:
            return ""
        return target_name(data.variable, address - self._starts[number], target)

    def storages(self) -> Iterator[Storage]:
        """Return the global variables of the user's own files among them."""
        for name, address in self.addresses.items():
            variable = self._data[name].variable
            is_local = "." in plain_name(name)
            if variable is not None and is_own(variable.location) and not is_local:
                yield Storage(variable, "global", address)

    def _find(self, address: int, size: int) -> tuple[str, int]:
        """Return the object that has bytes, and the offset there."""
        number = bisect_right(self._starts, address) - 1
        at = address - self._starts[number] if number >= 0 else -1
        if at < 0 or at + size > self._data[self._names[number]].size:
            raise EvaluationError(f"no object at {address:#x}")
        return self._names[number], at

    def _content(self, name: str, address_of: AddressOf) -> bytearray:
        """Return the content of an object as it is now."""
        self.is_used = True
        if name not in self._contents:
            self._contents[name] = self._create(name, address_of)
        return self._contents[name]

    def _create(self, name: str, address_of: AddressOf) -> bytearray:
        data, start = self._data[name], self.addresses[name]
        made = bytearray((data.content or b"").ljust(data.size, b"\0"))
        for each in data.relocations:
            value = (address_of(each.symbol) + each.addend) & 0xFFFF_FFFF
            made[each.offset : each.offset + 4] = value.to_bytes(4, "little")
        for patch in self._edits():
            at = patch.address - start
            if at >= 0 and at + len(patch.content) <= data.size:
                made[at : at + len(patch.content)] = patch.content
        return made
