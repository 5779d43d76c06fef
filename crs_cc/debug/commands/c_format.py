r"""Formatting of values by a format string of C, for `printf`.

>>> string_literal(r'"100%%\n"')
'100%%\n'
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from crs_cc.debug.commands.formats import printable_text
from crs_cc.debug.errors import DebugError
from crs_cc.ir.types import FloatType

if TYPE_CHECKING:
    from crs_cc.debug.data.values import Value

CONVERSION: Final = re.compile(
    r"%(?:%|(?P<flags>[-+ #0]*)(?P<width>\d{0,3}|\*)(?:\.(?P<precision>\d{0,3}|\*))?"
    r"(?:hh|h|ll|l|L|z|t|j)?(?P<kind>[diouxXcsfFeEgGap]))"
)
"""A conversion specification (C17 7.21.6.1) of at most three digits of width."""

_LITERAL: Final = re.compile(r'"(?:[^"\\]|\\.)*"')
_ESCAPE: Final = re.compile(r"\\(x[0-9a-fA-F]{1,2}|[0-7]{1,3}|.)", re.DOTALL)
_ESCAPES: Final = {"n": "\n", "t": "\t", "a": "\a", "b": "\b", "r": "\r", "e": "\x1b"}


def string_literal(text: str) -> str:
    """Return the content of a C string literal.

    Raises:
        DebugError: it is invalid.
    """
    if not _LITERAL.fullmatch(text):
        raise DebugError(f"{text} is not a format string in double quotes")
    return unescaped(text[1:-1])


def unescaped(text: str) -> str:
    r"""Return a text with C's escape sequences replaced.

    >>> unescaped(r"a\tb\41")
    'a\tb!'
    """

    def meant(found: re.Match[str]) -> str:
        code = found[1]
        if code[0] == "x" and len(code) > 1:
            return chr(int(code[1:], 16))
        if code[0] in "01234567":
            return chr(int(code, 8) & 0xFF)
        return _ESCAPES.get(code, code)

    return _ESCAPE.sub(meant, text)


@dataclass(frozen=True, slots=True)
class _Conversion:
    """A conversion specification.

    Attributes:
        flags: some of `-+ #0`.
        width: the least number of characters.
        precision: None for the default.
        kind: the letter.
    """

    flags: str
    width: int
    precision: int | None
    kind: str

    def padded(self, sign: str, digits: str, *, zeros: bool = False) -> str:
        """Return a text of the least width: digits after a sign or prefix."""
        if zeros and "0" in self.flags and "-" not in self.flags:
            return sign + digits.rjust(self.width - len(sign), "0")
        text = sign + digits
        return text.ljust(self.width) if "-" in self.flags else text.rjust(self.width)


def formatted_text(pattern: str, values: Sequence[Value]) -> str:
    """Return a format string with its conversions replaced by values, as `printf` would.

    Raises:
        DebugError: there are too few or too many values, or one does not suit its conversion.
    """
    left = iter(values)

    def converted(found: re.Match[str]) -> str:
        if found["kind"] is None:
            return "%"
        flags = found["flags"]
        width = _number(found["width"], left)
        precision = None if found["precision"] is None else _number(found["precision"], left)
        if precision is not None and precision < 0:  # C17 7.21.6.1p5
            precision = None
        if width < 0:
            flags, width = f"-{flags}", -width
        own = _Conversion(flags, width, precision, found["kind"])
        return _CONVERTED[own.kind](own, _next(left))

    text = CONVERSION.sub(converted, pattern)
    more = sum(1 for _ in left)
    if more:
        raise DebugError(f"too many arguments for the format: {more} more than conversions")
    return text


def _next(left: Iterator[Value]) -> Value:
    value = next(left, None)
    if value is None:
        raise DebugError("not enough arguments for the format")
    return value


def _number(digits: str, left: Iterator[Value]) -> int:
    """Return a width or precision, which may be the next argument."""
    if digits == "*":
        return max(-999, min(999, _whole(_next(left))))
    return int(digits or 0)


def _whole(value: Value) -> int:
    number = value.number
    if isinstance(number, float):
        if not abs(number) < 2**63:
            raise DebugError(f"{value.text} is not an integer")
        return int(number)
    if number is None:
        raise DebugError("an argument is not a number")
    return number


def _unsigned(value: Value) -> int:
    size = 8 if isinstance(value.type, FloatType) else value.type.size
    return _whole(value) & ((1 << 8 * size) - 1)


def _sign(own: _Conversion, *, negative: bool) -> str:
    return "-" if negative else "+" if "+" in own.flags else " " * (" " in own.flags)


def _integer(own: _Conversion, value: Value) -> str:
    number = _whole(value) if own.kind in "di" else _unsigned(value)
    base = {"o": "o", "x": "x", "X": "X"}.get(own.kind, "d")
    sign = _sign(own, negative=number < 0) if own.kind in "di" else ""
    digits = "" if number == own.precision == 0 else f"{abs(number):{base}}"
    digits = digits.rjust(own.precision or 0, "0")
    if "#" in own.flags and base in "xX" and number:
        sign = f"0{base}"
    elif "#" in own.flags and base == "o" and not digits.startswith("0"):
        digits = f"0{digits}"
    return own.padded(sign, digits, zeros=own.precision is None)


def _real(own: _Conversion, value: Value) -> str:
    number = value.number
    if number is None:
        raise DebugError("an argument is not a number")
    if own.kind == "a":
        head, _, exponent = abs(number).hex().partition("p")
        head = head.rstrip("0").rstrip(".") if "." in head else head
        sign = _sign(own, negative=math.copysign(1.0, number) < 0)
        return own.padded(sign, f"{head}p{exponent}")
    point = "" if own.precision is None else f".{own.precision}"
    return f"%{own.flags}{own.width or ''}{point}{own.kind}" % number


def _character(own: _Conversion, value: Value) -> str:
    return own.padded("", chr(_whole(value) & 0xFF))


def _string(own: _Conversion, value: Value) -> str:
    return own.padded("", printable_text(value)[: own.precision])


def _address(own: _Conversion, value: Value) -> str:
    return own.padded("", f"{_unsigned(value):#x}")


_CONVERTED: Final[dict[str, Callable[[_Conversion, Value], str]]] = {
    **dict.fromkeys("diouxX", _integer),
    **dict.fromkeys("fFeEgGa", _real),
    "c": _character,
    "s": _string,
    "p": _address,
}
