"""Lower initialisers: of locals to stores, of globals to bytes and relocations."""

from __future__ import annotations

import struct
from typing import Final

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.constant import ConstantAddress, constant_address
from crs_cc.frontend.check.tree import Initialiser, InitialValue
from crs_cc.frontend.lower.assign import set_record
from crs_cc.frontend.lower.bit_field import write_bits
from crs_cc.frontend.lower.convert import unnarrowed
from crs_cc.frontend.lower.lowerer import Lowering, Place, Rules, value, value_into
from crs_cc.frontend.lower.memory import store
from crs_cc.ir.instruction import Address, Constant, Copy, Fill, Lifetime, Register, Seal, Slot
from crs_cc.ir.types import (
    ArrayType,
    CType,
    EnumType,
    FloatType,
    IntegerType,
    Member,
    PointerType,
    RecordType,
)

_MAX_STORES: Final = 8
"""A local variable with more constant values is copied from an image."""


# Locals


def _declare(low: Lowering, statement: tree.Declare) -> None:
    found = low.local(statement.symbol)
    if statement.initialiser is None:
        return
    low.mark(statement.location)
    if isinstance(found, Register):
        for each in statement.initialiser.values:
            value_into(low, each.value, found)
        return
    if not statement.symbol.type.const:
        initialise(low, found, statement.symbol.type, statement.initialiser, statement.location)
        return
    low.emit(Lifetime(statement.location, found, begins=True))
    initialise(low, found, statement.symbol.type, statement.initialiser, statement.location)
    low.emit(Seal(statement.location, found))


def _lifetimes(low: Lowering, statement: tree.Lifetimes) -> None:
    """Start or end the lifetimes of a block's variables in memory."""
    if not statement.begins:
        low.leave_scopes(len(low.scopes) - 1, statement.location)
        low.scopes.pop()
        return
    found = [low.local(each) for each in statement.symbols if each.link_name is None]
    low.scopes.append([each for each in found if isinstance(each, Slot)])
    for slot in low.scopes[-1]:
        low.emit(Lifetime(statement.location, slot, begins=True))


def initialise(
    low: Lowering, slot: Slot, ctype: CType, initialiser: Initialiser, location: Location
) -> None:
    """Initialise an object in a frame slot."""
    constants = [each for each in initialiser.values if _is_constant(each)]
    others = [each for each in initialiser.values if not _is_constant(each)]
    if len(constants) > _MAX_STORES or any(_is_long(each) for each in constants):
        _copy_image(low, slot, ctype, constants, location)
        initialiser = Initialiser(others)
    elif initialiser.is_braced and _leaves_gaps(initialiser, ctype):
        start = low.address((slot, 0), location)
        size = Constant("i32", ctype.size)
        low.emit(Fill(location, start, Constant("i32", 0), size))
    used = low.used_registers()
    for each in initialiser.values:
        _set(low, (slot, each.offset), each)
        low.reuse_registers(used)


def _is_constant(each: InitialValue) -> bool:
    if each.member is not None:
        return False
    return isinstance(each.value, tree.Literal) or isinstance(each.type, ArrayType)


def _is_long(each: InitialValue) -> bool:
    return isinstance(each.type, ArrayType) and each.type.size > _MAX_STORES


def _leaves_gaps(initialiser: Initialiser, ctype: CType) -> bool:
    """Return whether some bytes of the object are not initialised."""
    filled = 0
    for each in initialiser.values:
        if each.offset != filled or each.member is not None:
            return True
        filled += each.type.size
    return filled != ctype.size


def _copy_image(
    low: Lowering, slot: Slot, ctype: CType, constants: list[InitialValue], location: Location
) -> None:
    image = Image(ctype.size)
    for each in constants:
        image.put(each)
    name = low.unit.image(low.function.name, bytes(image.content), ctype.align, location)
    target = low.address((slot, 0), location)
    source = low.register("i32")
    low.emit(Address(location, source, low.refer(name, location), 0))
    low.emit(Copy(location, target, source, Constant("i32", ctype.size)))


