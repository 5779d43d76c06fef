r"""Format the bytes of an object by its C type, for messages and debuggers.

>>> from crs_cc.ir.types import CHAR, COMPLEX, DOUBLE, INT, ArrayType, Member, PointerType
>>> from crs_cc.ir.types import Record, RecordType
>>> show = Values().show
>>> show(INT, b"\xff\xff\xff\xff"), show(CHAR, b"a"), show(DOUBLE, bytes(8))
('-1', "97 'a'", '0.0')
>>> show(ArrayType(CHAR, 8), b"left\0\0\0\0"), show(PointerType(INT), bytes(4))
('"left"', 'null')
>>> point = Record("struct", "point")
>>> point.complete([Member("x", INT), Member("on", INT, bit_width=2)])
>>> show(RecordType(point), bytes((7, 0, 0, 0, 3, 0, 0, 0)))
'{x = 7, on = -1}'
>>> show(COMPLEX["float"], bytes((0, 0, 0, 64, 0, 0, 128, 191)))
'2.0 - 1.0i'
"""

from __future__ import annotations

import functools
import operator
import struct
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from crs_cc.ir.instruction import ByteState
from crs_cc.ir.types import (
    ArrayType,
    CType,
    EnumType,
    FloatType,
    FunctionType,
    IntegerType,
    Member,
    PointerType,
    RecordType,
    VoidType,
    is_complex,
    spell,
    unqualified,
)

LONGEST: Final = 60
LONGEST_TEXT: Final = 40

_ESCAPES: Final = {7: "\\a", 8: "\\b", 9: "\\t", 10: "\\n", 11: "\\v", 12: "\\f", 13: "\\r"}
_ESCAPES_IN_TEXT: Final = (
    _ESCAPES
    | {34: '\\"', 92: "\\\\", 127: "\\177"}
    | {0xDC00 + code: f"\\{code:o}" for code in range(128, 256)}  # bytes that are not UTF-8
)

_FEWEST_FLAGS: Final = 2
_INDENT: Final = "  "
_KNOWN: Final = bytes([ByteState.WITH_VALUE])


@dataclass(frozen=True, slots=True)
class Style:
    """Limits for formatting values.

    Attributes:
        longest: maximum length of a value [characters].
        most_elements: maximum number of elements of an array.
        longest_text: maximum length of a string [characters].
        most_nested: maximum depth of nested structs and arrays.
        repeats: minimum number of equal elements written as one; 0 for never.
        unset: the text for an uninitialised value.
        is_pretty: whether each member of a struct has a line of its own.
    """

    longest: int = LONGEST
    most_elements: int = 8
    longest_text: int = LONGEST_TEXT
    most_nested: int = 3
    repeats: int = 0
    unset: str = "?"
    is_pretty: bool = False

    def braced(self, members: Sequence[str], depth: int) -> str:
        """Return the members of a struct in braces.

        Args:
            members: the text of each.
            depth: in how many structs and arrays the struct is.
        """
        if not self.is_pretty or not members:
            return "{" + ", ".join(members) + "}"
        outside = "\n" + _INDENT * depth
        inside = outside + _INDENT
        return "{" + inside + f",{inside}".join(members) + outside + "}"


BRIEF: Final = Style()
"""For messages."""


def _nothing(_address: int, _size: int) -> bytes:
    return b""


def _no_object(_address: int, _target: CType) -> str:
    return ""


def _shown(content: bytes, states: bytes) -> bytes:
    """Return bytes with the uninitialised ones set to a fixed value."""
    if not states.strip(_KNOWN):
        return content
    pairs = zip(content, states.ljust(len(content), _KNOWN), strict=False)
    return bytes(byte if state in _KNOWN else 0 for byte, state in pairs)


def _no_function(_number: int) -> str:
    return ""


