r"""Find in the text of an expression the pointer that it dereferences, and the names in it.

Only simple expressions are understood: a name with members, indices and stars. For
others nothing is found, and messages do without.

>>> from crs_cc.ir.types import INT, ArrayType, Member, PointerType, Record, RecordType
>>> node = Record("struct", "node")
>>> pointer = PointerType(RecordType(node))
>>> node.complete([Member("data", ArrayType(INT, 2)), Member("next", pointer)])
>>> head = pointer, b"\x10\0\0\0"
>>> memory = {0x10: bytes(12)}
>>> find = {"head": head, "i": (INT, b"\1\0\0\0")}.get
>>> read = lambda address, size: memory.get(address, b"")
>>> pointer_in("head->next->data[i]", find, read)
('head->next', 0)
>>> pointer_in("head->data[i]", find, read)
('head', 16)
>>> names_in("head->next->data[i] + f(2)")
['head', 'i']
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Final, TypeAlias

from crs_cc.ir.types import ArrayType, CType, IntegerType, PointerType, RecordType

Find: TypeAlias = Callable[[str], "tuple[CType, bytes] | None"]
"""Returns type and content of a variable."""

Read: TypeAlias = Callable[[int, int], bytes]
"""Returns the bytes at an address, as many as are readable."""

_EXPRESSION: Final = re.compile(
    r"\s*(\**)\s*(?:\+\+|--)?\s*([^\W\d]\w*)((?:\s*(?:->|\.)\s*\w+|\s*\[[^][]*\])*)\s*(?:\+\+|--)?\s*"
)
_SUFFIX: Final = re.compile(r"\s*(->|\.)\s*(\w+)|\s*\[\s*([^][]*?)\s*\]")
_NAME: Final = re.compile(
    r""""(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*'|(?:->|\.)\s*\w+|\.?\d[\w.]*|([^\W\d]\w*)(\s*\()?"""
)


def names_in(expression: str) -> list[str]:
    """Return the names in an expression that may be variables, without duplicates."""
    found = (match for match in _NAME.finditer(expression) if match[1] and not match[2])
    return list(dict.fromkeys(match[1] for match in found))


def pointer_in(expression: str, find: Find, read: Read) -> tuple[str, int | None] | None:
    """Return the text of the last pointer that an expression dereferences, and its value if known.

    Args:
        expression: an expression that names an object.
        find: looks up variables.
        read: reads memory.
    """
    whole = _EXPRESSION.fullmatch(expression)
    known = find(whole[2]) if whole else None
    if whole is None or known is None:
        return None
    walk = _Evaluator(whole[2], *known, read)
    try:
        for suffix in _SUFFIX.finditer(whole[3]):
            if isinstance(walk.ctype, PointerType) and suffix[1] != ".":
                walk.follow(0 if suffix[1] else _index(suffix[3], find))
            elif suffix[1] is None:
                walk.index(_index(suffix[3], find))
            if suffix[1]:
                walk.member(suffix[2])
            walk.text += suffix[0]
        for _ in whole[1]:
            walk.follow(0)
            walk.text = f"*{walk.text}"
    except _UnknownValueError:
        return None
    return walk.pointer


class _UnknownValueError(Exception):
    """The expression cannot be evaluated from its text."""


class _Evaluator:
    """Evaluates an expression from the left: the object reached, and the last pointer followed."""

    def __init__(self, text: str, ctype: CType, content: bytes, read: Read) -> None:
        self.text = text
        self.ctype = ctype
        self.content: bytes | None = content
        self.pointer: tuple[str, int | None] | None = None
        self._read = read

    def follow(self, index: int | None) -> None:
        """Follow a pointer to an element of its target."""
        if not isinstance(self.ctype, PointerType):
            raise _UnknownValueError
        address = None if self.content is None else int.from_bytes(self.content, "little")
        self.pointer = self.text, address
        self.ctype = self.ctype.target
        size, self.content = self.ctype.size, None
        if address is not None and index is not None:
            found = self._read(address + index * size, size)
            self.content = found if len(found) == size else None

    def index(self, index: int | None) -> None:
        """Select an element of an array."""
        if not isinstance(self.ctype, ArrayType):
            raise _UnknownValueError
        self.ctype = self.ctype.element
        self._cut(None if index is None else index * self.ctype.size)

    def member(self, name: str) -> None:
        """Select a member of a struct."""
        named = self.ctype.record.named if isinstance(self.ctype, RecordType) else {}
        if name not in named:
            raise _UnknownValueError
        self.ctype = named[name].type
        self._cut(named[name].offset)

    def _cut(self, offset: int | None) -> None:
        """Keep the bytes of the current type at an offset."""
        if offset is None or self.content is None:
            self.content = None
            return
        part = self.content[offset : offset + self.ctype.size] if offset >= 0 else b""
        self.content = part if len(part) == self.ctype.size else None


def _index(text: str, find: Find) -> int | None:
    """Return the value of an index that is a number or a variable."""
    if text.isdecimal():
        return int(text)
    known = find(text)
    if known is None or not isinstance(known[0], IntegerType):
        return None
    return int.from_bytes(known[1], "little", signed=known[0].signed)
