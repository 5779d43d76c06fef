"""Lower constants, operators without side effects, and conditions."""

from __future__ import annotations

from typing import Final

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.fold import COMPARISONS
from crs_cc.frontend.check.tree import Expression
from crs_cc.frontend.lower.convert import convert_operand, narrow
from crs_cc.frontend.lower.lowerer import (
    Lowering,
    Place,
    Rules,
    branch,
    constant,
    effect,
    place,
    statements,
    truth,
    value,
    value_into,
    value_type,
)
from crs_cc.frontend.lower.memory import copy
from crs_cc.ir.instruction import (
    Binary,
    Block,
    Branch,
    Constant,
    Jump,
    Move,
    Operand,
    Register,
    SameObject,
    Unary,
)
from crs_cc.ir.names import in_library
from crs_cc.ir.types import (
    INT,
    LLONG,
    CType,
    FloatType,
    FunctionType,
    IntegerType,
    PointerType,
    VoidType,
    is_variably_modified,
)

_INTEGER_OPERATORS: Final = {
    "+": "add", "-": "sub", "*": "mul", "&": "and", "|": "or", "^": "xor", "<<": "shl",
    "==": "eq", "!=": "ne",
}  # fmt: skip
_SIGNED_OPERATORS: Final = {
    "/": "div", "%": "rem", ">>": "shr", "<": "lt", ">": "gt", "<=": "le", ">=": "ge",
}  # fmt: skip
_FLOAT_OPERATORS: Final = {
    "+": "add", "-": "sub", "*": "mul", "/": "div", "<": "lt", ">": "gt", "<=": "le",
    ">=": "ge", "==": "eq", "!=": "ne",
}  # fmt: skip


def _operator_names() -> dict[tuple[str, str], str]:
    names = {}
    for kind in ("i32", "i64"):
        for signed in "su":
            for op, name in _INTEGER_OPERATORS.items():
                names[kind + signed, op] = f"{kind}.{name}"
            for op, name in _SIGNED_OPERATORS.items():
                names[kind + signed, op] = f"{kind}.{name}_{signed}"
    for kind in ("f32", "f64"):
        for op, name in _FLOAT_OPERATORS.items():
            names[kind, op] = f"{kind}.{name}"
    return names


_NAMES: Final = _operator_names()
_ORDERED: Final = frozenset({"<", ">", "<=", ">="})
_EXCHANGEABLE: Final = COMPARISONS | {"+", "*", "&", "|", "^"}


def operator_name(op: str, ctype: CType) -> str:
    """Return the IR operator for a C operator on operands of a promoted type."""
    if isinstance(ctype, IntegerType):
        kind = f"{ctype.memory}{'s' if ctype.signed else 'u'}"
    elif isinstance(ctype, FloatType):
        kind = ctype.memory
    else:
        kind = "i32u"
    return _NAMES[kind, op]


def _literal(_low: Lowering, expression: tree.Literal, _into: Register | None) -> Operand:
    return constant(expression.type, expression.value)


def _binary(low: Lowering, expression: tree.Binary, into: Register | None) -> Operand:
    if _is_evaluated_last(expression):
        right = value(low, expression.right)
        left = value(low, expression.left)
    else:
        left = value(low, expression.left)
        right = value(low, expression.right)
    op, location = expression.op, expression.location
    if op in {"<<", ">>"}:
        right = shift_count(low, right, expression.left.type, location)
    if op in _ORDERED:
        _relate(low, expression, left, right)
    if into is None:
        into = low.register("i32" if op in COMPARISONS else left.type)
    name = operator_name(op, expression.left.type)
    low.emit(Binary(location, into, name, left, right, is_checked(op, expression.left.type)))
    return into if op in COMPARISONS else _truncated(low, into, expression.type, location)


