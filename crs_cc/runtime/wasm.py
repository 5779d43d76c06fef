"""WebAssembly modules as data: instructions as tuples, encoded as binary or text.

An instruction is a tuple of its name and its immediates, for example `("local.get", 0)` or
`("i32.load", memory, offset)`. Only the part of WebAssembly that the code generator uses is here
(core specification 3.0, chapters 5 "Binary format" and 6 "Text format"). An `UNLIKELY` test is an
`if` with a branch hint (7.4.2 "Custom Sections"): the guarded code is placed out of line.

>>> body = [("local.get", 0), ("i32.const", 1), ("i32.add",)]
>>> plus_one = Code("plus_one", TYPE_I32_I32, [], body)
>>> Module(functions=[plus_one], exports=[("plus_one", "func", 0)]).to_binary()[1:4]
b'asm'
"""

from __future__ import annotations

import functools
import struct
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Final, Literal, TypeAlias

from crs_cc.core.file_names import displayed
from crs_cc.ir.operators import OPERATORS
from crs_cc.ir.value_type import ValueType
from crs_cc.runtime import layout

Instr: TypeAlias = tuple[Any, ...]
FuncType: TypeAlias = tuple[tuple[ValueType, ...], tuple[ValueType, ...]]

TYPE_I32_I32: Final[FuncType] = (("i32",), ("i32",))
TYPE_CALL: Final[FuncType] = (("i32", "i64"), ("i64",))
"""The general type of a C function: (frame pointer, fuel) -> remaining fuel."""
PAGE: Final = layout.PAGE

UNLIKELY: Final[Instr] = ("if", "unlikely")

_VALUE: Final[dict[str, int]] = {"i32": 0x7F, "i64": 0x7E, "f32": 0x7D, "f64": 0x7C}

_PLAIN: Final[dict[str, bytes]] = {
    "unreachable": b"\x00", "nop": b"\x01", "else": b"\x05", "end": b"\x0b", "return": b"\x0f",
    "drop": b"\x1a", "select": b"\x1b",
}  # fmt: skip
_PLAIN.update((operator.name, operator.opcode) for operator in OPERATORS.values())

_MEMORY_FROM_0X28: Final = """
i32.load i64.load f32.load f64.load i32.load8_s i32.load8_u i32.load16_s i32.load16_u
i64.load8_s i64.load8_u i64.load16_s i64.load16_u i64.load32_s i64.load32_u
i32.store i64.store f32.store f64.store i32.store8 i32.store16 i64.store8 i64.store16 i64.store32
"""
_ACCESS: Final = {name: 0x28 + number for number, name in enumerate(_MEMORY_FROM_0X28.split())}
_VECTOR: Final = {"v128.load": 0, "v128.store": 11}
_BLOCK: Final = {"block": 0x02, "loop": 0x03, "if": 0x04}
_INDEX: Final = {
    "br": 0x0C, "br_if": 0x0D, "call": 0x10,
    "local.get": 0x20, "local.set": 0x21, "local.tee": 0x22, "global.get": 0x23, "global.set": 0x24,
}  # fmt: skip

_FLOATING: Final = {"f32.const": (b"\x43", "<f"), "f64.const": (b"\x44", "<d")}


def unsigned(value: int) -> bytes:
    """Encode an unsigned LEB128 number."""
    if value < 0x80:
        return bytes((value,))
    out = bytearray()
    while value >= 0x80:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    out.append(value)
    return bytes(out)


def signed(value: int) -> bytes:
    """Encode a signed LEB128 number."""
    out = bytearray()
    while not -0x40 <= value < 0x40:
        out.append(value & 0x7F | 0x80)
        value >>= 7
    out.append(value & 0x7F)
    return bytes(out)


def _vector(items: Iterable[bytes]) -> bytes:
    parts = list(items)
    return unsigned(len(parts)) + b"".join(parts)


def _name(text: str) -> bytes:
    raw = displayed(text).encode()
    return unsigned(len(raw)) + raw


def _section(number: int, content: bytes) -> bytes:
    return bytes((number,)) + unsigned(len(content)) + content


def encode(instr: Instr) -> bytes:
    """Encode one instruction."""
    floating = _FLOATING.get(instr[0])
    if floating is None:
        return _encode(instr)
    opcode, form = floating  # not cached: 0.0 and -0.0 are equal
    return opcode + struct.pack(form, instr[1])


@functools.lru_cache(2**16)
def _encode(instr: Instr) -> bytes:
    name = instr[0]
    if name in _PLAIN:
        return _PLAIN[name]
    if name in _INDEX:
        return bytes((_INDEX[name],)) + unsigned(instr[1])
    if name in _ACCESS:  # memory index by bit 6 of the alignment, which is a hint only: 0
        return bytes((_ACCESS[name], 0x40)) + unsigned(instr[1]) + unsigned(instr[2])
    if name in _BLOCK:
        return bytes((_BLOCK[name], 0x40))
    return _encode_rare(instr)


