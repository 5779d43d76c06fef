"""Arithmetic builtins: overflow checks, bit counts, floating-point classification.

Each becomes an expression of ordinary operators; an operand that is needed twice is kept in a
variable.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Final, TypeAlias

from crs_cc.core.source import Location
from crs_cc.frontend.check import fold, tree
from crs_cc.frontend.check.checker import CheckError, Unit
from crs_cc.frontend.check.conversion import (
    assigned,
    convert,
    is_integer,
    is_scalar,
    promote_argument,
)
from crs_cc.frontend.check.expressions import rvalue
from crs_cc.frontend.check.operators import operate
from crs_cc.frontend.check.scope import FunctionSymbol, ObjectSymbol
from crs_cc.frontend.check.tree import Expression
from crs_cc.frontend.parse.nodes import Node
from crs_cc.ir.types import (
    DOUBLE,
    FLOAT,
    INT,
    LDOUBLE,
    LLONG,
    LONG,
    UINT,
    ULLONG,
    ULONG,
    USHORT,
    CType,
    EnumType,
    FloatType,
    FunctionType,
    IntegerType,
    PointerType,
    unqualified,
)

NumberBuiltin: TypeAlias = Callable[[Unit, list[Node], Location], Expression]

NUMBER_BUILTINS: Final[dict[str, NumberBuiltin]] = {}
"""The checker of each builtin in this file."""


def _values(unit: Unit, nodes: list[Node], count: int, location: Location) -> list[Expression]:
    if len(nodes) != count:
        what = "few" if len(nodes) < count else "many"
        text = f"too {what} arguments to function call, expected {count}, have {len(nodes)}"
        raise CheckError(location, text)
    return [rvalue(unit, each) for each in nodes]


def kept(value: Expression) -> tuple[Expression, Expression]:
    """Return the assignment of a value to a new variable, and the variable; constants stay."""
    if isinstance(value, tree.Literal):
        return value, value
    in_memory = not is_scalar(value.type)
    symbol = ObjectSymbol("", value.type, value.location, in_memory=in_memory)
    name = tree.ObjectName(value.type, value.location, symbol)
    return tree.Assign(value.type, value.location, name, value), name


def then(*parts: Expression) -> Expression:
    """Build `a, b, c`, without constants that nothing uses."""
    result = parts[-1]
    for each in reversed(parts[:-1]):
        if isinstance(each, tree.Literal):
            continue
        result = tree.Comma(result.type, result.location, each, result)
    return result


# Overflow


def _overflow(op: str, ctype: CType | None, *, has_target: bool = True) -> NumberBuiltin:
    """Return the checker of an overflow builtin.

    Args:
        op: `+`, `-` or `*`.
        ctype: the type of both operands and of the result; None if it accepts any.
        has_target: whether the last argument points to the result, and is not just a value of
            its type.
    """

    def check(unit: Unit, nodes: list[Node], location: Location) -> Expression:
        left, right, last = _values(unit, nodes, 3, location)
        if ctype is not None:
            left, right = (assigned(unit, each, ctype, "pass") for each in (left, right))
            last = assigned(unit, last, PointerType(ctype), "pass")
        target = last.type
        if has_target:
            target = target.target if isinstance(target, PointerType) else target
        for each in (left.type, right.type, target):
            if not is_integer(each):
                raise CheckError(location, f"overflow of '{each}' is not supported")
        target = unqualified(target)
        if not has_target and (known := _known(op, left, right, target)) is not None:
            return tree.integer(known, INT, location)
        keep, pointer = kept(last)
        first = [keep] if has_target else [convert(last, INT)]
        place = tree.Dereference(target, location, pointer) if has_target else None
        if max(left.type.size, right.type.size, target.size) > 4:
            return _wide(op, (left, right), target, (first, place), location)
        left, right = (convert(convert(each, LLONG), ULLONG) for each in (left, right))
        exact = operate(unit, op, left, right, location)  # unsigned, as it may wrap
        keep_exact, exact = kept(convert(exact, LLONG))
        cut = convert(exact, target)
        store = [] if place is None else [tree.Assign(target, location, place, cut)]
        differs = operate(unit, "!=", convert(cut, LLONG), exact, location)
        return then(keep_exact, *first, *store, differs)

    return check


def _known(op: str, left: Expression, right: Expression, target: CType) -> int | None:
    """Return whether an operation on constants overflows a type; None if they are not constant."""
    assert isinstance(target, IntegerType | EnumType)
    if not isinstance(left, tree.Literal) or not isinstance(right, tree.Literal):
        return None
    exact = fold.exact(op, int(left.value), int(right.value))
    return int(exact != fold.wrap(exact, target.bits, target.signed))


_WIDE: Final = FunctionType(INT, (INT, ULLONG, INT, ULLONG, INT, INT, INT, PointerType(ULLONG)))


def _wide(
    op: str,
    operands: tuple[Expression, Expression],
    target: CType,
    where: tuple[list[Expression], Expression | None],
    location: Location,
) -> Expression:
    """Return a call of the library's calculation, for results that may exceed 64 bits."""
    assert isinstance(target, IntegerType | EnumType)
    symbol = ObjectSymbol("", ULLONG, location, in_memory=True)
    result = tree.ObjectName(ULLONG, location, symbol)
    name = "__crs_exact"
    callee = tree.FunctionName(_WIDE, location, FunctionSymbol(name, _WIDE, location, name))
    arguments: list[Expression] = [tree.integer(ord(op), INT, location)]
    for each in operands:
        arguments += [convert(each, ULLONG), tree.integer(_is_signed(each.type), INT, location)]
    arguments.append(tree.integer(8 * target.size, INT, location))
    arguments.append(tree.integer(_is_signed(target), INT, location))
    arguments.append(tree.AddressOf(PointerType(ULLONG), location, result))
    keep, overflows = kept(tree.Call(INT, location, callee, arguments))
    first, place = where
    if place is None:
        return then(keep, *first, overflows)
    store = tree.Assign(target, location, place, convert(result, target))
    return then(keep, *first, store, overflows)


