"""Compatibility of declarations of one name in several files (C17 6.2.7p2).

Types differ only if a running program would notice it on this machine: `int` and `long` agree, and
so do pointers to different types.

>>> from crs_cc.ir.types import CHAR, DOUBLE, INT, LONG, ArrayType, PointerType
>>> agree(INT, LONG), agree(INT, DOUBLE), agree(PointerType(CHAR), ArrayType(CHAR, 9))
(True, False, False)
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


def agree(left: CType, right: CType) -> bool:
    """Return whether an object or function of one type may be used as one of the other."""
    if isinstance(left, ArrayType) and isinstance(right, ArrayType):
        lengths = {left.length, right.length} - {None}
        return len(lengths) < 2 and agree(left.element, right.element)
    if isinstance(left, FunctionType) and isinstance(right, FunctionType):
        return agree(left.result, right.result) and _parameters_agree(left, right)
    return _kind(left) == _kind(right) and left.size == right.size


def _parameters_agree(left: FunctionType, right: FunctionType) -> bool:
    """Compare parameters; an unknown list agrees with any."""
    if left.parameters is None or right.parameters is None:
        return True
    if len(left.parameters) != len(right.parameters) or left.variadic != right.variadic:
        return False
    return all(map(agree, left.parameters, right.parameters))


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
