"""Structs of a function that is not inlined in registers, in unchecked run builds.

The calls of small functions, in which nothing can fail, are expanded first: to these structs
are mostly passed. What stays in registers has a home in the frame all the same, where it is written
when the program is suspended, so that it is found there.
"""

from __future__ import annotations

from typing import Final

from crs_cc.ir.program import Function
from crs_cc.runtime.codegen.expansion import expand_some
from crs_cc.runtime.codegen.inlined_calls import inlined_calls
from crs_cc.runtime.codegen.scalar_replacement import Partly, replace_some
from crs_cc.runtime.codegen.small_functions import Bodies

MOST_BLOCKS: Final = 300
MOST_SLOTS: Final = 16
"""Functions with more are left as they are: each slot that stays in memory is found by a pass."""


def with_structs_in_registers(function: Function, bodies: Bodies) -> Partly:
    """Return a function with structs in registers, or unchanged."""
    is_large = len(function.blocks) > MOST_BLOCKS or len(function.slots) > MOST_SLOTS
    if function.slots and not is_large:
        expanded = expand_some(function, inlined_calls(function.blocks, bodies))
        replaced = replace_some(expanded.function, expanded.fuel)
        if replaced is not None:
            return replaced
    return Partly(function, {block: block.fuel for block in function.blocks}, {})
