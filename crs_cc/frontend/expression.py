r"""Compiles single C expressions in the scope of a C file, for the debugger.

The expression becomes a function. The local variables in scope are passed to it by address, so
that it works on the stopped program's memory; all other names, macros included, have the meaning
that they have at the end of the file.

>>> import tempfile
>>> from crs_cc.ir.types import INT
>>> with tempfile.NamedTemporaryFile("w", suffix=".c") as file:
...     _ = file.write("#define TWICE(x) (2 * (x))\nstruct point { int x, y; } goal;\n")
...     file.flush()
...     names = FileNames(Path(file.name), Options())
>>> found = names.compile("TWICE(goal.y) + speed", "main", [("speed", INT)], Diagnostics())
>>> str(found.type), found.is_place, found.variables
('int', False, ('speed',))
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Final

from pycparser import c_ast

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostics, Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.checker import CheckError, FunctionState, Unit, expression
from crs_cc.frontend.check.conversion import convert
from crs_cc.frontend.check.operators import is_lvalue
from crs_cc.frontend.check.scope import (
    EnumConstant,
    FunctionSymbol,
    ObjectSymbol,
    Symbol,
    Tag,
    TypedefName,
)
from crs_cc.frontend.check.tree_parts import walk
from crs_cc.frontend.error_limit import CompilationAborted
from crs_cc.frontend.lower.graph import simplify
from crs_cc.frontend.lower.lowerer import Lowering, effect, place, value, value_type
from crs_cc.frontend.lower.rules import RULES
from crs_cc.frontend.lower.unit_state import UnitState
from crs_cc.frontend.parse.lexer import lex
from crs_cc.frontend.parse.parser import parse_expression
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.unit import check_file
from crs_cc.ir.instruction import Block, Operand, Return, Variable
from crs_cc.ir.program import Function, Parameter, Program
from crs_cc.ir.types import (
    ArrayType,
    CType,
    EnumType,
    FunctionType,
    PointerType,
    RecordType,
    VoidType,
)

EXPRESSION: Final = "<expression>"
"""The name of the expression's file and of the function that it becomes."""


@dataclass(frozen=True, slots=True)
class CompiledExpression:
    """An expression, compiled to a function of the addresses of variables.

    Attributes:
        text: the source text.
        program: the function `EXPRESSION` and its string literals.
        type: the type of the expression.
        is_place: whether the function returns the address of the object that the expression
            designates, as it always does for a struct; otherwise it returns the value.
        variables: the variables whose addresses are its arguments, in order.
        is_assignment: whether it assigns to something.
    """

    text: str
    program: Program
    type: CType
    is_place: bool
    variables: tuple[str, ...]
    is_assignment: bool = False

    @property
    def function(self) -> Function:
        """The function."""
        return self.program.functions[EXPRESSION]


@dataclass(frozen=True, slots=True)
class BlockNames:
    """The constants and types, other than variables, that some blocks declare."""

    names: Mapping[str, EnumConstant | TypedefName] = field(default_factory=dict)
    tags: Mapping[str, Tag] = field(default_factory=dict)


