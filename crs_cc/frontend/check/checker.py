"""Checking: what every checker shares, and the tables that say who checks which node.

Each `check_*.py` file enters its functions here under pycparser's node classes. A mistake raises
`CheckError`; whoever checks a statement or declaration catches it with `Unit.attempt`, so that
the rest of the file is checked too.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
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
from crs_cc.ir.types import CType

Result = TypeVar("Result")


class Checked(OwnNode):
    """Stands for an expression that is checked already."""

    __slots__ = ("expression",)

    def __init__(self, expression: tree.Expression, coord: Any) -> None:
        super().__init__(coord)
        self.expression = expression


class CheckError(Exception):
    """A mistake in the source; an empty text means that it was reported before."""

    def __init__(self, location: Location, text: str, hint: str = "") -> None:
        super().__init__(text)
        self.location = location
        self.text = text
        self.hint = hint


@dataclass(slots=True, eq=False)
class Automatic:
    """A local variable of a variably modified type, in its scope.

    Attributes:
        mark: for an array the hidden variable that tells what memory to give back after it.
    """

    name: str
    location: Location
    mark: ObjectSymbol | None


@dataclass(slots=True, eq=False)
class SwitchState:
    """An open `switch`: the type of its value and its labels.

    Attributes:
        lows: the lowest value of each `case`, sorted.
        cases: for each of them the highest value, and where it stands.
        default: where `default` stands.
        automatics: how many `Automatic`s there were where it began.
    """

    type: CType
    automatics: int
    labels: list[tree.CaseLabel] = field(default_factory=list)
    lows: list[int] = field(default_factory=list)
    cases: list[tuple[int, Location]] = field(default_factory=list)
    default: Location | None = None


@dataclass(slots=True, eq=False)
class FunctionState:
    """What is known while a function's body is checked.

    Attributes:
        returns_implicit_int: no result type was written, so that no value need be returned.
        loops: for each open loop, how many `automatics` there were where it began.
        switches: every open switch.
        breakable: the same for each open loop and switch.
        addresses: number of each label whose address is taken, and where that was first done;
            the number is the address.
        label_names: for each open block with labels of its own, what they are called in `labels`.
        labels: where each label stands, and the `automatics` there.
        gotos: every `goto`, with the `automatics` there.
        returns: every `return`.
        automatics: the variables in scope that have variably modified types.
        effects: what must be done for the types in the present declaration or expression.
        alloca_mark: as in `Automatic`, for all that the function got with `alloca`.
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


@dataclass(slots=True, eq=False)
class Unit:
    """One C file while it is checked.

    Attributes:
        name: the file's name as the user gave it.
        scope: the innermost scope.
        externals: objects and functions with linkage, by name, wherever they were declared.
        objects: the objects with static storage, in the order of their definitions.
        functions: the functions that are defined.
        specified: the type of each specifier node; declarators share them.
        function: the function being checked.
        place: the last known place, for nodes without one.
        link_names: how many statics of each name there are.
        prototypes: how many lists of parameters, whose lengths are not computed, are open.
        unknown: unknown names that were reported, with the function that used them.
        suggestions: how many more unknown names get a hint.
        trusted: whether its functions may tell the shadow memory what C may do.
        dialect: whose functions it calls.
        headers: the folders of the headers that come with crs.
        macros: the names of the macros, which may be misspelled, too.
    """

    name: str
    diagnostics: Diagnostics
    place: Location
    scope: Scope = field(default_factory=Scope)
    externals: dict[str, ObjectSymbol | FunctionSymbol] = field(default_factory=dict)
    objects: list[tree.ObjectDefinition] = field(default_factory=list)
    functions: list[tree.FunctionDefinition] = field(default_factory=list)
    specified: dict[Any, CType] = field(default_factory=dict)
    function: FunctionState | None = None
    link_names: dict[str, int] = field(default_factory=dict)
    prototypes: int = 0
    unknown: set[tuple[str, str]] = field(default_factory=set)
    suggestions: int = 20
    trusted: bool = False
    dialect: Dialect = "nomad"
    headers: tuple[Path, ...] = ()
    macros: tuple[str, ...] = ()

    def at(self, node: Node) -> Location:
        """Return a node's place, the last known one if it has none."""
        coord = node.coord
        if coord is not None:
            self.place = coord.location
        return self.place

    def at_name(self, node: Node) -> Location:
        """Return the place of the name that a declaration declares."""
        inner = node.type
        while isinstance(inner, c_ast.PtrDecl | c_ast.ArrayDecl | c_ast.FuncDecl):
            inner = inner.type
        is_named = isinstance(inner, c_ast.TypeDecl) and inner.coord is not None
        return self.at(inner if is_named else node)

    def error(self, location: Location, text: str, hint: str = "") -> None:
        """Report a mistake that need not stop the check of the expression.

        Raises:
            GiveUp: when the file is hopeless.
        """
        report(self.diagnostics, location, text, hint)

    def warning(self, location: Location, text: str, hint: str = "") -> None:
        """Report a habit that works, but should not."""
        self.diagnostics.warning(location, text, hint)

    def attempt(self, action: Callable[..., Result], *arguments: Any) -> Result | None:
        """Call `action(unit, *arguments)`; on a mistake reports it and gives None."""
        scope = self.scope
        try:
            return action(self, *arguments)
        except CheckError as mistake:
            self.scope = scope
            if mistake.text:
                self.error(mistake.location, mistake.text, mistake.hint)
            return None

    def suggest(self, name: str, kind: type[Symbol] | None = None) -> str:
        """Return a hint for an unknown name; after some of them none, as they take time."""
        self.suggestions -= 1
        if self.suggestions < 0:
            return ""
        hint = header_hint(name, self.headers)
        if hint:
            return hint
        macros = [] if kind else [each for each in self.macros if not each.startswith("_")]
        similar = self.scope.closest(name, kind, macros)
        return f"did you mean '{similar}'?" if similar is not None else ""

    @contextmanager
    def new_scope(self) -> Iterator[Scope]:
        """Open a scope inside the present one and closes it again."""
        outer = self.scope
        self.scope = Scope(outer)
        try:
            yield self.scope
        finally:
            self.scope = outer

    def static_name(self, name: str) -> str:
        """Build a linker name that no other file can use: `wander.c:turn`."""
        wanted = f"{self.name}:{name}"
        number = self.link_names.get(wanted, 0) + 1
        self.link_names[wanted] = number
        return wanted if number == 1 else f"{wanted}.{number}"


CheckExpression: TypeAlias = Callable[[Unit, Node], tree.Expression]
CheckStatement: TypeAlias = Callable[[Unit, Node, list[tree.Statement]], None]

EXPRESSIONS: Final[dict[type, CheckExpression]] = {}
"""Who checks each class of expression."""

STATEMENTS: Final[dict[type, CheckStatement]] = {}
"""Who checks each class of statement and declaration in a block, adding to a list."""


def checks(*classes: type) -> Callable[[CheckExpression], CheckExpression]:
    """Enter a function into `EXPRESSIONS`."""

    def enter(function: CheckExpression) -> CheckExpression:
        EXPRESSIONS.update(dict.fromkeys(classes, function))
        return function

    return enter


def checks_statement(*classes: type) -> Callable[[CheckStatement], CheckStatement]:
    """Enter a function into `STATEMENTS`."""

    def enter(function: CheckStatement) -> CheckStatement:
        STATEMENTS.update(dict.fromkeys(classes, function))
        return function

    return enter


def expression(unit: Unit, node: Node) -> tree.Expression:
    """Check an expression; arrays and functions stay what they are.

    Raises:
        CheckError: at the first mistake in it.
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
