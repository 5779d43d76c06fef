"""Conversions (C17 6.3): promotions, the usual arithmetic conversions, casts and assignments.

>>> from crs_cc.core.source import Location
>>> from crs_cc.ir.types import LONG
>>> here = Location("a.c", 1, 1)
>>> one, two = tree.integer(1, UINT, here), tree.integer(2, LONG, here)
>>> left, right = usual_arithmetic_conversions(one, two)
>>> print(left.type, right.value)
unsigned long 2
"""

from __future__ import annotations

from typing import Final, NoReturn

from crs_cc.frontend.check import complex_numbers, fold, tree
from crs_cc.frontend.check.checker import CheckError, Unit
from crs_cc.frontend.check.lost_value_warnings import warn_constant, warn_division
from crs_cc.frontend.check.scope import ObjectSymbol
from crs_cc.frontend.check.tree import Expression
from crs_cc.frontend.check.type_compat import compatible
from crs_cc.ir.types import (
    BOOL,
    COMPLEX,
    DOUBLE,
    INT,
    NULLPTR,
    UINT,
    ULLONG,
    ULONG,
    VOID,
    ArrayType,
    CType,
    EnumType,
    FloatType,
    FunctionType,
    IntegerType,
    PointerType,
    RecordType,
    VoidType,
    bit_field,
    is_complex,
    unqualified,
)

_UNSIGNED: Final = {"int": UINT, "long": ULONG, "long long": ULLONG}

PHRASES: Final = {
    "assign": (
        "assigning to '{to}' from '{of}'",
        "assigning to '{to}' from incompatible type '{of}'",
    ),
    "initialise": (
        "initializing '{to}' with an expression of type '{of}'",
        "initializing '{to}' with an expression of incompatible type '{of}'",
    ),
    "pass": (
        "passing '{of}' to parameter of type '{to}'",
        "passing '{of}' to parameter of incompatible type '{to}'",
    ),
    "return": (
        "returning '{of}' from a function with result type '{to}'",
        "returning '{of}' from a function with incompatible result type '{to}'",
    ),
}  # fmt: skip
"""The purposes of conversions: as part of a warning, and of an error."""


def is_integer(ctype: CType) -> bool:
    """Return whether a type is an integer type or an enum (C17 6.2.5p17)."""
    return isinstance(ctype, IntegerType | EnumType)


def is_arithmetic(ctype: CType) -> bool:
    """Return whether a type is an integer or floating type."""
    return isinstance(ctype, IntegerType | FloatType | EnumType)


def is_scalar(ctype: CType) -> bool:
    """Return whether a type is an arithmetic or pointer type."""
    return isinstance(ctype, IntegerType | FloatType | EnumType | PointerType)


def is_null_constant(expression: Expression) -> bool:
    """Return whether an expression is a null pointer constant (C17 6.3.2.3p3)."""
    if not isinstance(expression, tree.Literal) or expression.value != 0:
        return False
    ctype = expression.type
    is_null = isinstance(ctype, PointerType) and ctype.target in (VOID, NULLPTR.target)
    return is_integer(ctype) or is_null


def decay(expression: Expression) -> Expression:
    """Convert an lvalue to its value; arrays and functions become pointers (C17 6.3.2.1)."""
    ctype = expression.type
    if isinstance(ctype, ArrayType):
        return tree.AddressOf(PointerType(ctype.element), expression.location, expression)
    if isinstance(ctype, FunctionType):
        return tree.AddressOf(PointerType(ctype), expression.location, expression)
    if ctype.const or ctype.volatile:
        expression.type = unqualified(ctype)
    if isinstance(expression, tree.ObjectName) and expression.is_constant:
        value = expression.symbol.constant
        assert value is not None
        return tree.Literal(expression.type, expression.location, value)
    return expression


def is_number(ctype: CType) -> bool:
    """Return whether a type is arithmetic: integer, floating or complex (C17 6.2.5p18)."""
    return is_arithmetic(ctype) or is_complex(ctype)


def convert(expression: Expression, target: CType) -> Expression:
    """Convert a value to a type without checks; fold it if it is constant."""
    source = expression.type
    if source is target or source == target:
        return expression
    if is_complex(target) or (is_complex(source) and is_arithmetic(target)):
        return complex_numbers.converted(expression, target, convert)
    if isinstance(expression, tree.Literal):
        value = fold.convert(expression.value, source, target)
        if value is not None:
            return tree.Literal(target, expression.location, value)
    return tree.Convert(target, expression.location, expression)


