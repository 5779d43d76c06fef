"""Local variables: static and automatic ones, alignment, the attribute `cleanup` (C17 6.2.4)."""

from __future__ import annotations

from typing import Final

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree, vla
from crs_cc.frontend.check.alignment import alignment, attributes, natural_alignment
from crs_cc.frontend.check.checker import Automatic, CheckError, Unit
from crs_cc.frontend.check.conversion import convert, decay, is_scalar
from crs_cc.frontend.check.declarator import require_complete
from crs_cc.frontend.check.initializer import initialise, known_value
from crs_cc.frontend.check.scope import FunctionSymbol, ObjectSymbol
from crs_cc.frontend.check.tree import Expression, Initialiser
from crs_cc.frontend.parse.nodes import Node
from crs_cc.ir.types import (
    CHAR,
    UINT,
    VOID,
    ArrayType,
    CType,
    FunctionType,
    PointerType,
    is_variably_modified,
)

_FRAME_ALIGNMENT: Final = 16
"""The alignment of every frame [bytes]; objects with a stricter one are found by a pointer."""

_USED: Final = frozenset({"unused", "maybe_unused", "cleanup"})


def declare_local(
    unit: Unit, node: Node, ctype: CType, location: Location, out: list[tree.Statement] | None
) -> None:
    """Declare a variable inside a function; append its actions at run time to `out`.

    Raises:
        CheckError: it has an error.
    """
    assert unit.function is not None
    known = unit.scope.names.get(node.name)
    if known is not None:
        raise CheckError(location, f"redefinition of '{node.name}'", f"first at {known.location}")
    storage = set(node.storage or [])
    symbol = ObjectSymbol(node.name, ctype, location)
    symbol.align = max(alignment(unit, node), natural_alignment(unit, node))
    symbol.in_memory = not is_scalar(ctype)
    symbol.is_used = any(each.name in _USED for each in attributes(node))
    is_static = bool({"static", "_Thread_local", "thread_local"} & storage)
    if is_static:
        symbol.link_name = unit.static_name(f"{unit.function.symbol.name}.{node.name}")
        symbol.is_defined = True
    unit.scope.names[node.name] = symbol
    if is_variably_modified(ctype):
        _declare_variable(unit, node, symbol, out)
        if symbol.is_indirect:
            return
    made = _initial_value(unit, node, symbol, is_static or "constexpr" in storage)
    require_complete(symbol.type, location, node.name)
    if is_static:
        unit.objects.append(tree.ObjectDefinition(symbol, made))
    elif out is not None and max(symbol.align, symbol.type.align) > _FRAME_ALIGNMENT:
        _declare_aligned(symbol, made, out)
    elif out is not None:
        out.append(tree.Declare(location, symbol, made))
    if not is_static:
        _enter_cleanup(unit, node, symbol)


def _declare_variable(
    unit: Unit, node: Node, symbol: ObjectSymbol, out: list[tree.Statement] | None
) -> None:
    """Declare an array or a struct of variable length, or a pointer to one."""
    is_static = symbol.link_name is not None
    if vla.is_variable(symbol.type) and (is_static or node.init is not None):
        what = "be static" if is_static else "be initialized"
        kind = "array" if isinstance(symbol.type, ArrayType) else "struct"
        text = f"variable length {kind} '{node.name}' cannot {what}"
        raise CheckError(symbol.location, text)
    vla.declare(unit, symbol, symbol.type, out)


def _initial_value(
    unit: Unit, node: Node, symbol: ObjectSymbol, is_constant: bool
) -> Initialiser | None:
    """Check an initialiser, if there is one, and complete the variable's type."""
    if node.init is None:
        return None
    made, symbol.type = initialise(unit, symbol.type, node.init, is_constant)
    symbol.constant = known_value(made, symbol.type)
    symbol.is_constexpr = "constexpr" in (node.storage or [])
    return made


def _declare_aligned(
    symbol: ObjectSymbol, made: Initialiser | None, out: list[tree.Statement]
) -> None:
    """Declare an object with a stricter alignment than frames have: a pointer into a larger one."""
    ctype, location = symbol.type, symbol.location
    align = max(symbol.align, ctype.align)
    room = ObjectSymbol("", ArrayType(CHAR, ctype.size + align), location, in_memory=True)
    symbol.type, symbol.in_memory, symbol.is_indirect = PointerType(ctype), False, True
    symbol.align = 0
    out += [tree.Declare(location, room, None), tree.Declare(location, symbol, None)]
    address = convert(decay(tree.ObjectName(room.type, location, room)), UINT)
    raised = tree.Binary(UINT, location, "+", address, tree.integer(align - 1, UINT, location))
    mask = tree.integer(UINT.largest + 1 - align, UINT, location)
    rounded = convert(tree.Binary(UINT, location, "&", raised, mask), symbol.type)
    pointer = tree.ObjectName(symbol.type, location, symbol)
    out.append(_statement(tree.Assign(symbol.type, location, pointer, rounded)))
    if made is None:
        return
    if is_scalar(ctype):
        target = tree.Dereference(ctype, location, pointer)
        out.append(_statement(tree.Assign(ctype, location, target, made.values[0].value)))
        return
    initial = ObjectSymbol("", ctype, location, in_memory=True)
    source = tree.CompoundLiteral(ctype, location, initial, made)
    operands: list[Expression] = [
        convert(pointer, PointerType(VOID)),
        tree.AddressOf(PointerType(VOID), location, source),
        tree.integer(ctype.size, UINT, location),
    ]
    copy = tree.Intrinsic(PointerType(VOID), location, "__builtin_memcpy", operands)
    out.append(_statement(copy))


def _statement(expression: Expression) -> tree.Statement:
    return tree.ExpressionStatement(expression.location, expression)


def _enter_cleanup(unit: Unit, node: Node, symbol: ObjectSymbol) -> None:
    """Call the function that the attribute `cleanup` names, at the end of a variable's scope.

    Raises:
        CheckError: there is no such function.
    """
    for each in attributes(node):
        if each.name != "cleanup":
            continue
        name = each.words[0].value if each.words else ""
        function = unit.scope.find(name)
        if not isinstance(function, FunctionSymbol):
            raise CheckError(each.location, f"'{name}' is not a function, as 'cleanup' needs one")
        symbol.in_memory = symbol.in_memory or not symbol.is_indirect
        assert unit.function is not None
        unit.function.automatics.append(
            Automatic(symbol.name, symbol.location, None, _Cleanup(function, symbol))
        )


class _Cleanup:
    """The call of a function with the address of a variable."""

    def __init__(self, function: FunctionSymbol, symbol: ObjectSymbol) -> None:
        self._function = function
        self._symbol = symbol

    def __call__(self) -> Expression:
        """Return the call."""
        symbol, location = self._symbol, self._symbol.location
        variable: Expression = tree.ObjectName(symbol.type, location, symbol)
        if not symbol.is_indirect:
            variable = tree.AddressOf(PointerType(symbol.type), location, variable)
        ctype: FunctionType = self._function.type
        callee = tree.FunctionName(ctype, location, self._function)
        if ctype.parameters:
            variable = convert(variable, ctype.parameters[0])
        return tree.Call(ctype.result, location, callee, [variable])
