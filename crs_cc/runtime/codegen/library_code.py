"""Code of library functions that several programs of a process share.

Most of a program is the C library. What its functions' code has of the rest of the program are
numbers: function indices, addresses, site numbers. So the code of a function that is asked for
again is generated with symbols in place of these numbers, and kept; each program fills them in. The
few decisions that depend on the program, like the checks of a call through a pointer, are kept,
too, and where a program decides otherwise, the code is generated anew.
"""

from __future__ import annotations

import functools
import itertools
from collections.abc import Container, Hashable, Mapping
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, field, replace
from operator import getitem
from typing import Any, Final, NoReturn, Self, TypeAlias

from crs_cc.ir.instruction import Call
from crs_cc.ir.names import in_library
from crs_cc.ir.program import Function
from crs_cc.runtime.codegen.body import Body
from crs_cc.runtime.codegen.build import Build
from crs_cc.runtime.codegen.function_code import generate
from crs_cc.runtime.codegen.signatures import Shape
from crs_cc.runtime.codegen.small_functions import Bodies, calls_of
from crs_cc.runtime.codegen.symbols import Symbols
from crs_cc.runtime.compiled import FunctionInfo
from crs_cc.runtime.sites import CallSite, Site
from crs_cc.runtime.wasm import UNLIKELY, Code, Instr, encode, encode_hints, unsigned

_Symbol: TypeAlias = tuple[str, Hashable]


def generate_shared(function: Function, names: Symbols, build: Build) -> tuple[Code, FunctionInfo]:
    """Generate the code of a verified function, or link code that was generated before."""
    if not in_library(function.location):
        return generate(function, names, build)
    key = function, build.checked, build.debug, bool(build.watch), build.trap_overflow
    templates = _TEMPLATES.get(key)
    if templates is None:
        _TEMPLATES[key] = []
        return generate(function, names, build)
    for template in templates:
        if template.matches(names):
            return template.link(names, build.watch)
    template = _template(function, names, build)
    templates[:] = [template, *templates[: _MAX_TEMPLATES - 1]]
    return template.link(names, build.watch)


class _Unknown(int):
    """A number that differs between programs: a symbol's plus a constant, the value as an int."""

    symbol: _Symbol

    def __new__(cls, symbol: _Symbol, addend: int = 0) -> Self:
        self = super().__new__(cls, addend)
        self.symbol = symbol
        return self

    def __add__(self, other: int) -> _Unknown:
        assert not isinstance(other, _Unknown)
        return _Unknown(self.symbol, int(self) + other)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Unknown) and (self.symbol, int(self)) == (
            other.symbol,
            int(other),
        )

    def __hash__(self) -> int:
        return hash((self.symbol, int(self)))

    def _unknown(self, *_: object) -> NoReturn:
        raise TypeError(f"the number of {self.symbol} is known only when it is linked")

    def __bool__(self) -> bool:
        if self.symbol != _WATCH:
            self._unknown()
        return True  # it exists in watching builds only

    __radd__ = __add__
    __sub__ = __rsub__ = __mul__ = __rmul__ = __floordiv__ = __mod__ = __neg__ = __abs__ = _unknown
    __lshift__ = __rshift__ = __and__ = __rand__ = __or__ = __ror__ = __xor__ = _unknown
    __lt__ = __le__ = __gt__ = __ge__ = __index__ = _unknown


class _Numbers(dict[str, int]):
    """Symbols in place of the numbers of names."""

    def __init__(self, kind: str) -> None:
        super().__init__()
        self._kind = kind

    def __missing__(self, name: str) -> int:
        return _Unknown((self._kind, name))


class _Answers(dict[str, Any]):
    """The results of look-ups by name in a table of a program, as they are made."""

    def __init__(self, real: Mapping[str, Any]) -> None:
        super().__init__()
        self._real = real
        self._missing: set[str] = set()

    def get(self, key: str, default: Any = None) -> Any:
        if key not in self._real:
            self._missing.add(key)
            return default
        self[key] = answer = self._real[key]
        return answer

    def __missing__(self, key: str) -> Any:
        return self.get(key)

    def is_asked(self) -> bool:
        return bool(self or self._missing)

    def matches(self, other: Mapping[str, Any]) -> bool:
        return self.items() <= other.items() and self._missing.isdisjoint(other)


class _Names:
    """The names that were asked for: those that there are, and those that there are not."""

    def __init__(self, real: Container[Any]) -> None:
        self._real = real
        self._present: set[Any] = set()
        self._absent: set[Any] = set()

    def has(self, name: object) -> bool:
        found = name in self._real
        (self._present if found else self._absent).add(name)
        return found

    def is_asked(self) -> bool:
        return bool(self._present or self._absent)

    def matches(self, other: AbstractSet[Any]) -> bool:
        return self._present <= other and self._absent.isdisjoint(other)


