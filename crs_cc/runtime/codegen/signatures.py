"""The functions that are compatible with a call through a pointer.

A callee reads its arguments as bytes, in the order of its parameters, whatever the caller passed.
It misreads them if it expects more than was passed, or one of another size or kind at the
same offset. Excess arguments are harmless, and common in C of the time.

Where a program calls a function by a pointer with a prototype, the function must also have a result
and parameters of the same kinds, unless it was itself defined without a prototype.
"""

from __future__ import annotations

from typing import NamedTuple, TypeAlias

from crs_cc.ir.instruction import Call, Register, Return
from crs_cc.ir.program import Function, Program
from crs_cc.ir.remembered import remembered
from crs_cc.ir.types import (
    CType,
    EnumType,
    FloatType,
    FunctionType,
    IntegerType,
    PointerType,
    RecordType,
)
from crs_cc.ir.value_type import MemoryType, ValueType

Shape: TypeAlias = tuple[str, ...]
"""The kinds of a call's arguments, in order: `word`, `f64`, `bytes 12`, ..."""


def _kind(memory: MemoryType | None, size: int) -> str:
    """Return the kind of an argument or parameter; integers and pointers are alike."""
    if memory is None:
        return f"bytes {size}"
    return memory if memory in {"i64", "f32", "f64"} else "word"


def call_shape(call: Call) -> Shape:
    """Return the kinds of a call's arguments; with a prototype, also those that it names."""
    passed = tuple(_kind(each.memory, each.size) for each in call.arguments)
    return passed if call.prototype is None else (*passed, "by", *_type_shape(call.prototype))


def _type_shape(ctype: FunctionType) -> Shape:
    """Return the kinds of the result and the parameters of a function with a prototype."""
    more = ("...",) if ctype.variadic else ()
    return (*map(_type_kind, (ctype.result, *(ctype.parameters or ()))), *more)


def _type_kind(ctype: CType) -> str:
    """Return the kind of a type: integers up to 4 bytes are alike, and so are pointers."""
    if isinstance(ctype, PointerType):
        return "pointer"
    if isinstance(ctype, IntegerType | FloatType | EnumType):
        return _kind(ctype.memory, ctype.size)
    return f"bytes {ctype.size}" if isinstance(ctype, RecordType) else "void"


def function_shape(function: Function) -> Shape:
    """Return the kinds of a function's parameters."""
    return tuple(_kind(each.memory, each.size) for each in function.parameters)


def is_compatible(shape: Shape, callee: Function) -> bool:
    """Return whether a function is compatible with the arguments passed, and has the type."""
    wanted = function_shape(callee)
    if shape[: len(wanted)] != wanted:
        return False
    ctype = callee.ctype
    if "by" not in shape or not isinstance(ctype, FunctionType) or ctype.parameters is None:
        return True
    return shape[shape.index("by") + 1 :] == _type_shape(ctype)


def pointer_tables(program: Program, pointers: list[str]) -> dict[Shape, bytes]:
    """Return, for each shape of calls through pointers, which of these functions are compatible.

    Args:
        program: the program.
        pointers: the functions that have a pointer, by its number minus 1.

    Returns:
        A byte for each pointer's number, 1 if compatible; no table if all are.
    """
    functions = program.functions
    shapes = dict.fromkeys(shape for each in functions.values() for shape in _pointer_calls(each))
    tables: dict[Shape, bytes] = {}
    for shape in shapes:
        right = [is_compatible(shape, functions[name]) for name in pointers]
        if not all(right):
            tables[shape] = bytes([0, *right])
    return tables


@remembered
def _pointer_calls(function: Function) -> list[Shape]:
    """Return the shapes of a function's calls through pointers."""
    calls = (block.terminator for block in function.blocks)
    return [
        call_shape(call)
        for call in calls
        if isinstance(call, Call) and isinstance(call.callee, Register)
    ]


class NamedCall(NamedTuple):
    """A function that is called by name, what it is passed, and the type of what is taken back."""

    callee: str
    shape: Shape
    result: ValueType | None


def named_call(call: Call) -> NamedCall | None:
    """Return how a call calls a function by name, if it does."""
    if not isinstance(call.callee, str):
        return None
    result = None if call.result is None else call.result.type
    return NamedCall(call.callee, call_shape(call), result)


@remembered
def named_calls(function: Function) -> list[NamedCall]:
    """Return a function's different calls of functions by name."""
    calls = (block.terminator for block in function.blocks)
    named = (named_call(call) for call in calls if isinstance(call, Call))
    return list(dict.fromkeys(call for call in named if call is not None))


@remembered
def ends_without_value(function: Function) -> bool:
    """Return whether a function may end without returning a value."""
    return any(
        isinstance(block.terminator, Return) and block.terminator.value is None
        for block in function.blocks
    )


def valueless_functions(program: Program, pointers: list[str]) -> set[str]:
    """Return the functions that may end without a value although it is used."""
    asked = set(pointers)
    for function in program.functions.values():
        asked.update(call.callee for call in named_calls(function) if call.result is not None)
    return {name for name in asked if ends_without_value(program.functions[name])}
