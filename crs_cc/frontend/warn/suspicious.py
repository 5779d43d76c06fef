"""Warnings about valid code that is probably a mistake, in functions without errors.

These are unused values and constant indices outside their array; those that need control flow are
in `flow`.
"""

from __future__ import annotations

import re
from typing import Any, Final

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.checker import Unit
from crs_cc.frontend.check.fold import COMPARISONS
from crs_cc.frontend.check.tree_parts import walk
from crs_cc.frontend.warn.flow import warn_paths
from crs_cc.frontend.warn.robot_state import warn_state
from crs_cc.frontend.warn.sequence import warn_order
from crs_cc.frontend.warn.unavailable import warn_unavailable
from crs_cc.frontend.warn.unused import warn_unused_names
from crs_cc.ir.types import ArrayType, VoidType

_PURE: Final = frozenset({
    "abs", "acos", "asin", "atan", "atan2", "atof", "atoi", "atol", "ceil", "cos", "exp", "fabs",
    "feof", "ferror", "floor", "fmod", "getenv", "hypot", "isalnum", "isalpha", "isdigit",
    "islower", "ispunct", "isspace", "isupper", "isxdigit", "labs", "llabs", "log", "log10",
    "memchr", "memcmp", "pow", "rint", "round", "sin", "sqrt", "strcasecmp", "strchr", "strcmp",
    "strcspn", "strlen", "strncasecmp", "strncmp", "strpbrk", "strrchr", "strspn", "strstr", "tan",
    "tolower", "toupper", "trunc",
})  # fmt: skip
"""Library functions without side effects."""

_EFFECTS: Final = (
    tree.Assign, tree.CompoundAssign, tree.Increment, tree.Call, tree.Intrinsic, tree.VarArg,
    tree.StatementExpression,
)  # fmt: skip
_VALUES: Final = (
    tree.Binary, tree.Unary, tree.PointerAdd, tree.PointerDifference, tree.ObjectName,
    tree.FunctionName, tree.Dereference, tree.MemberAccess, tree.AddressOf,
)  # fmt: skip


def warn_unit(unit: Unit) -> None:
    """Check every function of a file."""
    nodes = [list(walk(function.body)) for function in unit.functions]
    warn_unused_names(unit, nodes)
    warn_state(unit)
    warn_unavailable(unit, nodes)
    for function, its_nodes in zip(unit.functions, nodes, strict=True):
        for node in its_nodes:
            if isinstance(node, tree.Expression):
                _warn_expression(unit, node)
            else:
                _warn_statement(unit, node)
        warn_paths(unit, function)


def _warn_expression(unit: Unit, node: tree.Expression) -> None:
    if isinstance(node, tree.Dereference):
        _warn_index(unit, node)
    elif isinstance(node, tree.Comma):
        _warn_unused(unit, node.first)


def _warn_statement(unit: Unit, node: Any) -> None:
    for each in _full_expressions(node):
        warn_order(unit, each)
    if isinstance(node, tree.ExpressionStatement):
        _warn_unused(unit, node.expression)
    elif isinstance(node, tree.Loop) and node.step is not None:
        _warn_unused(unit, node.step)


def _full_expressions(node: Any) -> list[tree.Expression]:
    """Return the full expressions of a statement, but for those of inner statements."""
    match node:
        case tree.ExpressionStatement(expression=value) | tree.Switch(value=value):
            return [value]
        case tree.If(condition=value):
            return [value]
        case tree.Loop(condition=condition, step=step):
            return [each for each in (condition, step) if each is not None]
        case tree.Return(value=value) if value is not None:
            return [value]
        case tree.Declare(initialiser=tree.Initialiser(values=values)):
            return [each.value for each in values]
    return []


def _warn_unused(unit: Unit, value: tree.Expression) -> None:
    """Warn about a value that is dropped, if there was no reason to compute it but the value."""
    if isinstance(value, tree.Call):
        _warn_call(unit, value)
        return
    if not isinstance(value, _VALUES) or isinstance(value.type, VoidType) or _is_volatile(value):
        return
    if isinstance(value, tree.FunctionName):
        name = value.symbol.name
        unit.warning(
            value.location, f"'{name}' is not called here", f"write '{name}()'", flag="unused-value"
        )
    elif isinstance(value, tree.Binary) and value.op in COMPARISONS:
        hint = "write '=' to assign" if value.op == "==" else ""
        unit.warning(value.location, f"result of '{value.op}' unused", hint, flag="unused-value")
    elif not any(map(_has_effect, walk([value]))) and not _is_macro(unit, value.location):
        unit.warning(value.location, "expression result unused", flag="unused-value")


def _has_effect(value: tree.Expression) -> bool:
    return isinstance(value, _EFFECTS)


def _is_macro(unit: Unit, location: Location) -> bool:
    """Return whether there is a name in capitals at a location: probably a macro without effect."""
    line = unit.diagnostics.lines.get(location.file, [])[location.line - 1 : location.line]
    return bool(line) and re.match(r"[A-Z][A-Z0-9_]+\b", line[0][location.column - 1 :]) is not None


def _warn_call(unit: Unit, call: tree.Call) -> None:
    """Warn about the unused result of a function without side effects."""
    if isinstance(call.callee, tree.FunctionName) and not isinstance(call.type, VoidType):
        symbol = call.callee.symbol
        if symbol.is_external and symbol.name in _PURE:
            text = f"ignoring return value of '{symbol.name}', which has no side effects"
            unit.warning(call.location, text, flag="unused-value")


def _is_volatile(value: tree.Expression) -> bool:
    """Return whether to read an expression is an effect; reading drops its type's qualifiers."""
    return any(
        (isinstance(each, tree.ObjectName) and each.symbol.type.volatile)
        or (isinstance(each, tree.Dereference | tree.MemberAccess) and _points_to_volatile(each))
        for each in walk([value])
    )  # fmt: skip


def _points_to_volatile(value: Any) -> bool:
    if isinstance(value, tree.MemberAccess):
        return bool(value.member.type.volatile)
    target = getattr(value.pointer.type, "target", None)
    return target is not None and bool(target.volatile)


def _warn_index(unit: Unit, access: tree.Dereference) -> None:
    """Warn about a constant index that the array does not have."""
    match access.pointer:
        case tree.PointerAdd(
            pointer=tree.AddressOf(operand=array), index=tree.Literal(value=index), minus=minus
        ) if isinstance(array.type, ArrayType):
            number = -int(index) if minus else int(index)
            length = array.type.length
            is_tail = isinstance(array, tree.MemberAccess) and (length or 0) <= 1
            if length is None or is_tail or 0 <= number < length:
                return
            if number == length and isinstance(access.type, ArrayType):
                return  # the address of the end is valid
            text = f"array index {number} is outside the bounds of '{array.type}'"
            hint = f"valid indices are 0 to {length - 1}" if length else ""
            unit.warning(access.location, text, hint, flag="array-bounds")
