"""The operators of the IR in Python, for the user's expressions.

Integers are in the signed range of their type, as in `ir.Constant`; an `f32` is a float
that 32 bits can represent. Division by zero and other undefined behaviour raises `ArithmeticError`.

>>> compute("i32.add", 2147483647, 1), compute("i32.lt_u", -1, 1), compute("f64.div", 1.0, 4.0)
(-2147483648, 0, 0.25)
>>> compute("i32.div_s", 7, 0)  # doctest: +IGNORE_EXCEPTION_DETAIL
Traceback (most recent call last):
ZeroDivisionError: division by zero
"""

from __future__ import annotations

import functools
import math
import operator
import struct
from collections.abc import Callable
from typing import Any, Final

_BITS: Final = {"i32": 32, "i64": 64}
_FORMAT: Final = {"i32": "<i", "i64": "<q", "f32": "<f", "f64": "<d"}


def compute(op: str, *operands: float) -> Any:
    """Return the result of an operator of `ir.operators.OPERATORS`.

    Raises:
        ArithmeticError: division by zero, or a quotient that does not fit.
    """
    return operation(op)(*operands)


@functools.cache
def operation(op: str) -> Callable[..., Any]:
    """Return the function of an operator; it raises what `compute` does."""
    kind, _, name = op.partition(".")
    if "_f" in name or "_i" in name:
        return functools.partial(_convert, kind, name)
    if kind in _BITS:
        return _integer_operation(_BITS[kind], name)
    work = _FLOAT[name]
    if name in _COMPARISONS:
        return lambda left, right: int(work(left, right))
    return lambda *operands: _rounded(kind, work(*operands))


def signed(value: int, bits: int) -> int:
    """Return the low bits of a number, as a signed number."""
    value &= (1 << bits) - 1
    return value - (1 << bits) if value >> bits - 1 else value


def unsigned(value: int, bits: int) -> int:
    """Return the low bits of a number, as an unsigned number."""
    return value & (1 << bits) - 1


def _integer_operation(bits: int, name: str) -> Callable[..., int]:
    """Return the function of an operator; the frequent ones by themselves, as they are quicker."""
    stem, _, mode = name.rpartition("_")
    whole, half = 1 << bits, 1 << bits - 1
    mask = whole - 1
    if name in _COMPARISONS or (stem in _COMPARISONS and mode == "s"):
        compares = _EITHER[name if name in _COMPARISONS else stem]
        return lambda left, right: int(compares(left, right))
    if stem in _COMPARISONS:
        compares = _EITHER[stem]
        return lambda left, right: int(compares(left & mask, right & mask))
    if name == "eqz":
        return lambda value: int(not value)
    if name in _WRAPPING:
        work = _INTEGER[name]

        def wrapping(left: int, right: int) -> int:
            result: int = work(left, right) & mask
            return result - whole if result & half else result

        return wrapping
    return functools.partial(_integer, bits, name)


def _integer(bits: int, name: str, *operands: int) -> int:
    if name.startswith("extend"):
        return signed(operands[0], int(name[6:].partition("_")[0]))
    if name in _COUNTS:
        return _COUNTS[name](unsigned(operands[0], bits), bits)
    stem, _, mode = name.rpartition("_")
    if mode == "u":
        operands = tuple(unsigned(each, bits) for each in operands)
    if stem in {"shl", "shr"} or name in {"shl", "rotl", "rotr"}:
        left, right = operands
        return signed(_shift(stem or name, left, right % bits, bits), bits)
    result = _INTEGER[stem if mode in {"s", "u"} and stem else name](*operands)
    if name == "div_s" and result >> bits - 1 > 0:
        raise OverflowError("the quotient does not fit")
    return int(result) if isinstance(result, bool) else signed(result, bits)


def _shift(name: str, value: int, count: int, bits: int) -> int:
    match name:
        case "shl":
            return value << count
        case "shr":
            return value >> count
        case "rotr":
            count = (bits - count) % bits
    value = unsigned(value, bits)
    return value << count | value >> (bits - count)


