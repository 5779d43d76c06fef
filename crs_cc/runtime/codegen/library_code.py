"""Code of library functions that several programs of a process share.

Most of a program is the C library. What its functions' code has of the rest of the program are
numbers: function indices, addresses, site numbers. So the code of a function that is asked for
again is generated with symbols in place of these numbers, and kept; each program fills them in. The
few decisions that depend on the program, like the checks of a call through a pointer, are kept,
too, and where a program decides otherwise, the code is generated anew.
"""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from dataclasses import dataclass, replace
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
from crs_cc.runtime.wasm import UNLIKELY, Code, Instr, encode, unsigned

_Symbol: TypeAlias = tuple[str, Hashable]


def generate_shared(function: Function, names: Symbols, build: Build) -> tuple[Code, FunctionInfo]:
    """Generate the code of a verified function, or link code that was generated before."""
    if not in_library(function.location):
        return generate(function, names, build)
    key = function, replace(build, watch=bool(build.watch))
    if key not in _TEMPLATES:
        _TEMPLATES[key] = None
        return generate(function, names, build)
    template = _TEMPLATES[key]
    if template is None or not template.matches(names):
        template = _TEMPLATES[key] = _template(function, names, build)
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
    """What was asked for by name, with the answers; one for names without any."""

    def __init__(self, real: Mapping[str, Any], default: object) -> None:
        super().__init__()
        self._real = real
        self._default = default

    def get(self, key: str, default: Any = None) -> Any:
        assert default == self._default
        self[key] = answer = self._real.get(key, default)
        return answer

    def __missing__(self, key: str) -> Any:
        return self.get(key, self._default)

    def matches(self, other: Mapping[str, Any]) -> bool:
        return all(other.get(key, self._default) == answer for key, answer in self.items())


class _Tables(dict[Shape, int]):
    """The shapes that were asked for, each with a symbol for its table; None if it has none."""

    def __init__(self, real: Mapping[Shape, int]) -> None:
        super().__init__()
        self.asked: dict[Shape, bool] = {}
        self._real = real

    def get(self, shape: Shape, default: Any = None) -> Any:
        self.asked[shape] = found = shape in self._real
        return _Unknown(("table", shape)) if found else default

    def matches(self, other: Mapping[Shape, int]) -> bool:
        return all((shape in other) == found for shape, found in self.asked.items())


class _Valueless(set[str]):
    """The names that were asked for, and whether the set was asked to be empty."""

    def __init__(self, real: set[str]) -> None:
        super().__init__()
        self._real = real
        self._asked: dict[object, bool] = {}
        self._is_some: bool | None = None

    def __contains__(self, name: object) -> bool:
        self._asked[name] = found = name in self._real
        return found

    def __bool__(self) -> bool:
        self._is_some = found = bool(self._real)
        return found

    def matches(self, other: set[str]) -> bool:
        return self._is_some in {None, bool(other)} and all(
            (name in other) == found for name, found in self._asked.items()
        )


class _Bodies(Bodies):
    """The functions that were asked for, and those that they call, if they are small."""

    def __init__(self, real: Bodies) -> None:
        super().__init__(real.small, checked=real.checked, traps_overflow=real.traps_overflow)
        self._asked: dict[str, Function | None] = {}

    def is_small(self, name: str) -> bool:
        self._ask(name)
        return super().is_small(name)

    def of(self, call: Call) -> Body | None:
        if isinstance(call.callee, str):
            self._ask(call.callee)
        return super().of(call)

    def _ask(self, name: str) -> None:
        function = self._asked[name] = self.small.get(name)
        for call in calls_of(function) if function is not None else ():
            self._ask(str(call.callee))

    def matches(self, other: Bodies) -> bool:
        return all(other.small.get(name) is function for name, function in self._asked.items())


class _Recorder(Symbols):
    """Symbols for generating code that several programs link."""

    def __init__(self, names: Symbols) -> None:
        self._sizes, self._parameters = _Answers(names.sizes, 0), _Answers(names.parameters, 0)
        self._conventions = _Answers(names.conventions, None)
        self._constants = _Answers(names.constants, 0)
        self._tables, self._valueless = _Tables(names.tables), _Valueless(names.without_value)
        self._bodies = _Bodies(names.bodies)
        super().__init__(
            addresses=_Numbers("address"),
            functions=_Numbers("function"),
            general=_Numbers("general"),
            conventions=self._conventions,
            sizes=self._sizes,
            constants=self._constants,
            parameters=self._parameters,
            pointers=_Unknown(_POINTERS),
            tables=self._tables,
            without_value=self._valueless,
            bodies=self._bodies,
        )

    def number(self, site: Site) -> int:
        return _Unknown(_SITE, super().number(site))

    def call_number(self, site: CallSite) -> int:
        return _Unknown(_CALL, super().call_number(site))

    def matches(self, names: Symbols) -> bool:
        """Return whether another program gives the same answers."""
        return (
            self._sizes.matches(names.sizes)
            and self._parameters.matches(names.parameters)
            and self._conventions.matches(names.conventions)
            and self._constants.matches(names.constants)
            and self._tables.matches(names.tables)
            and self._valueless.matches(names.without_value)
            and self._bodies.matches(names.bodies)
        )


