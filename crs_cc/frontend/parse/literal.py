r"""The values of constants and string literals (C17 6.4.4, 6.4.5).

>>> value, ctype = number("0x80000000u")
>>> value, str(ctype)
(2147483648, 'unsigned int')
>>> character("'\\n'")[0], character("'ab'")[0], string('"\\x41\\102" "C"')[0]
(10, 24930, b'ABC\x00')
"""

from __future__ import annotations

import re
import struct
from collections.abc import Callable
from functools import lru_cache
from typing import Final

from crs_cc.ir.types import (
    CHAR,
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
    FloatType,
    IntegerType,
)

_MAX_DIGITS: Final = 100
_SUFFIX: Final = re.compile(r"[uUlL]*$")
_DECIMAL: Final = {"": (INT, LONG, LLONG), "l": (LONG, LLONG), "ll": (LLONG,)}
_DECIMAL_OF_C90: Final = {
    "": (INT, LONG, ULONG, LLONG), "l": (LONG, ULONG, LLONG), "ll": (LLONG,)
}  # fmt: skip
"""In C90 a decimal constant may have the type `unsigned long`."""

_ANY_SIGN: Final = {
    "": (INT, UINT, LONG, ULONG, LLONG, ULLONG),
    "l": (LONG, ULONG, LLONG, ULLONG),
    "ll": (LLONG, ULLONG),
}
_UNSIGNED: Final = {"u": (UINT, ULONG, ULLONG), "ul": (ULONG, ULLONG), "ull": (ULLONG,)}

_ESCAPE: Final = re.compile(
    r"\\(?:([0-7]{1,3})|x([0-9a-fA-F]+)|u([0-9a-fA-F]{4})|U([0-9a-fA-F]{8})|(.))", re.DOTALL
)
_SIMPLE_ESCAPES: Final = {
    "a": 7, "b": 8, "t": 9, "n": 10, "v": 11, "f": 12, "r": 13, "e": 27, "E": 27,
}  # fmt: skip
_PREFIX: Final = re.compile(r"(L|u8|u|U)?(?=['\"])")
_ELEMENT: Final = {None: CHAR, "": CHAR, "u8": CHAR, "L": INT, "u": USHORT, "U": UINT}


@lru_cache(maxsize=4096)
def number(text: str, is_c90: bool = False) -> tuple[int | float, IntegerType | FloatType]:
    """Return the value and type of an integer or floating constant.

    Args:
        text: the constant.
        is_c90: whether it has the type of C90.

    Raises:
        ValueError: no type can represent the value.
    """
    text = text.replace("'", "")
    is_hex = text[:2] in {"0x", "0X"}
    if is_hex and ("p" in text or "P" in text):
        return _floating(text.rstrip("fFlL"), text[-1], float.fromhex)
    if not is_hex and any(mark in text for mark in ".eE"):
        return _floating(text.rstrip("fFlL"), text[-1], float)
    return _integer(text, is_c90)


def _floating(digits: str, suffix: str, convert: Callable[[str], float]) -> tuple[float, FloatType]:
    try:
        value = convert(digits)
    except OverflowError:
        value = float("inf")
    if suffix in "fF":
        return single(value), FLOAT
    return value, LDOUBLE if suffix in "lL" else DOUBLE


def single(value: float) -> float:
    """Round to the nearest `float`; too large a value becomes infinite (C17 6.3.1.5)."""
    try:
        return float(struct.unpack("<f", struct.pack("<f", value))[0])
    except OverflowError:
        return float("inf") if value > 0 else float("-inf")