def _quotient(left: int, right: int) -> int:
    result = abs(left) // abs(right)
    return result if (left < 0) == (right < 0) else -result


def _remainder(left: int, right: int) -> int:
    return left - right * _quotient(left, right)


def _divide(left: float, right: float) -> float:
    if right:
        return left / right
    if left == 0 or math.isnan(left):
        return math.nan
    return math.copysign(math.inf, left) * math.copysign(1.0, right)


def _nearest(value: float) -> float:
    if not math.isfinite(value):
        return value
    return math.copysign(float(round(value)), value)


def _whole(round_: Callable[[float], int]) -> Callable[[float], float]:
    def apply(value: float) -> float:
        if not math.isfinite(value):
            return value
        return math.copysign(float(round_(value)), value)

    return apply


def _least(left: float, right: float) -> float:
    if math.isnan(left) or math.isnan(right):
        return math.nan
    return min(left, right, key=lambda each: (each, math.copysign(1.0, each)))


def _most(left: float, right: float) -> float:
    return -_least(-left, -right)


def _convert(kind: str, name: str, value: float) -> float:
    if name.startswith("reinterpret"):
        packed = struct.pack(_FORMAT[name[-3:]], value)
        return float_or_int(kind, struct.unpack(_FORMAT[kind], packed)[0])
    if kind in _BITS:
        bits, sign = _BITS[kind], name.endswith("_s")
        if "_f" in name:
            return _truncated(value, bits, sign)
        source = unsigned(int(value), 32) if name == "extend_i32_u" else int(value)
        return signed(source, bits)
    if name.startswith("convert"):
        value = unsigned(int(value), _BITS[name[8:11]]) if name.endswith("_u") else int(value)
    return _rounded(kind, float(value))


def _truncated(value: float, bits: int, sign: bool) -> int:
    """Truncate towards 0 and saturate (WebAssembly 2.0, 4.3.3)."""
    if math.isnan(value):
        return 0
    low, high = (-(1 << bits - 1), (1 << bits - 1) - 1) if sign else (0, (1 << bits) - 1)
    whole = low if value <= low else high if value >= high else int(value)
    return signed(whole, bits)


def float_or_int(kind: str, value: float) -> float:
    """Return a number in the representation of a type."""
    return int(value) if kind in _BITS else float(value)


def _rounded(kind: str, value: float) -> float:
    if kind == "f64":
        return float(value)
    try:
        return float(struct.unpack("<f", struct.pack("<f", value))[0])
    except OverflowError:
        return math.copysign(math.inf, value)


_COUNTS: Final[dict[str, Callable[[int, int], int]]] = {
    "clz": lambda value, bits: bits - value.bit_length(),
    "ctz": lambda value, bits: (value & -value).bit_length() - 1 if value else bits,
    "popcnt": lambda value, _bits: value.bit_count(),
}
_EITHER: Final[dict[str, Callable[..., Any]]] = {
    name: getattr(operator, name)
    for name in ("add", "sub", "mul", "eq", "ne", "lt", "gt", "le", "ge")
}
_COMPARISONS: Final = frozenset({"eq", "ne", "lt", "gt", "le", "ge"})
_WRAPPING: Final = frozenset({"add", "sub", "mul", "and", "or", "xor"})
_INTEGER: Final[dict[str, Callable[..., Any]]] = {
    **_EITHER,
    "div": _quotient,
    "rem": _remainder,
    "and": operator.and_,
    "or": operator.or_,
    "xor": operator.xor,
}
_FLOAT: Final[dict[str, Callable[..., Any]]] = {
    **_EITHER,
    "div": _divide,
    "min": _least,
    "max": _most,
    "copysign": math.copysign,
    "abs": abs,
    "neg": lambda value: -value,
    "ceil": _whole(math.ceil),
    "floor": _whole(math.floor),
    "trunc": _whole(math.trunc),
    "nearest": _nearest,
    "sqrt": lambda value: math.sqrt(value) if value >= 0 else math.nan,
}
