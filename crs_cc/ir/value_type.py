"""The types of values in registers and of scalars in memory."""

from __future__ import annotations

from typing import Final, Literal, TypeAlias

ValueType: TypeAlias = Literal["i32", "i64", "f32", "f64"]
MemoryType: TypeAlias = Literal["i8", "u8", "i16", "u16", "i32", "i64", "f32", "f64"]

MEMORY_SIZE: Final[dict[MemoryType, int]] = {
    "i8": 1, "u8": 1, "i16": 2, "u16": 2, "i32": 4, "i64": 8, "f32": 4, "f64": 8,
}  # fmt: skip
VALUE_TYPE: Final[dict[MemoryType, ValueType]] = {
    "i8": "i32", "u8": "i32", "i16": "i32", "u16": "i32",
    "i32": "i32", "i64": "i64", "f32": "f32", "f64": "f64",
}  # fmt: skip
