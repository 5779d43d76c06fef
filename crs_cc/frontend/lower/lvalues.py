"""Lower lvalues to their places and to their values.

A place is a base and an offset. Members and constant indices are added to the offset, so that
`p->a.b[2]` is a single load from the register of `p`.
"""

from __future__ import annotations

from typing import Final

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.fold import wrap
from crs_cc.frontend.check.tree import Expression
from crs_cc.frontend.lower.bit_field import read_bits
from crs_cc.frontend.lower.lowerer import Lowering, Place, Rules, place, value
from crs_cc.frontend.lower.memory import load
from crs_cc.ir.instruction import Address, Bounds, Constant, Move, Operand, Register
from crs_cc.ir.types import ArrayType, PointerType, RecordType

_LARGEST_OFFSET = 1 << 30


# Places


def _object(low: Lowering, expression: tree.ObjectName) -> Place:
    symbol = expression.symbol
    if symbol.link_name is not None:
        low.unit.sizes[symbol.link_name] = symbol.type.size
        name = low.refer(symbol.link_name, expression.location)
        return (_linked_address(low, name, expression) if symbol.may_be_missing else name), 0
    return low.local(symbol), 0


def _linked_address(low: Lowering, name: str, expression: tree.ObjectName) -> Register:
    """Return the address of an object that may be missing: accesses there must be checked."""
    address = low.register("i32")
    low.emit(Address(expression.location, address, name, 0))
    return address


def _string(low: Lowering, expression: tree.StringLiteral) -> Place:
    return low.unit.string(expression), 0


def _member(low: Lowering, expression: tree.MemberAccess) -> Place:
    base, offset = place(low, expression.record)
    return base, offset + expression.member.offset


def place_of_address(low: Lowering, expression: Expression) -> Place:
    """Return the place of an lvalue whose address is formed, but which is not accessed."""
    match expression:
        case tree.MemberAccess():
            base, offset = place_of_address(low, expression.record)
            return base, offset + expression.member.offset
        case tree.Dereference():
            return pointee(low, expression.pointer)
    return place(low, expression)


def _dereference(low: Lowering, expression: tree.Dereference) -> Place:
    return pointee(low, expression.pointer, expression.location)


def _function(low: Lowering, expression: tree.FunctionName) -> Place:
    return low.refer(expression.symbol.link_name, expression.location), 0


def pointee(low: Lowering, pointer: Expression, access: Location | None = None) -> Place:
    """Return the place that a pointer points to.

    Args:
        low: the function.
        pointer: the pointer.
        access: the location of the access there, whose index must be that of an element; None if
            only the address is formed.
    """
    match pointer:
        case tree.AddressOf(operand=operand):
            return place_of_address(low, operand) if access is None else place(low, operand)
        case tree.PointerAdd():
            return _moved(low, pointer, access)
        case tree.Convert(operand=operand) if isinstance(operand.type, PointerType):
            return pointee(low, operand, access)
    operand_ = value(low, pointer)
    if isinstance(operand_, Constant):
        register = low.register("i32")
        low.emit(Move(pointer.location, register, operand_))
        return register, 0
    return operand_, 0


def _moved(low: Lowering, moved: tree.PointerAdd, access: Location | None) -> Place:
    """Return the place of `pointer + index`, with its constant part in the offset."""
    assert isinstance(moved.type, PointerType)
    size, location = moved.type.target.size, moved.location
    array = None if access is None else _indexed_array(moved)
    base, offset = pointee(low, moved.pointer, access)
    index, extra = _split(moved.index)
    step = extra * size
    if abs(offset + step) > _LARGEST_OFFSET:
        index, extra, step = moved.index, 0, 0
    if moved.minus:
        step = -step
    if index is None:
        if array is not None and not 0 <= extra < (array.length or 0):
            wrong = Constant("i32", wrap(extra, 32, signed=True))
            low.emit(Bounds(access or location, wrong, base, offset, array))
        return base, offset + step
    operand = value(low, index)
    scaled = _scaled(low, operand, size, location)
    op = "i32.sub" if moved.minus else "i32.add"
    if isinstance(base, Register):
        found = low.binary(location, op, base, scaled), offset + step
    else:
        first = low.address((base, offset + step), location)
        found = low.binary(location, op, first, scaled), 0
    if array is not None:
        low.emit(Bounds(access or location, operand, base, offset, array, extra, found))
    return found


