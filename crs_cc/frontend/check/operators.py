"""Check the operators (C17 6.5.3 to 6.5.16)."""

from __future__ import annotations

from collections.abc import Callable
from typing import Final

from pycparser import c_ast

from crs_cc.core.source import Location
from crs_cc.frontend.check import complex_numbers, fold, tree, variable_record, vla
from crs_cc.frontend.check.checker import CheckError, Unit, checks, expression
from crs_cc.frontend.check.complex_numbers import Arithmetic, truth
from crs_cc.frontend.check.conversion import (
    assigned,
    common_base,
    convert,
    decay,
    is_arithmetic,
    is_integer,
    is_null_constant,
    is_number,
    is_scalar,
    promote,
    usual_arithmetic_conversions,
)
from crs_cc.frontend.check.expressions import rvalue, size_of
from crs_cc.frontend.check.lost_value_warnings import is_inexact, warn_divisions, warn_overflow
from crs_cc.frontend.check.suspicious_operands import warn_signs, warn_string
from crs_cc.frontend.check.tree import Expression
from crs_cc.frontend.check.type_compat import compatible
from crs_cc.frontend.parse.nodes import Node
from crs_cc.ir.types import (
    CHAR,
    INT,
    NULLPTR,
    VOID,
    ArrayType,
    CType,
    FunctionType,
    PointerType,
    RecordType,
    VoidType,
    is_complete,
    is_complex,
    unqualified,
)


def _invalid(left: Expression, right: Expression, location: Location) -> CheckError:
    text = f"invalid operands to binary expression ('{left.type}' and '{right.type}')"
    return CheckError(location, text)


# Binary operators


@checks(c_ast.BinaryOp)
def binary(unit: Unit, node: Node) -> Expression:
    """Check `left op right`."""
    left = decay(expression(unit, node.left))
    right = decay(expression(unit, node.right))
    return operate(unit, node.op, left, right, unit.at(node))


def operate(
    unit: Unit, op: str, left: Expression, right: Expression, location: Location
) -> Expression:
    """Return `left op right` for two values."""
    if op in {"&&", "||"}:
        return _logical(op, truth(left), truth(right), location)
    if is_complex(left.type) or is_complex(right.type):
        return _complex(unit, op, left, right, location)
    if op in fold.COMPARISONS:
        return _comparison(unit, op, left, right, location)
    if op in {"+", "-"} and (
        isinstance(left.type, PointerType) or isinstance(right.type, PointerType)
    ):
        return _pointer_arithmetic(op, left, right, location)
    if op in {"<<", ">>"}:
        return _shift(unit, op, left, right, location)
    allowed = is_integer if op in {"%", "&", "|", "^"} else is_arithmetic
    if not allowed(left.type) or not allowed(right.type):
        raise _invalid(left, right, location)
    warn_divisions(unit, left, right)
    left, right = usual_arithmetic_conversions(left, right)
    return _folded(unit, op, left.type, (left, right), location)


def _complex(
    unit: Unit, op: str, left: Expression, right: Expression, location: Location
) -> Expression:
    """Return an operation on numbers, at least one of them complex."""
    if not is_number(left.type) or not is_number(right.type):
        raise _invalid(left, right, location)

    operands, base = (left, right), common_base(left, right)
    return complex_numbers.binary(op, operands, base, location, _arithmetic(unit, location))


def _arithmetic(unit: Unit, location: Location) -> Arithmetic:
    """Return how the parts of complex numbers are computed with at some location."""
    return Arithmetic(
        lambda op, left, right: operate(unit, op, left, right, location),
        convert,
        lambda value: _negated(value, location),
    )


def _folded(
    unit: Unit, op: str, ctype: CType, operands: tuple[Expression, Expression], location: Location
) -> Expression:
    """Return an operation on converted operands, folded if they are constant."""
    left, right = operands
    if isinstance(right, tree.Literal):
        if isinstance(left, tree.Literal):
            value = fold.binary(op, left.type, left.value, right.value)
            if value is not None:
                warn_overflow(unit, op, left, right, location)
                return tree.Literal(ctype, location, value, is_inexact(op, left, right))
        if op in {"/", "%"} and right.value == 0 and is_integer(right.type):
            unit.warning(location, "division by zero is undefined", flag="div-by-zero")
    return tree.Binary(ctype, location, op, left, right)


