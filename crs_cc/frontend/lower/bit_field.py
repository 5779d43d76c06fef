"""Read and write bit-fields through their storage unit, or byte by byte.

In a packed struct a bit-field may straddle two units of its type, or its unit may extend beyond
the struct: then it is accessed byte by byte.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from crs_cc.core.source import Location
from crs_cc.frontend.lower.lowerer import Lowering, Place, constant, memory_type, value_type
from crs_cc.frontend.lower.memory import load, store
from crs_cc.ir.instruction import Constant, Load, Operand, Store, Unary
from crs_cc.ir.types import EnumType, IntegerType, Member


def _unit_op(member: Member, name: str) -> str:
    return f"{value_type(member.type)}.{name}"


def read_bits(low: Lowering, where: Place, member: Member, location: Location) -> Operand:
    """Return the value of a bit-field, sign- or zero-extended."""
    width, ctype = member.bit_width or 0, member.type
    assert isinstance(ctype, IntegerType | EnumType)
    if member.spread:
        return _read_bytes(low, where, member, location)
    unit = load(low, where, ctype, location)
    if width == 8 * ctype.size:
        return unit
    total = 64 if ctype.size == 8 else 32
    if ctype.signed:
        up = constant(ctype, total - width - member.bit_offset)
        down = constant(ctype, total - width)
        raised = low.binary(location, _unit_op(member, "shl"), unit, up)
        return low.binary(location, _unit_op(member, "shr_s"), raised, down)
    shifted: Operand = unit
    if member.bit_offset:
        by = constant(ctype, member.bit_offset)
        shifted = low.binary(location, _unit_op(member, "shr_u"), unit, by)
    mask = _mask(member, width)
    return low.binary(location, _unit_op(member, "and"), shifted, mask)


def _mask(member: Member, width: int, shift: int = 0, inverted: bool = False) -> Constant:
    bits = ((1 << width) - 1) << shift
    return constant(member.type, ~bits if inverted else bits)


def write_bits(
    low: Lowering, where: Place, member: Member, source: Operand, location: Location
) -> None:
    """Write a bit-field and keep the other bits of its unit."""
    width, ctype = member.bit_width or 0, member.type
    if member.spread:
        _write_bytes(low, where, member, source, location)
        return
    if width == 8 * ctype.size:
        store(low, where, ctype, source, location)
        return
    base, offset = low.access(where, ctype.size, location)
    unit = low.register(value_type(ctype))
    low.emit(Load(location, unit, base, offset, memory_type(ctype), unjudged=True))
    others = low.binary(
        location, _unit_op(member, "and"), unit, _mask(member, width, member.bit_offset, True)
    )
    bits = _shifted(low, member, source, location)
    merged = low.binary(location, _unit_op(member, "or"), others, bits)
    store(low, (base, offset), ctype, merged, location)


def _shifted(low: Lowering, member: Member, source: Operand, location: Location) -> Operand:
    """Return the low bits of a value, shifted to the position of a bit-field in its unit."""
    width, offset = member.bit_width or 0, member.bit_offset
    if isinstance(source, Constant):
        kept = int(source.value) & ((1 << width) - 1)
        return constant(member.type, kept << offset)
    bits = low.binary(location, _unit_op(member, "and"), source, _mask(member, width))
    if offset == 0:
        return bits
    return low.binary(location, _unit_op(member, "shl"), bits, constant(member.type, offset))


def fit_bits(low: Lowering, member: Member, source: Operand, location: Location) -> Operand:
    """Return the value that a bit-field holds after `source` was written to it."""
    width, ctype = member.bit_width or 0, member.type
    assert isinstance(ctype, IntegerType | EnumType)
    total = 64 if ctype.size == 8 else 32
    if width == total or ctype.size * 8 == width or ctype.name == "_Bool":
        return source
    if not ctype.signed:
        return low.binary(location, _unit_op(member, "and"), source, _mask(member, width))
    by = constant(ctype, total - width)
    raised = low.binary(location, _unit_op(member, "shl"), source, by)
    return low.binary(location, _unit_op(member, "shr_s"), raised, by)


class _Piece(NamedTuple):
    """One byte of a bit-field.

    Attributes:
        offset: the byte's offset from the field's first byte.
        shift: how many bits the byte's lowest bit is above the value's lowest.
        mask: the bits of the byte that belong to the field.
    """

    offset: int
    shift: int
    mask: int


def _pieces(member: Member) -> Iterator[_Piece]:
    end = member.bit_offset + (member.bit_width or 0)
    for offset in range(member.spread):
        low, high = max(0, member.bit_offset - 8 * offset), min(8, end - 8 * offset)
        yield _Piece(offset, 8 * offset - member.bit_offset, (1 << high) - (1 << low))


def _read_bytes(low: Lowering, where: Place, member: Member, location: Location) -> Operand:
    """Read a bit-field byte by byte."""
    ctype, kind = member.type, value_type(member.type)
    assert isinstance(ctype, IntegerType | EnumType)
    base, offset = low.access(where, member.spread, location)
    whole: Operand = constant(ctype, 0)
    for piece in _pieces(member):
        byte = low.register("i32")
        low.emit(Load(location, byte, base, offset + piece.offset, "u8"))
        bits: Operand = byte
        if kind == "i64":
            bits = low.register("i64")
            low.emit(Unary(location, bits, "i64.extend_i32_u", byte))
        bits = _moved(low, member, bits, piece.shift, location)
        whole = low.binary(location, f"{kind}.or", whole, bits)
    by = constant(ctype, (64 if kind == "i64" else 32) - (member.bit_width or 0))
    raised = low.binary(location, f"{kind}.shl", whole, by)
    return low.binary(location, f"{kind}.{'shr_s' if ctype.signed else 'shr_u'}", raised, by)


def _write_bytes(
    low: Lowering, where: Place, member: Member, source: Operand, location: Location
) -> None:
    """Write a bit-field byte by byte and keep the bits around it."""
    base, offset = low.access(where, member.spread, location)
    for piece in _pieces(member):
        bits = _moved(low, member, source, -piece.shift, location)
        if value_type(member.type) == "i64":
            narrow = low.register("i32")
            low.emit(Unary(location, narrow, "i32.wrap_i64", bits))
            bits = narrow
        if piece.mask != 0xFF:
            bits = low.binary(location, "i32.and", bits, Constant("i32", piece.mask))
            old = low.register("i32")
            low.emit(Load(location, old, base, offset + piece.offset, "u8", unjudged=True))
            others = low.binary(location, "i32.and", old, Constant("i32", 0xFF - piece.mask))
            bits = low.binary(location, "i32.or", others, bits)
        low.emit(Store(location, base, offset + piece.offset, bits, "u8"))


def _moved(low: Lowering, member: Member, bits: Operand, by: int, location: Location) -> Operand:
    """Shift left, or right if `by` is negative."""
    if by == 0:
        return bits
    kind, name = value_type(member.type), "shl" if by > 0 else "shr_u"
    return low.binary(location, f"{kind}.{name}", bits, constant(member.type, abs(by)))
