"""The variable arguments of active calls: which there are, and of which types they were passed."""

from __future__ import annotations

from crs_cc.ir.types import CType
from crs_cc.runtime.diagnosis.inspect import StoppedProgram
from crs_cc.runtime.layout import RESULT, argument_offsets
from crs_cc.runtime.sites import call_site


def variable_argument(stopped: StoppedProgram, address: int) -> tuple[int, CType] | None:
    """Return the number, from 1, and the type of the variable argument at an address, if known."""
    for each in stopped.stack:
        info = stopped.compiled.info(each.function)
        if not info.function.variadic:
            continue
        number = call_site(int(stopped.memory[each.fp + RESULT :][:8].view("<u8")[0]))
        if not 0 < number <= len(stopped.compiled.call_sites):
            continue
        first = each.fp - info.frame.size + info.frame.varargs
        passed = stopped.compiled.call_sites[number - 1].passed
        offsets = argument_offsets([ctype.size for ctype in passed])
        if address - first in offsets[:-1]:
            index = offsets.index(address - first)
            return len(info.function.parameters) + index + 1, passed[index]
    return None
