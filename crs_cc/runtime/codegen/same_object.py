"""The check that two pointers point to the same object when they are compared or subtracted.

Between two objects there is a gap of inaccessible bytes, so pointers are to one object if all bytes
from one to the other are accessible. A pointer right after an object is that object's. What was
found is kept: the range in which two pointers are last known to be in one object, and two ranges
outside the stack. Nothing makes bytes inaccessible there but the allocator, and nothing on the
stack but ends of scopes and of functions.

Only pointers that are to two different objects are reported. One to no object at all, such as one
before the start of an array, where loops that count down end, is left alone.
"""

from __future__ import annotations

from typing import Final

from crs_cc.ir.value_type import ValueType
from crs_cc.runtime.codegen import large_functions
from crs_cc.runtime.codegen.indices import GAP, SHADOW
from crs_cc.runtime.layout import STACK_TOP
from crs_cc.runtime.wasm import Code, FuncType, Instr

LONGEST: Final = 1 << 20
"""Pointers further apart than this are not checked [bytes]."""

STEP, WIDE_STEP, NARROW_PART = 16, 32, 128
"""Every gap has as many bytes as a step; behind an object of `NARROW_PART` it has a wide one, see
`layout.red_zone` and the headers of the heap's blocks."""

_AHEAD: Final = 256
"""How much more of an object is looked at first, so that the next pointer is known [bytes]."""

LAST, LAST_SPAN, FIRST_KEPT, FIRST_SPAN, SECOND_KEPT, SECOND_SPAN = range(
    large_functions.END, large_functions.END + 6
)
"""The globals: where each range starts, and its size."""

_RANGES: Final = ((LAST, LAST_SPAN), (FIRST_KEPT, FIRST_SPAN), (SECOND_KEPT, SECOND_SPAN))

GLOBALS: Final[list[tuple[ValueType, int]]] = [("i32", 0)] * 6


def forget_last() -> list[Instr]:
    """Discard the range that may be on the stack, in favour of one that is not."""
    return [
        ("global.get", FIRST_KEPT), ("global.set", LAST),
        ("global.get", FIRST_SPAN), ("global.set", LAST_SPAN),
    ]  # fmt: skip


def forget_all() -> list[Instr]:
    """Discard all ranges."""
    code: list[Instr] = []
    for _, span in _RANGES:
        code += [("i32.const", 0), ("global.set", span)]
    return code


def forget_at(address: Instr) -> list[Instr]:
    """Discard the ranges with the byte at an address, from which on bytes become inaccessible."""
    code: list[Instr] = []
    for start, span in _RANGES[1:]:
        code += [("i32.const", 0), ("global.get", span)]
        code += [address, ("global.get", start), ("i32.sub",), ("global.get", span), ("i32.le_u",)]
        code += [("select",), ("global.set", span)]
    return [*code, *forget_last()]


def is_new(left: Instr, right: Instr) -> list[Instr]:
    """Push whether two pointers are not both in the range that was found last."""
    return [*_outside(left, LAST, LAST_SPAN), *_outside(right, LAST, LAST_SPAN), ("i32.or",)]


def _outside(pointer: Instr, start: int, span: int) -> list[Instr]:
    return [
        pointer, ("global.get", start), ("i32.sub",), ("global.get", span), ("i32.gt_u",),
    ]  # fmt: skip


def gap() -> Code:
    """`gap(start, end)`: the first inaccessible byte that is found from one to the other, or 0."""
    start, end, at = 0, 1, 2
    body = [
        ("local.get", start), ("local.set", at),
        ("block",), ("loop",),
        ("local.get", at), ("local.get", end), ("i32.ge_u",), ("br_if", 1),
        ("local.get", at), ("i32.load8_u", SHADOW, 0), ("i32.eqz",),
        ("if",), ("local.get", at), ("return",), ("end",),
        ("local.get", at), ("i32.const", STEP), ("i32.const", WIDE_STEP),
        ("local.get", at), ("local.get", start), ("i32.sub",),
        ("i32.const", NARROW_PART), ("i32.lt_u",), ("select",), ("i32.add",), ("local.set", at),
        ("br", 0), ("end",), ("end",), ("i32.const", 0),
    ]  # fmt: skip
    return Code("gap", (("i32", "i32"), ("i32",)), ["i32"], body)


_TYPE: Final[FuncType] = (("i32", "i32", "i32"), ("i32",))
_LEFT, _RIGHT, _SIZE, _LOW, _HIGH, _END, _FOUND, _START = range(8)