class _Tables(dict[Shape, int]):
    """The shapes that were asked for, each with a symbol for its table; None if it has none."""

    def __init__(self, real: Mapping[Shape, int]) -> None:
        super().__init__()
        self._asked = _Names(real)

    def get(self, shape: Shape, default: Any = None) -> Any:
        return _Unknown(("tables", shape)) if self._asked.has(shape) else default

    def is_asked(self) -> bool:
        return self._asked.is_asked()

    def matches(self, other: Mapping[Shape, int]) -> bool:
        return self._asked.matches(other.keys())


class _Valueless(set[str]):
    """The names that were asked for, and whether the set was asked to be empty."""

    def __init__(self, real: set[str]) -> None:
        super().__init__()
        self._real = real
        self._asked = _Names(real)
        self._is_some: bool | None = None

    def __contains__(self, name: object) -> bool:
        return self._asked.has(name)

    def __bool__(self) -> bool:
        self._is_some = found = bool(self._real)
        return found

    def is_asked(self) -> bool:
        return self._is_some is not None or self._asked.is_asked()

    def matches(self, other: set[str]) -> bool:
        return self._is_some in {None, bool(other)} and self._asked.matches(other)


class _Bodies(Bodies):
    """The functions that were asked for, and those that they call, if they are small."""

    def __init__(self, real: Bodies) -> None:
        super().__init__(real.small, checked=real.checked, traps_overflow=real.traps_overflow)
        self._asked = _Answers(real.small)

    def is_small(self, name: str) -> bool:
        self._ask(name)
        return super().is_small(name)

    def of(self, call: Call) -> Body | None:
        if isinstance(call.callee, str):
            self._ask(call.callee)
        return super().of(call)

    def _ask(self, name: str) -> None:
        function = self._asked.get(name)
        for call in calls_of(function) if function is not None else ():
            self._ask(str(call.callee))

    def is_asked(self) -> bool:
        return self._asked.is_asked()

    def matches(self, other: Bodies) -> bool:
        return self._asked.matches(other.small)


_Asked: TypeAlias = _Answers | _Tables | _Valueless | _Bodies

_ASKED: Final = ("conventions", "sizes", "constants", "tables", "without_value", "bodies")
"""The tables of `Symbols` that decide which code is generated, beyond the numbers filled in."""


class _Recorder(Symbols):
    """Symbols for generating code that several programs link."""

    def __init__(self, names: Symbols) -> None:
        super().__init__(
            addresses=_Numbers("addresses"),
            functions=_Numbers("functions"),
            general=_Numbers("general"),
            conventions=_Answers(names.conventions),
            sizes=_Answers(names.sizes),
            constants=_Answers(names.constants),
            pointers=_Unknown(_POINTERS),
            tables=_Tables(names.tables),
            without_value=_Valueless(names.without_value),
            bodies=_Bodies(names.bodies),
        )

    def number(self, site: Site) -> int:
        return _Unknown(_SITE, super().number(site))

    def call_number(self, site: CallSite) -> int:
        return _Unknown(_CALL, super().call_number(site))

    def asked(self) -> list[tuple[str, _Asked]]:
        """Return the tables that were asked, by name."""
        tables = ((name, getattr(self, name)) for name in _ASKED)
        return [(name, table) for name, table in tables if table.is_asked()]


class _Form(dict[int, bytes]):
    """An instruction in which a number is left open: its encoding by the number."""

    def __init__(self, before: Instr, after: Instr) -> None:
        super().__init__()
        self._before, self._after = before, after

    def __missing__(self, number: int) -> bytes:
        encoded = self[number] = encode(self.instruction(number))
        return encoded

    def instruction(self, number: int) -> Instr:
        return (*self._before, number, *self._after)