def _indexed_array(moved: tree.PointerAdd) -> ArrayType | None:
    """Return the type of the array in `array + index` if its length is known.

    The last member of a struct may have more elements than it is declared with, as old programs
    allocate, if these are none or one.
    """
    pointer = moved.pointer
    if moved.minus or not isinstance(pointer, tree.AddressOf):
        return None
    designated, array = pointer.operand, pointer.operand.type
    if not isinstance(array, ArrayType) or array.extent is not None or array.length is None:
        return None
    if isinstance(designated, tree.MemberAccess) and array.length <= 1:
        record = designated.record.type
        assert isinstance(record, RecordType)
        assert record.record.members
        if record.record.kind == "union" or record.record.members[-1] is designated.member:
            return None
    if isinstance(array.element, ArrayType) and array.element.extent is not None:
        return None
    return array


def _split(index: Expression) -> tuple[Expression | None, int]:
    """Split an index into a variable part and a constant."""
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


def _scaled(low: Lowering, operand: Operand, size: int, location: Location) -> Operand:
    """Return `index * size`."""
    if size == 1:
        return operand
    if isinstance(operand, Constant):
        return Constant("i32", wrap(int(operand.value) * size, 32, signed=True))
    if size & (size - 1) == 0:
        shift = Constant("i32", size.bit_length() - 1)
        return low.binary(location, "i32.shl", operand, shift)
    return low.binary(location, "i32.mul", operand, Constant("i32", size))


# Values of objects


def _value_of_object(low: Lowering, expression: Expression, into: Register | None) -> Operand:
    """Read the object that an expression designates."""
    if isinstance(expression, tree.ObjectName) and expression.symbol.link_name is None:
        found = low.local(expression.symbol)
        if isinstance(found, Register):
            return found
        return load(low, (found, 0), expression.type, expression.location, into)
    if isinstance(expression, tree.MemberAccess) and expression.member.bit_width is not None:
        return read_bits(low, place(low, expression), expression.member, expression.location)
    where, is_const = place(low, expression), _is_const(expression)
    return load(low, where, expression.type, expression.location, into, is_const=is_const)


def _is_const(expression: Expression) -> bool:
    """Return whether an lvalue is const where it is reached through a pointer."""
    while isinstance(expression, tree.MemberAccess):
        expression = expression.record
    if not isinstance(expression, tree.Dereference):
        return False
    pointer = expression.pointer.type
    return isinstance(pointer, PointerType) and pointer.target.const


def _value_of_address(low: Lowering, expression: tree.AddressOf, into: Register | None) -> Operand:
    return low.address(place_of_address(low, expression.operand), expression.location, into)


def _value_of_moved(low: Lowering, expression: tree.PointerAdd, into: Register | None) -> Operand:
    where = _moved(low, expression, None)
    return low.address(where, expression.location, into)


RULES: Final = Rules(
    value={
        tree.ObjectName: _value_of_object,
        tree.Dereference: _value_of_object,
        tree.MemberAccess: _value_of_object,
        tree.CompoundLiteral: _value_of_object,
        tree.AddressOf: _value_of_address,
        tree.PointerAdd: _value_of_moved,
    },
    place={
        tree.ObjectName: _object,
        tree.StringLiteral: _string,
        tree.MemberAccess: _member,
        tree.Dereference: _dereference,
        tree.FunctionName: _function,
    },
)
