"""Lower conversions between scalar types (C17 6.3.1, 6.3.2.3)."""

from __future__ import annotations

from typing import Final

from crs_cc.core.source import Location
from crs_cc.frontend.check import tree
from crs_cc.frontend.lower.lowerer import Lowering, Rules, effect, truth, value, value_type
from crs_cc.ir.instruction import Binary, Constant, Operand, Register, Unary
from crs_cc.ir.operators import OPERATORS
from crs_cc.ir.types import BOOL, CType, EnumType, FloatType, IntegerType, PointerType

_NARROW: Final = {"i8": "i32.extend8_s", "i16": "i32.extend16_s"}
_MASK: Final = {"u8": 0xFF, "u16": 0xFFFF}


def convert_operand(
    low: Lowering,
    operand: Operand,
    source: CType,
    target: CType,
    location: Location,
    *,
    into: Register | None = None,
) -> Operand:
    """Convert a value from one scalar type to another."""
    if source is target or source == target:
        return operand
    if isinstance(target, IntegerType) and target.name == BOOL.name:
        return _to_bool(low, operand, source, location, into=into)
    if isinstance(source, FloatType):
        if isinstance(target, FloatType):
            return _between_floats(low, operand, source, target, location, into=into)
        return _from_float(low, operand, source, target, location, into=into)
    if isinstance(target, FloatType):
        signed = not isinstance(source, PointerType) and _signed(source)
        op = f"{target.memory}.convert_{value_type(source)}_{'s' if signed else 'u'}"
        return _unary(low, op, operand, location, into)
    return _between_integers(low, operand, source, target, location, into=into)


def _signed(ctype: CType) -> bool:
    return isinstance(ctype, IntegerType | EnumType) and ctype.signed


def _unary(
    low: Lowering, op: str, operand: Operand, location: Location, into: Register | None
) -> Register:
    result = low.register(OPERATORS[op].result) if into is None else into
    low.emit(Unary(location, result, op, operand))
    return result


def _to_bool(
    low: Lowering, operand: Operand, source: CType, location: Location, *, into: Register | None
) -> Operand:
    if isinstance(source, IntegerType) and source.name == BOOL.name:
        return operand
    zero = Constant(operand.type, 0 if operand.type in {"i32", "i64"} else 0.0)
    result = low.register("i32") if into is None else into
    low.emit(Binary(location, result, f"{operand.type}.ne", operand, zero))
    return result


def _between_floats(
    low: Lowering,
    operand: Operand,
    source: FloatType,
    target: FloatType,
    location: Location,
    *,
    into: Register | None,
) -> Operand:
    if source.size == target.size:
        return operand
    op = "f64.promote_f32" if target.size == 8 else "f32.demote_f64"
    return _unary(low, op, operand, location, into)


def _from_float(
    low: Lowering,
    operand: Operand,
    source: FloatType,
    target: CType,
    location: Location,
    *,
    into: Register | None,
) -> Operand:
    if target.size == 8:
        op = f"i64.trunc_{source.memory}_{'s' if _signed(target) else 'u'}"
        return _unary(low, op, operand, location, into)
    if target.size == 4 and not _signed(target):
        # As gcc does on i386: values beyond unsigned int wrap around.
        wide = _unary(low, f"i64.trunc_{source.memory}_s", operand, location, None)
        return _unary(low, "i32.wrap_i64", wide, location, into)
    if target.size == 4:
        return _unary(low, f"i32.trunc_{source.memory}_s", operand, location, into)
    whole = _unary(low, f"i32.trunc_{source.memory}_s", operand, location, None)
    return narrow(low, whole, target, location, into=into)


def _between_integers(
    low: Lowering,
    operand: Operand,
    source: CType,
    target: CType,
    location: Location,
    *,
    into: Register | None,
) -> Operand:
    wanted = value_type(target)
    if operand.type == "i32" and wanted == "i64":
        signed = isinstance(source, PointerType) or _signed(source)
        op = f"i64.extend_i32_{'s' if signed else 'u'}"
        operand = _unary(low, op, operand, location, into)
        return operand if _fits(source, target) else narrow(low, operand, target, location)
    if operand.type == "i64" and wanted == "i32":
        is_last = target.size == 4
        operand = _unary(low, "i32.wrap_i64", operand, location, into if is_last else None)
    elif _fits(source, target):
        return operand
    return narrow(low, operand, target, location, into=into)


def _fits(source: CType, target: CType) -> bool:
    """Return whether one integer type can represent every value of another."""
    if target.size == 4:
        return True
    if _signed(source) and not _signed(target):
        return False
    of, to = _bits(source), _bits(target)
    return of < to or (of == to and _signed(source) == _signed(target))


def _bits(ctype: CType) -> int:
    return ctype.bits if isinstance(ctype, IntegerType | EnumType) else 8 * ctype.size


def narrow(
    low: Lowering,
    operand: Operand,
    target: CType,
    location: Location,
    *,
    into: Register | None = None,
) -> Operand:
    """Truncate a value to a `char`, `short` or wide bit-field; return that of other types as is."""
    if isinstance(target, IntegerType) and target.width is not None:
        return _narrow_wide(low, operand, target, location, into)
    if target.size >= 4 or not isinstance(target, IntegerType | EnumType):
        return operand
    if target.memory in _NARROW:
        return _unary(low, _NARROW[target.memory], operand, location, into)
    mask = Constant("i32", _MASK[target.memory])
    return low.binary(location, "i32.and", operand, mask, into)


def _narrow_wide(
    low: Lowering,
    operand: Operand,
    target: IntegerType,
    location: Location,
    into: Register | None,
) -> Operand:
    if not target.signed:
        mask = Constant("i64", (1 << target.bits) - 1)
        return low.binary(location, "i64.and", operand, mask, into)
    by = Constant("i64", 64 - target.bits)
    raised = low.binary(location, "i64.shl", operand, by)
    return low.binary(location, "i64.shr_s", raised, by, into)


def unnarrowed(expression: tree.Expression) -> tree.Expression:
    """Return the operand of conversions to a narrow integer type.

    They are redundant in front of a store to memory, which drops the high bits itself.
    """
    ctype = expression.type
    while (
        isinstance(expression, tree.Convert)
        and isinstance(ctype, IntegerType)
        and isinstance(expression.type, IntegerType)
        and ctype.size < 4
        and expression.type.name != BOOL.name
        and isinstance(expression.operand.type, IntegerType | EnumType)
        and ctype.size <= expression.operand.type.size <= 4
    ):
        expression = expression.operand
    return expression


def _convert(low: Lowering, expression: tree.Convert, into: Register | None) -> Operand:
    source, target = expression.operand.type, expression.type
    if isinstance(target, IntegerType) and target.name == BOOL.name and value_type(source) != "i32":
        return truth(low, expression.operand)
    operand = value(low, expression.operand)
    return convert_operand(low, operand, source, target, expression.location, into=into)


def _drop(low: Lowering, expression: tree.Convert) -> None:
    effect(low, expression.operand)


RULES: Final = Rules(
    value={
        tree.Convert: _convert,
    },
    effect={
        tree.Convert: _drop,
    },
)
