"""Check a whole file: external declarations and function definitions (C17 6.9)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

from pycparser import c_ast

from crs_cc.core.source import Location
from crs_cc.frontend.check import calls, conditional, tree, vla
from crs_cc.frontend.check.alignment import has_attribute
from crs_cc.frontend.check.builtins import VA_LIST
from crs_cc.frontend.check.checker import CheckError, FunctionState, Unit, checks_statement
from crs_cc.frontend.check.conversion import is_scalar
from crs_cc.frontend.check.declaration import (
    declare,
    declare_broken,
    declare_function,
    declared_or_broken,
    finish_objects,
    typedef,
)
from crs_cc.frontend.check.declarator import declared_type, parameter_type
from crs_cc.frontend.check.function_attributes import apply_attributes
from crs_cc.frontend.check.nested import convert_nested, declare_nested, enter
from crs_cc.frontend.check.prototype import declare_prototype
from crs_cc.frontend.check.scope import FunctionSymbol, ObjectSymbol, TypedefName
from crs_cc.frontend.check.statements import check_labels, record_block, statement
from crs_cc.frontend.check.tag import static_assert
from crs_cc.frontend.check.type_compat import compatible, is_promoted
from crs_cc.frontend.check.unsupported import refused
from crs_cc.frontend.parse.keywords import INLINE
from crs_cc.frontend.parse.nodes import PREDECLARED_TYPES, Broken, Node, Prototype
from crs_cc.frontend.preprocess.options import is_c90
from crs_cc.ir.types import (
    DOUBLE,
    INT,
    CType,
    FloatType,
    FunctionType,
    VoidType,
    is_complete,
    is_variably_modified,
    unqualified,
)

_ = calls, conditional  # registers their checkers

VARARGS: Final = "__va_alist"
"""The parameter of variadic functions before C89, in <varargs.h>."""


def check_unit(unit: Unit, nodes: list[Node]) -> None:
    """Check all external declarations of a file; errors go to its diagnostics."""
    for name in PREDECLARED_TYPES:
        unit.scope.names[name] = TypedefName(name, VA_LIST, unit.location)
    for node in nodes:
        checker = EXTERNAL.get(node.__class__)
        if checker is None:
            error = refused(unit, node)
            unit.error(error.location, error.text)
        else:
            unit.attempt(checker, node)
    finish_objects(unit)


def _nothing(_unit: Unit, _node: Node) -> None:
    """Ignore `#pragma`."""


def function_definition(unit: Unit, node: Node) -> None:
    """Check a function with its body."""
    outer = unit.function
    try:
        _function_definition(unit, node)
    finally:
        unit.function = outer


@checks_statement(c_ast.FuncDef)
def _nested_definition(unit: Unit, node: Node, _out: list[tree.Statement]) -> None:
    assert unit.function is not None
    unit.function.has_nested = True
    unit.attempt(function_definition, node)


def _function_definition(unit: Unit, node: Node) -> None:
    declaration = node.decl
    location = unit.at_name(declaration)
    ctype = declared_or_broken(unit, declaration)
    if not isinstance(ctype, FunctionType):
        raise CheckError(location, f"expected ';' after the declaration of '{declaration.name}'")
    known = unit.scope.names.get(declaration.name) or unit.externals.get(declaration.name)
    before = known.type if isinstance(known, FunctionSymbol) and not known.is_implicit else None
    if not isinstance(ctype.result, VoidType) and not is_complete(ctype.result):
        raise CheckError(
            location, f"incomplete result type '{ctype.result}' in function definition"
        )
    symbol = _declared(unit, declaration, ctype, location)
    if symbol.is_defined:
        text = f"redefinition of '{declaration.name}'"
        raise CheckError(location, text, f"first at {symbol.location}")
    symbol.is_defined, symbol.location = True, location
    specifier = _specifier(declaration.type)
    implicit = ctype.result == INT and unit.at(specifier) == location
    state = FunctionState(symbol, ctype.result, implicit, symbol.type.variadic)
    if unit.function is not None:
        enter(unit, state, location)
    unit.function = state
    with unit.new_scope() as scope:
        body: list[tree.Statement] = []
        with vla.effects(unit) as effects:
            parameters, passed = _parameters(unit, node, ctype, before)
        body.extend(tree.ExpressionStatement(each.location, each) for each in effects)
        state.label_names.append({})
        with vla.block(state, body, location):
            for each in node.body.block_items or []:
                statement(unit, each, body)
    ends = record_block(unit, scope, node.body)
    check_labels(unit)
    vla.finish(state, body)
    _, end = ends or (location, unit.at(node.body))
    made = tree.FunctionDefinition(location, symbol, end, parameters, passed, body, implicit)
    convert_nested(unit, made, state)
    unit.functions.append(made)


def _declared(
    unit: Unit, declaration: Node, ctype: FunctionType, location: Location
) -> FunctionSymbol:
    """Declare a function that is being defined, with its specifiers and attributes."""
    storage = [*(declaration.storage or []), *(declaration.funcspec or [])]
    is_static = "static" in storage
    if unit.function is not None:
        symbol = declare_nested(unit, declaration.name, ctype, location)
    else:
        symbol = declare_function(unit, declaration.name, ctype, location, is_static)
    apply_attributes(unit, symbol, declaration)
    if symbol.is_replaceable:
        _forget_definition(unit, symbol)
    # An inline definition may be in a header that several files include (C17 6.7.4p7).
    is_inline = not INLINE.isdisjoint(storage)
    symbol.is_weak = symbol.is_weak or (is_inline and symbol.is_external and not is_static)
    symbol.is_used = symbol.is_used or is_inline
    is_gnu = is_c90(unit.standard) or has_attribute(declaration, "gnu_inline")
    symbol.is_replaceable = is_inline and is_gnu and "extern" in storage
    return symbol


def _forget_definition(unit: Unit, symbol: FunctionSymbol) -> None:
    """Drop the definition that GNU's `extern inline` gives, in favour of the real one."""
    unit.functions = [each for each in unit.functions if each.symbol is not symbol]
    symbol.is_defined = symbol.is_weak = symbol.is_replaceable = False


