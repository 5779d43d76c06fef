"""Compatibility of declarations of one name in several files (C17 6.2.7p2).

Types differ only if a running program would notice it on this machine: `int` and `long` are
compatible, and so are pointers to different types.

>>> from crs_cc.ir.types import CHAR, DOUBLE, INT, LONG, ArrayType, PointerType
>>> are_compatible(INT, LONG), are_compatible(INT, DOUBLE)
(True, False)
>>> are_compatible(PointerType(CHAR), ArrayType(CHAR, 9))
False
"""

from __future__ import annotations

from crs_cc.ir.types import (
    ArrayType,
    CType,
    EnumType,
    FloatType,
    FunctionType,
    IntegerType,
    PointerType,
    RecordType,
    VoidType,
)


def are_compatible(left: CType, right: CType) -> bool:
    """Return whether an object or function of one type may be used as one of the other."""
    if isinstance(left, ArrayType) and isinstance(right, ArrayType):
        lengths = {left.length, right.length} - {None}
        return len(lengths) < 2 and are_compatible(left.element, right.element)
    if isinstance(left, FunctionType) and isinstance(right, FunctionType):
        return are_compatible(left.result, right.result) and _are_compatible_parameters(left, right)
    return _kind(left) == _kind(right) and left.size == right.size


def _are_compatible_parameters(left: FunctionType, right: FunctionType) -> bool:
    """Compare parameters; an unknown list is compatible with any."""
    if left.parameters is None or right.parameters is None:
        return True
    if len(left.parameters) != len(right.parameters) or left.variadic != right.variadic:
        return False
    return all(map(are_compatible, left.parameters, right.parameters))


def _kind(ctype: CType) -> str:
    """Return the representation of a type's values."""
    match ctype:
        case IntegerType() | EnumType():
            return "integer"
        case FloatType():
            return "float"
        case PointerType():
            return "pointer"
        case RecordType():
            return "record"
        case ArrayType():
            return "array"
        case FunctionType():
            return "function"
        case VoidType():
            return "void"
