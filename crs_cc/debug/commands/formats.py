"""Output formats of values: `print/x`, `x/4xw`."""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Final

from crs_cc.debug.commands.arguments import OutputFormat
from crs_cc.debug.errors import DebugError
from crs_cc.ir.instruction import ByteState
from crs_cc.ir.types import ArrayType, FloatType, FunctionType, PointerType, RecordType

if TYPE_CHECKING:
    from crs_cc.debug.data.memory_inspection import MemoryInspector
    from crs_cc.debug.data.values import Value

_FLOATS: Final = {4: "<f", 8: "<d"}
_MAX_PARTS: Final = 200
MAX_TEXT_LENGTH: Final = 200
_IN_A_LINE: Final = {1: 8, 2: 8, 4: 4, 8: 2}
_MAX_BYTES: Final = 4096


def formatted(value: Value, wanted: OutputFormat, depth: int = 0) -> str:
    """Return a value in a format; arrays and structs are formatted by parts.

    As in gdb, formats for integers show the bits of a floating-point number, but "c" and "a" show
    its value as an integer.

    Args:
        value: the value.
        wanted: the format.
        depth: in how many arrays and structs it is.

    Raises:
        DebugError: the format does not apply.
    """
    if not wanted.letter:
        return _function(value) or value.full
    if wanted.letter == "s" and not _is_text(value):
        return value.full
    if isinstance(value.type, ArrayType | RecordType) and wanted.letter != "s":
        is_array = isinstance(value.type, ArrayType)
        parts = [
            f"{name} = " * (not is_array) + formatted(part, wanted, depth + 1)
            for name, part in value.children(0, _MAX_PARTS)
        ]
        parts += ["..."] if value.child_count > len(parts) else []
        if is_array:
            return "{" + ", ".join(parts) + "}"
        return value.inspector.full.style.braced(parts, depth)
    if not value.is_initialised or not value.content:
        return value.full
    if wanted.letter == "s":
        return text_at(value)
    if isinstance(value.type, FloatType) and wanted.letter in "ca":
        return _whole(value, wanted.letter)
    if wanted.letter == "a" and isinstance(value.type, PointerType):
        return _function(value) or f"{value.number:#x} {value.full}"
    return letters(value.content, wanted.letter)


def _is_text(value: Value) -> bool:
    """Return whether a value is an array of characters, or points to one."""
    inner = None
    match value.type:
        case ArrayType(element=ctype) | PointerType(target=ctype):
            inner = ctype
    return inner is not None and inner.size == 1


def _function(value: Value) -> str:
    """Return address and name of the function that a value points to, else ""."""
    is_function = isinstance(value.type, PointerType) and isinstance(
        value.type.target, FunctionType
    )
    if not is_function or not isinstance(value.number, int):
        return ""
    name = value.full
    return f"{value.number:#x} <{name}>" if name.isidentifier() and value.number else ""


def _whole(value: Value, letter: str) -> str:
    """Return a floating value in an integer format, without its fraction."""
    number = value.number
    if number is None or not abs(number) < 2**63:
        return value.full
    content = int(number).to_bytes(8, "little", signed=True)
    return letters(content[:4] if letter == "a" else content, letter)


def letters(content: bytes, letter: str) -> str:
    r"""Return bytes in the format of a letter.

    >>> [letters(b"\xff\0\0\0", letter) for letter in "xduot"]
    ['0xff', '255', '255', '0377', '11111111']
    >>> letters(b"\xfe", "d"), letters(b"A", "c"), letters(struct.pack("<f", 0.5), "f")
    ('-2', "65 'A'", '0.5')
    """
    return _LETTERS[letter](content)


def _unsigned(content: bytes) -> int:
    return int.from_bytes(content, "little")


def _signed(content: bytes) -> int:
    return int.from_bytes(content, "little", signed=True)


def _octal(content: bytes) -> str:
    number = _unsigned(content)
    return f"0{number:o}" if number else "0"


def _character(content: bytes) -> str:
    number = _signed(content[:1])
    shown = chr(number) if 32 <= number < 127 else f"\\{number & 255:03o}"
    return f"{number} '{shown}'"