def _encode_rare(instr: Instr) -> bytes:
    match instr:
        case ("i32.const", value):
            return b"\x41" + signed((value + 2**31) % 2**32 - 2**31)
        case ("i64.const", value):
            return b"\x42" + signed((value + 2**63) % 2**64 - 2**63)
        case ("br_table", targets, default):
            return b"\x0e" + _vector(map(unsigned, targets)) + unsigned(default)
        case ("call_indirect", type_index, table):
            return b"\x11" + unsigned(type_index) + unsigned(table)
        case ("memory.copy", target, source):
            return b"\xfc\x0a" + unsigned(target) + unsigned(source)
        case ("memory.fill", memory):
            return b"\xfc\x0b" + unsigned(memory)
        case ("memory.init", segment, memory):
            return b"\xfc\x08" + unsigned(segment) + unsigned(memory)
    return _encode_vector(instr)


def _encode_vector(instr: Instr) -> bytes:
    """Encode an instruction on vectors of 128 bits."""
    match instr:
        case (name, memory, offset) if name in _VECTOR:
            return bytes((0xFD, _VECTOR[name], 0x40)) + unsigned(memory) + unsigned(offset)
        case ("v128.and",):
            return b"\xfd\x4e"
        case ("v128.const", value):
            return b"\xfd\x0c" + int(value).to_bytes(16, "little")
        case ("i8x16.all_true",):
            return b"\xfd\x63"
    raise AssertionError(f"no encoding for {instr}")


@dataclass(slots=True)
class Code:
    """A function: its type, the types of its locals after the parameters, its instructions."""

    name: str
    type: FuncType
    locals: Sequence[ValueType]
    body: list[Instr]

    def to_binary(self) -> tuple[bytes, bytes]:
        """Return the entry in the code section, and the hints of the `UNLIKELY` tests in it."""
        content, hints = bytearray(self.head()), []
        for instr in self.body:
            if instr is UNLIKELY:
                hints.append(len(content))
            content += encode(instr) if instr[0] in _FLOATING else _encode(instr)
        content += b"\x0b"
        return unsigned(len(content)) + content, encode_hints(hints)

    def start(self) -> int:
        """Return the offset of the instructions in the entry's content [bytes]."""
        return len(self.head())

    def head(self) -> bytes:
        """Return the declarations of the locals in the entry."""
        runs: list[tuple[int, str]] = []
        for kind in self.locals:
            if runs and runs[-1][1] == kind:
                runs[-1] = (runs[-1][0] + 1, kind)
            else:
                runs.append((1, kind))
        return _vector(unsigned(count) + bytes((_VALUE[kind],)) for count, kind in runs)


@dataclass(slots=True)
class Module:
    """A module that may import functions and memories and define more, numbered after these.

    Attributes:
        memory_imports: (module, name) of each imported memory, of one page or more, shared by
            threads.
        own_imports: (module, name, pages) of each other imported memory, of a size that never
            changes; they come after those.
        function_imports: (module, name, type) of each imported function.
        memories: sizes of the module's own memories, in pages.
        tables: sizes of its tables of functions; 0 for one that the host grows.
        globals: (type, initial value) of its mutable globals.
        elements: (table, first index, functions) written into tables at instantiation.
        data: (memory, address, bytes) written into memory at instantiation; segments with a memory
            below 0 are passive, for `memory.init`.
        start: index of a function to call at instantiation.
        exports: (name, "func" | "memory" | "table" | "global", index).
    """

    functions: list[Code] = field(default_factory=list)
    memory_imports: list[tuple[str, str]] = field(default_factory=list)
    own_imports: list[tuple[str, str, int]] = field(default_factory=list)
    function_imports: list[tuple[str, str, FuncType]] = field(default_factory=list)
    memories: list[int] = field(default_factory=list)
    tables: list[int] = field(default_factory=list)
    globals: list[tuple[ValueType, int]] = field(default_factory=list)
    elements: list[tuple[int, int, list[int]]] = field(default_factory=list)
    data: list[tuple[int, int, bytes]] = field(default_factory=list)
    exports: list[tuple[str, Literal["func", "memory", "table", "global"], int]] = field(
        default_factory=list
    )
    start: int | None = None

    def types(self) -> list[FuncType]:
        """Return the function types in the order of the type section."""
        imported = (kind for _, _, kind in self.function_imports)
        own = (code.type for code in self.functions)
        return list(dict.fromkeys([TYPE_I32_I32, TYPE_CALL, *imported, *own]))

    def to_binary(self) -> bytes:
        """Return the module in the binary format."""
        kinds = {"func": 0, "table": 1, "memory": 2, "global": 3}
        types = self.types()
        number = {kind: unsigned(each) for each, kind in enumerate(types)}
        code = [each.to_binary() for each in self.functions]
        sections = [
            (1, [_func_type(each) for each in types]),
            (2, self._imports(number)),
            (3, [number[code.type] for code in self.functions]),
            (4, [b"\x70" + (_limits(size) if size else b"\0\0") for size in self.tables]),
            (5, [_limits(size) for size in self.memories]),
            (6, [_global(kind, value) for kind, value in self.globals]),
            (7, [_name(n) + bytes((kinds[k],)) + unsigned(i) for n, k, i in self.exports]),
            (9, [_element(*each) for each in self.elements]),
            (10, [content for content, _ in code]),
            (11, [_data(*each) for each in self.data]),
        ]  # fmt: skip
        parts = {each: _section(each, _vector(items)) for each, items in sections if items}
        if self.start is not None:
            parts[8] = _section(8, unsigned(self.start))
        parts[12] = _section(12, unsigned(len(self.data)))
        parts[0] = _branch_hints(len(self.function_imports), [hints for _, hints in code])
        order = (1, 2, 3, 4, 5, 6, 7, 8, 9, 12, 0, 10, 11)
        return b"\x00asm\x01\x00\x00\x00" + b"".join(parts.get(each, b"") for each in order)

    def _imports(self, types: Mapping[FuncType, bytes]) -> list[bytes]:
        shared = [_name(m) + _name(n) + _SHARED for m, n in self.memory_imports]
        own = [_name(m) + _name(n) + b"\x02" + _limits(size) for m, n, size in self.own_imports]
        functions = [
            _name(m) + _name(n) + b"\x00" + types[kind] for m, n, kind in self.function_imports
        ]
        return [*shared, *own, *functions]

    def to_text(self) -> str:
        """Return the functions in the text format."""
        return "\n".join(_function_text(code) for code in self.functions)


