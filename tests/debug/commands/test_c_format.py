"""`printf` of the debugger beside the C library's."""

from __future__ import annotations

import ctypes
import itertools
import struct

import pytest

from crs_cc.debug.commands.c_format import formatted_text, string_literal
from crs_cc.debug.data.values import Value
from crs_cc.debug.errors import DebugError
from crs_cc.ir.types import CHAR, DOUBLE, INT, UINT, ArrayType, CType

FLAGS = ["", "-", "+", " ", "#", "0", "-#", "+0", "#0"]
WIDTHS = ["", "1", "12"]
PRECISIONS = ["", ".", ".0", ".3"]


def value(ctype: CType, content: bytes) -> Value:
    return Value(None, ctype, content)  # type: ignore[arg-type]  # no pointer is followed


def integer(number: int, ctype: CType = INT) -> Value:
    return value(ctype, (number & 0xFFFF_FFFF).to_bytes(4, "little"))


def real(number: float) -> Value:
    return value(DOUBLE, struct.pack("<d", number))


def text(content: bytes) -> Value:
    return value(ArrayType(CHAR, len(content)), content)


def by_libc(pattern: str, *arguments: object) -> str:
    buffer = ctypes.create_string_buffer(200)
    ctypes.CDLL(None).snprintf(buffer, 200, pattern.encode(), *arguments)
    return buffer.value.decode()


def patterns(kinds: str, flags: list[str]) -> list[str]:
    made = itertools.product(flags, WIDTHS, PRECISIONS, kinds)
    return [f"<%{flag}{width}{precision}{kind}>" for flag, width, precision, kind in made]


def test_integers_are_formatted_as_by_the_c_library() -> None:
    for pattern in patterns("dixXou", FLAGS):
        for number in (0, 7, -7, 300, -(2**31)):
            expected = by_libc(pattern, ctypes.c_int(number))
            assert formatted_text(pattern, [integer(number)]) == expected, pattern


def test_reals_are_formatted_as_by_the_c_library() -> None:
    for pattern in patterns("fFeEgG", FLAGS):
        for number in (0.0, 1.5, -2.25e-7, 1e20):
            expected = by_libc(pattern, ctypes.c_double(number))
            assert formatted_text(pattern, [real(number)]) == expected, pattern


def test_characters_strings_and_stars_are_formatted_as_by_the_c_library() -> None:
    for pattern in patterns("c", ["", "-"]):
        if "." not in pattern:
            assert formatted_text(pattern, [integer(65)]) == by_libc(pattern, ctypes.c_int(65))
    for pattern in patterns("s", ["", "-"]):
        expected = by_libc(pattern, b"robot")
        assert formatted_text(pattern, [text(b"robot\0rest")]) == expected
    star = formatted_text("%*d|%-*d|%.*f", [integer(n) for n in (5, 42, 4, 7, 2)] + [real(0.125)])
    assert star == by_libc("%*d|%-*d|%.*f", 5, 42, 4, 7, 2, ctypes.c_double(0.125))


def test_numbers_are_converted_to_what_the_conversion_needs() -> None:
    assert formatted_text("%.1f %d", [integer(3), real(2.75)]) == "3.0 2"
    assert formatted_text("%u %#x %p", [integer(-1), integer(255, UINT), integer(16)]) == (
        "4294967295 0xff 0x10"
    )
    assert formatted_text("%a", [real(1.0)]) == "0x1p+0"


def test_what_would_act_on_a_terminal_is_escaped() -> None:
    assert formatted_text("%s", [text(b"\x1b[2Jx\0")]) == "\\033[2Jx"


@pytest.mark.parametrize(
    ("pattern", "values", "message"),
    [
        ("%d", [], "not enough arguments"),
        ("%%", [integer(1)], "too many arguments"),
        ("%s", [integer(1)], "shown as a string"),
        ("%d", [text(b"x\0")], "is not a number"),
    ],
)
def test_unsuitable_arguments_are_errors(pattern: str, values: list[Value], message: str) -> None:
    with pytest.raises(DebugError, match=message):
        formatted_text(pattern, values)


def test_escapes_of_literals_are_those_of_c() -> None:
    assert string_literal(r'"\x41\101\t\"\\"') == 'AA\t"\\'
    with pytest.raises(DebugError, match="not a format string"):
        string_literal("speed")
