"""Check the format strings of `printf` and `scanf` against their arguments (C17 7.21.6).

There is no warning for an argument of another type of the same size and class: on this machine
`%d` and `%ld` are equivalent.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

from pycparser import c_ast

from crs_cc.core.source import Location
from crs_cc.frontend.check.checker import Unit
from crs_cc.frontend.check.conversion import is_integer
from crs_cc.frontend.check.scope import Format, FunctionSymbol
from crs_cc.frontend.check.tree import Expression
from crs_cc.frontend.parse.nodes import Node
from crs_cc.ir.types import ArrayType, CType, FloatType, FunctionType, IntegerType, PointerType


def _family(kind: str, names: str) -> dict[str, Format]:
    formats = {}
    for row in names.split():
        name, string, first = row.split(":")
        formats[name] = Format(kind, int(string), int(first))
    return formats


KNOWN: Final = {
    **_family(
        "printf",
        "printf:0:1 fprintf:1:2 sprintf:1:2 snprintf:2:3 dprintf:1:2 asprintf:1:2 syslog:1:2 "
        "vprintf:0:-1 vfprintf:1:-1 vsprintf:1:-1 vsnprintf:2:-1",
    ),
    **_family("scanf", "scanf:0:1 fscanf:1:2 sscanf:1:2 vscanf:0:-1 vfscanf:1:-1 vsscanf:1:-1"),
}
"""The library functions with a format string."""

_PRINTF: Final = re.compile(
    r"%(?P<flags>[-+ #0'I]*)(?P<width>\*|\d*)(?:\.(?P<precision>\*|-?\d*))?"
    r"(?P<length>hh|h|ll|l|L|q|j|z|Z|t)?(?P<conversion>.|$)",
    re.DOTALL,
)
_SCANF: Final = re.compile(
    r"%(?P<flags>[*']*)(?P<width>\d*)(?P<length>hh|h|ll|l|L|q|j|z|t|m)?"
    r"(?P<conversion>\[\^?\]?[^\]]*\]|.|$)",
    re.DOTALL,
)
_INTEGER_BYTES: Final = {"hh": 1, "h": 2, "l": 4, "ll": 8, "q": 8, "L": 8, "j": 8}
_INTEGER_NAMES: Final = {1: "char", 2: "short", 4: "int", 8: "long long"}


@dataclass(frozen=True, slots=True)
class _ExpectedArgument:
    """The argument that a conversion specification expects.

    Attributes:
        at: the position of the specification in the format.
        text: the specification.
        what: "integer", "float" or "pointer".
        size: the size of the number, or of the pointer's target [bytes]; 0 for any.
        name: the type, for messages.
        pointee: the class of the pointer's target: "integer", "float", "pointer"; "" for any.
    """

    at: int
    text: str
    what: str
    size: int
    name: str
    pointee: str = ""

    def accepts(self, ctype: CType) -> bool:
        """Return whether an argument's type matches."""
        if self.what == "integer":
            return is_integer(ctype) and ctype.size == self.size
        if self.what == "float":
            return isinstance(ctype, FloatType) and (ctype.name == self.name)
        if not isinstance(ctype, PointerType):
            return False
        target = ctype.target
        while isinstance(target, ArrayType):
            target = target.element
        if self.pointee == "integer":
            return is_integer(target) and target.size == self.size
        if self.pointee == "float":
            return isinstance(target, FloatType) and target.name == self.name.removesuffix(" *")
        return self.pointee != "pointer" or isinstance(target, PointerType)


def check_format(
    unit: Unit, callee: FunctionSymbol, nodes: list[Node], arguments: list[Expression]
) -> None:
    """Warn about arguments that do not match a call's format string."""
    known = KNOWN.get(callee.name) if callee.is_external else None
    form = callee.format or known
    if form is None or form.string >= len(nodes) or not _takes_string(callee.type, form):
        return
    literal = nodes[form.string]
    if not isinstance(literal, c_ast.Constant) or not literal.value.startswith('"'):
        return
    raw = literal.value[1:-1]
    if re.search(r"%\d+\$", raw):
        return  # POSIX: the arguments are numbered
    location = unit.at(literal)
    _Check(unit, location, raw).run(form, arguments)


