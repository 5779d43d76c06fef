"""Constant folding with the target's arithmetic (C17 6.5, 6.6): wrap, round, truncate.

>>> from crs_cc.ir.types import CHAR, INT, UINT
>>> convert(300, INT, CHAR), binary("+", INT, 2147483647, 1), binary(">>", UINT, 4294967295, 28)
(44, -2147483648, 15)
>>> print(binary("/", INT, 1, 0))
None
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Final, TypeAlias

from crs_cc.frontend.parse.literal import single
from crs_cc.ir.types import CType, EnumType, FloatType, IntegerType, PointerType

Number: TypeAlias = int | float


def wrap(value: int, bits: int, signed: bool) -> int:
    """Return the low bits of a value as a number of that many bits."""
    value &= (1 << bits) - 1
    return value - (1 << bits) if signed and value >> bits - 1 else value


def convert(value: Number, source: CType, target: CType) -> Number | None:
    """Convert a constant (C17 6.3.1); return None if the result is undefined or not constant."""
    if isinstance(target, FloatType):
        return single(_float(value)) if target.size == 4 else _float(value)
    if isinstance(target, IntegerType) and target.name == "_Bool":
        return int(value != 0)
    if not isinstance(target, IntegerType | EnumType | PointerType):
        return None
    signed = not isinstance(target, PointerType) and target.signed
    bits = 8 * target.size if isinstance(target, PointerType) else target.bits
    if isinstance(source, FloatType):
        return _nearest(value, bits, signed)
    return wrap(int(value), bits, signed)


def _nearest(value: Number, bits: int, signed: bool) -> int:
    """Return the integer nearest to a constant, as gcc does where it is undefined (6.3.1.4)."""
    if math.isnan(value):
        return 0
    low, high = (-(1 << bits - 1), (1 << bits - 1) - 1) if signed else (0, (1 << bits) - 1)
    return low if value <= low else high if value >= high else int(value)


def _float(value: Number) -> float:
    try:
        return float(value)
    except OverflowError:
        return math.inf if value > 0 else -math.inf


def unary(op: str, ctype: CType, value: Number) -> Number | None:
    """Return `-value` or `~value` in a promoted type."""
    if isinstance(ctype, FloatType):
        return -value if op == "-" else None
    if isinstance(ctype, IntegerType):
        return wrap(-int(value) if op == "-" else ~int(value), ctype.bits, ctype.signed)
    return None


def compare(op: str, left: Number, right: Number) -> int:
    """Return 1 if the comparison is true, else 0."""
    return int(
        {
            "<": left < right,
            ">": left > right,
            "<=": left <= right,
            ">=": left >= right,
            "==": left == right,
            "!=": left != right,
        }[op]
    )


COMPARISONS: Final = frozenset({"<", ">", "<=", ">=", "==", "!="})


def binary(op: str, ctype: CType, left: Number, right: Number) -> Number | None:
    """Return `left op right` in a type; None if it is undefined, such as a division by zero."""
    if op in COMPARISONS:
        return compare(op, left, right)
    if isinstance(ctype, FloatType):
        result = _float_binary(op, float(left), float(right))
        return single(result) if result is not None and ctype.size == 4 else result
    if isinstance(ctype, IntegerType):
        exact = _integer_binary(op, ctype, int(left), int(right))
        return None if exact is None else wrap(exact, ctype.bits, ctype.signed)
    return None


def exact(op: str, left: int, right: int) -> int:
    """Return `left op right` in unlimited integers, for `+`, `-` and `*`."""
    return {"+": left + right, "-": left - right, "*": left * right}[op]


def builtin(name: str, values: Sequence[Number], ctype: CType) -> Number | None:
    """Return the value of a builtin; None if it is none of these, or undefined.

    Args:
        name: its name.
        values: its arguments.
        ctype: the type of the first one.
    """
    name = name.removeprefix("__builtin_")
    if isinstance(ctype, IntegerType):
        number = int(values[0]) & (1 << ctype.bits) - 1
        match name.rstrip("l"):
            case "popcount":
                return number.bit_count()
            case "clz" if number:
                return ctype.bits - number.bit_length()
            case "ctz" if number:
                return (number & -number).bit_length() - 1
        return None
    found = _FLOAT_BUILTINS.get(name) or _FLOAT_BUILTINS.get(name[:-1])
    if found is None or not isinstance(ctype, FloatType):
        return None
    result = found(*map(float, values))
    return single(result) if ctype.size == 4 else result


def _rounded(how: Callable[[float], int]) -> Callable[[float], float]:
    """Return a rounding function of floating-point numbers, which keeps signs and infinities."""

    def function(value: float) -> float:
        return math.copysign(how(value), value) if math.isfinite(value) else value

    return function


_FLOAT_BUILTINS: Final[dict[str, Callable[..., float]]] = {
    "fabs": abs,
    "copysign": math.copysign,
    "sqrt": lambda value: math.sqrt(value) if value >= 0 else math.nan,
    "floor": _rounded(math.floor),
    "ceil": _rounded(math.ceil),
    "trunc": _rounded(math.trunc),
    "rint": _rounded(round),
}


def _float_binary(op: str, left: float, right: float) -> float | None:
    try:
        match op:
            case "+":
                return left + right
            case "-":
                return left - right
            case "*":
                return left * right
            case "/":
                return left / right
    except ZeroDivisionError:
        if left == 0 or math.isnan(left):
            return math.nan
        return math.copysign(math.inf, left) * math.copysign(1.0, right)
    return None


def _integer_binary(op: str, ctype: IntegerType, left: int, right: int) -> int | None:
    match op:
        case "+":
            return left + right
        case "-":
            return left - right
        case "*":
            return left * right
        case "&":
            return left & right
        case "|":
            return left | right
        case "^":
            return left ^ right
        case "<<" | ">>":
            if not 0 <= right < ctype.bits:
                return None
            return left << right if op == "<<" else left >> right
        case "/" | "%":
            return _divide(op, left, right)
    return None


def _divide(op: str, left: int, right: int) -> int | None:
    """Divide, truncating towards zero (C17 6.5.5p6)."""
    if right == 0:
        return None
    quotient = abs(left) // abs(right) * (1 if (left < 0) == (right < 0) else -1)
    return quotient if op == "/" else left - quotient * right
