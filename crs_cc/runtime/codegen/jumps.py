"""C's `longjmp`: a suspension that resumes elsewhere immediately.

All functions unwind as if the program were suspended (see `function_code`). The target of the jump
stores another landing than that of its call, so that it continues there when `resume` calls the
outermost function again, which is invisible from outside. The frames that the jump has left are
below those that continue, and are dropped. Programs that never jump pay nothing.
"""

from __future__ import annotations

from typing import Final

from crs_cc.ir.value_type import ValueType
from crs_cc.requests import SUSPENDED
from crs_cc.runtime.codegen import failing
from crs_cc.runtime.codegen.indices import FUEL, LABEL, MEMORY, SP, STATUS
from crs_cc.runtime.wasm import Instr

JUMPED: Final = 3
"""Status of functions unwound by a jump; it never leaves `resume`."""

ACTIVATION, PLACE, VALUE, JUMP_SITE = range(5, 9)
"""Globals of a jump in progress; the activation becomes 0 when its function has been reached."""

GLOBALS: Final[list[tuple[ValueType, int]]] = [("i32", 0)] * 4

UNWINDING: Final = 4
"""Fuel for each function that a jump leaves and re-enters, about the time that it takes."""


def start(operands: list[Instr]) -> list[Instr]:
    """Return the start of a jump; `operands` push the values of the globals."""
    code: list[Instr] = []
    for operand, number in zip(operands, (ACTIVATION, PLACE, VALUE, JUMP_SITE), strict=True):
        code += [operand, ("global.set", number)]
    return [*code, ("i32.const", JUMPED), ("local.set", STATUS)]


def leave(activation: list[Instr], jump_value: int, left: list[Instr]) -> list[Instr]:
    """Return the epilogue code of a function that a jump leaves or targets.

    Args:
        activation: pushes the function's activation; empty when it has no `setjmp`.
        jump_value: offset from SP of the passed value.
        left: code to execute when the jump leaves the function.
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
    """Call the outermost function until it returns for a reason other than a jump.

    Args:
        root: index of the function.
        fp: address of its header.
        fuel: index of the i64 local with the fuel, in and out.
        status: index of the i32 local that receives the status.
    """
    return [
        ("loop",),
        ("i32.const", fp), ("local.get", fuel), ("call", root),
        ("local.set", fuel), ("local.tee", status), ("i32.const", JUMPED), ("i32.eq",), ("if",),
        ("global.get", ACTIVATION), ("if",),
        *failing.note(("global.get", JUMP_SITE), ("i32.const", 0)), ("local.set", status),
        ("else",),
        ("i32.const", SUSPENDED), ("local.set", status),
        ("local.get", fuel), ("i64.const", 0), ("i64.ge_s",), ("br_if", 2),
        ("end",), ("end",), ("end",),
    ]  # fmt: skip
