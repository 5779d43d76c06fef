"""C's `longjmp`: a suspension that goes on elsewhere, at once.

All functions leave as if the program were suspended (see `function_code`). The one that the jump
names notes another landing than that of its call, so that it goes on there when `resume` calls the
outermost function again, without anybody outside noticing. What the jump has left behind lies
below the frames that go on, and is forgotten. Nothing of this costs a program that never jumps.
"""

from __future__ import annotations

from typing import Final

from crs_cc.ir.value_type import ValueType
from crs_cc.requests import SUSPENDED
from crs_cc.runtime.codegen.indices import FAULT, FUEL, LABEL, MEMORY, SP, STATUS
from crs_cc.runtime.wasm import Instr

JUMPED: Final = 3
"""Status of functions on the way of a jump; it never leaves `resume`."""

ACTIVATION, PLACE, VALUE, JUMP_SITE = range(5, 9)
"""Globals of a jump on its way; the activation becomes 0 when its function has been found."""

GLOBALS: Final[list[tuple[ValueType, int]]] = [("i32", 0)] * 4

UNWINDING: Final = 4
"""Fuel for each function that a jump leaves and enters again, about the time that it takes."""


def start(operands: list[Instr]) -> list[Instr]:
    """Begin a jump; `operands` push the values of the globals."""
    code: list[Instr] = []
    for operand, number in zip(operands, (ACTIVATION, PLACE, VALUE, JUMP_SITE), strict=True):
        code += [operand, ("global.set", number)]
    return [*code, ("i32.const", JUMPED), ("local.set", STATUS)]


def leave(activation: list[Instr], jump_value: int, left: list[Instr]) -> list[Instr]:
    """Return what a function does on the way out when a jump leaves it, or leads to it.

    Args:
        activation: pushes the function's activation; empty when it has no `setjmp`.
        jump_value: offset from SP of what takes the value.
        left: what to do when the jump goes further out.
    """
    found: list[Instr] = []
    if activation:
        found = [
            *activation, ("global.get", ACTIVATION), ("i32.eq",), ("if",),
            ("global.get", PLACE), ("local.set", LABEL),
            ("local.get", SP), ("global.get", VALUE), ("i32.store", MEMORY, jump_value),
            ("i32.const", 0), ("global.set", ACTIVATION),
            ("end",),
        ]  # fmt: skip
    return [
        ("local.get", STATUS), ("i32.const", JUMPED), ("i32.eq",), ("if",),
        ("local.get", FUEL), ("i64.const", UNWINDING), ("i64.sub",), ("local.set", FUEL),
        *found,
        *([("global.get", ACTIVATION), ("if",), *left, ("end",)] if left else []),
        ("end",),
    ]  # fmt: skip


def call_root(root: int, fp: int, *, fuel: int, status: int) -> list[Instr]:
    """Call the outermost function until it comes back for another reason than a jump.

    Args:
        root: index of the function.
        fp: address of its header.
        fuel: index of the i64 local with the fuel, in and out.
        status: index of the i32 local that takes the status.
    """
    return [
        ("loop",),
        ("i32.const", fp), ("local.get", fuel), ("call", root),
        ("local.set", fuel), ("local.tee", status), ("i32.const", JUMPED), ("i32.eq",), ("if",),
        ("global.get", ACTIVATION), ("if",),
        ("global.get", JUMP_SITE), ("i32.const", 0), ("call", FAULT), ("local.set", status),
        ("else",),
        ("i32.const", SUSPENDED), ("local.set", status),
        ("local.get", fuel), ("i64.const", 0), ("i64.ge_s",), ("br_if", 2),
        ("end",), ("end",), ("end",),
    ]  # fmt: skip