def _shift(
    unit: Unit, op: str, left: Expression, right: Expression, location: Location
) -> Expression:
    if not is_integer(left.type) or not is_integer(right.type):
        raise _invalid(left, right, location)
    left, right = promote(left), promote(right)
    if isinstance(right, tree.Literal) and not 0 <= right.value < 8 * left.type.size:
        what = "negative" if right.value < 0 else ">= width of type"
        unit.warning(right.location, f"shift count is {what}", flag="shift-count-overflow")
    return _folded(unit, op, left.type, (left, right), location)


def _logical(op: str, left: Expression, right: Expression, location: Location) -> Expression:
    if not is_scalar(left.type) or not is_scalar(right.type):
        raise _invalid(left, right, location)
    if isinstance(left, tree.Literal):
        if bool(left.value) == (op == "||"):
            return tree.integer(int(op == "||"), INT, location)
        if isinstance(right, tree.Literal):
            return tree.integer(int(right.value != 0), INT, location)
    return tree.Logical(INT, location, op, left, right)


def _comparison(
    unit: Unit, op: str, left: Expression, right: Expression, location: Location
) -> Expression:
    if is_arithmetic(left.type) and is_arithmetic(right.type):
        if op not in {"==", "!="}:
            warn_signs(unit, left, right, location)
        warn_divisions(unit, left, right)
        left, right = usual_arithmetic_conversions(left, right)
        return _folded(unit, op, INT, (left, right), location)
    warn_string(unit, left, right, location)
    if not is_scalar(left.type) or not is_scalar(right.type):
        raise _invalid(left, right, location)
    _compare_pointers(unit, left, right, location)
    if not isinstance(left.type, PointerType):
        left = convert(left, right.type)
    elif not isinstance(right.type, PointerType):
        right = convert(right, left.type)
    return _folded(unit, op, INT, (left, right), location)


def _compare_pointers(unit: Unit, left: Expression, right: Expression, location: Location) -> None:
    if is_null_constant(left) or is_null_constant(right):
        return
    if isinstance(left.type, PointerType) and isinstance(right.type, PointerType):
        a, b = unqualified(left.type.target), unqualified(right.type.target)
        if not {VOID, NULLPTR.target} & {a, b} and not compatible(a, b):
            text = f"comparison of distinct pointer types ('{left.type}' and '{right.type}')"
            unit.warning(location, text, flag="distinct-pointer-types")
        return
    if not is_integer(left.type) and not is_integer(right.type):
        raise _invalid(left, right, location)
    text = f"comparison between pointer and integer ('{left.type}' and '{right.type}')"
    unit.warning(location, text, flag="pointer-integer-compare")


def _pointer_arithmetic(
    op: str, left: Expression, right: Expression, location: Location
) -> Expression:
    if isinstance(left.type, PointerType) and isinstance(right.type, PointerType):
        return _difference(op, left, right, location)
    if op == "+" and isinstance(right.type, PointerType):
        return _moved(right, left, op, location)
    return _moved(left, right, op, location)


def _moved(pointer: Expression, index: Expression, op: str, location: Location) -> Expression:
    if not isinstance(pointer.type, PointerType) or not is_integer(index.type):
        raise _invalid(pointer, index, location)
    _need_size(pointer, pointer.type)
    index = convert(promote(index), INT)
    return vla.moved(pointer, index, op == "-", location)


def _need_size(pointer: Expression, ctype: PointerType) -> None:
    target = ctype.target
    if not is_complete(target) and not isinstance(target, VoidType | FunctionType):
        raise CheckError(pointer.location, f"arithmetic on a pointer to incomplete type '{target}'")


def _difference(op: str, left: Expression, right: Expression, location: Location) -> Expression:
    assert isinstance(left.type, PointerType)
    assert isinstance(right.type, PointerType)
    same = compatible(unqualified(left.type.target), unqualified(right.type.target))
    if op != "-" or not same:
        raise _invalid(left, right, location)
    _need_size(left, left.type)
    return vla.difference(left, right, location)


@checks(c_ast.ArrayRef)
def index(unit: Unit, node: Node) -> Expression:
    """Check `array[index]`, which is `*(array + index)` (C17 6.5.2.1)."""
    array = decay(expression(unit, node.name))
    subscript = decay(expression(unit, node.subscript))
    if not isinstance(array.type, PointerType) and isinstance(subscript.type, PointerType):
        array, subscript = subscript, array
    if not isinstance(array.type, PointerType):
        raise CheckError(array.location, "subscripted value is not an array or pointer")
    if not is_integer(subscript.type):
        raise CheckError(
            subscript.location, f"array subscript is not an integer ('{subscript.type}')"
        )
    if isinstance(array.type.target, FunctionType):
        raise CheckError(array.location, "subscript of pointer to function type")
    moved = _moved(array, subscript, "+", array.location)
    return tree.Dereference(array.type.target, array.location, moved)


