"""The state of a check, and the tables of checkers by node class.

Each module of this package registers its functions here for classes of pycparser's nodes. An
error raises `CheckError`, which is caught for each statement and declaration by `Unit.attempt`, so
that the rest of the file is checked, too.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final, TypeAlias, TypeVar

from pycparser import c_ast

from crs_cc.core.source import Diagnostics, Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.header_hint import header_hint
from crs_cc.frontend.check.scope import FunctionSymbol, ObjectSymbol, Scope, Symbol
from crs_cc.frontend.error_limit import report
from crs_cc.frontend.parse.lexer import Span
from crs_cc.frontend.parse.nodes import Node, OwnNode
from crs_cc.frontend.preprocess.options import Dialect
from crs_cc.frontend.preprocess.output import WeakName
from crs_cc.ir.types import CType

Result = TypeVar("Result")


class Checked(OwnNode):
    """A node for an expression that is checked already."""

    __slots__ = ("expression",)

    def __init__(self, expression: tree.Expression, coord: Any) -> None:
        super().__init__(coord)
        self.expression = expression


class CheckError(Exception):
    """An error in the source; an empty text means that it was reported before."""

    def __init__(self, location: Location, text: str, hint: str = "") -> None:
        super().__init__(text)
        self.location = location
        self.text = text
        self.hint = hint


@dataclass(slots=True, eq=False)
class Automatic:
    """A local variable with an action at the end of its scope, or of a variably modified type.

    Attributes:
        mark: for an array, the hidden variable with the allocator's state before it.
        cleanup: returns the call of its attribute `cleanup`.
    """

    name: str
    location: Location
    mark: ObjectSymbol | None
    cleanup: Callable[[], tree.Expression] | None = None


@dataclass(slots=True, eq=False)
class SwitchState:
    """An open `switch`: the type of its value and its labels.

    Attributes:
        lows: the lowest value of each `case`, sorted.
        cases: the highest value and the location of each of them.
        default: the location of `default`.
        automatics: the number of `Automatic`s in scope at its start.
    """

    type: CType
    automatics: int
    labels: list[tree.CaseLabel] = field(default_factory=list)
    lows: list[int] = field(default_factory=list)
    cases: list[tuple[int, Location]] = field(default_factory=list)
    default: Location | None = None


@dataclass(slots=True, eq=False)
class FunctionState:
    """The state of a function whose body is checked.

    Attributes:
        returns_implicit_int: whether the result type is left out, so that `return` needs no value.
        loops: the number of `automatics` in scope at the start of each open loop.
        switches: the open switches.
        breakable: the number of `automatics` in scope at the start of each open loop and switch.
        addresses: the number, which serves as its address, of each label whose address is taken,
            and the location of the first use.
        label_names: for each open block with local labels, their names in `labels`.
        labels: the location of each label, and the `automatics` in scope there.
        gotos: every `goto`, with the `automatics` in scope there.
        returns: every `return`.
        automatics: the variables in scope that have variably modified types.
        effects: the side effects of the types in the current declaration or expression.
        alloca_mark: the mark, as in `Automatic`, for memory from `alloca`.
        outer: the function that it is nested in; for this and the following see `nested`.
        has_nested: whether there are functions inside it.
        chain: the hidden parameter of a nested function.
        record: the array of the addresses of `shared`.
        shared: the variables that functions inside it use.
        visible: the variables of functions around it that it can use.
        captured: those that it uses, each with the local variable for its address.
        landings: for each label that functions inside it jump to, the buffer of `setjmp`, and the
            `goto` that follows it.
        thunks: the static objects for pointers to each function inside it.
    """

    symbol: FunctionSymbol
    result: CType
    returns_implicit_int: bool = False
    is_variadic: bool = False
    loops: list[int] = field(default_factory=list)
    switches: list[SwitchState] = field(default_factory=list)
    breakable: list[int] = field(default_factory=list)
    addresses: dict[str, tuple[int, Location]] = field(default_factory=dict)
    label_names: list[dict[str, str]] = field(default_factory=list)
    labels: dict[str, tuple[Location, list[Automatic]]] = field(default_factory=dict)
    gotos: list[tuple[tree.Goto, list[Automatic]]] = field(default_factory=list)
    returns: list[tree.Return] = field(default_factory=list)
    automatics: list[Automatic] = field(default_factory=list)
    effects: list[tree.Expression] = field(default_factory=list)
    alloca_mark: ObjectSymbol | None = None
    outer: FunctionState | None = None
    has_nested: bool = False
    chain: ObjectSymbol | None = None
    record: ObjectSymbol | None = None
    shared: list[ObjectSymbol] = field(default_factory=list)
    visible: set[ObjectSymbol] = field(default_factory=set)
    captured: dict[ObjectSymbol, ObjectSymbol] = field(default_factory=dict)
    landings: dict[str, tuple[ObjectSymbol, tree.Goto]] = field(default_factory=dict)
    thunks: dict[FunctionSymbol, tuple[ObjectSymbol, ObjectSymbol]] = field(default_factory=dict)


@dataclass(slots=True, eq=False)
class Unit:
    """One C file while it is checked.

    Attributes:
        name: the file's name as the user gave it.
        scope: the innermost scope.
        externals: objects and functions with linkage, by name, wherever they were declared.
        objects: the objects with static storage duration, in the order of their definitions.
        functions: the defined functions.
        blocks: the blocks of functions that have been checked, each with its start and end.
        specified: the type of each specifier node; declarators share them.
        function: the function that is being checked.
        location: the last known location, for nodes without one.
        link_names: the number of static names of each spelling.
        static_initialisers: the number of open initialisers in which every value is constant.
        prototypes: the number of open parameter lists, in which array lengths are not evaluated.
        unknown: the unknown names that were reported, with the function that used them.
        suggestions: the number of further unknown names that get a hint.
        trusted: whether its functions may change the state of shadow memory.
        dialect: the dialect, which determines the robot functions.
        standard: the C standard, a key of `preprocess.options.STANDARDS`.
        headers: the directories of the headers that come with crs.
        macros: the names of the macros, for suggestions.
        weak: the names of `#pragma weak`.
    """

    name: str
    diagnostics: Diagnostics
    location: Location
    scope: Scope = field(default_factory=Scope)
    externals: dict[str, ObjectSymbol | FunctionSymbol] = field(default_factory=dict)
    objects: list[tree.ObjectDefinition] = field(default_factory=list)
    functions: list[tree.FunctionDefinition] = field(default_factory=list)
    blocks: list[tuple[Scope, tuple[Location, Location]]] = field(default_factory=list)
    specified: dict[Any, CType] = field(default_factory=dict)
    function: FunctionState | None = None
    link_names: dict[str, int] = field(default_factory=dict)
    static_initialisers: int = 0
    prototypes: int = 0
    unknown: set[tuple[str, str]] = field(default_factory=set)
    suggestions: int = 20
    trusted: bool = False
    dialect: Dialect = "nomad"
    standard: str = "gnu17"
    headers: tuple[Path, ...] = ()
    macros: tuple[str, ...] = ()
    weak: Mapping[str, WeakName] = field(default_factory=dict)

    def add_external(self, symbol: ObjectSymbol | FunctionSymbol) -> None:
        """Enter a name with external linkage, and apply `#pragma weak`."""
        self.externals[symbol.name] = symbol
        weak = self.weak.get(symbol.name)
        if weak is not None:
            symbol.is_weak, symbol.alias = True, weak.alias

    def at(self, node: Node) -> Location:
        """Return a node's location, the last known one if it has none."""
        coord = node.coord
        if coord is not None:
            self.location = coord.location
        return self.location

    def at_name(self, node: Node) -> Location:
        """Return the location of the name in a declaration."""
        inner = node.type
        while isinstance(inner, c_ast.PtrDecl | c_ast.ArrayDecl | c_ast.FuncDecl):
            inner = inner.type
        is_named = isinstance(inner, c_ast.TypeDecl) and inner.coord is not None
        return self.at(inner if is_named else node)

    def error(self, location: Location, text: str, hint: str = "") -> None:
        """Report an error after which the check of the expression can continue.

        Raises:
            CompilationAborted: there are too many errors.
        """
        report(self.diagnostics, location, text, hint)

    def warning(self, location: Location, text: str, hint: str = "", *, flag: str) -> None:
        """Report a warning; `flag` is its name, see `frontend.warn.flags`."""
        self.diagnostics.warning(location, text, hint, flag=flag)

    def attempt(self, action: Callable[..., Result], *arguments: Any) -> Result | None:
        """Call `action(unit, *arguments)`; report a `CheckError` and return None."""
        scope = self.scope
        try:
            return action(self, *arguments)
        except CheckError as mistake:
            self.scope = scope
            if mistake.text:
                self.error(mistake.location, mistake.text, mistake.hint)
            return None

    def suggest(self, name: str, kind: type[Symbol] | None = None) -> str:
        """Return a hint for an unknown name; none after many of them, since each takes time."""
        self.suggestions -= 1
        if self.suggestions < 0:
            return ""
        hint = header_hint(name, self.headers)
        if hint:
            return hint
        macros = [each for each in self.macros if not each.startswith("_")]
        similar = self.scope.closest(name, kind, macros)
        return f"did you mean '{similar}'?" if similar is not None else ""

    @contextmanager
    def new_scope(self) -> Iterator[Scope]:
        """Open a scope inside the current one, and close it at the end."""
        outer = self.scope
        self.scope = Scope(outer)
        try:
            yield self.scope
        finally:
            self.scope = outer

    def static_name(self, name: str) -> str:
        """Return a linker name that is unique to this file: `wander.c:turn`."""
        wanted = f"{self.name}:{name}"
        number = self.link_names.get(wanted, 0) + 1
        self.link_names[wanted] = number
        return wanted if number == 1 else f"{wanted}.{number}"


