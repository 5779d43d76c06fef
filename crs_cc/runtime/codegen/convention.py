"""The calling convention: arguments and results in registers.

A function is `(fp, fuel, registers...) -> (fuel, value)`. Arguments have their places in memory,
see `layout`. Those of the first parameters that are plain variables are passed in registers, and
in run builds without checks in these only: the callee stores them when the program stops. Functions
that may look at their arguments as bytes, by `va_arg` or through the address of a parameter, are
passed all of them in memory.

A call whose arguments may be others than the parameters, like one through a pointer, passes them
all in memory to the function's general form, `(fp, fuel) -> fuel`, which loads them, and
leaves the value in the header.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from crs_cc.ir.instruction import Register
from crs_cc.ir.program import Function, Program
from crs_cc.ir.remembered import remembered
from crs_cc.ir.value_type import VALUE_TYPE, MemoryType, ValueType
from crs_cc.runtime.codegen.indices import FP, FUEL, MEMORY
from crs_cc.runtime.codegen.memory_instructions import LOADS, STORES
from crs_cc.runtime.codegen.signatures import NamedCall, Shape, function_shape, named_calls
from crs_cc.runtime.codegen.stopping import IS_STOPPED
from crs_cc.runtime.layout import HEADER_SIZE, RESULT, argument_offsets
from crs_cc.runtime.wasm import TYPE_CALL, Code, FuncType, Instr

MAX_WORDS: Final = 4
MAX_FLOATS: Final = 8
"""Limits on the integers and floating-point numbers that are passed in registers."""

GENERAL_FORM: Final = 16
"""What a frame is charged for the host's frame of the general form, see `registers` [bytes]."""

NARROW: Final[dict[MemoryType, list[Instr]]] = {
    "i8": [("i32.extend8_s",)],
    "i16": [("i32.extend16_s",)],
    "u8": [("i32.const", 255), ("i32.and",)],
    "u16": [("i32.const", 65535), ("i32.and",)],
}
"""What a parameter of a narrow type does to its argument."""


@dataclass(frozen=True, slots=True)
class Convention:
    """How a function is called.

    Attributes:
        shape: the kinds of its parameters.
        variadic: whether it takes more arguments.
        registers: for each parameter its type in memory if it is passed in a register, else None.
        result: the type of the returned value, if there is one.
        size: the size of its parameters, as `layout` places them [bytes].
    """

    shape: Shape
    variadic: bool
    registers: tuple[MemoryType | None, ...]
    result: ValueType | None
    size: int

    @property
    def type(self) -> FuncType:
        """The WebAssembly type."""
        passed = [VALUE_TYPE[each] for each in self.registers if each is not None]
        return ("i32", "i64", *passed), ("i64",) if self.result is None else ("i64", self.result)

    @property
    def is_general(self) -> bool:
        """Whether the function is its own general form."""
        return self.type == TYPE_CALL

    def matches(self, call: NamedCall) -> bool:
        """Return whether a call passes just the parameters, and takes the result."""
        right = call.shape == self.shape and not self.variadic
        return right and call.result in (None, self.result)


@remembered
def convention_of(function: Function) -> Convention:
    """Return how a function is called."""
    parameters = function.parameters
    in_bytes = function.variadic or any(
        each.memory is not None and not isinstance(each.place, Register) for each in parameters
    )
    left = {True: MAX_FLOATS, False: MAX_WORDS}
    registers: list[MemoryType | None] = []
    for each in parameters:
        is_float = each.memory in ("f32", "f64")
        passed = not in_bytes and each.memory is not None and left[is_float] > 0
        left[is_float] -= passed
        registers.append(each.memory if passed else None)
    size = argument_offsets([each.size for each in parameters])[-1]
    shape = function_shape(function)
    return Convention(shape, function.variadic, tuple(registers), function.result, size)


def needing_general_form(program: Program, conventions: dict[str, Convention]) -> set[str]:
    """Return the functions that some call by name needs the general form of."""
    return {
        call.callee
        for function in program.functions.values()
        for call in named_calls(function)
        if not conventions[call.callee].matches(call)
    }


def general_form(name: str, number: int, convention: Convention, sizes: list[int]) -> Code:
    """Return the general form of a function."""
    value = len(TYPE_CALL[0])
    body: list[Instr] = [("local.get", FP), ("local.get", FUEL)]
    offsets = argument_offsets(sizes)
    for memory, offset in zip(convention.registers, offsets, strict=False):
        if memory is not None:
            body += [("local.get", FP), (LOADS[memory], MEMORY, HEADER_SIZE + offset)]
    body.append(("call", number))
    if convention.result is None:
        return Code(name, TYPE_CALL, [], body)
    body += [("local.set", value), ("local.set", FUEL)]
    body += [*IS_STOPPED, ("i32.eqz",), ("if",), ("local.get", FP), ("local.get", value)]
    body += [(STORES[convention.result], MEMORY, RESULT), ("end",), ("local.get", FUEL)]
    return Code(name, TYPE_CALL, [convention.result], body)
