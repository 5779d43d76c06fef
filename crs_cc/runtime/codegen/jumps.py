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
from crs_cc.runtime.codegen import failing, stopping
from crs_cc.runtime.codegen.indices import FUEL, LABEL, MEMORY, SP, STATUS_GLOBAL
from crs_cc.runtime.wasm import Instr

JUMPED: Final = 3
"""Status of functions unwound by a jump; it never leaves `resume`."""

ACTIVATION, PLACE, VALUE, JUMP_SITE = range(6, 10)
"""Globals of a jump in progress; the activation becomes 0 when its function has been reached."""

GLOBALS: Final[list[tuple[ValueType, int]]] = [("i32", 0)] * 4

UNWINDING: Final = 4
"""Fuel for each function that a jump leaves and re-enters, about the time that it takes."""


def start(operands: list[Instr]) -> list[Instr]:
    """Return the start of a jump; `operands` push the values of the globals."""
    code: list[Instr] = []
    for operand, number in zip(operands, (ACTIVATION, PLACE, VALUE, JUMP_SITE), strict=True):
        code += [operand, ("global.set", number)]
    return [*code, *stopping.status(JUMPED)]


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
        ("global.get", STATUS_GLOBAL), ("i32.const", JUMPED), ("i32.eq",), ("if",),
        ("local.get", FUEL), ("i64.const", UNWINDING), ("i64.sub",), ("local.set", FUEL),
        *found,
        *([("global.get", ACTIVATION), ("if",), *left, ("end",)] if left else []),
        ("end",),
    ]  # fmt: skip


def call_root(root: int, fp: int, *, status: int) -> list[Instr]:
    """Resume the outermost function until it stops for a reason other than a jump.

    Args:
        root: index of its general form.
        fp: address of its header.
        status: index of the i32 local that receives why it has stopped; 0 if it has returned.
    """
    return [
        ("loop",),
        ("i32.const", fp), *stopping.PUSH_STOPPED, ("call", root), ("local.set", FUEL),
        ("i32.const", 0), ("local.set", status),
        *stopping.IS_STOPPED, ("if",),
        *stopping.RESTORE,
        ("global.get", STATUS_GLOBAL), ("local.tee", status),
        ("i32.const", JUMPED), ("i32.eq",), ("if",),
        ("global.get", ACTIVATION), ("if",),
        *failing.note(("global.get", JUMP_SITE), ("i32.const", 0)), ("local.set", status),
        ("else",),
        ("i32.const", SUSPENDED), ("local.set", status),
        *stopping.IS_NEGATIVE, ("i32.eqz",), ("br_if", 3),
        ("end",), ("end",), ("end",), ("end",),
    ]  # fmt: skip
