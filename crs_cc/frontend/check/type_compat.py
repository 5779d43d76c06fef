"""Compatible and composite types (C17 6.2.7).

>>> from crs_cc.ir.types import CHAR
>>> unknown, known = ArrayType(CHAR), ArrayType(CHAR, 9)
>>> compatible(unknown, known), str(composite(unknown, known))
(True, 'char[9]')
"""

from __future__ import annotations

from dataclasses import replace

from crs_cc.ir.types import (
    INT,
    ArrayType,
    CType,
    EnumType,
    FloatType,
    FunctionType,
    IntegerType,
    PointerType,
    unqualified,
)


def compatible(left: CType, right: CType) -> bool:
    """Return whether two types are compatible (C17 6.2.7); an enum and its integer type are."""
    if left is right or left == right:
        return True
    if (left.const, left.volatile) != (right.const, right.volatile):
        return False
    if isinstance(left, PointerType) and isinstance(right, PointerType):
        return compatible(left.target, right.target)
    if isinstance(left, ArrayType) and isinstance(right, ArrayType):
        lengths = {left.length, right.length}  # None if unknown (6.7.6.2p6)
        return (None in lengths or len(lengths) == 1) and compatible(left.element, right.element)
    if isinstance(left, FunctionType) and isinstance(right, FunctionType):
        return compatible(left.result, right.result) and _compatible_parameters(left, right)
    enums = [each for each in (left, right) if isinstance(each, EnumType)]
    others = [each for each in (left, right) if isinstance(each, IntegerType)]
    return len(enums) == 1 and len(others) == 1 and others[0].name == enums[0].name


def _compatible_parameters(left: FunctionType, right: FunctionType) -> bool:
    """Compare parameter lists; an unknown one is compatible with promoted types (6.7.6.3)."""
    if left.parameters is None or right.parameters is None:
        known = right if left.parameters is None else left
        return not known.variadic and all(map(is_promoted, known.parameters or ()))
    if left.variadic != right.variadic or len(left.parameters) != len(right.parameters):
        return False
    pairs = zip(left.parameters, right.parameters, strict=True)
    return all(compatible(unqualified(a), unqualified(b)) for a, b in pairs)


def is_promoted(ctype: CType) -> bool:
    """Return whether the default argument promotions leave a type as it is (C17 6.5.2.2p6)."""
    if isinstance(ctype, IntegerType):
        return ctype.rank >= INT.rank
    return not (isinstance(ctype, FloatType) and ctype.name == "float")


def composite(left: CType, right: CType) -> CType:
    """Return the composite type of two compatible types (C17 6.2.7p3)."""
    if isinstance(left, ArrayType) and isinstance(right, ArrayType):
        is_better = left.length is None and (right.length is not None or left.extent is None)
        known = right if is_better else left
        return replace(known, element=composite(left.element, right.element))
    if isinstance(left, FunctionType) and isinstance(right, FunctionType):
        if left.parameters is None or right.parameters is None:
            return left if right.parameters is None else right
        pairs = zip(left.parameters, right.parameters, strict=True)
        parameters = tuple(composite(a, b) for a, b in pairs)
        return FunctionType(composite(left.result, right.result), parameters, left.variadic)
    if isinstance(left, PointerType) and isinstance(right, PointerType):
        return replace(left, target=composite(left.target, right.target))
    return left