def _specifier(node: Node) -> Node:
    while not isinstance(node, c_ast.TypeDecl):
        node = node.type
    return node.type


def _parameters(
    unit: Unit, node: Node, ctype: FunctionType, before: CType | None
) -> tuple[list[ObjectSymbol], list[CType]]:
    """Declare the parameters; return them and the types in which callers pass them."""
    declarator = node.decl.type
    if not isinstance(declarator, c_ast.FuncDecl):
        raise CheckError(unit.at(node.decl), "function definition declared through a typedef")
    arguments = [] if declarator.args is None else declarator.args.params
    arguments = [each for each in arguments if not isinstance(each, c_ast.EllipsisParam)]
    if ctype.parameters is None and arguments:
        if arguments[-1].name == VARARGS:
            _make_variadic(unit, node)
            arguments.pop()
        return _old_style(unit, node, arguments, before)
    symbols = []
    for each, parameter in zip(arguments, ctype.parameters or (), strict=False):
        if is_variably_modified(parameter) or _has_length(each):
            parameter = parameter_type(unit, each)  # noqa: PLW2901 - now the others are known
        symbols.append(_declare_parameter(unit, each, each.name, parameter))
    return symbols, list(ctype.parameters or ())


def _make_variadic(unit: Unit, node: Node) -> None:
    """Turn the parameter of <varargs.h>, `f(va_alist) va_dcl {...}`, into any number of them."""
    assert unit.function is not None
    symbol = unit.function.symbol
    symbol.type = FunctionType(symbol.type.result, None, variadic=True)
    unit.function.is_variadic = True
    node.param_decls = [each for each in node.param_decls or [] if each.name != VARARGS]


def _has_length(node: Node) -> bool:
    """Return whether a parameter is an array whose length may have side effects."""
    is_array = isinstance(node.type, c_ast.ArrayDecl)
    return is_array and not isinstance(node.type.dim, c_ast.Constant | None)


def _declare_parameter(unit: Unit, node: Node, name: str | None, ctype: CType) -> ObjectSymbol:
    location = unit.at_name(node) if isinstance(node, c_ast.Decl) else unit.at(node)
    if not is_complete(ctype):
        raise CheckError(location, f"parameter '{name or ''}' has incomplete type '{ctype}'")
    symbol = ObjectSymbol(name or "", ctype, location, in_memory=not is_scalar(ctype))
    symbol.is_array_parameter = isinstance(getattr(node, "type", None), c_ast.ArrayDecl)
    if name is not None:
        if name in unit.scope.names:
            raise CheckError(location, f"redefinition of parameter '{name}'")
        unit.scope.names[name] = symbol
    return symbol


def _old_style(
    unit: Unit, node: Node, names: list[Node], before: CType | None
) -> tuple[list[ObjectSymbol], list[CType]]:
    """Declare the parameters of `f(a, b) int a; {...}` (C17 6.9.1p6)."""
    declared: dict[str, tuple[Node, ObjectSymbol]] = {}
    listed = {each.name for each in names}
    # The length of an array may depend on parameters that are declared after it.
    for each in sorted(node.param_decls or [], key=_is_derived):
        if not isinstance(each, c_ast.Decl) or each.name is None:
            unit.attempt(declared_type, each.type) if isinstance(each, c_ast.Decl) else None
            continue
        if each.name not in listed:
            text = f"declaration for parameter '{each.name}' but no such parameter"
            unit.error(unit.at(each), text)
        ctype = parameter_type(unit, each)
        declared[each.name] = each, _declare_parameter(unit, each, each.name, ctype)
    symbols, passed = [], []
    prototype = before.parameters if isinstance(before, FunctionType) else None
    for number, each in enumerate(names):
        place, symbol = declared.get(each.name, (each, None))
        symbol = symbol or _declare_parameter(unit, each, each.name, INT)
        symbols.append(symbol)
        promised = prototype[number] if prototype and number < len(prototype) else None
        passed.append(_passed(symbol.type, promised))
        if promised is not None and not compatible(unqualified(promised), passed[-1]):
            text = f"parameter '{each.name}' has type '{promised}' in the prototype"
            unit.warning(unit.at(place), text, flag="conflicting-types")
    return symbols, passed


def _is_derived(node: Node) -> bool:
    """Return whether a declaration has an array, pointer or function declarator."""
    return not isinstance(node.type, c_ast.TypeDecl)


def _passed(ctype: CType, promised: CType | None) -> CType:
    """Return the type in which an old-style parameter arrives (C17 6.5.2.2p6).

    After a prototype with its own type it is passed as that type (as in gcc).
    """
    plain = unqualified(ctype)
    if is_promoted(plain) or (promised is not None and compatible(unqualified(promised), plain)):
        return plain
    return DOUBLE if isinstance(plain, FloatType) else INT


External = Callable[[Unit, Any], None]
EXTERNAL: Final[dict[type, External]] = {
    Broken: declare_broken,
    c_ast.Decl: declare,
    c_ast.FuncDef: function_definition,
    c_ast.Pragma: _nothing,
    Prototype: declare_prototype,
    c_ast.StaticAssert: static_assert,
    c_ast.Typedef: typedef,
}
"""The checker of each class of external declarations."""
