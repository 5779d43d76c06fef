"""Load, store and copy scalars and structs."""

from __future__ import annotations

from crs_cc.core.source import Location
from crs_cc.frontend.lower.lowerer import Lowering, Place, memory_type, value_type
from crs_cc.ir.instruction import Constant, Copy, Load, Operand, Register, Store
from crs_cc.ir.types import CType
from crs_cc.ir.value_type import MEMORY_SIZE


def load(
    low: Lowering,
    where: Place,
    ctype: CType,
    location: Location,
    into: Register | None = None,
    *,
    is_const: bool = False,
) -> Register:
    """Read a scalar from a place."""
    memory = memory_type(ctype)
    base, offset = low.access(where, MEMORY_SIZE[memory], location)
    result = low.register(value_type(ctype)) if into is None else into
    low.emit(Load(location, result, base, offset, memory, is_const=is_const))
    return result


def store(low: Lowering, where: Place, ctype: CType, source: Operand, location: Location) -> None:
    """Write a scalar to a place."""
    memory = memory_type(ctype)
    base, offset = low.access(where, MEMORY_SIZE[memory], location)
    low.emit(Store(location, base, offset, source, memory))


def copy(low: Lowering, target: Place, source: Place, size: int, location: Location) -> None:
    """Copy a struct."""
    if size > 0:
        to, of = low.address(target, location), low.address(source, location)
        low.emit(Copy(location, to, of, Constant("i32", size)))