def _relate(
    low: Lowering,
    expression: tree.Binary | tree.PointerDifference,
    left: Operand,
    right: Operand,
) -> None:
    """Check that two pointers of a program, not of the library, are to one object."""
    ctype, location = expression.left.type, expression.location
    if not isinstance(ctype, PointerType) or isinstance(ctype.target, FunctionType):
        return
    if isinstance(left, Register) and isinstance(right, Register) and not in_library(location):
        size = 1 if is_variably_modified(ctype.target) else ctype.target.size
        is_order = isinstance(expression, tree.Binary)
        low.emit(SameObject(location, left, right, max(1, size), is_order))


def _truncated(low: Lowering, result: Register, ctype: CType, location: Location) -> Operand:
    """Truncate a result to the width of a wide bit-field's type."""
    if isinstance(ctype, IntegerType) and ctype.width is not None:
        return narrow(low, result, ctype, location, into=result)
    return result


def _is_evaluated_last(expression: tree.Binary) -> bool:
    """Return whether gcc evaluates the left operand last, which programs may rely on.

    gcc moves a variable on the left of a commutative operator to the right.
    """
    if expression.op not in _EXCHANGEABLE or isinstance(expression.right, tree.Literal):
        return False
    return _is_variable(expression.left) and not _is_variable(expression.right)


def _is_variable(operand: Expression) -> bool:
    """Return whether an operand is a variable, possibly converted to a type of the same size."""
    while isinstance(operand, tree.Convert) and _is_same_size(operand.type, operand.operand.type):
        operand = operand.operand
    return isinstance(operand, tree.ObjectName)


def _is_same_size(left: CType, right: CType) -> bool:
    is_float = isinstance(left, FloatType) or isinstance(right, FloatType)
    return left.size == right.size and not is_float


def is_checked(op: str, ctype: CType) -> bool:
    """Return whether the result of an operation may be undefined, see `ir.instruction.Binary`."""
    signed = isinstance(ctype, IntegerType) and ctype.signed
    return op in {"<<", ">>"} or (signed and op in {"+", "-", "*"})


def shift_count(low: Lowering, count: Operand, shifted: CType, location: Location) -> Operand:
    """Convert a shift count to the type of the shifted value, as WebAssembly requires."""
    wanted = value_type(shifted)
    if count.type == wanted:
        return count
    if isinstance(count, Constant):
        return constant(shifted, count.value)
    source, target = (INT, LLONG) if wanted == "i64" else (LLONG, INT)
    return convert_operand(low, count, source, target, location)


def _unary(low: Lowering, expression: tree.Unary, into: Register | None) -> Operand:
    location, op = expression.location, expression.op
    operand = value(low, expression.operand)
    if op == "!":
        return _not(low, operand, location, into)
    if into is None:
        into = low.register(operand.type)
    if operand.type in {"f32", "f64"}:
        low.emit(Unary(location, into, f"{operand.type}.neg", operand))
    elif op == "-":
        zero = Constant(operand.type, 0)
        checked = is_checked(op, expression.type)
        low.emit(Binary(location, into, f"{operand.type}.sub", zero, operand, checked))
    else:
        ones = Constant(operand.type, -1)
        low.emit(Binary(location, into, f"{operand.type}.xor", operand, ones))
    return _truncated(low, into, expression.type, location)


def _not(low: Lowering, operand: Operand, location: Location, into: Register | None) -> Operand:
    result = low.register("i32") if into is None else into
    if operand.type in {"i32", "i64"}:
        low.emit(Unary(location, result, f"{operand.type}.eqz", operand))
    else:
        zero = Constant(operand.type, 0.0)
        low.emit(Binary(location, result, f"{operand.type}.eq", operand, zero))
    return result


