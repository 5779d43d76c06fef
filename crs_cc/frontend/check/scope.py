"""Symbols, and the scopes that map names to them (C17 6.2.1, 6.2.3).

>>> from crs_cc.ir.types import INT
>>> from crs_cc.core.source import Location
>>> outer = Scope()
>>> outer.names["speed"] = TypedefName("speed", INT, Location("a.c", 1, 1))
>>> inner = Scope(outer)
>>> inner.find("speed").name, inner.find("sped"), inner.closest("sped")
('speed', None, 'speed')
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any, Final, TypeAlias

from crs_cc.core.source import Location
from crs_cc.core.suggest import closest
from crs_cc.ir.instruction import Variable
from crs_cc.ir.types import CType, Enumeration, EnumType, FunctionType, RecordType

ENTRIES: Final = frozenset({"main", "runcode"})
"""Entry points of a program, whose result type may be left out: `main`, and that of the CRS
report's dialect."""


@dataclass(slots=True, eq=False)
class ObjectSymbol:
    """A variable or parameter.

    Attributes:
        link_name: the linker's name; None for an automatic variable.
        is_external: whether it has external linkage.
        is_defined: whether it has an initialiser or is static.
        is_used: whether an expression names it, or an attribute says that nothing needs to.
        is_tentative: whether it is declared at file scope without `extern` and initialiser
            (C17 6.9.2).
        is_weak: whether a definition in another file overrides it, or none need be.
        is_array_parameter: whether it is a pointer that was declared as an array.
        in_memory: whether its address is taken or it is not a scalar, so that it cannot be kept in
            a register.
        is_indirect: whether the variable is a pointer to the named object; an array of variable
            length is one.
        align: the alignment from `_Alignas` [bytes], 0 for the type's own.
        block: the start and end of the block that declares it, see `ir.instruction.Variable`.
        alias: the name of the object whose other name it is, from the attribute `alias`.
        constant: the value that a `const` scalar always has, if it is known.
        is_constexpr: whether that value may be used in constant expressions (C23 6.6p7).
    """

    name: str
    type: CType
    location: Location
    link_name: str | None = None
    is_external: bool = False
    is_defined: bool = False
    is_used: bool = False
    is_tentative: bool = False
    is_weak: bool = False
    is_array_parameter: bool = False
    in_memory: bool = False
    is_indirect: bool = False
    align: int = 0
    block: tuple[Location, Location] | None = None
    alias: str = ""
    constant: int | float | None = None
    is_constexpr: bool = False

    @property
    def may_be_missing(self) -> bool:
        """Return whether its address is 0 unless another file defines it."""
        return self.is_weak and not (self.is_defined or self.is_tentative or self.alias)

    def variable(self) -> Variable:
        """Return its description for debuggers and messages."""
        return Variable(self.name, self.type, self.location, self.block, self.is_indirect)


@dataclass(frozen=True, slots=True)
class Format:
    """The format string of a function like `printf`.

    Attributes:
        kind: "printf" or "scanf".
        string: the index of the format argument.
        first: the index of the first formatted argument, -1 for a `va_list`.
    """

    kind: str
    string: int
    first: int


@dataclass(slots=True, eq=False)
class FunctionSymbol:
    """A function.

    Attributes:
        is_implicit: whether it was declared only by a call.
        is_used: whether an expression names it, or nothing needs to: it is inline, or an attribute
            says so.
        is_noreturn: whether it never returns.
        is_weak: whether a definition in another file overrides it, or none need be.
        is_replaceable: whether its definition is GNU's `extern inline`, which another may follow.
        owner: the state of the check of the function that it is nested in; None if it is in none.
        alias: the name of the function whose other name it is, from the attribute `alias`.
        starts: the priority with which it runs before `main`; None if it does not.
        ends: the priority with which it runs after the program; None if it does not.
        format: its format string, if it has one.
    """

    name: str
    type: FunctionType
    location: Location
    link_name: str
    is_external: bool = True
    is_defined: bool = False
    is_implicit: bool = False
    is_used: bool = False
    is_noreturn: bool = False
    is_weak: bool = False
    is_replaceable: bool = False
    owner: Any = None
    alias: str = ""
    starts: int | None = None
    ends: int | None = None
    format: Format | None = None

    @property
    def may_be_missing(self) -> bool:
        """Return whether its address is 0 unless another file defines it."""
        return self.is_weak and not (self.is_defined or self.alias)


@dataclass(slots=True, eq=False)
class TypedefName:
    """A typedef name; `align` is the alignment from its attributes [bytes], 0 if there is none."""

    name: str
    type: CType
    location: Location
    align: int = 0


@dataclass(slots=True, eq=False)
class EnumConstant:
    """A constant of an enum, whose type is mostly not that of the enum (C17 6.7.2.2p3)."""

    name: str
    type: CType
    location: Location
    value: int
    enumeration: Enumeration


@dataclass(slots=True, eq=False)
class BrokenName:
    """A name with an invalid declaration; its uses are not reported."""

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
        """Return the symbol of a name, None if it is undeclared."""
        scope: Scope | None = self
        while scope is not None:
            if name in scope.names:
                return scope.names[name]
            scope = scope.outer
        return None

    def find_type(self, name: str) -> TypedefName | None:
        """Return the type of a name, even if another meaning of it is in an inner scope."""
        scope: Scope | None = self
        while scope is not None:
            found = scope.names.get(name)
            if isinstance(found, TypedefName):
                return found
            scope = scope.outer
        return None

    def find_tag(self, name: str) -> Tag | None:
        """Return the meaning of a tag, None if it is undeclared."""
        scope: Scope | None = self
        while scope is not None:
            if name in scope.tags:
                return scope.tags[name]
            scope = scope.outer
        return None

    def closest(
        self, name: str, kind: type[Symbol] | None = None, others: Iterable[str] = ()
    ) -> str | None:
        """Return the name that resembles an unknown one most, None if there is none.

        Args:
            name: the unknown name.
            kind: the class of symbol it must have, if that is known.
            others: further names to consider beside those in scope.
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
        return closest(name, list(known))
