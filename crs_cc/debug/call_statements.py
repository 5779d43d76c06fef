"""Statements that call a function: breakpoints on functions of the C library.

Such a function has no statements of its own, so a breakpoint on it stops before each statement
that calls it by name, whether or not the call is evaluated.
"""

from __future__ import annotations

from collections.abc import Iterator

from crs_cc.core.source import Location
from crs_cc.debug.program import DebugProgram
from crs_cc.ir.instruction import Block, Call, Statement
from crs_cc.ir.names import in_library, plain_name
from crs_cc.ir.program import Function


def calling(program: DebugProgram, name: str) -> frozenset[int]:
    """Return the numbers of the user's statements that call a function by its name."""
    detail = program.executable.detail()
    sites = {
        (site.function, site.location): number
        for number, site in enumerate(detail.compiled.statements)
    }
    return frozenset(
        sites[function.name, place]
        for function in detail.program.functions.values()
        if not in_library(function.location)
        for place in _places(function, name)
        if (function.name, place) in sites
    )


def _places(function: Function, name: str) -> Iterator[Location]:
    """Return the locations of a function's statements that call another one."""
    entry = function.blocks[0]
    begun: dict[Block, Location | None] = {entry: None}
    waiting = [entry]
    while waiting:
        block = waiting.pop()
        place = begun[block]
        for instruction in block.instructions:
            if isinstance(instruction, Statement):
                place = instruction.location
        end = block.terminator
        callee = end.callee if isinstance(end, Call) else None
        if isinstance(callee, str) and plain_name(callee) == name and place is not None:
            yield place
        for follower in block.successors():
            if follower not in begun:
                begun[follower] = place
                waiting.append(follower)