def _difference(
    low: Lowering, expression: tree.PointerDifference, into: Register | None
) -> Operand:
    location, size = expression.location, expression.size
    left, right = value(low, expression.left), value(low, expression.right)
    _relate(low, expression, left, right)
    if size == 1:
        return low.binary(location, "i32.sub", left, right, into)
    bytes_ = low.binary(location, "i32.sub", left, right)
    if size & (size - 1) == 0:
        shift = Constant("i32", size.bit_length() - 1)
        return low.binary(location, "i32.shr_s", bytes_, shift, into)
    return low.binary(location, "i32.div_s", bytes_, Constant("i32", size), into)


# Conditional values


def _logical(low: Lowering, expression: tree.Logical, into: Register | None) -> Operand:
    result = low.register("i32") if into is None else into
    location = expression.location
    yes, no, end = low.new_block("true"), low.new_block("false"), low.new_block("end")
    branch(low, expression, yes, no)
    low.start(yes, location)
    low.emit(Move(location, result, Constant("i32", 1)))
    low.end(Jump(location, end))
    low.start(no, location)
    low.emit(Move(location, result, Constant("i32", 0)))
    low.start(end, location)
    return result


def _conditional(low: Lowering, expression: tree.Conditional, into: Register | None) -> Operand:
    result = low.register(value_type(expression.type)) if into is None else into
    location = expression.location
    then, otherwise = low.new_block("then"), low.new_block("else")
    end = low.new_block("end")
    branch(low, expression.condition, then, otherwise)
    low.start(then, location)
    value_into(low, expression.then, result)
    low.end(Jump(location, end))
    low.start(otherwise, location)
    value_into(low, expression.otherwise, result)
    low.start(end, location)
    return result


def _conditional_effect(low: Lowering, expression: tree.Conditional) -> None:
    location = expression.location
    then, otherwise = low.new_block("then"), low.new_block("else")
    end = low.new_block("end")
    branch(low, expression.condition, then, otherwise)
    low.start(then, location)
    effect(low, expression.then)
    low.end(Jump(location, end))
    low.start(otherwise, location)
    effect(low, expression.otherwise)
    low.start(end, location)


def _conditional_place(low: Lowering, expression: tree.Conditional) -> Place:
    result = low.register("i32")
    location = expression.location
    then, otherwise = low.new_block("then"), low.new_block("else")
    end = low.new_block("end")
    branch(low, expression.condition, then, otherwise)
    low.start(then, location)
    low.move(result, low.address(place(low, expression.then), location, result), location)
    low.end(Jump(location, end))
    low.start(otherwise, location)
    low.move(result, low.address(place(low, expression.otherwise), location, result), location)
    low.start(end, location)
    return result, 0


def _logical_effect(low: Lowering, expression: tree.Logical) -> None:
    location = expression.location
    right, end = low.new_block("right"), low.new_block("end")
    if expression.op == "&&":
        branch(low, expression.left, right, end)
    else:
        branch(low, expression.left, end, right)
    low.start(right, location)
    effect(low, expression.right)
    low.start(end, location)


def _comma(low: Lowering, expression: tree.Comma, into: Register | None) -> Operand:
    effect(low, expression.first)
    return value(low, expression.second, into)


def _comma_effect(low: Lowering, expression: tree.Comma) -> None:
    effect(low, expression.first)
    effect(low, expression.second)


def _comma_place(low: Lowering, expression: tree.Comma) -> Place:
    effect(low, expression.first)
    return place(low, expression.second)


# Statement expressions


def _statements_value(
    low: Lowering, expression: tree.StatementExpression, into: Register | None
) -> Operand:
    with low.inner_statements():
        statements(low, expression.body)
    assert expression.value is not None
    return value(low, expression.value, into)


def _statements_effect(low: Lowering, expression: tree.StatementExpression) -> None:
    with low.inner_statements():
        statements(low, expression.body)
    if expression.value is not None:
        effect(low, expression.value)


def _statements_place(low: Lowering, expression: tree.StatementExpression) -> Place:
    with low.inner_statements():
        statements(low, expression.body)
    assert expression.value is not None
    made = low.slot("value", expression.type)
    location = expression.location
    copy(low, (made, 0), place(low, expression.value), expression.type.size, location)
    return made, 0


