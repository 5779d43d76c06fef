"""The shadow memory of frames at function entry and exit, in checked builds.

Everything below the stack pointer is inaccessible, but for structs that are passed by value, whose
states are copied with them. A function makes accessible its slots, its other parameters in memory
and, if it is variadic, the variable arguments; at exit it makes them all inaccessible again. A
function that has only registers pays nothing.
"""

from __future__ import annotations

from typing import Final

from crs_cc.ir.instruction import ByteState, Lifetime, Slot
from crs_cc.ir.program import Function
from crs_cc.runtime.codegen import origins, same_object, shadow
from crs_cc.runtime.codegen.indices import FP, MEMORY, PASSED, SHADOW, SP, STATES
from crs_cc.runtime.codegen.inline_ranges import MAX_FILLED
from crs_cc.runtime.codegen.symbols import Symbols
from crs_cc.runtime.layout import HEADER_SIZE, RESULT, Frame
from crs_cc.runtime.sites import ARGUMENT_UNIT, FRAME_BITS, SITE_BITS
from crs_cc.runtime.wasm import Code, Instr


def passed() -> Code:
    """`passed(address, 0, size)`: make those arguments accessible whose states are not known."""
    address, size = 0, 2
    body: list[Instr] = [
        ("loop",),
        ("local.get", address), ("i32.load", SHADOW, 0), ("i32.eqz",),
        ("if",),
        ("local.get", address), shadow.repeated(ByteState.WITH_VALUE, ARGUMENT_UNIT),
        shadow.store(ARGUMENT_UNIT, 0), ("end",),
        ("local.get", address), ("i32.const", ARGUMENT_UNIT), ("i32.add",), ("local.set", address),
        ("local.get", size), ("i32.const", ARGUMENT_UNIT), ("i32.sub",), ("local.tee", size),
        ("i32.const", 0), ("i32.gt_s",), ("br_if", 0), ("end",),
    ]  # fmt: skip
    return Code("passed", (("i32", "i32", "i32"), ()), [], body)


MAX_STORES: Final = 32
"""Slots that need more stores than this are made inaccessible by one `memory.fill`."""

_SP: Final[Instr] = ("local.get", SP)


def lasting(function: Function) -> set[Slot]:
    """Return the slots whose lifetime is that of the function."""
    instructions = (it for block in function.blocks for it in block.instructions)
    return set(function.slots) - {it.slot for it in instructions if isinstance(it, Lifetime)}


def enter(function: Function, frame: Frame, names: Symbols) -> list[Instr]:
    """Return the code that makes a function's frame accessible."""
    code: list[Instr] = []
    always = lasting(function)
    for slot in function.slots:
        if slot in always:
            code += origins.begin(slot, frame.offsets[slot], function.location, names)
    for parameter in function.parameters:
        if isinstance(parameter.place, Slot):
            offset, size = frame.offsets[parameter.place], parameter.size
            given = shadow.fill(_SP, offset, size, ByteState.WITH_VALUE)
            code += given if parameter.memory else _unless_copied(offset, given)
    return code + _rest(function, frame, [("call", PASSED)])


def _unless_copied(offset: int, given: list[Instr]) -> list[Instr]:
    """Return the code for a struct, whose states the caller has copied if it knew the type."""
    if not given:
        return []
    return [_SP, shadow.load(1, offset), ("i32.eqz",), ("if",), *given, ("end",)]


def leave(function: Function, frame: Frame) -> list[Instr]:
    """Return the code that makes a function's frame inaccessible again."""
    gone = ByteState.INACCESSIBLE
    code: list[Instr] = []
    for slot in function.slots:
        code += shadow.fill(_SP, frame.offsets[slot], slot.size, gone)
    if function.slots:  # together with the red zones between them, if that is shorter
        start = min(frame.offsets[slot] for slot in function.slots)
        end = max(frame.offsets[slot] + slot.size for slot in function.slots)
        if end - start <= MAX_FILLED or len(code) > 3 * MAX_STORES:
            code = min(code, shadow.fill(_SP, start, end - start, gone), key=len)
    for slot in _parameters(function):
        code += shadow.fill(_SP, frame.offsets[slot], slot.size, gone)
    code += _rest(function, frame, [("memory.fill", SHADOW)])
    return [*code, *same_object.forget_last()] if code else code


def _parameters(function: Function) -> list[Slot]:
    return [each.place for each in function.parameters if isinstance(each.place, Slot)]


def _rest(function: Function, frame: Frame, change: list[Instr]) -> list[Instr]:
    """Change the states of the variable arguments, whose size is in the call word.

    `change` takes their address, the state `INACCESSIBLE` and their size.
    """
    if not function.variadic:
        return []
    named = frame.varargs - frame.size - HEADER_SIZE
    return [
        ("local.get", FP), ("i64.load", MEMORY, RESULT),
        ("i64.const", SITE_BITS + FRAME_BITS), ("i64.shr_u",), ("i32.wrap_i64",),
        ("i32.const", ARGUMENT_UNIT), ("i32.mul",), ("i32.const", named), ("i32.sub",),
        ("local.tee", STATES), ("i32.const", 0), ("i32.gt_s",), ("if",),
        _SP, ("i32.const", frame.varargs), ("i32.add",),
        ("i32.const", ByteState.INACCESSIBLE), ("local.get", STATES), *change,
        ("end",),
    ]  # fmt: skip
