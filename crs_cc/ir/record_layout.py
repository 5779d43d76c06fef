"""The layout of structs and unions, as gcc's on i386.

Bit-fields are in the lowest free bits, but do not cross a boundary of their own type unless they
are packed; one of width 0 ends the unit.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol


class Sized(Protocol):
    """The size and alignment of a type [bytes]."""

    @property
    def size(self) -> int:
        """Return the size [bytes]."""

    @property
    def align(self) -> int:
        """Return the alignment [bytes]."""


class Member(Protocol):
    """The attributes of an `ir.types.Member` that the layout reads and sets."""

    name: str | None
    offset: int
    bit_offset: int
    bit_width: int | None
    align: int
    natural: int
    packed: bool
    spread: int

    @property
    def type(self) -> Sized:
        """Return the member's type."""


def lay_out(
    members: Sequence[Member], is_union: bool = False, align: int = 1, pack: int = 0
) -> tuple[int, int]:
    """Set the offset of each member, and return the size and alignment of the whole [bytes].

    Args:
        members: the members; those of a packed struct are packed.
        is_union: whether all start at the same offset.
        align: the minimum alignment of the whole [bytes].
        pack: the maximum alignment of members [bytes], from `#pragma pack`; 0 if there is none.
    """
    end_bits = size_bits = 0
    for member in members:
        end_bits = _place(member, 0 if is_union else end_bits, pack)
        size_bits = max(size_bits, end_bits)
        align = max(align, _wanted(member, pack))
    size = -(-size_bits // (8 * align)) * align
    for member in members:
        _spread(member, size)
    return size, align


def _wanted(member: Member, pack: int) -> int:
    """Return the alignment that a member demands of the whole [bytes]."""
    if member.bit_width is not None and member.name is None:
        return 1
    natural = member.natural or member.type.align
    is_free = member.packed and not (pack and member.bit_width is not None)
    return _least(max(member.align, 1 if is_free else natural), pack)


def _place(member: Member, start_bits: int, pack: int) -> int:
    """Place a member at the first suitable offset from `start_bits` on; return its end."""
    unit_bits = 8 * member.type.size
    if member.bit_width is None:
        start_bits = _rounded(start_bits, _wanted(member, pack))
        member.offset = start_bits // 8
        return start_bits + unit_bits
    natural = member.natural or member.type.align
    if member.bit_width == 0:
        return _rounded(start_bits, max(member.align, natural))
    if member.align:
        start_bits = _rounded(start_bits, _least(member.align, pack))
    crosses = start_bits % unit_bits + member.bit_width > unit_bits
    if crosses and not member.packed and not pack:
        start_bits = _rounded(start_bits, natural)
    member.offset = start_bits // unit_bits * member.type.size
    member.bit_offset = start_bits % unit_bits
    return start_bits + member.bit_width


def _spread(member: Member, size: int) -> None:
    """Divide a bit-field into single bytes if the unit it starts in does not contain it."""
    if not member.bit_width:
        return
    end = member.bit_offset + member.bit_width
    if end > 8 * member.type.size or member.offset + member.type.size > size:
        member.offset += member.bit_offset // 8
        member.bit_offset %= 8
        member.spread = -(-(member.bit_offset + member.bit_width) // 8)


def _rounded(bits: int, align: int) -> int:
    """Return the next multiple of an alignment [bytes]."""
    return -(-bits // (8 * align)) * 8 * align


def _least(align: int, pack: int) -> int:
    """Return an alignment, limited to that of `#pragma pack` if there is one."""
    return min(align, pack) if pack else align