@dataclass(slots=True)
class _Template:
    """The code of a function without the numbers of a program.

    Attributes:
        recorded: the sites, and what was asked about the program.
        asked: the tables that were asked, by name.
        indices: where numbers are to be filled in: the indices of the instructions.
        forms: these instructions.
        numbers: for each of them, which of the symbols it has, and what is added.
        symbols: the different symbols.
        parts: the encoded code: constant parts at even places, room for `forms` at odd ones.
        hints: the unlikely tests: which of these parts they are in, and the offset there.
        encoded_hints: the encoded hints, by the sizes of the instructions with numbers.
    """

    code: Code
    info: FunctionInfo
    recorded: _Recorder
    asked: list[tuple[str, _Asked]] = field(init=False)
    indices: list[int] = field(default_factory=list)
    forms: list[_Form] = field(default_factory=list)
    numbers: list[tuple[int, int]] = field(default_factory=list)
    symbols: dict[_Symbol, int] = field(default_factory=dict)
    parts: list[bytes] = field(default_factory=list)
    hints: list[tuple[int, int]] = field(default_factory=list)
    encoded_hints: dict[bytes, bytes] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.asked = self.recorded.asked()

    def add(self, index: int, instr: Instr, at: int) -> None:
        """Add an instruction with an unknown number."""
        number: _Unknown = instr[at]
        self.indices.append(index)
        self.forms.append(_form(instr[:at], instr[at + 1 :]))
        symbol = self.symbols.setdefault(number.symbol, len(self.symbols))
        self.numbers.append((symbol, int(number)))

    def matches(self, names: Symbols) -> bool:
        """Return whether another program gives the same answers."""
        return all(table.matches(getattr(names, name)) for name, table in self.asked)

    def link(self, names: Symbols, watch: int) -> tuple[Code, FunctionInfo]:
        """Return the code with the numbers of a program, and add its sites."""
        tables: dict[str, Mapping[Any, int]] = {
            "functions": names.functions, "general": names.general,
            "addresses": names.addresses, "tables": names.tables,
            "program": {
                "site": len(names.sites), "call": len(names.call_sites),
                "pointers": names.pointers, "watch": watch,
            },
        }  # fmt: skip
        values = [tables[kind][name] for kind, name in self.symbols]
        numbers = [values[symbol] + addend for symbol, addend in self.numbers]
        names.sites += self.recorded.sites
        names.call_sites += self.recorded.call_sites
        names.call_landings += self.recorded.call_landings
        return _LinkedCode(self, numbers), self.info

    def to_binary(self, numbers: list[int]) -> tuple[bytes, bytes]:
        """Return the code with these numbers, and its hints, as `Code.to_binary` does."""
        parts, filled = self.parts.copy(), list(map(getitem, self.forms, numbers))
        parts[1::2] = filled
        content = b"".join(parts)
        sizes = bytes(map(len, filled))
        hints = self.encoded_hints.get(sizes) if self.hints else b""
        if hints is None:
            starts = list(itertools.accumulate(map(len, parts), initial=0))
            hints = encode_hints([starts[part] + offset for part, offset in self.hints])
            self.encoded_hints[sizes] = hints
        return unsigned(len(content)) + content, hints


class _LinkedCode(Code):
    """Code of a template, with the numbers of a program."""

    __slots__ = ("_numbers", "_template")

    def __init__(self, template: _Template, numbers: list[int]) -> None:
        code = template.code
        self.name, self.type, self.locals = code.name, code.type, code.locals
        self._template, self._numbers = template, numbers

    @property
    def body(self) -> list[Instr]:  # type: ignore[override]
        """The instructions, which only texts and debuggers need."""
        template = self._template
        body = template.code.body.copy()
        rows = zip(template.indices, template.forms, self._numbers, strict=True)
        for index, form, number in rows:
            body[index] = form.instruction(number)
        return body

    def __reduce__(self) -> tuple[Any, ...]:
        return Code, (self.name, self.type, self.locals, self.body)

    def to_binary(self) -> tuple[bytes, bytes]:
        return self._template.to_binary(self._numbers)


_SITE: Final[_Symbol] = ("program", "site")
_CALL: Final[_Symbol] = ("program", "call")
_POINTERS: Final[_Symbol] = ("program", "pointers")
_WATCH: Final[_Symbol] = ("program", "watch")
_MAX_TEMPLATES: Final = 4
"""How many templates of a function are kept for programs that answer differently."""

_TEMPLATES: Final[dict[tuple[Function, bool, bool, bool, bool], list[_Template]]] = {}
"""The templates by function and build; none for functions that were generated once."""


@functools.cache
def _form(before: Instr, after: Instr) -> _Form:
    return _Form(before, after)


def _template(function: Function, names: Symbols, build: Build) -> _Template:
    asked = _Recorder(names)
    watch = _Unknown(_WATCH) if build.watch else 0
    code, info = generate(function, asked, replace(build, watch=watch))
    template = _Template(code, info, asked)
    part = bytearray(code.head())
    for index, instr in enumerate(code.body):
        at = next((at for at, each in enumerate(instr) if type(each) is _Unknown), 0)
        if at:
            template.add(index, instr, at)
            template.parts += bytes(part), b""
            part.clear()
            continue
        if instr is UNLIKELY:
            template.hints.append((len(template.parts), len(part)))
        part += encode(instr)
    template.parts.append(bytes(part) + b"\x0b")
    return template
