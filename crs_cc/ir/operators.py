"""The operators of the IR: WebAssembly's numeric instructions, with their types and opcodes.

One table serves the verifier (do the operand types fit?) and the code generator (which bytes?).

>>> OPERATORS["i64.lt_u"]
Operator(name='i64.lt_u', operands=('i64', 'i64'), result='i32', opcode=b'T')
>>> OPERATORS["f64.convert_i32_s"].operands, OPERATORS["f64.convert_i32_s"].result
(('i32',), 'f64')
>>> OPERATORS["i32.trunc_sat_f64_u"].opcode.hex()
'fc03'
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final, cast

from crs_cc.ir.value_type import ValueType


@dataclass(frozen=True, slots=True)
class Operator:
    """One operator.

    Attributes:
        name: its name in the WebAssembly text format.
        operands: the types of its operands: one for `Unary`, two for `Binary`.
        result: the type of its result.
        opcode: its bytes in a WebAssembly module (WebAssembly 2.0, section 5.4.7).
    """

    name: str
    operands: tuple[ValueType, ...]
    result: ValueType
    opcode: bytes


_INTEGER_TESTS: Final = "eq ne lt_s lt_u gt_s gt_u le_s le_u ge_s ge_u"
_FLOAT_TESTS: Final = "eq ne lt gt le ge"
_INTEGER_UNARY: Final = "clz ctz popcnt"
_INTEGER_BINARY: Final = "add sub mul div_s div_u rem_s rem_u and or xor shl shr_s shr_u rotl rotr"
_FLOAT_UNARY: Final = "abs neg ceil floor trunc nearest sqrt"
_FLOAT_BINARY: Final = "add sub mul div min max copysign"

_TESTS: Final = (
    (0x45, "i32", 1, "eqz"), (0x46, "i32", 2, _INTEGER_TESTS),
    (0x50, "i64", 1, "eqz"), (0x51, "i64", 2, _INTEGER_TESTS),
    (0x5B, "f32", 2, _FLOAT_TESTS), (0x61, "f64", 2, _FLOAT_TESTS),
)  # fmt: skip
_ARITHMETIC: Final = (
    (0x67, "i32", 1, _INTEGER_UNARY), (0x6A, "i32", 2, _INTEGER_BINARY),
    (0x79, "i64", 1, _INTEGER_UNARY), (0x7C, "i64", 2, _INTEGER_BINARY),
    (0x8B, "f32", 1, _FLOAT_UNARY), (0x92, "f32", 2, _FLOAT_BINARY),
    (0x99, "f64", 1, _FLOAT_UNARY), (0xA0, "f64", 2, _FLOAT_BINARY),
    (0xC0, "i32", 1, "extend8_s extend16_s"), (0xC2, "i64", 1, "extend8_s extend16_s extend32_s"),
)  # fmt: skip
_CONVERSIONS: Final = (
    (0xA7, "i32", "wrap_i64 trunc_f32_s trunc_f32_u trunc_f64_s trunc_f64_u"),
    (0xAC, "i64",
     "extend_i32_s extend_i32_u trunc_f32_s trunc_f32_u trunc_f64_s trunc_f64_u"),
    (0xB2, "f32", "convert_i32_s convert_i32_u convert_i64_s convert_i64_u demote_f64"),
    (0xB7, "f64", "convert_i32_s convert_i32_u convert_i64_s convert_i64_u promote_f32"),
    (0xBC, "i32", "reinterpret_f32"), (0xBD, "i64", "reinterpret_f64"),
    (0xBE, "f32", "reinterpret_i32"), (0xBF, "f64", "reinterpret_i64"),
)  # fmt: skip
_SATURATING: Final = (
    (0x00, "i32", "trunc_sat_f32_s trunc_sat_f32_u trunc_sat_f64_s trunc_sat_f64_u"),
    (0x04, "i64", "trunc_sat_f32_s trunc_sat_f32_u trunc_sat_f64_s trunc_sat_f64_u"),
)


def _source_type(conversion: str) -> ValueType:
    """Return the operand type of a conversion, which is part of its name."""
    found = next(part for part in conversion.split("_") if part in {"i32", "i64", "f32", "f64"})
    return cast("ValueType", found)


def _operators() -> Iterator[Operator]:
    for first, prefix, arity, names in (*_TESTS, *_ARITHMETIC):
        type_ = cast("ValueType", prefix)
        result: ValueType = "i32" if (first, prefix, arity, names) in _TESTS else type_
        for opcode, name in enumerate(names.split(), first):
            yield Operator(f"{type_}.{name}", (type_,) * arity, result, bytes([opcode]))
    for lead, rows in ((b"", _CONVERSIONS), (b"\xfc", _SATURATING)):
        for first, prefix, names in rows:
            type_ = cast("ValueType", prefix)
            for opcode, name in enumerate(names.split(), first):
                operands = (_source_type(name),)
                yield Operator(f"{type_}.{name}", operands, type_, lead + bytes([opcode]))


OPERATORS: Final[dict[str, Operator]] = {operator.name: operator for operator in _operators()}
"""Every operator by its name."""
