"""What names mean: symbols, and the scopes that hold them (C17 6.2.1, 6.2.3).

>>> from crs_cc.ir.types import INT
>>> from crs_cc.core.source import Location
>>> outer = Scope()
>>> outer.names["speed"] = TypedefName("speed", INT, Location("a.c", 1, 1))
>>> inner = Scope(outer)
>>> inner.find("speed").name, inner.find("sped"), inner.closest("sped")
('speed', None, 'speed')
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Final, TypeAlias

from crs_cc.core.source import Location
from crs_cc.ir.program import Variable
from crs_cc.ir.types import CType, EnumType, FunctionType, RecordType

ENTRIES: Final = frozenset({"main", "runcode"})
"""Functions that a program begins in, which need not say what they return: `main`, and that of a
program in the form of the CRS report."""


@dataclass(slots=True, eq=False)
class ObjectSymbol:
    """A variable or parameter.

    Attributes:
        link_name: the linker's name; None for a variable that lives in the function's frame.
        is_external: known to other files.
        is_defined: has an initialiser, or is static.
        is_tentative: declared at file scope without `extern` and initialiser (C17 6.9.2).
        is_weak: another file may define it, too, and prevails.
        is_array_parameter: a pointer, but declared as an array.
        in_memory: its address is taken, or it is no scalar, so that no register can hold it.
        is_indirect: the name means what this variable, a pointer, points to; so it is with an array
            whose length is not constant.
        align: alignment that `_Alignas` asks for [bytes], 0 for the type's own.
        block: the first and the last place of the block that declares it, see `ir.Variable`.
    """

    name: str
    type: CType
    location: Location
    link_name: str | None = None
    is_external: bool = False
    is_defined: bool = False
    is_tentative: bool = False
    is_weak: bool = False
    is_array_parameter: bool = False
    in_memory: bool = False
    is_indirect: bool = False
    align: int = 0
    block: tuple[Location, Location] | None = None

    def variable(self) -> Variable:
        """Return what debuggers and messages know of it."""
        return Variable(self.name, self.type, self.location, self.block, self.is_indirect)


@dataclass(frozen=True, slots=True)
class Format:
    """How a function's arguments are formatted, as `printf`'s are.

    Attributes:
        kind: "printf" or "scanf".
        string: number of the argument that is the format, from 0.
        first: number of the first argument that it formats, -1 when they come as a `va_list`.
    """

    kind: str
    string: int
    first: int


@dataclass(slots=True, eq=False)
class FunctionSymbol:
    """A function.

    Attributes:
        is_implicit: known only because it was called.
        is_noreturn: it never returns.
        is_weak: another file may define it, too, and prevails.
        starts: with what priority it runs before `main`; None when it does not.
        ends: with what priority it runs after the end; None when it does not.
        format: how its arguments are formatted.
    """

    name: str
    type: FunctionType
    location: Location
    link_name: str
    is_external: bool = True
    is_defined: bool = False
    is_implicit: bool = False
    is_noreturn: bool = False
    is_weak: bool = False
    starts: int | None = None
    ends: int | None = None
    format: Format | None = None


@dataclass(slots=True, eq=False)
class TypedefName:
    """A name for a type; `align` is what its attributes ask for [bytes], 0 for nothing."""

    name: str
    type: CType
    location: Location
    align: int = 0


@dataclass(slots=True, eq=False)
class EnumConstant:
    """A constant of an enum."""

    name: str
    type: CType
    location: Location
    value: int


@dataclass(slots=True, eq=False)
class BrokenName:
    """A name whose declaration was wrong; of its uses nothing more is said."""

    name: str
    location: Location


Symbol: TypeAlias = ObjectSymbol | FunctionSymbol | TypedefName | EnumConstant | BrokenName


@dataclass(slots=True, eq=False)
class Tag:
    """A struct, union or enum tag."""

    type: RecordType | EnumType
    location: Location


@dataclass(slots=True, eq=False)
class Scope:
    """The names of one file, parameter list or block, inside an outer scope."""

    outer: Scope | None = None
    names: dict[str, Symbol] = field(default_factory=dict)
    tags: dict[str, Tag] = field(default_factory=dict)

    def find(self, name: str) -> Symbol | None:
        """Return what a name means here, None when it is unknown."""
        scope: Scope | None = self
        while scope is not None:
            if name in scope.names:
                return scope.names[name]
            scope = scope.outer
        return None

    def find_tag(self, name: str) -> Tag | None:
        """Return what a tag means here, None when it is unknown."""
        scope: Scope | None = self
        while scope is not None:
            if name in scope.tags:
                return scope.tags[name]
            scope = scope.outer
        return None

    def closest(
        self, name: str, kind: type[Symbol] | None = None, others: Iterable[str] = ()
    ) -> str | None:
        """Return the known name most like an unknown one, None when none is like it.

        Args:
            name: the unknown name.
            kind: what it must be, if that is known.
            others: names to consider beside those in scope.
        """
        scope: Scope | None = self
        known: dict[str, None] = {}
        while scope is not None:
            known |= {
                each: None
                for each, symbol in scope.names.items()
                if kind is None or isinstance(symbol, kind)
            }
            scope = scope.outer
        known |= dict.fromkeys(others)
        for each in known:
            if each.lower() == name.lower():
                return each
        found = difflib.get_close_matches(name, list(known)[:_MOST_COMPARED], n=1, cutoff=0.7)
        return found[0] if found else None


_MOST_COMPARED = 5000
