"""Which functions a call through a pointer may reach without misreading its arguments.

A callee finds its arguments as bytes, in the order of its parameters, whatever the caller passed.
It misreads them when it expects more than was passed, or something of another size or kind at the
same place. What is passed in excess does no harm; C of the time does so.
"""

from __future__ import annotations

from typing import TypeAlias

from crs_cc.ir.program import Call, Function, MemoryType, Program, Register, Return

Shape: TypeAlias = tuple[str, ...]
"""The kinds of the arguments of a call, one after the other: `word`, `f64`, `bytes 12`, ..."""


def _kind(memory: MemoryType | None, size: int) -> str:
    """Return the kind of an argument or parameter; integers and pointers of up to 4 bytes alike."""
    if memory is None:
        return f"bytes {size}"
    return memory if memory in {"i64", "f32", "f64"} else "word"


def call_shape(call: Call) -> Shape:
    """Return what a call passes."""
    return tuple(_kind(each.memory, each.size) for each in call.arguments)


def is_understood(shape: Shape, callee: Function) -> bool:
    """Return whether a function reads its arguments as they were passed."""
    wanted = tuple(_kind(each.memory, each.size) for each in callee.parameters)
    return shape[: len(wanted)] == wanted


def pointer_tables(program: Program, pointers: list[str]) -> dict[Shape, bytes]:
    """Return for each shape of calls through pointers which of these functions understand it.

    Args:
        program: the program.
        pointers: the functions that have a pointer, by its number less 1.

    Returns:
        A byte for each pointer's number, 1 where the call is right; no table where all are.
    """
    tables: dict[Shape, bytes] = {}
    for function in program.functions.values():
        for block in function.blocks:
            call = block.terminator
            if isinstance(call, Call) and isinstance(call.callee, Register):
                shape = call_shape(call)
                right = [is_understood(shape, program.functions[name]) for name in pointers]
                if not all(right):
                    tables[shape] = bytes([0, *right])
    return tables


def ends_without_value(function: Function) -> bool:
    """Return whether a function may end without giving a value."""
    return any(
        isinstance(block.terminator, Return) and block.terminator.value is None
        for block in function.blocks
    )


def asked_for_values(program: Program, pointers: list[str]) -> set[str]:
    """Return the functions that may end without a value which somebody uses."""
    asked = set(pointers)
    for function in program.functions.values():
        for block in function.blocks:
            call = block.terminator
            if isinstance(call, Call) and isinstance(call.callee, str) and call.result is not None:
                asked.add(call.callee)
    return {name for name in asked if ends_without_value(program.functions[name])}
