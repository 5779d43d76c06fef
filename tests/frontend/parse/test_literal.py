"""Numbers, characters and strings have the values of gcc."""

from __future__ import annotations

import math

import pytest

from crs_cc.frontend.parse.literal import character, number, single, string

NUMBERS = {
    "0": (0, "int"), "017": (15, "int"), "0x7fffffff": (2147483647, "int"),
    "0xffffffff": (4294967295, "unsigned int"), "0b101": (5, "int"),
    "2147483647": (2147483647, "int"), "2147483648": (2147483648, "long long"),
    "037777777777": (4294967295, "unsigned int"), "1u": (1, "unsigned int"),
    "1L": (1, "long"), "1lu": (1, "unsigned long"), "1LLU": (1, "unsigned long long"),
    "4294967296u": (4294967296, "unsigned long long"),
    "9223372036854775808": (9223372036854775808, "unsigned long long"),
    "1.5": (1.5, "double"), ".5e1": (5.0, "double"), "1e-3f": (single(0.001), "float"),
    "1.": (1.0, "double"), "2.5L": (2.5, "long double"), "0x1.8p1": (3.0, "double"),
    "0x10p-4f": (1.0, "float"), "1e999": (math.inf, "double"), "1e39f": (math.inf, "float"),
}  # fmt: skip


@pytest.mark.parametrize("text", NUMBERS)
def test_number_has_its_value_and_the_first_type_that_fits(text: str) -> None:
    value, ctype = number(text)
    assert (value, ctype.name) == NUMBERS[text]


@pytest.mark.parametrize("text", ["18446744073709551616", "0x10000000000000000", "9" * 5000])
def test_number_too_large_for_any_type_is_an_error(text: str) -> None:
    with pytest.raises(ValueError, match="too large"):
        number(text)


CHARACTERS = {
    "'a'": 97, r"'\n'": 10, r"'\\'": 92, r"'\''": 39, r"'\0'": 0, r"'\377'": -1, r"'\x80'": -128,
    r"'\e'": 27, "'ab'": 24930, "'abcd'": 1633837924, r"'\377\377'": 65535, "L'a'": 97,
    "L'\u263a'": 0x263A, r"L'\x263a'": 0x263A, r"u'\u00e9'": 0xE9, "'\u00e9'": 0xC3A9,
    r"'\q'": 113,
}  # fmt: skip


@pytest.mark.parametrize("text", CHARACTERS)
def test_character_constant_values(text: str) -> None:
    assert character(text)[0] == CHARACTERS[text]


STRINGS = {
    '"abc"': b"abc\0", '""': b"\0", r'"\1" "23"': b"\x0123\0", r'"\x1" "a"': b"\x01a\0",
    r'"a\0b"': b"a\0b\0", r'"\"\\\t"': b'"\\\t\0', '"\u00e9"': b"\xc3\xa9\0",
    '"\udce9"': b"\xe9\0", 'L"a"': b"a\0\0\0\0\0\0\0", 'u"a" "b"': b"a\0b\0\0\0",
    r'u8"\u00e9"': b"\xc3\xa9\0",
}  # fmt: skip


@pytest.mark.parametrize("text", STRINGS)
def test_string_literal_bytes(text: str) -> None:
    assert string(text)[0] == STRINGS[text]


@pytest.mark.parametrize("text", [r"'\400'", r"'\x100'", "''", r"L'\x100000000'", r"'\U00110000'"])
def test_invalid_character_constants_are_errors(text: str) -> None:
    with pytest.raises(ValueError, match=r"range|empty"):
        character(text)
