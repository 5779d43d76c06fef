"""Slices of arrays and of what pointers point to, as arrays of their own."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Final

from crs_cc.debug.data.notation import Slice
from crs_cc.debug.data.operators import unsigned
from crs_cc.debug.data.values import Value
from crs_cc.debug.errors import DebugError
from crs_cc.ir.types import ArrayType, CType, PointerType, is_complete

MAX_ELEMENTS: Final = 100_000
"""Longer slices are refused."""


@dataclass(frozen=True, slots=True)
class Row:
    """A row of elements in memory.

    Attributes:
        address: that of the first one.
        type: the type of the row.
        first: the number of the first element in the whole array.
    """

    address: int
    type: ArrayType
    first: int


def row_of(wanted: Slice, part: Callable[[str], Value]) -> Row:
    """Return the row that a slice means.

    Args:
        wanted: the slice.
        part: evaluates a part of it.

    Raises:
        DebugError: it is not an array of objects in memory.
    """
    base = part(wanted.base)
    first = _whole(wanted.first, part)
    if not wanted.last:
        return _row(base.type, base.address, 0, first)
    last = _whole(wanted.last, part)
    if isinstance(base.type, ArrayType):
        return _row(base.type.element, base.address, first, last - first + 1)
    if isinstance(base.type, PointerType) and isinstance(base.number, int):
        return _row(base.type.target, base.number, first, last - first + 1)
    raise DebugError(f"'{wanted.base}' is neither an array nor a pointer")


def _row(ctype: CType, address: int | None, first: int, count: int) -> Row:
    if address is None or not is_complete(ctype):
        raise DebugError("only objects in memory can form a slice")
    if not 0 < count <= MAX_ELEMENTS:
        raise DebugError(f"invalid slice length {count:,} (expected 1 to {MAX_ELEMENTS:,})")
    return Row(unsigned(address + first * ctype.size, 32), ArrayType(ctype, count), first)


def _whole(text: str, part: Callable[[str], Value]) -> int:
    value = part(text)
    if not isinstance(value.number, int) or isinstance(value.type, PointerType):
        raise DebugError(f"'{text}' is not an integer")
    return value.number
