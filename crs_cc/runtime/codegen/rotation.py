"""Loop rotation: `while (c) body` as `if (c) do body while (c)`.

The header of such a loop is generated twice, before the loop and at its end, so that an iteration
takes one jump fewer. The copy before the loop is also where the function resumes.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Final

from crs_cc.ir.instruction import Block, Branch, Switch
from crs_cc.ir.loops import edges
from crs_cc.ir.program import Function

MAX_COPIED: Final = 12
"""A header with more instructions is not copied."""
MAX_BLOCKS: Final = 400
"""A loop of more blocks is not examined, which keeps the work linear."""


def rotated_loops(function: Function, headers: Iterable[Block]) -> dict[Block, set[Block]]:
    """Return the header of each loop to be tested at the bottom, with the blocks that jump back."""
    candidates = [block for block in headers if _is_test(block)]
    if not candidates:
        return {}
    back, predecessors = _edges(function)
    found = {}
    for header in candidates:
        latches = back[header]
        inside = _natural_loop(header, latches, predecessors)
        stays = sum(target in inside for target in header.successors())
        jumps = not any(isinstance(each.terminator, Switch) for each in latches)
        if stays == 1 and jumps and function.blocks[0] not in inside - {header}:
            found[header] = latches
    return found


def _is_test(block: Block) -> bool:
    is_short = len(block.instructions) <= MAX_COPIED
    return is_short and isinstance(block.terminator, Branch) and block not in block.successors()


def _edges(function: Function) -> tuple[dict[Block, set[Block]], dict[Block, list[Block]]]:
    """Return the sources of the back edges to each block, and of all edges."""
    back: dict[Block, set[Block]] = {block: set() for block in function.blocks}
    predecessors: dict[Block, list[Block]] = {block: [] for block in function.blocks}
    for block, target, leads_back in edges(function):
        predecessors[target].append(block)
        if leads_back:
            back[target].add(block)
    return back, predecessors


def _natural_loop(
    header: Block, latches: set[Block], predecessors: dict[Block, list[Block]]
) -> set[Block]:
    """Return the header and the blocks that lead to a latch without it; none of a large loop."""
    inside = {header, *latches}
    work = list(latches)
    while work:
        if len(inside) > MAX_BLOCKS:
            return set()
        for source in predecessors[work.pop()]:
            if source not in inside:
                inside.add(source)
                work.append(source)
    return inside
