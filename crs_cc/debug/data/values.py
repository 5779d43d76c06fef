"""Values of a stopped program: a line of text each, and their parts on demand.

A value holds the bytes at its creation. Pointers are followed in the
current memory, so it is valid until the program resumes.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Final, Protocol

from crs_cc.debug.world.state_fields import StateField
from crs_cc.ir.instruction import ByteState
from crs_cc.ir.types import (
    ArrayType,
    CType,
    EnumType,
    FloatType,
    FunctionType,
    IntegerType,
    Member,
    PointerType,
    RecordType,
    VoidType,
)
from crs_cc.runtime.diagnosis.values import Values, bit_field

UNINITIALISED: Final = "uninitialised"
_VALUED: Final = bytes([ByteState.WITH_VALUE])
GONE: Final = bytes([ByteState.INACCESSIBLE])


class ValueReader(Protocol):
    """The part of the stopped program that values need: formatting, targets of pointers."""

    @property
    def short(self) -> Values:
        """Format values in at most a line."""

    @property
    def full(self) -> Values:
        """Format values at length."""

    def read(self, address: int, size: int) -> bytes:
        """Return the bytes at an address, as many as exist."""

    def is_accessible(self, address: int, size: int) -> bool:
        """Return whether C may access bytes, initialised or not."""

    def value(self, address: int, ctype: CType) -> Value:
        """Return the object of a type at an address."""


@dataclass(frozen=True, slots=True)
class Value:
    """A value.

    Attributes:
        inspector: the inspector of the program.
        type: its C type.
        content: its bytes; those of a bit-field are those of an object of its type.
        states: the `ByteState`s of these bytes; none when all have values.
        address: its address; None for a computed value, and for a bit-field.
        first: the number of its first element, if it is a slice of an array.
        fields: the fields of `State[]`, if it is part of that.
    """

    inspector: ValueReader
    type: CType
    content: bytes
    states: bytes = b""
    address: int | None = None
    first: int = 0
    fields: tuple[StateField, ...] = ()

    @property
    def is_initialised(self) -> bool:
        """Return whether all its bytes have values."""
        return not self.states.strip(_VALUED)

    @property
    def exists(self) -> bool:
        """Return whether C may access any of its bytes."""
        return not self.states or bool(self.states.strip(GONE))

    @property
    def text(self) -> str:
        """Return the value in a line."""
        return self._written(self.inspector.short)

    @property
    def full(self) -> str:
        """Return the value in a line that may be long: up to 200 elements of each array."""
        return self._written(self.inspector.full)

    def _written(self, values: Values) -> str:
        if isinstance(self.type, VoidType):
            return "void"
        is_plain = not isinstance(self.type, ArrayType | RecordType)
        if is_plain and not self.is_initialised:
            return UNINITIALISED
        if is_plain and self.fields and isinstance(self.number, int):
            meaning, number = self.fields[0].text(self.number), str(self.number)
            return meaning if meaning.startswith(number) else f"{number} ({meaning})"
        return values.show(self.type, self.content, self.states)

    @property
    def number(self) -> int | float | None:
        """Return a number, an enum or the address in a pointer; None for all else."""
        if not self.is_initialised or not self.content:
            return None
        if isinstance(self.type, FloatType):
            return float(struct.unpack("<f" if self.type.size == 4 else "<d", self.content)[0])
        if isinstance(self.type, IntegerType | EnumType):
            return int.from_bytes(self.content, "little", signed=self.type.signed)
        if isinstance(self.type, PointerType):
            return int.from_bytes(self.content, "little")
        return None

    @property
    def child_count(self) -> int:
        """Return the number of parts."""
        match self.type:
            case ArrayType():
                size = self.type.element.size
                return len(self.content) // size if size else 0
            case RecordType():
                return sum(1 for _ in self._members())
            case PointerType():
                return int(self.target() is not None)
        return 0

    def children(self, start: int = 0, count: int | None = None) -> Iterator[tuple[str, Value]]:
        """Return its parts with their names: members, elements, or the target of a pointer.

        Args:
            start: number of the first one.
            count: how many; None for all.
        """
        stop = self.child_count if count is None else min(self.child_count, start + count)
        match self.type:
            case ArrayType():
                for number in range(start, stop):
                    name = f" {self.fields[number].name}" if number < len(self.fields) else ""
                    yield f"[{self.first + number}]{name}", self.element(number)
            case RecordType():
                for member in list(self._members())[start:stop]:
                    yield member.name or f"<{member.type}>", self.member(member)
            case PointerType():
                target = self.target()
                if target is not None and start < stop:
                    yield "*", target

    def element(self, number: int) -> Value:
        """Return an element of an array."""
        assert isinstance(self.type, ArrayType)
        size = self.type.element.size
        part = self._part(self.type.element, number * size, size)
        return replace(part, fields=self.fields[number : number + 1])

    def _members(self) -> Iterator[Member]:
        """Return the members that hold anything: no bit-fields without names."""
        assert isinstance(self.type, RecordType)
        for member in self.type.record.members or []:
            if member.name is not None or isinstance(member.type, RecordType):
                yield member

    def member(self, member: Member) -> Value:
        """Return a member of a struct or union."""
        part = self._part(member.type, member.offset, member.spread or member.type.size)
        if member.bit_width is None:
            return part
        return replace(part, content=bit_field(member, part.content), address=None)

    def _part(self, ctype: CType, offset: int, size: int) -> Value:
        part = slice(offset, offset + size)
        address = None if self.address is None else self.address + offset
        return Value(self.inspector, ctype, self.content[part], self.states[part], address)

    def target(self) -> Value | None:
        """Return the object that a pointer points to, if it is accessible and not just text."""
        assert isinstance(self.type, PointerType)
        target, address = self.type.target, self.number
        if not isinstance(address, int) or isinstance(target, FunctionType | VoidType):
            return None
        if not self.inspector.is_accessible(address, target.size) or not target.size:
            return None
        return self.inspector.value(address, target)