@dataclass(frozen=True, slots=True)
class Values:
    """Formats values; the callbacks give access to the targets of pointers.

    Attributes:
        read: returns the bytes at an address, as many as are readable.
        states: returns the `ByteState`s of these bytes; empty if all are initialised.
        object_at: names the object of a type at an address (`sonar`, `&head.next`); empty if
            unknown.
        function_at: names the function of a function pointer; empty if unknown.
        style: the limits.
    """

    read: Callable[[int, int], bytes] = _nothing
    states: Callable[[int, int], bytes] = _nothing
    object_at: Callable[[int, CType], str] = _no_object
    function_at: Callable[[int], str] = _no_function
    style: Style = BRIEF

    def show(self, ctype: CType, content: bytes, states: bytes = b"") -> str:
        """Return the value of an object of a type, in one line unless the style is pretty.

        Args:
            ctype: the type.
            content: its bytes.
            states: their states; empty if all are initialised.
        """
        text, longest = self._show(ctype, content, states, 0), self.style.longest
        return text if len(text) <= longest else text[: longest - 3] + "..."

    def show_target(self, ctype: CType, content: bytes) -> str:
        """Return the struct that a pointer points to; empty for other values."""
        if isinstance(ctype, PointerType) and isinstance(ctype.target, RecordType):
            address, size = _integer(content, signed=False), ctype.target.size
            target, states = self.read(address, size), self.states(address, size)
            if target and len(target) == size and ByteState.INACCESSIBLE not in states:
                return self.show(ctype.target, target, states)
        return ""

    def _show(self, ctype: CType, content: bytes, states: bytes, depth: int) -> str:
        is_scalar = not isinstance(ctype, ArrayType | RecordType)
        if is_scalar and (len(content) < ctype.size or states.strip(_KNOWN)):
            return self.style.unset
        match ctype:
            case EnumType():
                return _enumerator(ctype, _integer(content, signed=ctype.signed))
            case IntegerType():
                return _number(ctype, content)
            case FloatType():
                return _floating(content)
            case PointerType():
                return self._pointer(ctype, _integer(content, signed=False))
            case ArrayType():
                return self._array(ctype, content, states, depth)
            case RecordType():
                return self._record(ctype, content, states, depth)
            case VoidType() | FunctionType():
                return ""

    def _pointer(self, ctype: PointerType, address: int) -> str:
        if address == 0:
            return "null"
        target = ctype.target
        if isinstance(target, FunctionType):
            return self.function_at(address) or f"{address:#x}"
        if isinstance(target, IntegerType) and target.name.endswith("char"):
            size = self.style.longest_text + 1
            text = self._text(self.read(address, size), self.states(address, size))
            if text is not None:
                return text
        return self.object_at(address, target) or f"{address:#x}"

    def _array(self, ctype: ArrayType, content: bytes, states: bytes, depth: int) -> str:
        element, size = ctype.element, ctype.element.size
        if isinstance(element, IntegerType) and element.name.endswith("char"):
            text = self._text(content, states)
            if text is not None:
                return text
        if depth >= self.style.most_nested or size == 0:
            return "{...}"
        parts: list[str] = []
        start, shown = 0, _shown(content, states)
        while start < len(content) and len(parts) < self.style.most_elements:
            part = slice(start, start + size)
            count = self._run(shown, states, start, size) if self.style.repeats else 1
            text = self._show(element, content[part], states[part], depth + 1)
            parts.append(text if count == 1 else f"{text} <repeats {count} times>")
            start += count * size
        if start < len(content):
            parts.append("...")
        return "{" + ", ".join(parts) + "}"

    def _run(self, content: bytes, states: bytes, start: int, size: int) -> int:
        """Return the number of equal elements from one on, if it is large; else 1."""
        first, known, end = content[start : start + size], states[start : start + size], start
        while content[end : end + size] == first and states[end : end + size] == known:
            end += size
            if end >= len(content):
                break
        count = (end - start) // size
        return count if count >= self.style.repeats else 1

    def _record(self, ctype: RecordType, content: bytes, states: bytes, depth: int) -> str:
        if depth >= self.style.most_nested:
            return "{...}"
        parts = []
        for member in ctype.record.members or []:
            if member.name is None and not isinstance(member.type, RecordType):
                continue
            part = slice(member.offset, member.offset + member.type.size)
            inner = bit_field(member, content[part])
            shown = self._show(member.type, inner, states[part], depth + 1)
            parts.append(shown if member.name is None else f"{member.name} = {shown}")
        if is_complex(ctype):
            real, imaginary = (each.partition(" = ")[2] for each in parts)
            sign = "-" if imaginary.startswith("-") else "+"
            return f"{real} {sign} {imaginary.removeprefix('-')}i"
        return self.style.braced(parts, depth)

    def _text(self, content: bytes, states: bytes) -> str | None:
        """Return a string in quotes, truncated; None if it is not text."""
        characters, end, _ = content.partition(b"\0")
        longest = self.style.longest_text
        if states[: len(characters + end)].strip(_KNOWN):
            return None
        if not content or any(code < 32 and code not in b"\t\n\r" for code in characters):
            return None
        if not end and len(content) <= longest:
            return None  # not terminated
        shown = characters[:longest]
        text = shown.decode("utf-8", "surrogateescape").translate(_ESCAPES_IN_TEXT)
        return f'"{text}"' + ("..." if len(characters) > longest else "")