def promote(expression: Expression) -> Expression:
    """Perform the integer promotions (C17 6.3.1.1p2); return other types as they are."""
    ctype = expression.type
    if ctype is INT or not isinstance(ctype, IntegerType | EnumType):
        return expression
    if ctype.rank < INT.rank:
        return convert(expression, INT)
    width = _field_width(expression)
    if width is not None and width <= 8 * INT.size:
        return convert(expression, INT if width < 8 * INT.size or ctype.signed else UINT)
    if width is not None and width < 8 * ctype.size:
        return convert(expression, bit_field(ctype, width))
    if isinstance(ctype, EnumType):
        return convert(expression, ctype.definition.integer)
    return expression


def _field_width(expression: Expression) -> int | None:
    """Return the width of a bit-field's value, read or assigned [bits]; None for other values."""
    while True:
        match expression:
            case tree.Assign(target=inner) | tree.CompoundAssign(target=inner):
                expression = inner
            case tree.Increment(target=inner) | tree.Comma(second=inner):
                expression = inner
            case tree.MemberAccess(member=member):
                return member.bit_width
            case _:
                return None


def promote_argument(expression: Expression) -> Expression:
    """Perform the default argument promotions (C17 6.5.2.2p6)."""
    if isinstance(expression.type, FloatType) and expression.type.size == 4:
        return convert(expression, DOUBLE)
    return promote(expression)


def usual_arithmetic_conversions(
    left: Expression, right: Expression
) -> tuple[Expression, Expression]:
    """Perform the usual arithmetic conversions (C17 6.3.1.8)."""
    left, right = promote(left), promote(right)
    if left.type is right.type:
        return left, right
    if is_complex(left.type) or is_complex(right.type):
        both = COMPLEX[common_base(left, right).name]
        return convert(left, both), convert(right, both)
    common = _common(left.type, right.type)
    return convert(left, common), convert(right, common)


def common_base(left: Expression, right: Expression) -> IntegerType | FloatType:
    """Return the common type of the parts of two numbers, one of them complex (C17 6.3.1.8).

    GNU C does not promote the parts of complex integers.
    """
    types = [
        complex_numbers.base_of(each.type) if is_complex(each.type) else promote(each).type
        for each in (left, right)
    ]
    common = _common(types[0], types[1])
    assert isinstance(common, IntegerType | FloatType)
    return common


def _common(left: CType, right: CType) -> CType:
    assert isinstance(left, IntegerType | FloatType)
    assert isinstance(right, IntegerType | FloatType)
    high, low = (left, right) if left.rank >= right.rank else (right, left)
    if isinstance(high, FloatType):
        return high
    assert isinstance(low, IntegerType), "floating types have the higher ranks"
    if high.signed == low.signed or not high.signed:
        return high
    if high.rank == low.rank:
        return low
    return high if high.bits > low.bits else _UNSIGNED[high.name]


def cast(unit: Unit, expression: Expression, target: CType) -> Expression:
    """Convert as a cast does (C17 6.5.4)."""
    value = decay(expression)
    source = value.type
    if isinstance(target, VoidType):
        return tree.Convert(VOID, value.location, value)
    target = unqualified(target)
    if is_number(target) and is_number(source) and not is_scalar(target):
        return convert(value, target)
    if isinstance(target, RecordType):
        return value if source == target else _union_of(value, target)
    if not is_scalar(target):
        _fail(value, f"used type '{target}' where arithmetic or pointer type is required")
    if not is_scalar(source) and not (is_complex(source) and is_arithmetic(target)):
        _fail(value, f"operand of type '{source}' where arithmetic or pointer type is required")
    if isinstance(target, PointerType) and isinstance(source, FloatType):
        _fail(value, f"operand of type '{source}' cannot be cast to a pointer type")
    if isinstance(source, PointerType) and isinstance(target, FloatType):
        _fail(value, f"pointer cannot be cast to type '{target}'")
    is_narrow = isinstance(source, PointerType) and is_integer(target) and target.size < 4
    if is_narrow and target != BOOL:
        unit.warning(
            value.location,
            f"cast to smaller integer type '{target}' from '{source}'",
            flag="pointer-to-int-cast",
        )
    if source == target and _field_width(value) is not None:
        return tree.Convert(target, value.location, value)  # not a bit-field any more
    return convert(value, target)


def _union_of(value: Expression, target: RecordType) -> Expression:
    """Cast to a union with a member of the value's type (GNU C)."""
    location, source = value.location, unqualified(value.type)
    for member in target.record.members or [] if target.record.kind == "union" else []:
        is_null = isinstance(member.type, PointerType) and is_null_constant(value)
        if compatible(unqualified(member.type), source) or is_null:
            value = convert(value, unqualified(member.type))
            symbol = ObjectSymbol("", target, location, in_memory=True)
            is_field = member.bit_width is not None
            part = tree.InitialValue(0, member.type, value, member if is_field else None)
            filled = tree.Initialiser([part], is_braced=True)
            return tree.CompoundLiteral(target, location, symbol, filled)
    text = f"used type '{target}' where arithmetic or pointer type is required"
    if target.record.kind == "union":
        text = f"no member of '{target}' has the type '{source}'"
    raise CheckError(location, text)