CheckExpression: TypeAlias = Callable[[Unit, Node], tree.Expression]
CheckStatement: TypeAlias = Callable[[Unit, Node, list[tree.Statement]], None]

EXPRESSIONS: Final[dict[type, CheckExpression]] = {}
"""The checker of each class of expressions."""

STATEMENTS: Final[dict[type, CheckStatement]] = {}
"""The checker of each class of statements and declarations in a block; it appends to a list."""


def checks(*classes: type) -> Callable[[CheckExpression], CheckExpression]:
    """Register a function in `EXPRESSIONS`."""

    def enter(function: CheckExpression) -> CheckExpression:
        EXPRESSIONS.update(dict.fromkeys(classes, function))
        return function

    return enter


def checks_statement(*classes: type) -> Callable[[CheckStatement], CheckStatement]:
    """Register a function in `STATEMENTS`."""

    def enter(function: CheckStatement) -> CheckStatement:
        STATEMENTS.update(dict.fromkeys(classes, function))
        return function

    return enter


def expression(unit: Unit, node: Node) -> tree.Expression:
    """Check an expression without decay of arrays and functions.

    Raises:
        CheckError: it has an error.
    """
    found = EXPRESSIONS.get(node.__class__)
    if found is None:
        raise CheckError(unit.at(node), f"expected an expression, not {node.__class__.__name__}")
    checked = found(unit, node)
    if node.coord.__class__ is Span:
        checked.location = node.coord.location
    return checked


@checks(Checked)
def _checked(_unit: Unit, node: Checked) -> tree.Expression:
    return node.expression
