"""Check calls (C17 6.5.2.2), including those of undeclared functions."""

from __future__ import annotations

from pathlib import Path

from pycparser import c_ast

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.argument_hints import argument_hint
from crs_cc.frontend.check.builtins import call_builtin
from crs_cc.frontend.check.checker import CheckError, Unit, checks
from crs_cc.frontend.check.conversion import assigned, decay, promote_argument
from crs_cc.frontend.check.expressions import offset_of, rvalue
from crs_cc.frontend.check.format_string import check_format
from crs_cc.frontend.check.library_prototypes import library_functions, undeclared
from crs_cc.frontend.check.scope import FunctionSymbol
from crs_cc.frontend.check.tree import Expression
from crs_cc.frontend.parse.nodes import Node
from crs_cc.ir.types import (
    INT,
    FunctionType,
    PointerType,
    VoidType,
    is_complete,
    spell,
    unqualified,
)

_OFFSETOF = {"offsetof", "__builtin_offsetof"}
_ATOMIC = ("__sync_", "__atomic_")


@checks(c_ast.FuncCall)
def call(unit: Unit, node: Node) -> Expression:
    """Check `function(arguments)`."""
    if isinstance(node.name, c_ast.ID):
        name = node.name.name
        if name in _OFFSETOF:
            return offset_of(unit, node)
        if name.startswith("__"):
            found = call_builtin(unit, name, node)
            if found is not None:
                return found
            if name.startswith("__builtin_"):
                return _call(unit, node, decay(_library_function(unit, node.name)))
        if unit.scope.find(name) is None:
            if name.startswith(_ATOMIC):
                text = f"'{name}' is not a known atomic builtin; use plain operators"
                raise CheckError(unit.at(node.name), text)
            if name == "alloca":
                node.name.name = "__builtin_alloca"
                return call(unit, node)
            _declare_implicitly(unit, name, unit.at(node.name))
    return _call(unit, node, rvalue(unit, node.name))


def _library_function(unit: Unit, node: Node) -> Expression:
    """Return the library function for a name with the prefix `__builtin_`.

    Raises:
        CheckError: there is no such builtin, or it is not supported.
    """
    location, name = unit.at(node), node.name.removeprefix("__builtin_")
    found = library_functions().get(name)
    if found is None:
        raise CheckError(location, f"'{node.name}' is not supported")
    symbol = unit.externals.get(name)
    if not isinstance(symbol, FunctionSymbol) or symbol.is_implicit:
        symbol = FunctionSymbol(name, found[0], location, name)
    return tree.FunctionName(symbol.type, location, symbol)


def _call(unit: Unit, node: Node, callee: Expression) -> Expression:
    """Check the call of a declared function."""
    location = unit.at(node)
    pointer = callee.type
    if not isinstance(pointer, PointerType) or not isinstance(pointer.target, FunctionType):
        text = f"called object type '{callee.type}' is not a function or function pointer"
        raise CheckError(location, text)
    function = pointer.target
    if not isinstance(function.result, VoidType) and not is_complete(function.result):
        raise CheckError(
            location, f"calling function with incomplete result type '{function.result}'"
        )
    nodes = [] if node.args is None else node.args.exprs
    arguments = _arguments(unit, callee, function, nodes)
    if isinstance(callee, tree.AddressOf) and isinstance(callee.operand, tree.FunctionName):
        callee = callee.operand
        check_format(unit, callee.symbol, nodes, arguments)
    return tree.Call(unqualified(function.result), location, callee, arguments)


def _arguments(
    unit: Unit, callee: Expression, function: FunctionType, nodes: list[Node]
) -> list[Expression]:
    """Convert the arguments to the parameters' types (C17 6.5.2.2p6, p7)."""
    values = [rvalue(unit, each) for each in nodes]
    for value in values:
        if not is_complete(value.type):
            raise CheckError(value.location, f"argument type '{value.type}' is incomplete")
    if function.parameters is None:
        return [promote_argument(value) for value in values]
    wanted = len(function.parameters)
    if len(values) < wanted or (len(values) > wanted and not function.variadic):
        what = "few" if len(values) < wanted else "many"
        least = "at least " if function.variadic else ""
        text = (
            f"too {what} arguments to function call, expected {least}{wanted}, have {len(values)}"
        )
        raise CheckError(callee.location, text, _hint(callee, values) or _declared(unit, callee))
    hint = _hint(callee, values)
    fixed = [
        assigned(unit, value, ctype, "pass", hint)
        for value, ctype in zip(values, function.parameters, strict=False)
    ]
    return fixed + [promote_argument(value) for value in values[wanted:]]


def _hint(callee: Expression, values: list[Expression]) -> str:
    """Return a hint at a known mistake in the arguments of a library function."""
    symbol = _called(callee)
    return "" if symbol is None else argument_hint(symbol, symbol.type, values)


def _called(callee: Expression) -> FunctionSymbol | None:
    """Return the function, if it is called by its name."""
    match callee:
        case tree.AddressOf(operand=tree.FunctionName(symbol=symbol)):
            return symbol
    return None


def _declared(unit: Unit, callee: Expression) -> str:
    """Return a hint at the declaration of the called function."""
    symbol = _called(callee)
    if symbol is not None:
        declared = spell(symbol.type, symbol.name)
        place = Path(symbol.location.file)
        folder = next((each for each in unit.headers if place.is_relative_to(each)), None)
        where = f"in <{place.relative_to(folder)}>" if folder else f"at {symbol.location}"
        return f"'{symbol.name}' is declared {where}, as '{declared}'"
    return ""


def _declare_implicitly(unit: Unit, name: str, location: Location) -> None:
    """Declare an unknown function with the result `int` (C90 6.3.2.2).

    A library function gets its own type, as in gcc.
    """
    text, found = f"implicit declaration of function '{name}'", undeclared(name)
    if found is None:
        ctype = FunctionType(INT)
        unit.warning(
            location, text, unit.suggest(name, FunctionSymbol), flag="implicit-function-declaration"
        )
    else:
        ctype, header = found
        unit.warning(
            location,
            f"{text} with type '{ctype}'",
            f"include <{header}>",
            flag="implicit-function-declaration",
        )
    outermost = unit.scope
    while outermost.outer is not None:
        outermost = outermost.outer
    known = unit.externals.get(name)
    if not isinstance(known, FunctionSymbol):
        known = FunctionSymbol(name, ctype, location, name, is_implicit=True)
        unit.add_external(known)
    outermost.names[name] = known