def _integer(text: str, is_c90: bool) -> tuple[int, IntegerType]:
    found = _SUFFIX.search(text)
    suffix = "" if found is None else found.group().lower()
    digits = text[: len(text) - len(suffix)]
    prefix = digits[:2].lower()
    base = {"0x": 16, "0b": 2}.get(prefix, 8 if digits[0] == "0" else 10)
    if len(digits) > _MAX_DIGITS:
        raise ValueError("integer constant is too large for any type")
    value = int(digits[2:] if base in {16, 2} else digits, base)
    length = suffix.count("l") * "l"
    if "u" in suffix:
        types = _UNSIGNED["u" + length]
    else:
        decimal = _DECIMAL_OF_C90 if is_c90 else _DECIMAL
        types = (decimal if base == 10 else _ANY_SIGN)[length]
    for ctype in types:
        if value <= ctype.largest:
            return value, ctype
    if value <= ULLONG.largest:
        return value, ULLONG
    raise ValueError(f"integer constant {text} is too large for any type")


@lru_cache(maxsize=1024)
def character(text: str) -> tuple[int, IntegerType]:
    """Return the value and type of a character constant; `'ab'` is `'a' * 256 + 'b'`, as in gcc.

    Raises:
        ValueError: it is empty or contains a number that is too large.
    """
    prefix, body = _split(text)
    units = _units(body, prefix)
    if not units:
        raise ValueError("empty character constant")
    element = _ELEMENT[prefix]
    if element is not CHAR:
        return units[-1], element
    if len(units) == 1:
        return units[0] - 256 if units[0] > CHAR.largest else units[0], INT
    value = 0
    for unit in units:
        value = (value << 8 | unit) & 0xFFFFFFFF
    return value - (1 << 32) if value > INT.largest else value, INT


@lru_cache(maxsize=1024)
def string(text: str) -> tuple[bytes, IntegerType]:
    """Return the bytes of adjacent string literals, with the final zero, and the element type.

    Raises:
        ValueError: a number in it is too large for an element.
    """
    prefix, _ = _split(text)
    element = _ELEMENT[prefix]
    units = [unit for part in _parts(text) for unit in _units(part, prefix)] + [0]
    try:
        return b"".join(unit.to_bytes(element.size, "little") for unit in units), element
    except OverflowError:
        raise ValueError("escape sequence out of range") from None


def _split(text: str) -> tuple[str, str]:
    found = _PREFIX.match(text)
    prefix = (found.group(1) if found is not None else None) or ""
    return prefix, text[len(prefix) + 1 : -1]


def _parts(text: str) -> list[str]:
    """Return the text between the quotes of each of several adjacent literals."""
    return [found.group(1) for found in re.finditer(r'"((?:[^"\\]|\\.)*)"', text, re.DOTALL)]


def _units(body: str, prefix: str) -> list[int]:
    """Return the array elements that a literal's text denotes, as numbers."""
    units: list[int] = []
    position = 0
    for found in _ESCAPE.finditer(body):
        units.extend(_encoded(body[position : found.start()], prefix))
        units.extend(_escape(found, prefix))
        position = found.end()
    units.extend(_encoded(body[position:], prefix))
    return units


def _escape(found: re.Match[str], prefix: str) -> list[int]:
    octal, hexadecimal, short, long, simple = found.groups()
    if octal is not None or hexadecimal is not None:
        value = int(octal, 8) if octal is not None else int(hexadecimal, 16)
        if value >= 1 << 8 * _ELEMENT[prefix].size:
            raise ValueError("escape sequence out of range")
        return [value]
    if simple is None:
        code = int(short or long, 16)
        if code > 0x10FFFF:
            raise ValueError("escape sequence out of range")
        return _encoded(chr(code), prefix)
    if simple in _SIMPLE_ESCAPES:
        return [_SIMPLE_ESCAPES[simple]]
    return _encoded(simple, prefix)


def _encoded(text: str, prefix: str) -> list[int]:
    """Encode plain characters: UTF-8 for `char`, else UTF-16 or UTF-32 (as gcc does)."""
    size = _ELEMENT[prefix].size
    if size == 1:
        return list(text.encode("utf-8", "surrogateescape"))
    data = text.encode("utf-16-le" if size == 2 else "utf-32-le", "surrogatepass")
    return [int.from_bytes(data[i : i + size], "little") for i in range(0, len(data), size)]