def unrelated() -> Code:
    """`unrelated(left, right, size)`: whether they point to two different objects.

    Null is compared with everything, as gcc's sanitizer has it by default. A pointer that is
    less than `size` before the object of the other is where a loop that counts down ends.
    """
    low, high = ("local.get", _LOW), ("local.get", _HIGH)
    body: list[Instr] = [
        ("local.get", _LEFT), ("i32.eqz",), ("local.get", _RIGHT), ("i32.eqz",), ("i32.or",),
        *_return_if(0),
        ("local.get", _LEFT), ("local.get", _RIGHT),
        ("local.get", _LEFT), ("local.get", _RIGHT), ("i32.lt_u",), ("select",),
        ("local.set", _LOW),
        ("local.get", _RIGHT), ("local.get", _LEFT),
        ("local.get", _LEFT), ("local.get", _RIGHT), ("i32.lt_u",), ("select",),
        ("local.set", _HIGH),
        *_recall(FIRST_KEPT, FIRST_SPAN), *_recall(SECOND_KEPT, SECOND_SPAN),
        high, low, ("i32.sub",), ("i32.const", LONGEST), ("i32.gt_u",), *_return_if(0),
        low, high, ("call", GAP), ("i32.eqz",),
        ("if",), *_keep(), ("i32.const", 0), ("return",), ("end",),
        *_in_no_object(low), *_in_no_object(high), ("i32.or",), *_return_if(0),
        low, ("local.get", _SIZE), ("i32.add",), high, ("call", GAP),
        ("i32.const", 0), ("i32.ne",),
    ]  # fmt: skip
    return Code("unrelated", _TYPE, ["i32"] * 5, body)


def _return_if(result: int) -> list[Instr]:
    return [("if",), ("i32.const", result), ("return",), ("end",)]


def _recall(start: int, span: int) -> list[Instr]:
    """Make a range that was kept the last one, and return, if both pointers are in it."""
    low, high = ("local.get", _LOW), ("local.get", _HIGH)
    return [
        *_outside(low, start, span), *_outside(high, start, span), ("i32.or",), ("i32.eqz",),
        ("if",),
        ("global.get", start), ("global.set", LAST),
        ("global.get", span), ("global.set", LAST_SPAN),
        ("i32.const", 0), ("return",), ("end",),
    ]  # fmt: skip


def _keep() -> list[Instr]:
    """Keep the range between the pointers, and what follows it in the same object.

    A range that has one of them already grows by twice its size: so all comparisons in an object
    look at each of its bytes a few times only.
    """
    low, high = ("local.get", _LOW), ("local.get", _HIGH)
    start, end, ahead = ("local.get", _START), ("local.get", _END), ("local.get", _FOUND)
    code: list[Instr] = [low, ("local.set", _START)]
    code += [high, low, ("i32.sub",), ("i32.const", _AHEAD), ("i32.add",), ("local.set", _FOUND)]
    for kept, span in _RANGES:
        code += [*_outside(low, kept, span), ("i32.eqz",), ("if",)]
        code += [("global.get", kept), ("local.set", _START)]
        code += [("global.get", span), ("i32.const", 1), ("i32.shl",), ahead]
        code += [("i32.add",), ("local.set", _FOUND), ("end",)]
    code += [
        high, ahead, ("i32.const", LONGEST), ahead, ("i32.const", LONGEST), ("i32.lt_u",),
        ("select",), ("i32.add",), ("local.set", _END),
        high, end, ("call", GAP), ("local.tee", _FOUND),
        ("if",),
        ahead, ("i32.const", WIDE_STEP), ("i32.sub",), high,
        ahead, high, ("i32.sub",), ("i32.const", WIDE_STEP), ("i32.gt_u",), ("select",),
        ("local.set", _END), ("end",),
        start, ("global.set", LAST), end, start, ("i32.sub",), ("global.set", LAST_SPAN),
        start, ("i32.const", STACK_TOP), ("i32.ge_u",),
        ("if",),
        start, ("global.get", FIRST_KEPT), ("i32.ne",),
        ("if",),
        ("global.get", FIRST_KEPT), ("global.set", SECOND_KEPT),
        ("global.get", FIRST_SPAN), ("global.set", SECOND_SPAN), ("end",),
        ("global.get", LAST), ("global.set", FIRST_KEPT),
        ("global.get", LAST_SPAN), ("global.set", FIRST_SPAN), ("end",),
    ]  # fmt: skip
    return code


def _in_no_object(pointer: Instr) -> list[Instr]:
    """Push whether a pointer is neither to an accessible byte nor right after one."""
    return [
        pointer, ("i32.load8_u", SHADOW, 0),
        pointer, ("i32.const", 1), ("i32.sub",), ("i32.load8_u", SHADOW, 0),
        ("i32.or",), ("i32.eqz",),
    ]  # fmt: skip