# Unary operators


@checks(c_ast.UnaryOp)
def unary(unit: Unit, node: Node) -> Expression:
    """Check the operators with one operand."""
    return _UNARY[node.op](unit, node)


def _sign(unit: Unit, node: Node) -> Expression:
    operand, place = rvalue(unit, node.expr), unit.at(node)
    if is_complex(operand.type):
        return complex_numbers.negated(node.op, operand, _arithmetic(unit, place))
    if not is_arithmetic(operand.type) or (node.op == "~" and not is_integer(operand.type)):
        text = f"invalid argument type '{operand.type}' to unary expression"
        raise CheckError(place, text)
    operand = promote(operand)
    return operand if node.op == "+" else _negated(operand, place, node.op)


def _negated(operand: Expression, location: Location, op: str = "-") -> Expression:
    """Return `-x` or `~x`, computed if it is constant."""
    operand = promote(operand)
    if isinstance(operand, tree.Literal):
        value = fold.unary(op, operand.type, operand.value)
        if value is not None:
            return tree.Literal(operand.type, location, value)
    return tree.Unary(operand.type, location, op, operand)


def _not(unit: Unit, node: Node) -> Expression:
    operand, place = truth(rvalue(unit, node.expr)), unit.at(node)
    if not is_scalar(operand.type):
        text = f"invalid argument type '{operand.type}' to unary expression"
        raise CheckError(place, text)
    if isinstance(operand, tree.Literal):
        return tree.integer(int(operand.value == 0), INT, place)
    return tree.Unary(INT, place, "!", operand)


def _part(unit: Unit, node: Node) -> Expression:
    """Check GNU's `__real__` and `__imag__`, which are lvalues if their operand is one."""
    operand, index = expression(unit, node.expr), ["__real", "__imag"].index(node.op)
    if is_complex(operand.type):
        return complex_numbers.part(operand, index)
    operand = decay(operand)
    if not is_arithmetic(operand.type):
        text = f"invalid argument type '{operand.type}' to unary expression"
        raise CheckError(unit.at(node), text)
    return operand if index == 0 else convert(tree.integer(0, INT, operand.location), operand.type)


def _dereference(unit: Unit, node: Node) -> Expression:
    operand, place = rvalue(unit, node.expr), unit.at(node)
    if not isinstance(operand.type, PointerType):
        text = f"indirection requires pointer operand ('{operand.type}' invalid)"
        raise CheckError(place, text)
    return tree.Dereference(operand.type.target, place, operand)


def _address(unit: Unit, node: Node) -> Expression:
    operand, place = expression(unit, node.expr), unit.at(node)
    if isinstance(operand, tree.Dereference):
        return convert(operand.pointer, PointerType(operand.type))
    if not is_lvalue(operand) and not isinstance(operand, tree.FunctionName):
        text = f"cannot take the address of an rvalue of type '{operand.type}'"
        raise CheckError(place, text)
    if isinstance(operand, tree.MemberAccess) and operand.member.bit_width is not None:
        raise CheckError(place, f"address of bit-field '{operand.member.name}' requested")
    if isinstance(operand, tree.ObjectName):
        operand.symbol.in_memory = True
    return tree.AddressOf(PointerType(operand.type), place, operand)


def _increment(unit: Unit, node: Node) -> Expression:
    target = modifiable(expression(unit, node.expr))
    place = unit.at(node)
    ctype = target.type
    if is_complex(ctype):
        return _complex_step(unit, node, target)
    if isinstance(ctype, PointerType):
        _need_size(target, ctype)
    elif not is_arithmetic(ctype):
        what = "increment" if node.op[-1] == "+" else "decrement"
        raise CheckError(place, f"cannot {what} value of type '{ctype}'")
    step = 1 if node.op[-1] == "+" else -1
    is_postfix = node.op[0] == "p"
    if isinstance(ctype, PointerType) and vla.is_variable(ctype.target):
        return vla.step(target, step, is_postfix=is_postfix)
    return tree.Increment(unqualified(ctype), place, target, step, is_postfix)


def _complex_step(unit: Unit, node: Node, target: Expression) -> Expression:
    """Return `++` or `--` of a complex number."""
    place, one = unit.at(node), tree.integer(1, INT, unit.at(node))
    changed = _compound(unit, node.op[-1], target, one, place)
    if node.op[0] != "p":
        return changed
    return operate(unit, "-" if node.op[-1] == "+" else "+", changed, one, place)


