"""Warnings about implicit conversions that change a number: overflow, and lost fractions."""

from __future__ import annotations

from crs_cc.core.source import Location
from crs_cc.frontend.check import fold, tree
from crs_cc.frontend.check.checker import Unit
from crs_cc.ir.types import BOOL, INT, CType, EnumType, FloatType, IntegerType


def warn_constant(unit: Unit, value: tree.Expression, target: CType) -> None:
    """Warn about a constant that an implicit conversion changes (C17 6.3.1.3, 6.3.1.4).

    A number that the type of the other sign holds is accepted, as in gcc: `char c = 0xff`,
    `unsigned n = -1`; unless its own type is larger: `int n = 3000000000`.
    """
    if not isinstance(value, tree.Literal) or not isinstance(target, IntegerType | EnumType):
        return
    low, high = -(1 << target.bits - 1), 1 << target.bits
    if target.signed and value.type.size > target.size >= INT.size:
        high >>= 1
    if target == BOOL or low <= value.value < high:
        return
    changed = fold.convert(value.value, value.type, target)
    number = value.value if isinstance(value.value, int) else f"{value.value:g}"
    text = f"conversion from '{value.type}' to '{target}' changes {number} to {changed}"
    unit.warning(value.location, text, flag="overflow")


def warn_overflow(
    unit: Unit, op: str, left: tree.Literal, right: tree.Literal, location: Location
) -> None:
    """Warn about constant arithmetic whose result its signed type cannot hold (C17 6.5p5)."""
    ctype = left.type
    if op not in {"+", "-", "*"} or not isinstance(ctype, IntegerType) or not ctype.signed:
        return
    a, b = int(left.value), int(right.value)
    exact = a + b if op == "+" else a - b if op == "-" else a * b
    if not -(1 << ctype.bits - 1) <= exact < 1 << ctype.bits - 1:
        text = f"overflow in the constant expression: {exact} is outside the range of '{ctype}'"
        unit.warning(location, text, flag="overflow")


def is_inexact(op: str, left: tree.Literal, right: tree.Literal) -> bool:
    """Return whether an operation is a division of integers with a remainder."""
    if op != "/" or not isinstance(left.type, IntegerType | EnumType):
        return False
    return int(left.value) % int(right.value) != 0


def warn_divisions(unit: Unit, left: tree.Expression, right: tree.Expression) -> None:
    """Check both operands of arithmetic: `4 / 3 * PI`."""
    warn_division(unit, left, right.type)
    warn_division(unit, right, left.type)


def warn_division(unit: Unit, value: tree.Expression, target: CType) -> None:
    """Warn about a quotient of integers whose fraction is lost: `double half = 1 / 2`.

    What is cast is accepted, and so are quotients of sizes, which are unsigned.
    """
    if not isinstance(target, FloatType):
        return
    if isinstance(value, tree.Literal):
        is_lost, result = value.is_truncated, f": its value is {value.value}"
    else:
        is_lost, result = _is_quotient(value), ""
    if is_lost:
        text = f"the fraction of this division of integers is lost{result}"
        hint = "make one operand a floating-point number, such as 2.0 or (double)n"
        unit.warning(value.location, text, hint, flag="integer-division")


def _is_quotient(value: tree.Expression) -> bool:
    """Return whether an expression is the quotient of signed integers."""
    ctype = value.type
    is_division = isinstance(value, tree.Binary) and value.op == "/"
    return is_division and isinstance(ctype, IntegerType) and ctype.signed
