"""What is known about bytes of memory at a point of checked code, so that tests are omitted.

The facts hold until the next join of control flow. Only allocation, calls and ends of scopes make
bytes inaccessible, and only copies of uninitialised bytes make them so.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from crs_cc.ir.instruction import (
    VARARGS,
    Base,
    Block,
    Instruction,
    Operand,
    Register,
    Slot,
)
from crs_cc.runtime.codegen.plain_memory import PlainMemory
from crs_cc.runtime.codegen.value_numbering import KnownBytes, Root, ValueNumbers
from crs_cc.runtime.codegen.writer import Writer


@dataclass(slots=True)
class Facts:
    """What is known at one point of a function.

    Attributes:
        places: which registers hold which addresses.
        proved: the bytes known to be accessible, or initialised.
        writable: the bytes known to be accessible and not constant.
        within: the bytes known to be inside the object that their address was computed from.
        indices: the lengths that values are known to be less than, as unsigned numbers.
        ended: the slots whose lifetime has ended.
    """

    places: ValueNumbers = field(default_factory=ValueNumbers)
    proved: KnownBytes = field(default_factory=KnownBytes)
    writable: KnownBytes = field(default_factory=KnownBytes)
    within: KnownBytes = field(default_factory=KnownBytes)
    indices: dict[tuple[Root | None, int], int] = field(default_factory=dict)
    ended: set[Slot] = field(default_factory=set)

    def copy(self) -> Facts:
        """Return a copy of the facts, to continue from another point."""
        places, proved, writable = self.places.copy(), self.proved.copy(), self.writable.copy()
        within, indices = self.within.copy(), self.indices.copy()
        return Facts(places, proved, writable, within, indices, self.ended.copy())


class KnownMemory(PlainMemory):
    """Keeps the facts while the code of a function is written.

    Attributes:
        facts: what is known where code is being written.
        sole: the only predecessor of each block that inherits what is known at the end of that.
    """

    def __init__(self, writer: Writer, sole: Mapping[Block, Block]) -> None:
        super().__init__(writer, shadowed=True)
        self.sole = sole
        self._inherited = set(sole.values())
        self._at_end: dict[Block, Facts] = {}
        self.facts = Facts()

    @property
    def places(self) -> ValueNumbers:
        """Which registers hold which addresses."""
        return self.facts.places

    @property
    def proved(self) -> KnownBytes:
        """The bytes known to be accessible, or initialised."""
        return self.facts.proved

    def forget(self) -> None:
        """Discard known facts at a join of control flow."""
        self.facts = Facts()

    def begin(self, block: Block) -> None:
        """Restore the facts at the start of a block: those at the end of its predecessor.

        It is not if that has not been written yet.
        """
        known = self._at_end.get(self.sole.get(block))  # type: ignore[arg-type]
        if known is not None:
            self.facts = known.copy()

    def end(self, block: Block) -> None:
        """Note what is known at the end of a block."""
        if block in self._inherited:
            self._at_end[block] = self.facts

    def pass_facts(self, argument: Operand, parameter: Register, callee: KnownMemory) -> None:
        """Pass the facts about the bytes at an address to an inlined function."""
        root, distance = (
            self.places.of(argument, 0) if isinstance(argument, Register) else (None, 0)
        )
        target = callee.places.of(parameter, 0)
        if isinstance(root, Slot | str) and root not in self.facts.ended:
            room = root.size if isinstance(root, Slot) else self.writer.names.sizes.get(root, 0)
            if 0 <= distance < room:
                callee.proved.add(target, room - distance, valued=False)
                if self._changes(root):
                    callee.facts.writable.add(target, room - distance, valued=False)
        if root is not None:
            callee.proved.add_all(target, self.proved, (root, distance))
            callee.facts.writable.add_all(target, self.facts.writable, (root, distance))

    def add_callee_facts(
        self, argument: Operand, place: tuple[Root | None, int], callee: KnownMemory
    ) -> None:
        """Add what an inlined function knows of the bytes at an address that it was passed."""
        if isinstance(argument, Register):
            where = self.places.of(argument, 0)
            self.proved.add_all(where, callee.proved, place)
            self.facts.writable.add_all(where, callee.facts.writable, place)

    def after(self, it: Instruction) -> None:
        """Update known facts after an instruction."""
        self.places.update(it)

    def _inside(self, base: Base, offset: int, size: int) -> bool:
        """Return whether an access is known to be inside a named object."""
        match base:
            case Slot() if base is not VARARGS and base not in self.facts.ended:
                return offset >= 0 and offset + size <= base.size
            case str():
                known = self.writer.names.sizes.get(base, 0)
                return offset >= 0 and offset + size <= known
        return False

    def _accessible(self, base: Base, offset: int, size: int) -> bool:
        root, distance = self.places.of(base, offset)
        if isinstance(root, Slot | str) and self._inside(root, distance, size):
            return True
        return self.proved.has((root, distance), size, valued=False)

    def _writable(self, base: Base, offset: int, size: int) -> bool:
        """Return whether bytes are known to be accessible and not constant."""
        root, distance = self.places.of(base, offset)
        if isinstance(root, Slot | str) and self._changes(root):
            return self._inside(root, distance, size)
        return self.facts.writable.has((root, distance), size, valued=False)

    def _changes(self, root: Root | None) -> bool:
        """Return whether a root is an object that is not constant."""
        if isinstance(root, Slot):
            return root.variable is None or not root.variable.ctype.const
        return isinstance(root, str) and not self.writer.names.constants.get(root, 0)

    def _valued(self, base: Base, offset: int, size: int) -> bool:
        root, distance = self.places.of(base, offset)
        if isinstance(root, str) and self.writer.names.constants.get(root, 0):
            return self._inside(root, distance, size)
        return self.proved.has((root, distance), size, valued=True)