def _floating(content: bytes) -> str:
    if len(content) not in _FLOATS:
        return str(_signed(content))
    number = struct.unpack(_FLOATS[len(content)], content)[0]
    return f"{number:.9g}" if len(content) == 4 else f"{number:.17g}"


_LETTERS: Final[dict[str, Callable[[bytes], str]]] = {
    "x": lambda content: f"{_unsigned(content):#x}",
    "d": lambda content: str(_signed(content)),
    "u": lambda content: str(_unsigned(content)),
    "o": _octal,
    "t": lambda content: f"{_unsigned(content):b}",
    "c": _character,
    "f": _floating,
    "a": lambda content: f"{_unsigned(content):#x}",
    "z": lambda content: f"{_unsigned(content):#0{2 + 2 * len(content)}x}",
}


def text_at(value: Value) -> str:
    """Return the string in an array, or to which a pointer points.

    Raises:
        DebugError: it is neither an array nor a pointer.
    """
    return quoted(_characters(value))


def printable_text(value: Value) -> str:
    """Return the characters of the string in an array, or to which a pointer points.

    Those that would do something to a terminal are octal escapes.

    Raises:
        DebugError: it is neither an array nor a pointer.
    """
    text = _characters(value).partition(b"\0")[0][:MAX_TEXT_LENGTH].decode(errors="replace")
    return "".join(
        each if each.isprintable() or each in "\n\t" else f"\\{ord(each):03o}" for each in text
    )


def _characters(value: Value) -> bytes:
    """Return the bytes of an array, or those to which a pointer points."""
    if isinstance(value.type, ArrayType):
        return value.content
    if isinstance(value.type, PointerType) and isinstance(value.number, int):
        return value.inspector.read(value.number, MAX_TEXT_LENGTH + 1)
    raise DebugError("only an array or a pointer can be shown as a string")


def quoted(content: bytes) -> str:
    r"""Return the string at the start of some bytes, as a C literal.

    >>> print(quoted(b'a "b"\n\0c'))
    "a \"b\"\n"
    """
    text, end, _ = content.partition(b"\0")
    shown = "".join(_QUOTED.get(each, chr(each)) for each in text[:MAX_TEXT_LENGTH])
    return f'"{shown}"' + ("" if end and len(text) <= MAX_TEXT_LENGTH else "...")


_QUOTED: Final = {
    **{each: f"\\{each:03o}" for each in (*range(32), *range(127, 256))},
    10: "\\n",
    9: "\\t",
    13: "\\r",
    34: '\\"',
    92: "\\\\",
}


def dump(inspector: MemoryInspector, address: int, wanted: OutputFormat) -> Iterator[str]:
    """Return a memory dump: lines of an address and units.

    A unit with uninitialised bytes is `??`, one with inaccessible bytes `--`.

    Args:
        inspector: the inspector of the program.
        address: the start.
        wanted: the format, the number of units, and their size.

    Raises:
        DebugError: the memory does not exist.
    """
    size, end = wanted.size or 4, address + (wanted.size or 4) * wanted.count
    if end - address > _MAX_BYTES:
        raise DebugError(f"at most {_MAX_BYTES} bytes can be shown at once")
    a_line = size * _IN_A_LINE[size]
    for start in range(address, end, a_line):
        content = inspector.read(start, min(a_line, end - start))
        whole = [
            _unit(content[at : at + size], inspector.states(start + at, size), wanted.letter or "x")
            for at in range(0, len(content) - size + 1, size)
        ]
        if whole:
            yield f"{place_text(inspector, start)}: " + "  ".join(whole)
        if len(whole) * size < min(a_line, end - start):
            raise DebugError(f"cannot access memory at {start + len(whole) * size:#x}")


def place_text(inspector: MemoryInspector, address: int) -> str:
    """Return an address with the name of the variable that is there."""
    name = inspector.symbol_at(address)
    return f"{address:#010x} <{name}>" if name else f"{address:#010x}"


def _unit(content: bytes, states: bytes, letter: str) -> str:
    if ByteState.INACCESSIBLE in states:
        return "--"
    if ByteState.WITHOUT_VALUE in states:
        return "??"
    if letter == "t":
        return f"{_unsigned(content):0{8 * len(content)}b}"
    return letters(content, "z" if letter == "x" else letter)
