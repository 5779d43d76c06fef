"""Lowers what names an object to its place, and reads and writes objects there.

A place is a base and an offset. The offset grows with members and constant indices, so that
`p->a.b[2]` is one load from the register of `p`. Bit-fields are read and written through the unit
they lie in.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from crs_cc.frontend import tree
from crs_cc.frontend.lower import (
    PLACE,
    VALUE,
    Lowering,
    Place,
    constant,
    memory_type,
    place,
    value,
    value_type,
)
from crs_cc.frontend.lower_spread import read_spread, write_spread
from crs_cc.frontend.tree import Expression
from crs_cc.ir.program import (
    MEMORY_SIZE,
    Constant,
    Copy,
    Load,
    Move,
    Operand,
    Register,
    Store,
)
from crs_cc.ir.types import CType, EnumType, IntegerType, Member, PointerType
from crs_cc.source import Location

_LARGEST_OFFSET = 1 << 30


def load(
    low: Lowering, where: Place, ctype: CType, location: Location, into: Register | None = None
) -> Register:
    """Reads a scalar from a place."""
    memory = memory_type(ctype)
    base, offset = low.access(where, MEMORY_SIZE[memory], location)
    result = low.register(value_type(ctype)) if into is None else into
    low.emit(Load(location, result, base, offset, memory))
    return result


def store(low: Lowering, where: Place, ctype: CType, source: Operand, location: Location) -> None:
    """Writes a scalar to a place."""
    memory = memory_type(ctype)
    base, offset = low.access(where, MEMORY_SIZE[memory], location)
    low.emit(Store(location, base, offset, source, memory))


def copy(low: Lowering, target: Place, source: Place, size: int, location: Location) -> None:
    """Copies a struct."""
    if size > 0:
        to, of = low.address(target, location), low.address(source, location)
        low.emit(Copy(location, to, of, Constant("i32", size)))


# Bit-fields


def _unit_op(member: Member, name: str) -> str:
    return f"{value_type(member.type)}.{name}"


def read_bits(low: Lowering, where: Place, member: Member, location: Location) -> Operand:
    """Reads a bit-field: its bits, extended as its type says."""
    width, ctype = member.bit_width or 0, member.type
    assert isinstance(ctype, IntegerType | EnumType)
    if member.spread:
        return read_spread(low, where, member, location)
    unit = load(low, where, ctype, location)
    if width == 8 * ctype.size:
        return unit
    total = 64 if ctype.size == 8 else 32
    if ctype.signed:
        up = constant(ctype, total - width - member.bit_offset)
        down = constant(ctype, total - width)
        raised = low.binary(location, _unit_op(member, "shl"), unit, up)
        return low.binary(location, _unit_op(member, "shr_s"), raised, down)
    shifted: Operand = unit
    if member.bit_offset:
        by = constant(ctype, member.bit_offset)
        shifted = low.binary(location, _unit_op(member, "shr_u"), unit, by)
    mask = _mask(member, width)
    return low.binary(location, _unit_op(member, "and"), shifted, mask)


def _mask(member: Member, width: int, shift: int = 0, inverted: bool = False) -> Constant:
    bits = ((1 << width) - 1) << shift
    return constant(member.type, ~bits if inverted else bits)


def write_bits(
    low: Lowering, where: Place, member: Member, source: Operand, location: Location
) -> None:
    """Writes a bit-field and leaves the other bits of its unit as they are."""
    width, ctype = member.bit_width or 0, member.type
    if member.spread:
        write_spread(low, where, member, source, location)
        return
    if width == 8 * ctype.size:
        store(low, where, ctype, source, location)
        return
    base, offset = low.access(where, ctype.size, location)
    unit = low.register(value_type(ctype))
    low.emit(Load(location, unit, base, offset, memory_type(ctype), unjudged=True))
    others = low.binary(
        location, _unit_op(member, "and"), unit, _mask(member, width, member.bit_offset, True)
    )
    bits = _shifted(low, member, source, location)
    merged = low.binary(location, _unit_op(member, "or"), others, bits)
    store(low, (base, offset), ctype, merged, location)


def _shifted(low: Lowering, member: Member, source: Operand, location: Location) -> Operand:
    """Gives the low bits of a value at the place of a bit-field in its unit."""
    width, offset = member.bit_width or 0, member.bit_offset
    if isinstance(source, Constant):
        kept = int(source.value) & ((1 << width) - 1)
        return constant(member.type, kept << offset)
    bits = low.binary(location, _unit_op(member, "and"), source, _mask(member, width))
    if offset == 0:
        return bits
    return low.binary(location, _unit_op(member, "shl"), bits, constant(member.type, offset))


def fit_bits(low: Lowering, member: Member, source: Operand, location: Location) -> Operand:
    """Gives the value that a bit-field holds after `source` was written to it."""
    width, ctype = member.bit_width or 0, member.type
    assert isinstance(ctype, IntegerType | EnumType)
    total = 64 if ctype.size == 8 else 32
    if width == total or ctype.size * 8 == width or ctype.name == "_Bool":
        return source
    if not ctype.signed:
        return low.binary(location, _unit_op(member, "and"), source, _mask(member, width))
    by = constant(ctype, total - width)
    raised = low.binary(location, _unit_op(member, "shl"), source, by)
    return low.binary(location, _unit_op(member, "shr_s"), raised, by)


# Places


def _places(kind: type) -> Callable[[Any], Any]:
    def enter(function: Any) -> Any:
        PLACE[kind] = function
        return function

    return enter


@_places(tree.ObjectName)
def _object(low: Lowering, expression: tree.ObjectName) -> Place:
    symbol = expression.symbol
    if symbol.link_name is not None:
        low.unit.sizes[symbol.link_name] = symbol.type.size
        return low.refer(symbol.link_name, expression.location), 0
    return low.local(symbol), 0


@_places(tree.StringLiteral)
def _string(low: Lowering, expression: tree.StringLiteral) -> Place:
    return low.unit.string(expression), 0


@_places(tree.MemberAccess)
def _member(low: Lowering, expression: tree.MemberAccess) -> Place:
    base, offset = place(low, expression.record)
    return base, offset + expression.member.offset


@_places(tree.Dereference)
def _dereference(low: Lowering, expression: tree.Dereference) -> Place:
    return pointee(low, expression.pointer)


@_places(tree.FunctionName)
def _function(low: Lowering, expression: tree.FunctionName) -> Place:
    return low.refer(expression.symbol.link_name, expression.location), 0


def pointee(low: Lowering, pointer: Expression) -> Place:
    """Gives the place that a pointer points to."""
    match pointer:
        case tree.AddressOf(operand=operand):
            return place(low, operand)
        case tree.PointerAdd():
            return _moved(low, pointer)
        case tree.Convert(operand=operand) if isinstance(operand.type, PointerType):
            return pointee(low, operand)
    operand_ = value(low, pointer)
    if isinstance(operand_, Constant):
        register = low.register("i32")
        low.emit(Move(pointer.location, register, operand_))
        return register, 0
    return operand_, 0


def _moved(low: Lowering, moved: tree.PointerAdd) -> Place:
    """Gives the place of `pointer + index`; what is constant of it goes into the offset."""
    assert isinstance(moved.type, PointerType)
    size, location = moved.type.target.size, moved.location
    base, offset = pointee(low, moved.pointer)
    index, extra = _split(moved.index)
    step = extra * size
    if abs(offset + step) > _LARGEST_OFFSET:
        index, step = moved.index, 0
    if moved.minus:
        step = -step
    if index is None:
        return base, offset + step
    scaled = _scaled(low, index, size, location)
    op = "i32.sub" if moved.minus else "i32.add"
    if isinstance(base, Register):
        return low.binary(location, op, base, scaled), offset + step
    start = low.address((base, offset + step), location)
    return low.binary(location, op, start, scaled), 0


def _split(index: Expression) -> tuple[Expression | None, int]:
    """Splits an index into a part that varies and a constant."""
    if isinstance(index, tree.Literal):
        return None, int(index.value)
    if isinstance(index, tree.Convert) and index.operand.type.size == index.type.size:
        index = index.operand
    if isinstance(index, tree.Binary) and isinstance(index.right, tree.Literal):
        if index.op == "+":
            return index.left, int(index.right.value)
        if index.op == "-":
            return index.left, -int(index.right.value)
    return index, 0


def _scaled(low: Lowering, index: Expression, size: int, location: Location) -> Operand:
    """Gives `index * size`."""
    operand = value(low, index)
    if size == 1:
        return operand
    if isinstance(operand, Constant):
        return constant(index.type, (int(operand.value) * size) & 0xFFFFFFFF)
    if size & (size - 1) == 0:
        shift = Constant("i32", size.bit_length() - 1)
        return low.binary(location, "i32.shl", operand, shift)
    return low.binary(location, "i32.mul", operand, Constant("i32", size))


# Values of objects


def _value_of_object(low: Lowering, expression: Expression, into: Register | None) -> Operand:
    """Reads the object that an expression names."""
    if isinstance(expression, tree.ObjectName) and expression.symbol.link_name is None:
        found = low.local(expression.symbol)
        if isinstance(found, Register):
            return found
        return load(low, (found, 0), expression.type, expression.location, into)
    if isinstance(expression, tree.MemberAccess) and expression.member.bit_width is not None:
        return read_bits(low, place(low, expression), expression.member, expression.location)
    return load(low, place(low, expression), expression.type, expression.location, into)


def _value_of_address(low: Lowering, expression: tree.AddressOf, into: Register | None) -> Operand:
    return low.address(place(low, expression.operand), expression.location, into)


def _value_of_moved(low: Lowering, expression: tree.PointerAdd, into: Register | None) -> Operand:
    return low.address(_moved(low, expression), expression.location, into)


VALUE[tree.ObjectName] = _value_of_object
VALUE[tree.Dereference] = _value_of_object
VALUE[tree.MemberAccess] = _value_of_object
VALUE[tree.CompoundLiteral] = _value_of_object

VALUE[tree.AddressOf] = _value_of_address
VALUE[tree.PointerAdd] = _value_of_moved