def _fail(expression: Expression, text: str) -> NoReturn:
    raise CheckError(expression.location, text)


def assigned(
    unit: Unit, expression: Expression, target: CType, use: str, hint: str = ""
) -> Expression:
    """Convert a value as an assignment does (C17 6.5.16.1), with gcc's severities for gnu89.

    Args:
        unit: receives warnings.
        expression: the value.
        target: the type of the target.
        use: the purpose, a key of `PHRASES`.
        hint: a hint for the message.

    Raises:
        CheckError: there is no such conversion.
    """
    value = decay(expression)
    source = value.type
    if source is target:
        return value
    target = unqualified(target)
    if is_number(target) and is_number(source):
        warn_constant(unit, value, target)
        warn_division(unit, value, target)
        return convert(value, target)
    if isinstance(target, PointerType):
        if isinstance(source, PointerType):
            _check_pointers(unit, value, target, use, hint)
            return convert(value, target)
        if is_integer(source):
            if not is_null_constant(value):
                kind = "incompatible integer to pointer conversion"
                _warn(
                    unit,
                    kind,
                    value,
                    target,
                    use,
                    hint=hint or _quotes_hint(unit, value, target),
                    flag="int-conversion",
                )
            return convert(value, target)
    if isinstance(source, PointerType) and is_integer(target):
        if target != BOOL:
            kind, hint = "pointer to integer", hint or _quotes_hint(unit, value, target)
            _warn(
                unit,
                f"incompatible {kind} conversion",
                value,
                target,
                use,
                hint=hint,
                flag="int-conversion",
            )
        return convert(value, target)
    if isinstance(target, RecordType) and (source == target or _takes_members(target, use)):
        return value if source == target else _union_of(value, target)
    impossible = PHRASES[use][1].format(to=target, of=source)
    raise CheckError(value.location, impossible, hint)


def _takes_members(target: RecordType, use: str) -> bool:
    """Return whether a value may be passed as one of a union's members."""
    return target.record.is_transparent and use == "pass"


def _warn(
    unit: Unit, kind: str, value: Expression, target: CType, use: str, *, hint: str, flag: str
) -> None:
    text = f"{kind} {PHRASES[use][0].format(to=target, of=value.type)}"
    unit.warning(value.location, text, hint, flag=flag)


def _quotes_hint(unit: Unit, value: Expression, target: CType) -> str:
    """Return a hint at quotes of the wrong kind: `char c = "x"`, `char *s = 'x'`."""
    if isinstance(target, PointerType):
        is_string = isinstance(target.target, IntegerType) and target.target.size == 1
        quoted = unit.diagnostics.text_at(value.location).startswith("'")
        return "use double quotes for a string" if is_string and quoted else ""
    is_text = isinstance(value, tree.AddressOf) and isinstance(value.operand, tree.StringLiteral)
    return "use single quotes for a character" if is_text and target.size == 1 else ""


def _check_pointers(
    unit: Unit, value: Expression, target: PointerType, use: str, hint: str
) -> None:
    assert isinstance(value.type, PointerType)
    left, right = target.target, value.type.target
    if left is right or is_null_constant(value) or right == NULLPTR.target:
        return
    lost = [
        word
        for word, is_lost in (
            ("const", right.const and not left.const),
            ("volatile", right.volatile and not left.volatile),
        )
        if is_lost
    ]
    if lost and not isinstance(right, FunctionType):
        text = f"{PHRASES[use][0].format(to=target, of=value.type)} discards qualifiers"
        unit.warning(value.location, text, flag="discarded-qualifiers")
        return
    left, right = unqualified(left), unqualified(right)
    if VOID in (left, right) or compatible(left, right):
        return
    if _differ_in_sign(left, right):
        return
    _warn(
        unit,
        "incompatible pointer types",
        value,
        target,
        use,
        hint=hint,
        flag="incompatible-pointer-types",
    )


def _differ_in_sign(left: CType, right: CType) -> bool:
    """Return whether two pointees differ in sign only, which gcc accepts by default."""
    if not isinstance(left, IntegerType) or not isinstance(right, IntegerType):
        return False
    return left.size == right.size and left.rank == right.rank and BOOL not in (left, right)
