"""Complex numbers (C17 6.2.5p11, 6.3.1.6 to 6.3.1.8, annex G).

A complex number is a struct of its real and its imaginary part, see `ir.types.COMPLEX`. Arithmetic
becomes arithmetic of the parts and a compound literal of the results; a real operand has no
imaginary part, which is not the same as one of zero. Constants are folded with their parts.
GNU C has complex integers, too, with parts of any integer type.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final, TypeAlias

from crs_cc.core.source import Location
from crs_cc.frontend.check import complex_constants, tree
from crs_cc.frontend.check.checker import CheckError
from crs_cc.frontend.check.scope import FunctionSymbol, ObjectSymbol
from crs_cc.frontend.check.tree import Expression, Initialiser, InitialValue
from crs_cc.ir.types import (
    BOOL,
    COMPLEX,
    DOUBLE,
    FLOAT,
    INT,
    LLONG,
    UINT,
    ULLONG,
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
    """How real numbers are computed with.

    They are `operate(op, left, right)`, `convert(value, type)` and `negate(value)`.
    """

    operate: Operate
    convert: Convert
    negate: Callable[[Expression], Expression]


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


def base_of(ctype: CType) -> IntegerType | FloatType:
    """Return the type of the parts of a complex type."""
    assert isinstance(ctype, RecordType)
    assert ctype.record.members is not None
    base = ctype.record.members[0].type
    assert isinstance(base, IntegerType | FloatType)
    return base


def zero(base: CType, location: Location) -> Expression:
    """Return zero of an arithmetic type."""
    return tree.Literal(base, location, 0.0 if isinstance(base, FloatType) else 0)


def build(base: CType, real: Expression, imaginary: Expression, location: Location) -> Expression:
    """Return a complex number of two parts of its base type."""
    assert isinstance(base, IntegerType | FloatType)
    ctype = COMPLEX[base.name]
    values = [InitialValue(0, base, real), InitialValue(base.size, base, imaginary)]
    symbol = ObjectSymbol("", ctype, location, in_memory=True)
    return tree.CompoundLiteral(ctype, location, symbol, Initialiser(values, is_braced=True))


def part(value: Expression, index: int) -> Expression:
    """Return the real (0) or imaginary (1) part of a complex object."""
    ctype = value.type
    assert isinstance(ctype, RecordType)
    assert ctype.record.members is not None
    if isinstance(value, tree.CompoundLiteral) and _is_constant(value):
        return value.initialiser.values[index].value
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
        imaginary = given.imaginary or zero(base, value.location)
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
    assert given.imaginary is not None
    numbers = [_at_least_int(each) for each in (given.real, given.imaginary)]
    none = zero(numbers[0].type, location)
    tests: list[Expression] = [tree.Binary(INT, location, "!=", each, none) for each in numbers]
    return after(given.effects, tree.Binary(INT, location, "|", tests[0], tests[1]))


def _at_least_int(value: Expression) -> Expression:
    """Return a number as an `int`, if its type is shorter."""
    is_short = isinstance(value.type, IntegerType) and value.type.size < INT.size
    return tree.Convert(INT, value.location, value) if is_short else value


def negated(op: str, value: Expression, arithmetic: Arithmetic) -> Expression:
    """Return `+z`, `-z`, or the conjugate `~z`."""
    if op == "+":
        return value
    given = parts(value)
    assert given.imaginary is not None
    real = arithmetic.negate(given.real) if op == "-" else given.real
    number = _built(given.base, real, arithmetic.negate(given.imaginary), arithmetic.convert)
    return after(given.effects, number)


def _built(base: CType, real: Expression, imaginary: Expression, convert: Convert) -> Expression:
    """Return a complex number of two parts of any type; short integers were promoted."""
    return build(base, convert(real, base), convert(imaginary, base), real.location)


def binary(
    op: str,
    operands: tuple[Expression, Expression],
    base: IntegerType | FloatType,
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
    left, right = (_in_base(each, base, arithmetic.convert) for each in operands)
    effects = [*left.effects, *right.effects]
    if op in {"==", "!="}:
        return after(effects, _compared(op, left, right, arithmetic.operate))
    if op not in {"+", "-", *_PRODUCTS}:
        types = " and ".join(f"'{each.type}'" for each in operands)
        raise CheckError(location, f"invalid operands to binary expression ({types})")
    return after(effects, _computed(op, left, right, location, arithmetic))


def _computed(
    op: str, left: Parts, right: Parts, location: Location, arithmetic: Arithmetic
) -> Expression:
    """Return a sum, difference, product or quotient of numbers with parts of one type."""
    operate, convert = arithmetic.operate, arithmetic.convert
    if op in {"+", "-"}:
        real = operate(op, left.real, right.real)
        return _built(left.base, real, _added(op, left, right, arithmetic), convert)
    if right.imaginary is None or (left.imaginary is None and op == "*"):
        return _scaled(op, left, right, arithmetic)
    if isinstance(left.base, IntegerType):
        return _integer_product(op, left, right, location, arithmetic)
    return _product(op, left, right, location, convert)


def _in_base(value: Expression, base: CType, convert: Convert) -> Parts:
    """Return the parts of an operand, converted to the common type."""
    given = parts(value if is_complex(value.type) else convert(value, base))
    given.real = convert(given.real, base)
    if given.imaginary is not None:
        given.imaginary = convert(given.imaginary, base)
    given.base = base
    return given


def _compared(op: str, left: Parts, right: Parts, operate: Operate) -> Expression:
    none = zero(left.base, left.real.location)
    reals = operate(op, left.real, right.real)
    others = operate(op, left.imaginary or none, right.imaginary or none)
    return operate("&" if op == "==" else "|", reals, others)


def _added(op: str, left: Parts, right: Parts, arithmetic: Arithmetic) -> Expression:
    """Return the imaginary part of a sum or difference."""
    if left.imaginary is not None and right.imaginary is not None:
        return arithmetic.operate(op, left.imaginary, right.imaginary)
    if left.imaginary is not None:
        return left.imaginary
    assert right.imaginary is not None
    if op == "+":
        return right.imaginary
    return arithmetic.negate(right.imaginary)


def _scaled(op: str, left: Parts, right: Parts, arithmetic: Arithmetic) -> Expression:
    """Return the product with a real number, or the quotient by one."""
    scale, number = (left, right) if left.imaginary is None else (right, left)
    assert number.imaginary is not None
    operate = arithmetic.operate
    if number is right:
        values = [operate(op, scale.real, each) for each in (number.real, number.imaginary)]
    else:
        values = [operate(op, each, scale.real) for each in (number.real, number.imaginary)]
    return _built(number.base, values[0], values[1], arithmetic.convert)


def _integer_product(
    op: str, left: Parts, right: Parts, location: Location, arithmetic: Arithmetic
) -> Expression:
    """Return a product or quotient of complex integers.

    gcc divides by R. L. Smith's method (CACM 1962, algorithm 116), all of whose quotients are
    truncated; the library does the same.
    """
    operate, convert = arithmetic.operate, arithmetic.convert
    none = zero(left.base, location)
    a, b, c, d = left.real, left.imaginary or none, right.real, right.imaginary or none
    if op == "*":
        real = operate("-", operate("*", a, c), operate("*", b, d))
        imaginary = operate("+", operate("*", a, d), operate("*", b, c))
        return _built(left.base, real, imaginary, convert)
    base = left.base
    assert isinstance(base, IntegerType)
    computed = LLONG if base.signed else ULLONG if base.size == ULLONG.size else UINT
    constants = _constants([a, b, c, d])
    if constants:
        found = complex_constants.integer_quotient(computed, *map(int, constants))
        if found is not None:
            real, imaginary = (tree.integer(each, computed, location) for each in found)
            return _built(base, real, imaginary, convert)
    name = f"__crs_quotient_{'signed' if base.signed else f'unsigned{8 * computed.size}'}"
    quotient = _called(name, computed, [convert(each, computed) for each in (a, b, c, d)], location)
    return converted(quotient, COMPLEX[base.name], convert)


def _called(
    name: str, base: IntegerType | FloatType, arguments: list[Expression], location: Location
) -> Expression:
    """Return the complex result of a function of the library with parts of one type."""
    ctype = FunctionType(COMPLEX[base.name], (base,) * len(arguments))
    callee = tree.FunctionName(ctype, location, FunctionSymbol(name, ctype, location, name))
    return tree.Call(ctype.result, location, callee, arguments)


def _product(
    op: str, left: Parts, right: Parts, location: Location, convert: Convert
) -> Expression:
    """Return a product or quotient of complex numbers, which the library computes."""
    base = left.base
    none = zero(base, location)
    operands = [left.real, left.imaginary or none, right.real, right.imaginary or none]
    constants = _constants(operands)
    if constants:
        found = complex_constants.floating(op, complex(*constants[:2]), complex(*constants[2:]))
        if found is not None:
            real, imaginary = (
                tree.Literal(DOUBLE, location, each) for each in (found.real, found.imag)
            )
            return _built(base, real, imaginary, convert)
    computed = FLOAT if base == FLOAT else DOUBLE
    name = f"__{_PRODUCTS[op]}{'s' if computed == FLOAT else 'd'}c3"
    call = _called(name, computed, [convert(each, computed) for each in operands], location)
    assert isinstance(base, FloatType)
    return converted(call, COMPLEX[base.name], convert)


def _constants(operands: Sequence[Expression]) -> list[int | float]:
    """Return the values of operands; none unless all are constant."""
    values = [each.value for each in operands if isinstance(each, tree.Literal)]
    return values if len(values) == len(operands) else []


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