class FileNames:
    """The names that are visible at the end of a C file.

    Attributes:
        lines: the lines of all files that were read, by file name.
    """

    def __init__(self, path: Path, options: Options) -> None:
        """Read the file; raise CompileError when there are errors in it."""
        diagnostics = Diagnostics()
        self._unit, self._source = check_file(path, options, diagnostics)
        self.lines: Mapping[str, Sequence[str]] = diagnostics.lines
        self._locals = {(each.name, each.location): each.type for each in _locals(self._unit)}

    def defines(self, function: str) -> bool:
        """Return whether the file, or a header that it includes, defines a function."""
        return any(each.symbol.link_name == function for each in self._unit.functions)

    def body(self, function: str) -> Location | None:
        """Return where the body of a function begins; None if it is not defined here."""
        for each in self._unit.functions:
            if each.symbol.link_name == function:
                ends = (start for _, (start, end) in self._unit.blocks if end == each.end)
                return next(ends, None)
        return None

    def knows(self, name: str) -> bool:
        """Return whether a name is declared at file scope."""
        return self._unit.scope.find(name) is not None

    def macro(self, name: str) -> tuple[Location, str] | None:
        """Return the location and the directive of a macro's definition; None for no macro."""
        macro = self._source.macros.get(name)
        return None if macro is None else (self._source.definition(macro), macro.definition)

    def macros(self) -> Iterator[str]:
        """Return the names of the macros that are defined at the end of the file."""
        return iter(self._source.macros)

    def expanded(self, text: str) -> str:
        """Return a text with its macros replaced, as at the end of the file."""
        assert self._source.more is not None
        return " ".join(self._source.more(EXPRESSION, text.replace("\n", " ")).text.split())

    def types(self) -> Iterator[tuple[Location, CType, str]]:
        """Return location, type and typedef name, or "", of the types declared at file scope."""
        scope = self._unit.scope
        for tag in scope.tags.values():
            yield tag.location, tag.type, ""
        for symbol in scope.names.values():
            if isinstance(symbol, TypedefName):
                yield symbol.location, symbol.type, symbol.name

    def type_of(self, variable: Variable) -> CType:
        """Return the type of a variable in a function, in terms of this file.

        The structs of a program that was compiled separately are distinct types.
        """
        return self._locals.get((variable.name, variable.location), variable.ctype)

    def in_blocks(self, location: Location) -> BlockNames:
        """Return the constants and types that the blocks around a location declare before it."""
        found: dict[str, EnumConstant | TypedefName] = {}
        tags: dict[str, Tag] = {}
        for scope, (start, end) in sorted(self._unit.blocks, key=lambda block: block[1][0]):
            if location.file == start.file and start <= location <= end:
                found |= {
                    name: symbol
                    for name, symbol in scope.names.items()
                    if isinstance(symbol, EnumConstant | TypedefName)
                    and symbol.location <= location
                }
                tags |= {name: tag for name, tag in scope.tags.items() if tag.location <= location}
        return BlockNames(found, tags)

    def compile(
        self,
        text: str,
        function: str,
        variables: Iterable[tuple[str, CType]],
        diagnostics: Diagnostics,
        blocks: BlockNames | None = None,
    ) -> CompiledExpression:
        """Compile an expression.

        Args:
            text: the expression.
            function: the C name of the function around it, for `__func__`.
            variables: the variables in scope, the outermost first; later ones hide earlier ones.
            diagnostics: receives warnings.
            blocks: what the blocks around it declare, which the variables hide.

        Raises:
            CompileError: when the expression is invalid here.
        """
        own = Diagnostics()
        unit = replace(self._unit, name=EXPRESSION, diagnostics=own, suggestions=1, unknown=set())
        symbols = {name: _indirect(name, ctype) for name, ctype in variables}
        try:
            checked = self._checked(unit, text, function, symbols, blocks or BlockNames())
        except CompilationAborted:
            checked = None
        except CheckError as mistake:
            own.error(mistake.location, mistake.text or "invalid expression", mistake.hint)
            checked = None
        own.sort()
        if own.errors or checked is None:
            raise CompileError(own.errors)
        diagnostics.messages.extend(own.messages)
        return _lowered(unit, text, checked, symbols)

    def _checked(
        self,
        unit: Unit,
        text: str,
        function: str,
        symbols: dict[str, ObjectSymbol],
        blocks: BlockNames,
    ) -> tree.Expression | None:
        assert self._source.more is not None
        report = unit.diagnostics
        source = self._source.more(EXPRESSION, text.replace("\n", " "))
        report.lines[EXPRESSION] = [text]
        tokens = lex(source.text, source.location, report, unit.standard)
        if not tokens:
            report.error(Location(EXPRESSION, 1, 1), "expected an expression")
            return None
        inner: dict[str, Symbol] = {**blocks.names, **symbols}
        names = unit.scope.names | inner
        types = [name for name, symbol in names.items() if isinstance(symbol, TypedefName)]
        node = parse_expression(tokens, types, report, unit.standard)
        if node is None or report.errors:
            return None
        place_ = Location(EXPRESSION, 1, 1)
        symbol = FunctionSymbol(function, FunctionType(VoidType(), ()), place_, function)
        unit.function = FunctionState(symbol, VoidType())
        with unit.new_scope() as scope:
            scope.names.update(inner)
            scope.tags.update(blocks.tags)
            return _of_enum(unit, node, expression(unit, node))


def _of_enum(unit: Unit, node: c_ast.Node, checked: tree.Expression) -> tree.Expression:
    """Return a constant of an enum in the type of the enum, so that it is shown by its name.

    In C it is an int (C17 6.7.2.2p3), and in larger expressions it stays one.
    """
    symbol = unit.scope.find(node.name) if isinstance(node, c_ast.ID) else None
    if isinstance(symbol, EnumConstant):
        return convert(checked, EnumType(symbol.enumeration))
    return checked


def _locals(unit: Unit) -> Iterator[ObjectSymbol]:
    """Yield the variables of all functions, including parameters and static ones."""
    for function in unit.functions:
        yield from function.parameters
        for node in walk(function.body):
            if isinstance(node, tree.Declare):
                yield node.symbol
    yield from (each.symbol for each in unit.objects)


def _indirect(name: str, ctype: CType) -> ObjectSymbol:
    """Return the symbol of a variable that is passed by address."""
    location = Location(EXPRESSION, 1, 1)
    return ObjectSymbol(name, PointerType(ctype), location, is_indirect=True)


def _lowered(
    unit: Unit, text: str, checked: tree.Expression, symbols: dict[str, ObjectSymbol]
) -> CompiledExpression:
    location, shared = Location(EXPRESSION, 1, 1), UnitState(unit)
    function, entry = Function(EXPRESSION, location), Block("entry")
    function.blocks.append(entry)
    low = Lowering(shared, function, RULES, entry)
    for symbol in symbols.values():
        register = low.new_register("i32")
        low.places[symbol] = register
        function.parameters.append(Parameter(register, "i32", 4))
    ctype = checked.type
    is_place = is_lvalue(checked) and not _is_bit_field(checked) and not _is_hidden(checked)
    result: Operand | None = None
    if is_place or isinstance(ctype, RecordType | ArrayType):
        result, is_place = low.address(place(low, checked), location), True
        function.result = "i32"
    elif isinstance(ctype, FunctionType):
        pointer = tree.AddressOf(PointerType(ctype), checked.location, checked)
        result, function.result = value(low, pointer), "i32"
    elif isinstance(ctype, VoidType):
        effect(low, checked)
    else:
        result, function.result = value(low, checked), value_type(ctype)
    low.end(Return(location, result))
    simplify(function)
    shared.program.functions[EXPRESSION] = function
    assigns = isinstance(checked, tree.Assign | tree.CompoundAssign)
    return CompiledExpression(text, shared.program, ctype, is_place, tuple(symbols), assigns)


def _is_bit_field(checked: tree.Expression) -> bool:
    return isinstance(checked, tree.MemberAccess) and checked.member.bit_width is not None


def _is_hidden(checked: tree.Expression) -> bool:
    """Return whether an expression is the hidden pointer to a variable."""
    return isinstance(checked, tree.ObjectName) and checked.symbol.is_indirect
