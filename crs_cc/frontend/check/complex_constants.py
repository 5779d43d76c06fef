"""Products and quotients of complex constants, to the bits that gcc computes.

It rounds each part of the exact result once. Quotients of integers are those of R. L. Smith's
method (CACM 1962, algorithm 116), each of whose divisions is truncated, see the library's
`complex_integers.c`.

>>> floating("/", 1 + 2j, 3 - 4j)
(-0.2+0.4j)
>>> from crs_cc.ir.types import INT
>>> integer_quotient(INT, -7, 5, 2, 3)
(1, 2)
"""

from __future__ import annotations

import cmath
import math
from fractions import Fraction

from crs_cc.frontend.check.fold import wrap
from crs_cc.ir.types import IntegerType


def floating(op: str, left: complex, right: complex) -> complex | None:
    """Return `left * right` or `left / right`; None for infinite or undefined operands."""
    if not (cmath.isfinite(left) and cmath.isfinite(right)):
        return None
    a, b, c, d = left.real, left.imag, right.real, right.imag
    if op == "*":
        signs = a * c - b * d, a * d + b * c
        scale = Fraction(1)
    elif right == 0:
        return _by_zero(left, c) if left != 0 else None
    else:
        signs = a * c + b * d, b * c - a * d
        scale = Fraction(c) ** 2 + Fraction(d) ** 2
        d = -d
    a_, b_, c_, d_ = map(Fraction, (a, b, c, d))
    exact = (a_ * c_ - b_ * d_) / scale, (a_ * d_ + b_ * c_) / scale
    return complex(*map(_rounded, exact, signs))


def _by_zero(left: complex, zero: float) -> complex:
    """Return what C17 G.5.1p8 has for a division by zero."""
    infinity = math.copysign(math.inf, zero)
    return complex(*(infinity * each if each else math.nan for each in (left.real, left.imag)))


def _rounded(exact: Fraction, near: float) -> float:
    """Return the nearest `double`; a zero has the sign of `near`, if that is a zero."""
    if not exact:
        return near if near == 0 else 0.0
    try:
        return exact.numerator / exact.denominator
    except OverflowError:
        return math.inf if exact > 0 else -math.inf


def integer_quotient(ctype: IntegerType, a: int, b: int, c: int, d: int) -> tuple[int, int] | None:
    """Return `(a + bi) / (c + di)` in an integer type; None if a part is divided by zero."""
    small, large = (c, d) if abs(c) < abs(d) else (d, c)
    if large == 0:
        return None
    ratio = _truncated(small, large)
    divisor = wrap(small * ratio + large, ctype.bits, ctype.signed)
    if divisor == 0:
        return None
    parts = (a * ratio + b, b * ratio - a) if abs(c) < abs(d) else (b * ratio + a, b - a * ratio)
    real, imaginary = (wrap(each, ctype.bits, ctype.signed) for each in parts)
    return _truncated(real, divisor), _truncated(imaginary, divisor)


def _truncated(left: int, right: int) -> int:
    quotient = abs(left) // abs(right)
    return quotient if (left < 0) == (right < 0) else -quotient