def _set(low: Lowering, where: Place, each: InitialValue) -> None:
    location = each.value.location
    if each.member is not None:
        write_bits(low, where, each.member, value(low, each.value), location)
    elif isinstance(each.type, RecordType):
        set_record(low, where, each.value, location)
    elif isinstance(each.type, ArrayType):
        _set_string(low, where, each, location)
    else:
        store(low, where, each.type, value(low, unnarrowed(each.value)), location)


def _set_string(low: Lowering, where: Place, each: InitialValue, location: Location) -> None:
    assert isinstance(each.value, tree.StringLiteral)
    assert isinstance(each.type, ArrayType)
    base, offset = where
    content = each.value.content.ljust(each.type.size, b"\0")
    element = each.type.element
    assert isinstance(element, IntegerType)
    for start in range(0, len(content), element.size):
        unit = int.from_bytes(content[start : start + element.size], "little", signed=True)
        store(low, (base, offset + start), element, Constant("i32", unit), location)


def _compound_literal(low: Lowering, expression: tree.CompoundLiteral) -> Place:
    symbol = expression.symbol
    if symbol.link_name is not None:
        low.unit.sizes[symbol.link_name] = symbol.type.size
        return low.refer(symbol.link_name, expression.location), 0
    slot = low.local(symbol)
    assert isinstance(slot, Slot)
    if low.scopes:
        low.emit(Lifetime(expression.location, slot, begins=True))
        if slot not in low.scopes[-1]:
            low.scopes[-1].append(slot)
    initialise(low, slot, symbol.type, expression.initialiser, expression.location)
    return slot, 0


# Globals


class Image:
    r"""The initial bytes of a static object.

    >>> from crs_cc.ir.types import SHORT
    >>> image = Image(4)
    >>> image.put(InitialValue(2, SHORT, tree.Literal(SHORT, Location("a.c"), -2)))
    >>> bytes(image.content)
    b'\x00\x00\xfe\xff'
    """

    def __init__(self, size: int) -> None:
        self.content = bytearray(size)
        self.addresses: dict[int, ConstantAddress] = {}

    def put(self, each: InitialValue) -> None:
        """Store one constant value."""
        end = each.offset + each.type.size
        if isinstance(each.type, ArrayType):
            assert isinstance(each.value, tree.StringLiteral)
            self.content[each.offset : end] = each.value.content.ljust(each.type.size, b"\0")
        elif isinstance(each.value, tree.Literal):
            if each.member is not None:  # its unit may overlap a pointer before it
                self._put_bits(each.offset, each.member, int(each.value.value))
            else:
                self.addresses.pop(each.offset, None)
                self.content[each.offset : end] = encoded(each.type, each.value.value)
        else:
            self._put_address(each)

    def _put_address(self, each: InitialValue) -> None:
        address = constant_address(each.value)
        assert address is not None, "the checker lets only constants through"
        if address.base is None:
            raw = (address.offset & 0xFFFFFFFF).to_bytes(4, "little")
            self.content[each.offset : each.offset + each.type.size] = raw[: each.type.size]
        else:
            self.addresses[each.offset] = address

    def _put_bits(self, offset: int, member: Member, number: int) -> None:
        size = member.spread or member.type.size
        unit = int.from_bytes(self.content[offset : offset + size], "little")
        mask = ((1 << (member.bit_width or 0)) - 1) << member.bit_offset
        unit = unit & ~mask | number << member.bit_offset & mask
        self.content[offset : offset + size] = unit.to_bytes(size, "little")


def encoded(ctype: CType, number: float) -> bytes:
    """Return the bytes of a scalar."""
    if isinstance(ctype, FloatType):
        return struct.pack("<f" if ctype.size == 4 else "<d", number)
    assert isinstance(ctype, IntegerType | EnumType | PointerType)
    return (int(number) & (1 << 8 * ctype.size) - 1).to_bytes(ctype.size, "little")


RULES: Final = Rules(
    place={
        tree.CompoundLiteral: _compound_literal,
    },
    statement={
        tree.Declare: _declare,
        tree.Lifetimes: _lifetimes,
    },
)