def _takes_string(ctype: FunctionType, form: Format) -> bool:
    """Return whether a function is the library's and not a namesake with other parameters."""
    if ctype.parameters is None:
        return True
    if len(ctype.parameters) <= form.string:
        return False
    parameter = ctype.parameters[form.string]
    is_string = isinstance(parameter, PointerType) and parameter.target.size == 1
    return is_string and ctype.variadic == (form.first >= 0)


@dataclass(slots=True)
class _Check:
    """The check of one format string."""

    unit: Unit
    location: Location
    raw: str

    def run(self, form: Format, arguments: list[Expression]) -> None:
        read = self._printf if form.kind == "printf" else self._scanf
        wanted = list(read())
        if form.first < 0:
            return
        given = arguments[form.first :]
        for each, argument in zip(wanted, given, strict=False):
            self._compare(each, argument, form.kind)
        if len(wanted) > len(given):
            text = f"'{wanted[len(given)].text}' has no argument: the format takes "
            self._warn(wanted[len(given)].at, f"{text}{len(wanted)}, but gets {len(given)}")
        elif len(given) > len(wanted):
            plural = "" if len(wanted) == 1 else "s"
            text = f"the format takes {len(wanted)} argument{plural}, but gets {len(given)}"
            self.unit.warning(given[len(wanted)].location, text, flag="format")

    def _warn(self, at: int, text: str, hint: str = "") -> None:
        self.unit.warning(
            location_in_literal(self.unit, self.location, at), text, hint, flag="format"
        )

    def _compare(self, wanted: _ExpectedArgument, argument: Expression, kind: str) -> None:
        if wanted.what == "ignored" or wanted.accepts(argument.type):
            return
        hint = ""
        if kind == "scanf" and not isinstance(argument.type, PointerType):
            hint = "scanf stores the value through a pointer: pass the address, with '&'"
        elif kind == "scanf" and wanted.pointee in {"integer", "float"}:
            better = _scanning(argument.type)
            hint = f"use '{better}'" if better else ""
        elif kind == "printf" and (better := fitting(argument.type)):
            hint = f"use '{better}'"
        expected = f"'{wanted.text}' specifies type '{wanted.name}'"
        self._warn(wanted.at, f"{expected} but the argument has type '{argument.type}'", hint)

    def _printf(self) -> Iterator[_ExpectedArgument]:
        at = 0
        while (at := self.raw.find("%", at)) >= 0:
            match = _PRINTF.match(self.raw, at)
            assert match is not None
            text, conversion, length = match[0], match["conversion"], match["length"] or ""
            for star in ("width", "precision"):
                if match[star] == "*":
                    yield _ExpectedArgument(at, f"* in {text}", "integer", 4, "int")
            if conversion not in {"%", "m"}:
                found = self._printed(at, text, conversion, length)
                if found is not None:
                    yield found
            at = match.end()

    def _printed(
        self, at: int, text: str, conversion: str, length: str
    ) -> _ExpectedArgument | None:
        """Return the argument for a conversion of `printf`; None if it is unknown."""
        if conversion in "diouxXbBc" and conversion:
            size = max(4, _INTEGER_BYTES.get(length, 4))
            return _ExpectedArgument(at, text, "integer", size, _INTEGER_NAMES[size])
        if conversion in "fFeEgGaA" and conversion:
            return _ExpectedArgument(
                at, text, "float", 8, "long double" if length == "L" else "double"
            )
        if conversion in {"s", "S"}:
            wide = length == "l" or conversion == "S"
            name = "wchar_t *" if wide else "char *"
            return _ExpectedArgument(at, text, "pointer", 4 if wide else 1, name, "integer")
        if conversion == "p":
            return _ExpectedArgument(at, text, "pointer", 0, "void *")
        if conversion == "n":
            size = _INTEGER_BYTES.get(length, 4)
            return _ExpectedArgument(
                at, text, "pointer", size, f"{_INTEGER_NAMES[size]} *", "integer"
            )
        self._unknown(at, text, conversion)
        return _ExpectedArgument(at, text, "ignored", 0, "") if conversion.strip("\\") else None

    def _unknown(self, at: int, text: str, conversion: str) -> None:
        is_incomplete = conversion in {"", "\\"}
        what = "incomplete format specifier" if is_incomplete else "invalid conversion specifier"
        text = text.rstrip("\\")
        self._warn(at, f"{what} '{text}'", "write '%%' for a percent sign")

    def _scanf(self) -> Iterator[_ExpectedArgument]:
        at = 0
        while (at := self.raw.find("%", at)) >= 0:
            match = _SCANF.match(self.raw, at)
            assert match is not None
            if match["conversion"] != "%" and "*" not in match["flags"]:
                found = self._scanned(at, match[0], match["conversion"], match["length"] or "")
                if found is not None:
                    yield found
            at = match.end()

    def _scanned(
        self, at: int, text: str, conversion: str, length: str
    ) -> _ExpectedArgument | None:
        """Return the argument for a conversion of `scanf`; None if it is unknown."""
        if conversion in "dibouxXn" and conversion:
            size = _INTEGER_BYTES.get(length, 4)
            return _ExpectedArgument(
                at, text, "pointer", size, f"{_INTEGER_NAMES[size]} *", "integer"
            )
        if conversion in "fFeEgGaA" and conversion:
            name = {"l": "double", "L": "long double"}.get(length, "float")
            return _ExpectedArgument(at, text, "pointer", 0, f"{name} *", "float")
        if conversion[:1] in {"s", "c", "["} and conversion != "[":
            if length == "m":
                return _ExpectedArgument(at, text, "pointer", 0, "char **", "pointer")
            name = "wchar_t *" if length == "l" else "char *"
            return _ExpectedArgument(
                at, text, "pointer", 4 if length == "l" else 1, name, "integer"
            )
        if conversion == "p":
            return _ExpectedArgument(at, text, "pointer", 0, "void **", "pointer")
        self._unknown(at, text, conversion)
        return _ExpectedArgument(at, text, "ignored", 0, "") if conversion.strip("\\") else None


