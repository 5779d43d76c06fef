"""Check the conditional operator (C17 6.5.15), and gcc's `condition ?: otherwise`."""

from __future__ import annotations

from pycparser import c_ast

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree, variable_record, vla
from crs_cc.frontend.check.checker import CheckError, Unit, checks
from crs_cc.frontend.check.complex_numbers import truth
from crs_cc.frontend.check.conversion import (
    convert,
    is_arithmetic,
    is_integer,
    is_null_constant,
    is_number,
    is_scalar,
    usual_arithmetic_conversions,
)
from crs_cc.frontend.check.expressions import rvalue
from crs_cc.frontend.check.operators import is_lvalue
from crs_cc.frontend.check.scope import ObjectSymbol
from crs_cc.frontend.check.tree import Expression
from crs_cc.frontend.check.type_compat import compatible, composite
from crs_cc.frontend.parse.nodes import Node
from crs_cc.ir.types import VOID, CType, PointerType, RecordType, qualify, unqualified


@checks(c_ast.TernaryOp)
def conditional(unit: Unit, node: Node) -> Expression:
    """Check `condition ? then : otherwise` (C17 6.5.15), and gcc's `condition ?: otherwise`."""
    condition = rvalue(unit, node.cond)
    if node.iftrue is not None:
        condition = truth(condition)
    if not is_scalar(condition.type):
        text = f"used type '{condition.type}' where arithmetic or pointer type is required"
        raise CheckError(condition.location, text)
    if node.iftrue is None:
        symbol = ObjectSymbol("", condition.type, condition.location)
        then: Expression = tree.ObjectName(condition.type, condition.location, symbol)
        condition = tree.Assign(then.type, then.location, then, condition)
    else:
        then = rvalue(unit, node.iftrue)
    otherwise = rvalue(unit, node.iffalse)
    if is_number(then.type) and is_number(otherwise.type):
        then, otherwise = usual_arithmetic_conversions(then, otherwise)
    ctype = _conditional_type(unit, then, otherwise)
    if vla.is_variable(ctype):
        return variable_record.choice(condition, then, otherwise)
    if ctype != VOID:
        then, otherwise = convert(then, ctype), convert(otherwise, ctype)
    if isinstance(condition, tree.Literal):
        chosen = then if condition.value else otherwise
        if is_lvalue(chosen) and is_scalar(ctype):
            return tree.Convert(ctype, chosen.location, chosen)  # not an lvalue any more
        return chosen
    return tree.Conditional(ctype, unit.at(node), condition, then, otherwise)


def _conditional_type(unit: Unit, then: Expression, otherwise: Expression) -> CType:
    left, right = then.type, otherwise.type
    if is_arithmetic(left) and is_arithmetic(right):
        return left
    if VOID in (left, right):
        return VOID
    if isinstance(left, PointerType) or isinstance(right, PointerType):
        return _conditional_pointer(unit, then, otherwise)
    if left == right and isinstance(left, RecordType):
        return left
    text = f"incompatible operand types ('{left}' and '{right}')"
    raise CheckError(then.location, text)


def _conditional_pointer(unit: Unit, then: Expression, otherwise: Expression) -> CType:
    left, right = then.type, otherwise.type
    if is_null_constant(otherwise) and isinstance(left, PointerType):
        return left
    if is_null_constant(then) and isinstance(right, PointerType):
        return right
    if not isinstance(left, PointerType) or not isinstance(right, PointerType):
        if not is_integer(left) and not is_integer(right):
            text = f"incompatible operand types ('{left}' and '{right}')"
            raise CheckError(then.location, text)
        text = f"pointer/integer type mismatch in conditional expression ('{left}' and '{right}')"
        unit.warning(then.location, text, flag="pointer-type-mismatch")
        return left if isinstance(left, PointerType) else right
    return PointerType(_common_target(unit, left, right, then.location))


def _common_target(unit: Unit, left: PointerType, right: PointerType, location: Location) -> CType:
    """Return the target type of a conditional expression of pointers (C17 6.5.15p6)."""
    a, b = left.target, right.target
    const, volatile = a.const or b.const, a.volatile or b.volatile
    plain_a, plain_b = unqualified(a), unqualified(b)
    if VOID in (plain_a, plain_b):
        return qualify(VOID, const, volatile)
    if compatible(plain_a, plain_b):
        return qualify(composite(plain_a, plain_b), const, volatile)
    text = f"pointer type mismatch in conditional expression ('{left}' and '{right}')"
    unit.warning(location, text, flag="pointer-type-mismatch")
    return qualify(VOID, const, volatile)
