"""Warnings about operands that need their types before conversion."""

from __future__ import annotations

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.checker import Unit
from crs_cc.frontend.check.conversion import is_integer, is_null_constant
from crs_cc.frontend.check.tree import Expression
from crs_cc.ir.types import ArrayType, IntegerType


def warn_signs(unit: Unit, left: Expression, right: Expression, location: Location) -> None:
    """Warn about the comparison of a negative constant with an unsigned operand."""
    for constant, other in ((left, right), (right, left)):
        if not isinstance(constant, tree.Literal) or constant.value >= 0:
            continue
        ctype = other.type
        is_unsigned = isinstance(ctype, IntegerType) and not ctype.signed
        if is_unsigned and is_integer(constant.type) and ctype.size >= constant.type.size:
            text = (
                f"comparison of '{ctype}' with a negative constant, which is converted to unsigned"
            )
            unit.warning(location, text, flag="sign-compare")


def warn_string(unit: Unit, left: Expression, right: Expression, location: Location) -> None:
    """Warn about the comparison of a string literal's address."""
    pair = (left, right)
    if any(_is_string(each) for each in pair) and not any(map(is_null_constant, pair)):
        text = "comparison against a string literal compares addresses, not contents"
        unit.warning(location, text, "use strcmp", flag="string-compare")


def _is_string(value: Expression) -> bool:
    return isinstance(value, tree.AddressOf) and isinstance(value.operand, tree.StringLiteral)


def warn_size(unit: Unit, operand: Expression, location: Location) -> None:
    """Warn about `sizeof` of a parameter that was declared as an array and is a pointer."""
    if isinstance(operand, tree.ObjectName) and operand.symbol.is_array_parameter:
        name = operand.symbol.name
        text = f"sizeof on array parameter '{name}' is the size of a pointer"
        unit.warning(
            location, text, f"declared at {operand.symbol.location}", flag="sizeof-array-argument"
        )


def warn_returned(unit: Unit, value: Expression) -> None:
    """Warn about the return of a local variable's address."""
    match value:
        case tree.Convert(operand=inner) if inner.type.size == value.type.size:
            warn_returned(unit, inner)
        case tree.Conditional():
            warn_returned(unit, value.then)
            warn_returned(unit, value.otherwise)
        case tree.PointerAdd(pointer=inner):
            warn_returned(unit, inner)
        case tree.AddressOf(operand=operand):
            _warn_object(unit, operand, value.location)


def _warn_object(unit: Unit, operand: Expression, location: Location) -> None:
    while True:
        match operand:
            case tree.MemberAccess(record=record):
                operand = record
            case tree.Dereference(pointer=tree.PointerAdd(pointer=tree.AddressOf(operand=array))):
                if not isinstance(array.type, ArrayType):
                    return
                operand = array
            case tree.ObjectName(symbol=symbol):
                if symbol.link_name is None:
                    text = f"address of local variable '{symbol.name}' returned"
                    unit.warning(
                        location,
                        text,
                        "make it static, or let the caller provide the memory",
                        flag="return-local-addr",
                    )
                return
            case _:
                return