def fitting(ctype: CType) -> str:
    """Return the conversion that prints a value of a type; "" if there is none."""
    if isinstance(ctype, FloatType):
        return "%Lf" if ctype.name == "long double" else "%f"
    if isinstance(ctype, PointerType):
        return "%s" if isinstance(ctype.target, IntegerType) and ctype.target.size == 1 else "%p"
    if isinstance(ctype, IntegerType):
        long = {4: "l" if ctype.name.endswith("long") else "", 8: "ll"}.get(ctype.size, "")
        return f"%{long}{'d' if ctype.signed else 'u'}"
    return "%d" if is_integer(ctype) else ""


def _scanning(ctype: CType) -> str:
    """Return the conversion that reads a number into a pointer's target; "" if there is none."""
    target = ctype.target if isinstance(ctype, PointerType) else ctype
    if isinstance(target, FloatType):
        return {"float": "%f", "double": "%lf"}.get(target.name, "%Lf")
    if not isinstance(target, IntegerType) or target.name == "_Bool":
        return ""
    short = {1: "%hh", 2: "%h"}.get(target.size)
    return f"{short}{'d' if target.signed else 'u'}" if short else fitting(target)


_SEGMENT: Final = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
_MAX_LINES: Final = 100


def location_in_literal(unit: Unit, location: Location, at: int) -> Location:
    """Return the location of a character in a sequence of string literals.

    Args:
        unit: has the lines of the source.
        location: the location of the first literal.
        at: the index of the character as written, without the quotes.

    Returns:
        Its location, or that of the literal if there is a macro between.
    """
    lines = unit.diagnostics.lines.get(location.file, [])
    column = location.column - 1
    for number in range(location.line, min(len(lines), location.line + _MAX_LINES) + 1):
        line = lines[number - 1]
        while True:
            column += len(line[column:]) - len(line[column:].lstrip())
            match = _SEGMENT.match(line, column)
            if match is None:
                break
            if at < len(match[1]) or (at == 0 and not match[1]):
                return Location(location.file, number, match.start(1) + at + 1)
            at -= len(match[1])
            column = match.end()
        if line[column:].strip(" \t\\"):
            break
        column = 0
    return location