_SHARED: Final = b"\x02\x03" + unsigned(1) + unsigned(2**16)
"""The type of an imported memory that threads share, of any size."""


def _limits(size: int) -> bytes:
    return b"\x01" + unsigned(size) + unsigned(size)


def _func_type(kind: FuncType) -> bytes:
    parameters, results = kind
    return b"\x60" + b"".join(_vector(bytes((_VALUE[t],)) for t in side)
                              for side in (parameters, results))  # fmt: skip


def _global(kind: ValueType, value: int) -> bytes:
    return bytes((_VALUE[kind], 1)) + encode((f"{kind}.const", value)) + b"\x0b"


def _element(table: int, first: int, functions: list[int]) -> bytes:
    offset = encode(("i32.const", first)) + b"\x0b"
    return b"\x02" + unsigned(table) + offset + b"\x00" + _vector(map(unsigned, functions))


def encode_hints(offsets: Sequence[int]) -> bytes:
    """Return the hints that the tests at some offsets in a function are unlikely; empty if none."""
    return _vector(map(_unlikely, offsets)) if offsets else b""


def _branch_hints(first: int, hints: Sequence[bytes]) -> bytes:
    """Return the custom section of branch hints, from those of the functions from an index on."""
    rows = [unsigned(function) + row for function, row in enumerate(hints, start=first) if row]
    return _section(0, _name("metadata.code.branch_hint") + _vector(rows))


@functools.lru_cache(2**16)
def _unlikely(place: int) -> bytes:
    """Return the hint that the test at an offset is unlikely."""
    return unsigned(place) + b"\x01\x00"


def _data(memory: int, address: int, content: bytes) -> bytes:
    if memory < 0:
        return b"\x01" + unsigned(len(content)) + content
    offset = encode(("i32.const", address)) + b"\x0b"
    return b"\x02" + unsigned(memory) + offset + unsigned(len(content)) + content


def _function_text(code: Code) -> str:
    parameters, results = code.type
    head = f"(func ${_identifier(code.name)}"
    head += "".join(f" (param {kind})" for kind in parameters)
    head += "".join(f" (result {kind})" for kind in results)
    rows = [head]
    if code.locals:
        rows.append("  (local " + " ".join(code.locals) + ")")
    depth = 1
    for instr in code.body:
        if instr[0] in ("end", "else"):
            depth -= 1
        rows.append("  " * depth + _instruction_text(instr))
        if instr[0] in ("block", "loop", "if", "else"):
            depth += 1
    return "\n".join(rows) + ")\n"


def _identifier(name: str) -> str:
    return "".join(c if c.isalnum() or c in "_.:$-" else "_" for c in name)


def _instruction_text(instr: Instr) -> str:
    match instr:
        case ("if", _):
            return "if  ;; unlikely"
        case ("br_table", targets, default):
            return "br_table " + " ".join(map(str, [*targets, default]))
        case ("call_indirect", type_index, table):
            return f"call_indirect {table} (type {type_index})"
        case (name, memory, offset) if name in _ACCESS or name in _VECTOR:
            return f"{name} {memory}" + (f" offset={offset}" if offset else "")
    return " ".join(map(str, instr))
