"""Constant expressions (C17 6.6): integers for the compiler, addresses for the linker.

Arithmetic on constants is folded while expressions are checked, so an integer constant expression
is a `Literal`. Address constants remain: `&table[3].next`, `"text" + 1`, `(int)main`.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from crs_cc.frontend.check import checker, tree
from crs_cc.frontend.check.checker import CheckError, Unit
from crs_cc.frontend.check.conversion import decay, is_integer
from crs_cc.frontend.check.fold import wrap
from crs_cc.frontend.check.scope import FunctionSymbol, ObjectSymbol
from crs_cc.frontend.check.tree import Expression
from crs_cc.frontend.parse.nodes import Node
from crs_cc.ir.types import EnumType, IntegerType, PointerType

Base: TypeAlias = ObjectSymbol | FunctionSymbol | tree.StringLiteral


@dataclass(frozen=True, slots=True)
class ConstantAddress:
    """An address that is known at link time: `base + offset`, or a number without base."""

    base: Base | None
    offset: int


def integer(unit: Unit, node: Node, what: str) -> int:
    """Return the value of an integer constant expression.

    Raises:
        CheckError: it is not constant or not an integer.
    """
    expression = decay(checker.expression(unit, node))
    value = integer_value(expression)
    if value is None:
        raise CheckError(expression.location, f"{what} is not an integer constant expression")
    return value


def integer_value(expression: Expression) -> int | None:
    """Return the value of a checked expression, None if it is not an integer constant."""
    if not is_integer(expression.type):
        return None
    if isinstance(expression, tree.Literal):
        return int(expression.value)
    address = constant_address(expression)
    if address is None or address.base is not None:
        return None
    assert isinstance(expression.type, IntegerType | EnumType)
    return wrap(address.offset, expression.type.bits, expression.type.signed)


def constant_address(expression: Expression) -> ConstantAddress | None:
    """Return the value of a pointer or integer expression, None if it is not constant."""
    match expression:
        case tree.Literal(value=int(value)):
            return ConstantAddress(None, value)
        case tree.AddressOf(operand=operand):
            return _object_address(operand)
        case tree.Convert(operand=operand):
            is_address = isinstance(expression.type, PointerType | IntegerType)
            if is_address and expression.type.size == operand.type.size == 4:
                return constant_address(operand)
        case tree.PointerAdd(pointer=pointer, index=tree.Literal(value=index), minus=minus):
            assert isinstance(expression.type, PointerType)
            step = int(index) * expression.type.target.size
            return _moved(constant_address(pointer), -step if minus else step)
        case tree.PointerDifference() | tree.Binary():
            return _combined(expression)
    return None


def _combined(expression: tree.PointerDifference | tree.Binary) -> ConstantAddress | None:
    left = constant_address(expression.left)
    right = constant_address(expression.right)
    if left is None or right is None:
        return None
    if isinstance(expression, tree.PointerDifference):
        if left.base is not right.base:
            return None
        return ConstantAddress(None, (left.offset - right.offset) // expression.size)
    if expression.op == "+" and (left.base is None or right.base is None):
        return ConstantAddress(left.base or right.base, left.offset + right.offset)
    if expression.op == "-" and right.base is left.base:
        return ConstantAddress(None, left.offset - right.offset)
    if expression.op == "-" and right.base is None:
        return ConstantAddress(left.base, left.offset - right.offset)
    return None


def _moved(address: ConstantAddress | None, step: int) -> ConstantAddress | None:
    return None if address is None else ConstantAddress(address.base, address.offset + step)


def _object_address(operand: Expression) -> ConstantAddress | None:
    """Return the address of an object, function or string."""
    match operand:
        case tree.ObjectName(symbol=symbol):
            return None if symbol.link_name is None else ConstantAddress(symbol, 0)
        case tree.FunctionName(symbol=symbol):
            return ConstantAddress(symbol, 0)
        case tree.StringLiteral():
            return ConstantAddress(operand, 0)
        case tree.CompoundLiteral(symbol=symbol):
            return None if symbol.link_name is None else ConstantAddress(symbol, 0)
        case tree.Dereference(pointer=pointer):
            return constant_address(pointer)
        case tree.MemberAccess(record=record, member=member) if member.bit_width is None:
            return _moved(_object_address(record), member.offset)
    return None