def _is_signed(ctype: CType) -> int:
    return int(isinstance(ctype, IntegerType | EnumType) and ctype.signed)


def _enter_overflow() -> None:
    for word, op in (("add", "+"), ("sub", "-"), ("mul", "*")):
        NUMBER_BUILTINS[f"__builtin_{word}_overflow"] = _overflow(op, None)
        NUMBER_BUILTINS[f"__builtin_{word}_overflow_p"] = _overflow(op, None, has_target=False)
        for sign, types in (("s", (INT, LONG, LLONG)), ("u", (UINT, ULONG, ULLONG))):
            for suffix, ctype in zip(("", "l", "ll"), types, strict=True):
                NUMBER_BUILTINS[f"__builtin_{sign}{word}{suffix}_overflow"] = _overflow(op, ctype)


# Bits


def _bits(ctype: IntegerType, make: Callable[[Unit, Expression], Expression]) -> NumberBuiltin:
    """Return the checker of a function of one integer."""

    def check(unit: Unit, nodes: list[Node], location: Location) -> Expression:
        (value,) = _values(unit, nodes, 1, location)
        keep, name = kept(assigned(unit, value, ctype, "pass"))
        return then(keep, make(unit, name))

    return check


def _number(value: int, like: Expression) -> Expression:
    return tree.integer(value, INT, like.location)


def _count(name: str, value: Expression) -> Expression:
    suffix = "ll" if value.type.size == 8 else ""
    return _computed(INT, f"__builtin_{name}{suffix}", [value])


def _computed(ctype: CType, name: str, operands: list[Expression]) -> Expression:
    """Return the call of a builtin, folded if its operands are constant."""
    return folded(tree.Intrinsic(ctype, operands[0].location, name, operands))


