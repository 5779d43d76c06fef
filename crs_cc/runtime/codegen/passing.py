"""How a call passes its arguments: the caller stores them and the callee's header, see `layout`."""

from __future__ import annotations

from crs_cc.ir.instruction import Call, Constant
from crs_cc.ir.program import Function
from crs_cc.runtime.codegen.build import Build
from crs_cc.runtime.codegen.indices import SP
from crs_cc.runtime.codegen.plain_memory import PlainMemory
from crs_cc.runtime.codegen.symbols import Symbols
from crs_cc.runtime.layout import FUNCTION, HEADER_SIZE, RESULT, RESUME, argument_offsets
from crs_cc.runtime.sites import CallSite, call_word


def arguments_size(function: Function, names: Symbols) -> int:
    """Return the maximum size of the arguments of all calls; -1 if there are no calls.

    A callee may have more parameters than it is passed arguments.
    """
    most = -1
    for block in function.blocks:
        call = block.terminator
        if isinstance(call, Call):
            passed = argument_offsets([argument.size for argument in call.arguments])[-1]
            wanted = names.parameters.get(call.callee, 0)  # type: ignore[arg-type]
            most = max(most, passed, wanted)
    return most


def pass_arguments(call: Call, caller: str, memory: PlainMemory, build: Build) -> None:
    """Store the arguments of a call, and its header; `memory` is accessed by the caller."""
    writer = memory.writer
    offsets = argument_offsets([argument.size for argument in call.arguments])
    for argument, offset in zip(call.arguments, offsets, strict=False):
        at = HEADER_SIZE + offset
        if argument.memory:
            writer.store_at(SP, at, argument.value, argument.memory)
            continue
        size = Constant("i32", argument.size)
        memory.argument(argument.value, at, size, call.location)
    if build.checked:
        number = writer.names.call_number(CallSite(caller, call.location))
        word = call_word(number, writer.frame.size, offsets[-1])
        writer.store_at(SP, RESULT, Constant("i64", word), "i64")
    if build.checked or build.debug:
        writer.store_at(SP, FUNCTION, Constant("i64", 0), "i64")
    else:
        writer.store_at(SP, RESUME, Constant("i32", 0), "i32")
