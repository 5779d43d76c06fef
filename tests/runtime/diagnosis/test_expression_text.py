"""Pointers and names found in the text of an expression."""

from __future__ import annotations

import pytest

from crs_cc.ir.types import INT, ArrayType, CType, Member, PointerType, Record, RecordType
from crs_cc.runtime.diagnosis.expression_text import names_in, pointer_in

NODE = Record("struct", "node")
POINTER = PointerType(RecordType(NODE))
NODE.complete([Member("list", ArrayType(INT, 3)), Member("next", POINTER)])
VARIABLES: dict[str, tuple[CType, bytes]] = {
    "n": (POINTER, b"\x10\0\0\0"),
    "pp": (PointerType(POINTER), b"\x1c\0\0\0"),
    "nodes": (ArrayType(POINTER, 2), b"\x10\0\0\0\x20\0\0\0"),
    "i": (INT, b"\x01\0\0\0"),
    "here": (RecordType(NODE), bytes(12) + b"\x10\0\0\0"),
    "table": (ArrayType(INT, 2), bytes(8)),
}
MEMORY = bytes(16) + bytes(12) + b"\x20\0\0\0" + bytes(12) + b"\x30\0\0\0"


@pytest.mark.parametrize(
    ("expression", "wanted"),
    [
        ("*n", ("n", 0x10)),
        ("n->next", ("n", 0x10)),
        ("n -> next -> list[ i ]", ("n -> next", 0x20)),
        ("n->next->next->list[0]", ("n->next->next", 0x30)),
        ("n[2].next->list[0]", ("n[2].next", None)),
        ("n[1].next->list[0]", ("n[1].next", 0x30)),
        ("nodes[i]->list[7]", ("nodes[i]", 0x20)),
        ("nodes[k]->next", ("nodes[k]", None)),
        ("nodes[7]->next", ("nodes[7]", None)),
        ("*pp", ("pp", 0x1C)),
        ("**pp", ("*pp", 0x20)),
        ("here.next->next", ("here.next", 0x10)),
        ("*here.next", ("here.next", 0x10)),
        ("*n++", ("n", 0x10)),
        ("table[i]", None),
        ("here.list[2]", None),
        ("n->nothing", None),
        ("i->next", None),
        ("unknown->next", None),
        ("NEXT(n)", None),
        ("(n)->next", None),
        ("f(n)->next", None),
        ("", None),
        ("->", None),
    ],
)
def test_the_last_pointer_is_found(expression: str, wanted: tuple[str, int | None] | None) -> None:
    read = lambda address, size: MEMORY[address : address + size]  # noqa: E731
    assert pointer_in(expression, VARIABLES.get, read) == wanted


@pytest.mark.parametrize(
    ("expression", "wanted"),
    [
        ("a[i] + b.c->d", ["a", "i", "b"]),
        ("f(x, g (y)) * 2.5e3 / 0x1F", ["x", "y"]),
        ("strcmp(s, \"a b 'c' \\\" d\") == 'e'", ["s"]),
        ("i + i * j", ["i", "j"]),
    ],
)
def test_names_are_found(expression: str, wanted: list[str]) -> None:
    assert names_in(expression) == wanted
