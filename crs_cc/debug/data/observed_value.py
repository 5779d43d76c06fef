"""The value of an evaluated expression with the memory that it depends on."""

from __future__ import annotations

from typing import Any, Final

from crs_cc.debug.data.instruction_steps import SCRATCH
from crs_cc.debug.data.interpret import Interpreter, result_bytes
from crs_cc.debug.data.memory import StoppedMemory
from crs_cc.debug.data.observation import Observation
from crs_cc.debug.data.operators import unsigned
from crs_cc.frontend.expression import CompiledExpression
from crs_cc.ir.instruction import ByteState
from crs_cc.ir.types import ArrayType, RecordType

_WITHOUT: Final = bytes([ByteState.WITHOUT_VALUE])


def observed(
    compiled: CompiledExpression, result: Any, memory: StoppedMemory, interpreter: Interpreter
) -> Observation:
    """Return the value of an expression that has just been evaluated, with its reads recorded.

    Raises:
        EvaluationError: it cannot be read.
    """
    reads, ctype = memory.reads, compiled.type
    assert reads is not None
    address = unsigned(result, 32) if compiled.is_place else SCRATCH
    if address >= SCRATCH:
        if compiled.is_place:
            content = interpreter.scratch(address, ctype.size)
        else:
            content = result_bytes(ctype, result)
        states = _WITHOUT * len(content) if reads.is_unset else b""
        return Observation((content, states), None, reads.in_program())
    spans, is_whole = reads.in_program(), not isinstance(ctype, ArrayType | RecordType)
    content = memory.read(address, ctype.size, judged=is_whole)
    states = b"" if is_whole else memory.states(address, ctype.size)
    if reads.is_unset:
        states = _WITHOUT * ctype.size
    return Observation((content, states), (address, ctype.size), spans)
