"""The instructions that access memory, by the type of what they access."""

from __future__ import annotations

from typing import Final

from crs_cc.ir.value_type import MemoryType

LOADS: Final[dict[MemoryType, str]] = {
    "i8": "i32.load8_s", "u8": "i32.load8_u", "i16": "i32.load16_s", "u16": "i32.load16_u",
    "i32": "i32.load", "i64": "i64.load", "f32": "f32.load", "f64": "f64.load",
}  # fmt: skip
STORES: Final[dict[MemoryType, str]] = {
    "i8": "i32.store8", "u8": "i32.store8", "i16": "i32.store16", "u16": "i32.store16",
    "i32": "i32.store", "i64": "i64.store", "f32": "f32.store", "f64": "f64.store",
}  # fmt: skip