_NOT_ASSIGNABLE: Final = "array type '{}' is not assignable"
_UNARY: Final[dict[str, Callable[[Unit, Node], Expression]]] = {
    "+": _sign, "-": _sign, "~": _sign, "!": _not, "*": _dereference, "&": _address,
    "++": _increment, "--": _increment, "p++": _increment, "p--": _increment,
    "__real": _part, "__imag": _part, "sizeof": size_of, "_Alignof": size_of,
}  # fmt: skip


# Assignment


def is_lvalue(value: Expression) -> bool:
    """Return whether an expression is an lvalue (C17 6.3.2.1p1)."""
    match value:
        case tree.ObjectName() | tree.Dereference() | tree.StringLiteral() | tree.CompoundLiteral():
            return not isinstance(value.type, FunctionType)
        case tree.MemberAccess(record=record):
            return is_lvalue(record)
    return False


def modifiable(target: Expression) -> Expression:
    """Check that an expression is a modifiable lvalue; raise CheckError if it is not."""
    ctype = target.type
    if not is_lvalue(target):
        raise CheckError(target.location, "expression is not assignable")
    if isinstance(ctype, ArrayType):
        raise CheckError(target.location, _NOT_ASSIGNABLE.format(ctype))
    if isinstance(ctype, VoidType) or not is_complete(ctype):
        raise CheckError(target.location, f"incomplete type '{ctype}' is not assignable")
    if ctype.const:
        raise CheckError(target.location, _read_only(target))
    if isinstance(ctype, RecordType) and _has_const_member(ctype):
        raise CheckError(target.location, f"cannot assign to '{ctype}' with a const member")
    return target


def _read_only(target: Expression) -> str:
    what = "read-only location"
    if isinstance(target, tree.ObjectName):
        what = f"variable '{target.symbol.name}'"
    elif isinstance(target, tree.MemberAccess):
        what = f"member '{target.member.name}'"
    return f"cannot assign to {what} with const-qualified type '{target.type}'"


def _has_const_member(ctype: RecordType) -> bool:
    return any(
        each.type.const or (isinstance(each.type, RecordType) and _has_const_member(each.type))
        for each in ctype.record.members or []
    )


@checks(c_ast.Assignment)
def assignment(unit: Unit, node: Node) -> Expression:
    """Check `target = value` and `target op= value`."""
    target = expression(unit, node.lvalue)
    value = decay(expression(unit, node.rvalue))
    if node.op == "=" and isinstance(target.type, ArrayType):
        hint = _copying(target) if isinstance(value.type, PointerType) else ""
        raise CheckError(target.location, _NOT_ASSIGNABLE.format(target.type), hint)
    target = modifiable(target)
    place = unit.at(node)
    if node.op == "=":
        value = assigned(unit, value, target.type, "assign")
        if vla.is_variable(target.type):
            return variable_record.copy(target, value, place)
        return tree.Assign(unqualified(target.type), place, target, value)
    return _compound(unit, node.op[:-1], target, value, place)


def _copying(target: Expression) -> str:
    """Return a hint at how to copy an array."""
    assert isinstance(target.type, ArrayType)
    if target.type.element.size != 1:
        return "copy its elements one by one, or all with memcpy"
    if isinstance(target, tree.ObjectName):
        return f"copy the text into it: strcpy({target.symbol.name}, ...)"
    return "copy the text into it, with strcpy"


def _compound(
    unit: Unit, op: str, target: Expression, value: Expression, location: Location
) -> Expression:
    ctype = unqualified(target.type)
    if isinstance(ctype, PointerType):
        if op not in {"+", "-"} or not is_integer(value.type):
            raise _invalid(target, value, location)
        _need_size(target, ctype)
        index_ = convert(promote(value), INT)
        if vla.is_variable(ctype.target):
            index_, computed = vla.scaled(index_, ctype.target), PointerType(CHAR)
            return tree.CompoundAssign(ctype, location, op, target, index_, computed)
        return tree.CompoundAssign(ctype, location, op, target, index_, ctype)
    if is_complex(ctype) or is_complex(value.type):
        return complex_numbers.assignment(
            target, lambda old: convert(operate(unit, op, decay(old), value, location), ctype)
        )
    made = operate(unit, op, decay(target), value, location)
    if not isinstance(made, tree.Binary):
        raise _invalid(target, value, location)
    return tree.CompoundAssign(ctype, location, op, target, made.right, made.left.type)