@dataclass(slots=True)
class _Template:
    """The code of a function without the numbers of a program.

    Attributes:
        asked: what was asked about the program, and its sites.
        places: where numbers are to be filled in: the instruction's index, what comes before the
            number, its symbol, what is added, and what follows.
        encoded: the encoded instructions between the places, with the offsets of the unlikely
            tests among them; one more than there are places.
    """

    code: Code
    info: FunctionInfo
    asked: _Recorder
    places: list[tuple[int, Instr, _Symbol, int, Instr]]
    encoded: list[tuple[bytes, list[int]]]

    def matches(self, names: Symbols) -> bool:
        return self.asked.matches(names)

    def link(self, names: Symbols, watch: int) -> tuple[Code, FunctionInfo]:
        """Return the code with the numbers of a program, and add its sites."""
        calls = len(names.call_sites)
        known: dict[_Symbol, int] = {
            _SITE: len(names.sites),
            _CALL: calls,
            _POINTERS: names.pointers,
            _WATCH: watch,
        }
        names.sites += self.asked.sites
        names.call_sites += self.asked.call_sites
        body = self.code.body.copy()
        for index, before, symbol, addend, after in self.places:
            value = known.get(symbol)
            if value is None:
                value = known[symbol] = _value(symbol, names)
            body[index] = (*before, value + addend, *after)
        code = _LinkedCode(self.code.name, self.code.type, self.code.locals, body, self)
        moved = {calls + number: landing for number, landing in self.info.calls.items()}
        return code, replace(self.info, calls=moved)


@dataclass(slots=True)
class _LinkedCode(Code):
    """Code of a template, which keeps most of it encoded."""

    template: _Template

    def __reduce__(self) -> tuple[Any, ...]:
        return Code, (self.name, self.type, self.locals, self.body)

    def to_binary(self) -> tuple[bytes, list[int]]:
        content, hints = bytearray(self.head()), list[int]()
        places = iter(self.template.places)
        for part, offsets in self.template.encoded:
            hints += [len(content) + offset for offset in offsets]
            content += part
            for index, *_ in places:
                content += encode(self.body[index])
                break
        content += b"\x0b"
        return unsigned(len(content)) + content, hints


_SITE: Final[_Symbol] = ("site", None)
_CALL: Final[_Symbol] = ("call", None)
_POINTERS: Final[_Symbol] = ("pointers", None)
_WATCH: Final[_Symbol] = ("watch", None)
_TEMPLATES: Final[dict[tuple[Function, Build], _Template | None]] = {}
"""The templates by function and build; None for functions that were generated once."""


def _value(symbol: _Symbol, names: Symbols) -> int:
    kind, name = symbol
    tables: dict[str, Mapping[Any, int]] = {
        "function": names.functions, "general": names.general,
        "address": names.addresses, "table": names.tables,
    }  # fmt: skip
    return tables[kind][name]


def _template(function: Function, names: Symbols, build: Build) -> _Template:
    asked = _Recorder(names)
    watch = _Unknown(_WATCH) if build.watch else 0
    code, info = generate(function, asked, replace(build, watch=watch))
    places: list[tuple[int, Instr, _Symbol, int, Instr]] = []
    encoded: list[tuple[bytes, list[int]]] = []
    part, hints = bytearray(), list[int]()
    for index, instr in enumerate(code.body):
        at = next((at for at, each in enumerate(instr) if type(each) is _Unknown), 0)
        if at:
            number = instr[at]
            places.append((index, instr[:at], number.symbol, int(number), instr[at + 1 :]))
            encoded.append((bytes(part), hints))
            part, hints = bytearray(), []
            continue
        if instr is UNLIKELY:
            hints.append(len(part))
        part += encode(instr)
    encoded.append((bytes(part), hints))
    return _Template(code, info, asked, places, encoded)