def folded(call: tree.Intrinsic) -> Expression:
    """Return the value of a builtin's call as a constant if it is one."""
    values = [each.value for each in call.arguments if isinstance(each, tree.Literal)]
    if not values or len(values) < len(call.arguments):
        return call
    value = fold.builtin(call.name, values, call.arguments[0].type)
    return call if value is None else tree.Literal(call.type, call.location, value)


def _either(test: Expression, then: Expression, otherwise: Expression) -> Expression:
    """Return `test ? then : otherwise` of two `int`s, folded if the test is constant."""
    if isinstance(test, tree.Literal):
        return then if test.value else otherwise
    return tree.Conditional(INT, test.location, test, then, otherwise)


def _find_first(unit: Unit, value: Expression) -> Expression:
    number = operate(unit, "+", _count("ctz", value), _number(1, value), value.location)
    return _either(value, number, _number(0, value))


def _parity(unit: Unit, value: Expression) -> Expression:
    return operate(unit, "&", _count("popcount", value), _number(1, value), value.location)


def _sign_bits(unit: Unit, value: Expression) -> Expression:
    """Count the redundant sign bits: the leading zeros of `x ^ x >> all`, less one."""
    place, width = value.location, 8 * value.type.size
    sign = operate(unit, ">>", value, _number(width - 1, value), place)
    same = operate(unit, "^", value, sign, place)
    doubled = operate(unit, "<<", same, _number(1, value), place)
    last = operate(unit, "|", doubled, _number(1, value), place)
    return _count("clz", last)


def _swap_bytes(unit: Unit, value: Expression) -> Expression:
    place, size = value.location, value.type.size
    wide = ULLONG if size == 8 else UINT
    result: Expression = tree.integer(0, wide, place)
    for number in range(size):
        byte = operate(unit, ">>", convert(value, wide), _number(8 * number, value), place)
        byte = operate(unit, "&", byte, _number(0xFF, value), place)
        moved = operate(unit, "<<", byte, _number(8 * (size - 1 - number), value), place)
        result = operate(unit, "|", result, moved, place)
    return convert(result, value.type)


def _enter_bits() -> None:
    signed, unsigned = (INT, LONG, LLONG), (UINT, ULONG, ULLONG)
    for suffix, ctype, plain in zip(("", "l", "ll"), signed, unsigned, strict=True):
        NUMBER_BUILTINS[f"__builtin_ffs{suffix}"] = _bits(ctype, _find_first)
        NUMBER_BUILTINS[f"__builtin_clrsb{suffix}"] = _bits(ctype, _sign_bits)
        NUMBER_BUILTINS[f"__builtin_parity{suffix}"] = _bits(plain, _parity)
    for width, ctype in ((16, USHORT), (32, UINT), (64, ULLONG)):
        NUMBER_BUILTINS[f"__builtin_bswap{width}"] = _bits(ctype, _swap_bytes)


# Floating-point classification and comparison (C17 7.12.3, 7.12.14)

_LIMITS: Final = {FLOAT: 2.0**-126, DOUBLE: 2.0**-1022, LDOUBLE: 2.0**-1022}


def _float(make: Callable[[Unit, Expression], Expression]) -> NumberBuiltin:
    """Return the checker of a function of one floating-point number of any type."""

    def check(unit: Unit, nodes: list[Node], location: Location) -> Expression:
        (value,) = _values(unit, nodes, 1, location)
        if not isinstance(value.type, FloatType):
            raise CheckError(location, f"'{value.type}' is not a floating type")
        keep, name = kept(value)
        return then(keep, make(unit, name))

    return check


def _real(value: float, like: Expression) -> Expression:
    return tree.Literal(like.type, like.location, value)


def _magnitude(value: Expression) -> Expression:
    suffix = "f" if value.type.size == 4 else ""
    return _computed(value.type, f"__builtin_fabs{suffix}", [value])