def place_name(name: str, ctype: CType, offset: int, wanted: CType | None = None) -> str:
    """Return the name of the part of an object at an offset, also past the end of an array.

    Of the parts that start there, it is the first that has the type `wanted`, else the smallest.

    >>> from crs_cc.ir.types import INT, ArrayType
    >>> place_name("order", ArrayType(INT, 4), 16)
    'order[4]'
    """
    if offset == 0 and wanted is not None and _is_same(ctype, wanted):
        return name
    if isinstance(ctype, ArrayType) and ctype.element.size:
        index, rest = divmod(offset, ctype.element.size)
        return place_name(f"{name}[{index}]", ctype.element, rest, wanted)
    if isinstance(ctype, RecordType):
        for member in ctype.record.members or []:
            start = member.offset
            if start <= offset < start + member.type.size and member.bit_width is None:
                inner = f"{name}.{member.name}" if member.name else name
                return place_name(inner, member.type, offset - start, wanted)
    return name


def _is_same(ctype: CType, wanted: CType) -> bool:
    """Return whether two types, possibly of different files, are the same."""
    ctype, wanted = unqualified(ctype), unqualified(wanted)
    return ctype == wanted or (ctype.size == wanted.size and spell(ctype) == spell(wanted))


def _integer(content: bytes, *, signed: bool) -> int:
    return int.from_bytes(content, "little", signed=signed)


def _number(ctype: IntegerType, content: bytes) -> str:
    value = _integer(content, signed=ctype.signed)
    if ctype.name == "_Bool":
        return "true" if value else "false"
    if ctype.name.endswith("char") and (32 <= value < 127 or value in _ESCAPES):
        return f"{value} {_quoted(value)}"
    return str(value)


def _quoted(code: int) -> str:
    return "'" + (_ESCAPES.get(code) or ("\\" if code in b"\\'" else "") + chr(code)) + "'"


def _floating(content: bytes) -> str:
    if len(content) == 4:
        return str(np.frombuffer(content, "<f4")[0])
    return repr(struct.unpack("<d", content)[0])


def _enumerator(ctype: EnumType, value: int) -> str:
    constants = ctype.definition.constants or {}
    for name, each in constants.items():
        if each == value:
            return name
    return _flags(constants, value) or str(value)


def _flags(constants: Mapping[str, int], value: int) -> str:
    """Return a value as a combination of flags, if the constants are flags.

    They are if they share no bits, and each has one or several adjacent bits, as in
    gdb.
    """
    flags = {name: each for name, each in constants.items() if each}
    union = functools.reduce(operator.or_, flags.values(), 0)
    if len(flags) < _FEWEST_FLAGS or min(flags.values()) < 0 or sum(flags.values()) != union:
        return ""
    if any(each // (each & -each) & (each // (each & -each) + 1) for each in flags.values()):
        return ""
    names = [name for name, each in flags.items() if value & each == each]
    return " | ".join(names) if sum(flags[name] for name in names) == value else ""


def bit_field(member: Member, content: bytes) -> bytes:
    """Return a member's bytes; a bit-field is extended to an object of its type."""
    if member.bit_width is None:
        return content
    value = _integer(content, signed=False) >> member.bit_offset & (1 << member.bit_width) - 1
    signed = isinstance(member.type, IntegerType | EnumType) and member.type.signed
    if signed and value >> member.bit_width - 1:
        value -= 1 << member.bit_width
    return value.to_bytes(len(content), "little", signed=value < 0)
