"""Reads and writes bit-fields that no unit of their type holds, byte by byte.

In a packed struct a bit-field may lie across two units, or in one that reaches beyond the struct.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from crs_cc.frontend.lower import Lowering, Place, constant, value_type
from crs_cc.ir.program import Constant, Load, Operand, Store, Unary
from crs_cc.ir.types import EnumType, IntegerType, Member
from crs_cc.source import Location


class _Piece(NamedTuple):
    """One byte of a bit-field.

    Attributes:
        offset: of the byte, from the field's first one.
        shift: by how many bits the byte's lowest bit lies above the value's lowest.
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


def read_spread(low: Lowering, where: Place, member: Member, location: Location) -> Operand:
    """Reads a bit-field, extended as its type says."""
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


def write_spread(
    low: Lowering, where: Place, member: Member, source: Operand, location: Location
) -> None:
    """Writes a bit-field and leaves the bits around it as they are."""
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
    """Shifts left, or right by a negative number."""
    if by == 0:
        return bits
    kind, name = value_type(member.type), "shl" if by > 0 else "shr_u"
    return low.binary(location, f"{kind}.{name}", bits, constant(member.type, abs(by)))
