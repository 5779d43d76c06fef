"""The value of a call that has just returned, by the function's type."""

from __future__ import annotations

from crs_cc.debug.data.values import Value, ValueReader
from crs_cc.ir.types import FunctionType, RecordType, VoidType
from crs_cc.runtime.diagnosis.inspect import StackFrame, StoppedProgram
from crs_cc.runtime.layout import HEADER_SIZE, RESULT


def returned_value(stopped: StoppedProgram, reader: ValueReader, call: StackFrame) -> Value | None:
    """Return the value of a call, directly after it; None if it has none.

    Only there the header of the callee, which has the value, is still intact (see `layout`).

    Args:
        stopped: the program.
        reader: what reads its memory.
        call: the frame of the call as it was before it returned.
    """
    ctype = stopped.compiled.info(call.function).function.ctype
    if stopped.stack_pointer() != call.fp or not isinstance(ctype, FunctionType):
        return None
    if isinstance(ctype.result, VoidType):
        return None
    if isinstance(ctype.result, RecordType):  # the first argument is where it goes
        return reader.value(_word(stopped, call.fp + HEADER_SIZE), ctype.result)
    start = call.fp + RESULT
    return Value(reader, ctype.result, stopped.memory[start : start + ctype.result.size].tobytes())


def _word(stopped: StoppedProgram, address: int) -> int:
    return int(stopped.memory[address : address + 4].view("<i4")[0])
