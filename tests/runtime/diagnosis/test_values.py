"""Values are formatted as a C programmer would write them."""

from __future__ import annotations

import struct
from dataclasses import replace

import pytest

from crs_cc.ir.types import (
    BOOL,
    CHAR,
    DOUBLE,
    FLOAT,
    INT,
    LLONG,
    SHORT,
    UCHAR,
    UINT,
    VOID,
    ArrayType,
    CType,
    Enumeration,
    EnumType,
    FunctionType,
    Member,
    PointerType,
    Record,
    RecordType,
)
from crs_cc.runtime.diagnosis.values import BRIEF, LONGEST, Values, place_name

STRING = PointerType(CHAR)
MODE = EnumType(Enumeration("mode", {"IDLE": 0, "TURN": 5}))
MEMORY = b"\0\0\0\0left\0\x01\x02\x03" + b"x" * 100


def read(address: int, size: int) -> bytes:
    return MEMORY[address : address + size]


def record(kind: str, *members: Member) -> RecordType:
    made = Record(kind, "point")  # type: ignore[arg-type]
    made.complete(members)
    return RecordType(made)


FLAGS = EnumType(Enumeration("flags", {"NONE": 0, "LEFT": 1, "RIGHT": 2, "BACK": 12}))
POINT = record("struct", Member("x", INT), Member("y", DOUBLE))
SHOWN: list[tuple[CType, bytes, str]] = [
    (INT, b"\xfe\xff\xff\xff", "-2"),
    (UINT, b"\xfe\xff\xff\xff", "4294967294"),
    (SHORT, b"\x00\x80", "-32768"),
    (LLONG, b"\0\0\0\0\x01\0\0\0", "4294967296"),
    (BOOL, b"\x01", "true"),
    (CHAR, b"\x80", "-128"),
    (CHAR, b"\n", r"10 '\n'"),
    (CHAR, b"'", r"39 '\''"),
    (UCHAR, b"\xff", "255"),
    (FLOAT, struct.pack("<f", 0.1), "0.1"),
    (DOUBLE, struct.pack("<d", 0.1), "0.1"),
    (DOUBLE, struct.pack("<d", float("nan")), "nan"),
    (DOUBLE, struct.pack("<d", -float("inf")), "-inf"),
    (MODE, b"\x05\0\0\0", "TURN"),
    (MODE, b"\x06\0\0\0", "6"),
    (MODE, b"\x07\0\0\0", "7"),
    (FLAGS, b"\0\0\0\0", "NONE"),
    (FLAGS, b"\x0d\0\0\0", "LEFT | BACK"),
    (FLAGS, b"\x05\0\0\0", "5"),
    (FLAGS, b"\x11\0\0\0", "17"),
    (EnumType(Enumeration(None)), b"\x06\0\0\0", "6"),
    (STRING, b"\x04\0\0\0", '"left"'),
    (STRING, b"\x08\0\0\0", '""'),
    (STRING, b"\x09\0\0\0", "0x9"),
    (STRING, b"\x10\0\0\0", '"' + "x" * 40 + '"...'),
    (STRING, b"\x00\x10\0\0", "0x1000"),
    (PointerType(VOID), b"\0\0\0\0", "null"),
    (PointerType(FunctionType(INT)), b"\x02\0\0\0", "turn"),
    (PointerType(FunctionType(INT)), b"\x03\0\0\0", "0x3"),
    (PointerType(INT), b"\x44\0\0\0", "&here"),
    (ArrayType(INT, 2), b"\x01\0\0\0\x02\0\0\0", "{1, 2}"),
    (ArrayType(SHORT, 9), b"\x01\0" * 9, "{1, 1, 1, 1, 1, 1, 1, 1, ...}"),
    (ArrayType(CHAR, 4), b"ab\0c", '"ab"'),
    (ArrayType(CHAR, 2), b"ab", "{97 'a', 98 'b'}"),
    (ArrayType(UCHAR, 2), b"\x01\x02", "{1, 2}"),
    (POINT, bytes(16), "{x = 0, y = 0.0}"),
    (record("union", Member("i", INT), Member("c", CHAR)), b"A\0\0\0", "{i = 65, c = 65 'A'}"),
    (
        record("struct", Member("a", UINT, bit_width=3), Member("b", INT, bit_width=4)),
        bytes((0b1_1000_111, 0, 0, 0)),
        "{a = 7, b = -8}",
    ),
    (record("struct", Member(None, POINT), Member(None, INT, bit_width=0)), bytes(16),
     "{{x = 0, y = 0.0}}"),
]  # fmt: skip


@pytest.mark.parametrize(("ctype", "content", "wanted"), SHOWN)
def test_values_are_formatted_by_their_c_types(ctype: CType, content: bytes, wanted: str) -> None:
    values = Values(
        read,
        lambda _address, _size: b"",
        lambda address, _target: "&here" if address == 0x44 else "",
        lambda number: "turn" if number == 2 else "",
    )
    assert values.show(ctype, content) == wanted


def test_long_values_are_cut() -> None:
    shown = Values().show(ArrayType(POINT, 8), bytes(128))
    assert len(shown) == LONGEST
    assert shown.endswith("...")


def test_a_cyclic_list_is_written_once() -> None:
    node = Record("struct", "node")
    node.complete([Member("value", INT), Member("next", PointerType(RecordType(node)))])
    pointer = PointerType(RecordType(node))
    values = Values(lambda _address, _size: b"\x07\0\0\0\x10\0\0\0")
    assert values.show_target(pointer, b"\x10\0\0\0") == "{value = 7, next = 0x10}"
    assert Values().show_target(pointer, b"\x10\0\0\0") == ""


@pytest.mark.parametrize(
    ("ctype", "states", "wanted"),
    [
        (INT, b"\xff\xff\xff\xff", "0"),
        (INT, b"\xff\xff\x01\xff", "?"),
        (POINT, b"\xff" * 8 + b"\x01" * 8, "{x = 0, y = ?}"),
        (ArrayType(SHORT, 2), b"\x01\x01\xff\xff", "{?, 0}"),
        (ArrayType(CHAR, 3), b"\xff\x01\x01", '""'),
        (ArrayType(CHAR, 3), b"\x01\xff\xff", "{?, 0, 0}"),
    ],
)
def test_uninitialised_values_are_not_shown(ctype: CType, states: bytes, wanted: str) -> None:
    assert Values().show(ctype, bytes(ctype.size), states) == wanted


def test_uninitialised_elements_are_equal_whatever_their_bytes() -> None:
    values = Values(style=replace(BRIEF, repeats=3))
    states = b"\x01" * 5 + b"\xff"
    assert values.show(ArrayType(CHAR, 6), b"abcdef", states) == "{? <repeats 5 times>, 102 'f'}"


@pytest.mark.parametrize(
    ("ctype", "offset", "wanted"),
    [
        (INT, 0, "it"),
        (ArrayType(INT, 4), 64, "it[16]"),
        (ArrayType(INT, 4), -4, "it[-1]"),
        (ArrayType(ArrayType(CHAR, 3), 2), 5, "it[1][2]"),
        (POINT, 8, "it.y"),
        (ArrayType(POINT, 2), 24, "it[1].y"),
        (POINT, 4, "it"),
    ],
)
def test_parts_of_objects_have_names(ctype: CType, offset: int, wanted: str) -> None:
    assert place_name("it", ctype, offset) == wanted
