"""Structs of a function that is not inlined in registers, in run builds.

The calls of small functions, in which nothing can fail, are expanded first: to these structs
are mostly passed. What stays in registers has a home in the frame all the same, where it is written
when the program is suspended, so that it is found there.

A checked build tests the structs that are passed and returned. These tests must be of structs that
stay in registers, which have all their values: else the call is not expanded, so that it fails with
a frame on the stack.
"""

from __future__ import annotations

from typing import Final

from crs_cc.ir.program import Function
from crs_cc.runtime.codegen.expansion import expand_some
from crs_cc.runtime.codegen.inlined_calls import inlined_calls
from crs_cc.runtime.codegen.scalar_replacement import PartiallyReplaced, replace_some
from crs_cc.runtime.codegen.small_functions import Bodies

MAX_BLOCKS: Final = 300
MAX_SLOTS: Final = 16
"""Functions with more are left as they are: each slot that stays in memory is found by a pass."""


def with_structs_in_registers(function: Function, bodies: Bodies | None) -> PartiallyReplaced:
    """Return a function with structs in registers; unchanged in debug builds.

    Args:
        function: the function.
        bodies: the small functions; None in a debug build.
    """
    is_small = len(function.blocks) <= MAX_BLOCKS and len(function.slots) <= MAX_SLOTS
    if bodies is not None and function.slots and is_small:
        replaced = _replaced(function, bodies)
        if replaced is not None:
            return replaced
    return PartiallyReplaced(function, {block: block.fuel for block in function.blocks}, {})


def _replaced(function: Function, bodies: Bodies) -> PartiallyReplaced | None:
    """Return a function with structs in registers; None if there are none."""
    calls = inlined_calls(function.blocks, bodies)
    while True:
        expanded = expand_some(function, calls)
        replaced = replace_some(expanded.function, expanded.fuel, checked=bodies.checked)
        if replaced is None or not bodies.checked:
            return replaced
        blocks, checks = replaced.function.blocks, expanded.checks
        tested = {checks[it] for block in blocks for it in block.instructions if it in checks}
        if not tested:
            return replaced
        calls = {call: body for call, body in calls.items() if call not in tested}