# Conditions


def _branch_literal(low: Lowering, expression: tree.Literal, then: Block, otherwise: Block) -> None:
    low.end(Jump(expression.location, then if expression.value != 0 else otherwise))


def _branch_logical(low: Lowering, expression: tree.Logical, then: Block, otherwise: Block) -> None:
    right = low.new_block("and" if expression.op == "&&" else "or")
    if expression.op == "&&":
        branch(low, expression.left, right, otherwise)
    else:
        branch(low, expression.left, then, right)
    low.start(right, expression.right.location)
    branch(low, expression.right, then, otherwise)


def _branch_unary(low: Lowering, expression: tree.Unary, then: Block, otherwise: Block) -> None:
    if expression.op == "!":
        branch(low, expression.operand, otherwise, then)
    else:
        low.end(Branch(expression.location, truth(low, expression), then, otherwise))


def _branch_binary(low: Lowering, expression: tree.Binary, then: Block, otherwise: Block) -> None:
    """Branch on a comparison; one with zero is left out where the operand can be tested itself."""
    test: Expression = expression
    if expression.op in {"==", "!="} and isinstance(expression.right, tree.Literal):
        is_plain = isinstance(expression.left.type, IntegerType | PointerType)
        if expression.right.value == 0 and is_plain and value_type(expression.left.type) == "i32":
            test = expression.left
            if expression.op == "==":
                then, otherwise = otherwise, then
            branch(low, test, then, otherwise)
            return
    low.end(Branch(expression.location, truth(low, test), then, otherwise))


def _branch_convert(low: Lowering, expression: tree.Convert, then: Block, otherwise: Block) -> None:
    """Ignore conversions that map zero, and only zero, to zero."""
    source, target = expression.operand.type, expression.type
    keeps = not isinstance(source, FloatType) and source.size <= target.size
    if keeps and not isinstance(target, VoidType):
        branch(low, expression.operand, then, otherwise)
    else:
        low.end(Branch(expression.location, truth(low, expression), then, otherwise))


def _branch_conditional(
    low: Lowering, expression: tree.Conditional, then: Block, otherwise: Block
) -> None:
    yes, no = low.new_block("then"), low.new_block("else")
    branch(low, expression.condition, yes, no)
    low.start(yes, expression.location)
    branch(low, expression.then, then, otherwise)
    low.start(no, expression.location)
    branch(low, expression.otherwise, then, otherwise)


def _branch_comma(low: Lowering, expression: tree.Comma, then: Block, otherwise: Block) -> None:
    effect(low, expression.first)
    branch(low, expression.second, then, otherwise)


def _nothing(_low: Lowering, _expression: Expression) -> None:
    """Emit nothing: the expression has no effect."""


RULES: Final = Rules(
    value={
        tree.Literal: _literal,
        tree.Binary: _binary,
        tree.Unary: _unary,
        tree.PointerDifference: _difference,
        tree.Logical: _logical,
        tree.Conditional: _conditional,
        tree.Comma: _comma,
        tree.StatementExpression: _statements_value,
    },
    effect={
        tree.Literal: _nothing,
        tree.StringLiteral: _nothing,
        tree.ObjectName: _nothing,
        tree.FunctionName: _nothing,
        tree.Logical: _logical_effect,
        tree.Conditional: _conditional_effect,
        tree.Comma: _comma_effect,
        tree.StatementExpression: _statements_effect,
    },
    place={
        tree.Conditional: _conditional_place,
        tree.Comma: _comma_place,
        tree.StatementExpression: _statements_place,
    },
    branch={
        tree.Literal: _branch_literal,
        tree.Logical: _branch_logical,
        tree.Unary: _branch_unary,
        tree.Binary: _branch_binary,
        tree.Convert: _branch_convert,
        tree.Conditional: _branch_conditional,
        tree.Comma: _branch_comma,
    },
)
