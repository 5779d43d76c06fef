"""How a call passes its arguments: the caller stores them and the callee's header, see `layout`."""

from __future__ import annotations

from collections.abc import Sequence

from crs_cc.ir.instruction import Argument, Call, Constant, Register, passed_state
from crs_cc.ir.program import Function
from crs_cc.ir.types import CType
from crs_cc.runtime.codegen import shadow
from crs_cc.runtime.codegen.build import Build
from crs_cc.runtime.codegen.call_checks import may_lack_value
from crs_cc.runtime.codegen.indices import SP
from crs_cc.runtime.codegen.plain_memory import PlainMemory
from crs_cc.runtime.codegen.symbols import Symbols
from crs_cc.runtime.layout import FUNCTION, HEADER_SIZE, RESULT, argument_offsets
from crs_cc.runtime.sites import CallSite, call_word
from crs_cc.runtime.wasm import Instr


def arguments_size(function: Function, names: Symbols) -> int:
    """Return the maximum size of the arguments of all calls; -1 if there are no calls.

    A callee may have more parameters than it is passed arguments.
    """
    most = -1
    for block in function.blocks:
        call = block.terminator
        if isinstance(call, Call):
            passed = argument_offsets([argument.size for argument in call.arguments])[-1]
            most = max(most, passed)
            if isinstance(call.callee, str):
                most = max(most, names.conventions[call.callee].size)
    return most


def pass_arguments(
    call: Call, caller: str, memory: PlainMemory, build: Build, *, in_registers: Sequence[bool]
) -> None:
    """Store the arguments of a call, and its header.

    Args:
        call: the call.
        caller: the calling function, whose accesses `memory` writes.
        memory: accesses memory.
        build: how the function is compiled.
        in_registers: which arguments are passed in registers.
    """
    writer = memory.writer
    offsets = argument_offsets([argument.size for argument in call.arguments])
    rows = zip(call.arguments, offsets[:-1], in_registers, strict=True)
    for argument, offset, in_register in rows:
        at = HEADER_SIZE + offset
        if argument.memory is None:
            size = Constant("i32", argument.size)
            memory.argument(argument.value, at, size, call.location)
        elif build.debug or not in_register:
            writer.store_at(SP, at, argument.value, argument.memory)
        if build.checked and argument.ctype is not None and _is_variadic(call, writer.names):
            writer.code += _states(argument, argument.ctype, at)
    if build.checked:
        types = tuple(each.ctype for each in call.arguments if each.ctype is not None)
        number = writer.names.call_number(CallSite(caller, call.location, types))
        word = call_word(number, writer.frame.size, offsets[-1])
        writer.store_at(SP, RESULT, Constant("i64", word), "i64")
    if build.debug or may_lack_value(writer.names, call):
        writer.store_at(SP, FUNCTION, Constant("i64", 0), "i64")


def _is_variadic(call: Call, names: Symbols) -> bool:
    """Return whether the function called, whatever is declared, makes its arguments accessible."""
    return isinstance(call.callee, Register) or names.conventions[call.callee].variadic


def _states(argument: Argument, ctype: CType, offset: int) -> list[Instr]:
    """Set states of a variable argument at SP + `offset`: of a struct, that of its first byte."""
    sp: Instr = ("local.get", SP)
    state = passed_state(ctype)
    assert state is not None
    if argument.memory is not None:
        return shadow.fill(sp, offset, argument.size, state)
    if argument.size == 0:
        return []
    first = [sp, shadow.load(1, offset), ("i32.const", state), ("i32.and",)]
    return [sp, *first, shadow.store(1, offset)]
