"""Complex numbers (C17 6.2.5p11, 6.3.1.6 to 6.3.1.8, annex G).

A complex number is a struct of its real and its imaginary part, see `ir.types.COMPLEX`. Arithmetic
becomes arithmetic of the parts and a compound literal of the results; a real operand has no
imaginary part, which is not the same as one of zero. Constants are folded with their parts.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, TypeAlias

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.check.checker import CheckError
from crs_cc.frontend.check.scope import FunctionSymbol, ObjectSymbol
from crs_cc.frontend.check.tree import Expression, Initialiser, InitialValue
from crs_cc.ir.types import (
    BOOL,
    COMPLEX,
    DOUBLE,
    FLOAT,
    INT,
    CType,
    FloatType,
    FunctionType,
    IntegerType,
    PointerType,
    RecordType,
    is_complex,
    unqualified,
)

Convert: TypeAlias = Callable[[Expression, CType], Expression]
Operate: TypeAlias = Callable[[str, Expression, Expression], Expression]

_PRODUCTS: Final = {"*": "mul", "/": "div"}


@dataclass(frozen=True, slots=True)
class Arithmetic:
    """How real numbers are computed with: `operate(op, left, right)`, `convert(value, type)`."""

    operate: Operate
    convert: Convert


@dataclass(slots=True)
class Parts:
    """The parts of a number.

    Attributes:
        effects: what must be evaluated before them.
        base: the type of both parts; that of a real number.
        real: the real part.
        imaginary: the imaginary part; None for a real number.
    """

    effects: list[Expression]
    base: CType
    real: Expression
    imaginary: Expression | None = None


def base_of(ctype: CType) -> FloatType:
    """Return the type of the parts of a complex type."""
    assert isinstance(ctype, RecordType)
    assert ctype.record.members is not None
    base = ctype.record.members[0].type
    assert isinstance(base, FloatType)
    return base


def build(base: CType, real: Expression, imaginary: Expression, location: Location) -> Expression:
    """Return a complex number of two parts of its base type."""
    assert isinstance(base, FloatType)
    ctype = COMPLEX[base.name]
    values = [InitialValue(0, base, real), InitialValue(base.size, base, imaginary)]
    symbol = ObjectSymbol("", ctype, location, in_memory=True)
    return tree.CompoundLiteral(ctype, location, symbol, Initialiser(values, is_braced=True))


def part(value: Expression, index: int) -> Expression:
    """Return the real (0) or imaginary (1) part of a complex object."""
    ctype = value.type
    assert isinstance(ctype, RecordType)
    assert ctype.record.members is not None
    member = ctype.record.members[index]
    return tree.MemberAccess(member.type, value.location, value, member)


def parts(value: Expression) -> Parts:
    """Return the parts of a number, which is evaluated once."""
    location = value.location
    if not is_complex(value.type):
        if isinstance(value, tree.Literal):
            return Parts([], value.type, value)
        keep, name = _kept(value)
        return Parts([keep], value.type, name)
    base = base_of(value.type)
    if isinstance(value, tree.CompoundLiteral) and _is_constant(value):
        real, imaginary = (each.value for each in value.initialiser.values)
        return Parts([], base, real, imaginary)
    effects: list[Expression] = []
    if not isinstance(value, tree.ObjectName):
        keep, value = _kept(value)
        effects.append(keep)
    value.location = location
    return Parts(effects, base, part(value, 0), part(value, 1))


def _is_constant(literal: tree.CompoundLiteral) -> bool:
    return all(isinstance(each.value, tree.Literal) for each in literal.initialiser.values)


def _kept(value: Expression) -> tuple[Expression, Expression]:
    is_record = isinstance(value.type, RecordType)
    symbol = ObjectSymbol("", value.type, value.location, in_memory=is_record)
    name = tree.ObjectName(value.type, value.location, symbol)
    return tree.Assign(value.type, value.location, name, value), name


def after(effects: list[Expression], result: Expression) -> Expression:
    """Return an expression that is evaluated after others."""
    for each in reversed(effects):
        result = tree.Comma(result.type, result.location, each, result)
    return result


def converted(value: Expression, target: CType, convert: Convert) -> Expression:
    """Convert between complex types, or between a complex and a real type (C17 6.3.1.6, 6.3.1.7).

    Args:
        value: the number.
        target: the type.
        convert: converts a real number.
    """
    if unqualified(value.type) == target:
        return value
    given = parts(value)
    if is_complex(target):
        base = base_of(target)
        imaginary = given.imaginary or tree.Literal(base, value.location, 0.0)
        real, imaginary = convert(given.real, base), convert(imaginary, base)
        return after(given.effects, build(base, real, imaginary, value.location))
    if isinstance(target, IntegerType) and target.name == BOOL.name:
        return convert(truth(value), BOOL)
    return after(given.effects, convert(given.real, target))


def truth(value: Expression) -> Expression:
    """Return a condition: an `int` that is not zero if a complex number is not; others as is."""
    if not is_complex(value.type):
        return value
    given, location = parts(value), value.location
    zero = tree.Literal(given.base, location, 0.0)
    assert given.imaginary is not None
    tests: list[Expression] = [
        tree.Binary(INT, location, "!=", each, zero) for each in (given.real, given.imaginary)
    ]
    return after(given.effects, tree.Binary(INT, location, "|", tests[0], tests[1]))


def _negative(value: Expression) -> Expression:
    if isinstance(value, tree.Literal):
        return tree.Literal(value.type, value.location, -value.value)
    return tree.Unary(value.type, value.location, "-", value)


def negated(op: str, value: Expression) -> Expression:
    """Return `+z`, `-z`, or the conjugate `~z`."""
    if op == "+":
        return value
    given = parts(value)
    assert given.imaginary is not None
    real = _negative(given.real) if op == "-" else given.real
    number = build(given.base, real, _negative(given.imaginary), value.location)
    return after(given.effects, number)


def binary(
    op: str,
    operands: tuple[Expression, Expression],
    base: FloatType,
    location: Location,
    arithmetic: Arithmetic,
) -> Expression:
    """Return `left op right`, at least one of which is complex.

    Args:
        op: an arithmetic operator, `==` or `!=`.
        operands: both sides.
        base: the common type of the parts.
        location: the location of the operation.
        arithmetic: computes with real numbers.

    Raises:
        CheckError: complex numbers have no such operator.
    """
    operate, convert = arithmetic.operate, arithmetic.convert
    left, right = (_in_base(each, base, convert) for each in operands)
    effects = [*left.effects, *right.effects]
    if op in {"==", "!="}:
        return after(effects, _compared(op, left, right, operate))
    if op in {"+", "-"}:
        real = operate(op, left.real, right.real)
        return after(effects, build(base, real, _added(op, left, right, operate), location))
    if op not in _PRODUCTS:
        types = " and ".join(f"'{each.type}'" for each in operands)
        raise CheckError(location, f"invalid operands to binary expression ({types})")
    if right.imaginary is None or (left.imaginary is None and op == "*"):
        return after(effects, _scaled(op, left, right, operate, location))
    return after(effects, _product(op, left, right, location, convert))


def _in_base(value: Expression, base: CType, convert: Convert) -> Parts:
    """Return the parts of an operand, converted to the common type."""
    given = parts(value if is_complex(value.type) else convert(value, base))
    given.real = convert(given.real, base)
    if given.imaginary is not None:
        given.imaginary = convert(given.imaginary, base)
    given.base = base
    return given


def _compared(op: str, left: Parts, right: Parts, operate: Operate) -> Expression:
    zero = tree.Literal(left.base, left.real.location, 0.0)
    reals = operate(op, left.real, right.real)
    others = operate(op, left.imaginary or zero, right.imaginary or zero)
    return operate("&" if op == "==" else "|", reals, others)


def _added(op: str, left: Parts, right: Parts, operate: Operate) -> Expression:
    """Return the imaginary part of a sum or difference."""
    if left.imaginary is not None and right.imaginary is not None:
        return operate(op, left.imaginary, right.imaginary)
    if left.imaginary is not None:
        return left.imaginary
    assert right.imaginary is not None
    if op == "+":
        return right.imaginary
    return _negative(right.imaginary)


def _scaled(op: str, left: Parts, right: Parts, operate: Operate, location: Location) -> Expression:
    """Return the product with a real number, or the quotient by one."""
    scale, number = (left, right) if left.imaginary is None else (right, left)
    assert number.imaginary is not None
    if number is right:
        values = [operate(op, scale.real, each) for each in (number.real, number.imaginary)]
    else:
        values = [operate(op, each, scale.real) for each in (number.real, number.imaginary)]
    return build(number.base, values[0], values[1], location)


def _product(
    op: str, left: Parts, right: Parts, location: Location, convert: Convert
) -> Expression:
    """Return a product or quotient of complex numbers, which the library computes."""
    base = left.base
    zero = tree.Literal(base, location, 0.0)
    operands = [left.real, left.imaginary or zero, right.real, right.imaginary or zero]
    values = [each.value for each in operands if isinstance(each, tree.Literal)]
    if len(values) == len(operands) and (op == "*" or any(values[2:])):
        first, second = complex(*values[:2]), complex(*values[2:])
        exact = first * second if op == "*" else first / second
        results = [tree.Literal(DOUBLE, location, each) for each in (exact.real, exact.imag)]
        return build(base, convert(results[0], base), convert(results[1], base), location)
    computed = FLOAT if base == FLOAT else DOUBLE
    name = f"__{_PRODUCTS[op]}{'s' if computed == FLOAT else 'd'}c3"
    ctype = FunctionType(COMPLEX[computed.name], (computed,) * 4)
    callee = tree.FunctionName(ctype, location, FunctionSymbol(name, ctype, location, name))
    call = tree.Call(ctype.result, location, callee, [convert(each, computed) for each in operands])
    assert isinstance(base, FloatType)
    return converted(call, COMPLEX[base.name], convert)


def assignment(target: Expression, make: Callable[[Expression], Expression]) -> Expression:
    """Return `target = make(target)`, with the target's address computed once."""
    location, ctype = target.location, unqualified(target.type)
    if isinstance(target, tree.ObjectName):
        return tree.Assign(ctype, location, target, make(target))
    address = tree.AddressOf(PointerType(ctype), location, target)
    keep, pointer = _kept(address)
    place = tree.Dereference(ctype, location, pointer)
    again = tree.Dereference(ctype, location, pointer)
    return after([keep], tree.Assign(ctype, location, place, make(again)))