def _is_nan(unit: Unit, value: Expression) -> Expression:
    return operate(unit, "!=", value, value, value.location)


def _is_infinite(unit: Unit, value: Expression) -> Expression:
    return operate(unit, "==", _magnitude(value), _real(math.inf, value), value.location)


def _infinite_sign(unit: Unit, value: Expression) -> Expression:
    place = value.location
    above = operate(unit, "==", value, _real(math.inf, value), place)
    below = operate(unit, "==", value, _real(-math.inf, value), place)
    return operate(unit, "-", above, below, place)


def _is_finite(unit: Unit, value: Expression) -> Expression:
    return operate(unit, "<", _magnitude(value), _real(math.inf, value), value.location)


def _is_normal(unit: Unit, value: Expression) -> Expression:
    lowest = _real(_LIMITS[unqualified(value.type)], value)  # type: ignore[index]
    large = operate(unit, ">=", _magnitude(value), lowest, value.location)
    return operate(unit, "&", large, _is_finite(unit, value), value.location)


def _sign_bit(unit: Unit, value: Expression) -> Expression:
    suffix = "f" if value.type.size == 4 else ""
    operands = [_real(1.0, value), value]
    one = _computed(value.type, f"__builtin_copysign{suffix}", operands)
    return operate(unit, "<", one, _real(0.0, value), value.location)


def _classify(unit: Unit, nodes: list[Node], location: Location) -> Expression:
    """Check `__builtin_fpclassify(nan, infinite, normal, subnormal, zero, x)`."""
    *kinds, value = _values(unit, nodes, 6, location)
    kinds = [assigned(unit, each, INT, "pass") for each in kinds]
    keep, name = kept(value)
    is_zero = operate(unit, "==", name, _real(0.0, name), location)
    tests = [_is_nan(unit, name), _is_infinite(unit, name), _is_normal(unit, name), is_zero]
    result = kinds[3]
    for test, kind in zip(reversed(tests), (kinds[4], kinds[2], kinds[1], kinds[0]), strict=True):
        result = _either(test, kind, result)
    return then(keep, result)


def _ordered(*ops: str) -> NumberBuiltin:
    """Return the checker of a comparison; several operators are joined by `or`."""

    def check(unit: Unit, nodes: list[Node], location: Location) -> Expression:
        operands = _values(unit, nodes, 2, location)
        pairs = [kept(promote_argument(each)) for each in operands]
        (_, left), (_, right) = pairs
        result: Expression = tree.integer(0, INT, location)
        for op in ops:
            if op == "unordered":
                test = operate(unit, "|", _is_nan(unit, left), _is_nan(unit, right), location)
            else:
                test = operate(unit, op, left, right, location)
            result = operate(unit, "|", result, test, location)
        return then(*(keep for keep, _ in pairs), result)

    return check


def _enter_floats() -> None:
    kinds = {
        "isnan": _is_nan,
        "isinf": _is_infinite,
        "isfinite": _is_finite,
        "finite": _is_finite,
        "isnormal": _is_normal,
        "isinf_sign": _infinite_sign,
        "signbit": _sign_bit,
    }
    for name, make in kinds.items():
        for suffix in ("", "f", "l") if name != "isnormal" else ("",):
            NUMBER_BUILTINS[f"__builtin_{name}{suffix}"] = _float(make)
    comparisons = {
        "isgreater": (">",),
        "isgreaterequal": (">=",),
        "isless": ("<",),
        "islessequal": ("<=",),
        "islessgreater": ("<", ">"),
        "isunordered": ("unordered",),
    }
    for name, ops in comparisons.items():
        NUMBER_BUILTINS[f"__builtin_{name}"] = _ordered(*ops)
    NUMBER_BUILTINS["__builtin_fpclassify"] = _classify


_enter_overflow()
_enter_bits()
_enter_floats()
