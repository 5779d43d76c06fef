"""Checks around a call: a function pointer that is valid, a callee that has returned a value."""

from __future__ import annotations

from typing import Final

from crs_cc.ir.instruction import Call, Register
from crs_cc.runtime.codegen.indices import MEMORY, SP
from crs_cc.runtime.codegen.signatures import call_shape
from crs_cc.runtime.codegen.symbols import Symbols
from crs_cc.runtime.codegen.writer import Writer
from crs_cc.runtime.layout import FUNCTION
from crs_cc.runtime.sites import Site

NO_VALUE: Final = -1  # in place of the number of a function that ended without a value


def check_pointer(writer: Writer, call: Call, pointer: Register, *, shapes: bool) -> None:
    """Check that a function pointer is valid; with `shapes`, that its function fits the call."""
    names, code = writer.names, writer.code
    push = writer.value(pointer)
    code += [push, ("i32.const", 1), ("i32.sub",)]
    code += [("i32.const", names.pointers), ("i32.ge_u",)]
    writer.fail_if(Site("bad function pointer", call.location), [push])
    table = names.tables.get(call_shape(call))
    if table is not None and shapes:
        code += [push, ("i32.load8_u", MEMORY, table), ("i32.eqz",)]
        writer.fail_if(Site("mismatched call", call.location), [push])


def may_lack_value(names: Symbols, call: Call) -> bool:
    """Return whether the callee may return without the value that is used."""
    if call.result is None:
        return False
    is_indirect = isinstance(call.callee, Register)
    return bool(names.without_value) if is_indirect else call.callee in names.without_value


def check_value(writer: Writer, call: Call) -> None:
    """Check that the callee has returned a value."""
    if may_lack_value(writer.names, call):
        writer.load_at(SP, FUNCTION, "i32")
        writer.code += [("i32.const", NO_VALUE), ("i32.eq",)]
        writer.fail_if(Site("no value returned", call.location), [("i32.const", 0)])
