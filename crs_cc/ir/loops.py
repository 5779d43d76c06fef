"""Loop headers, at which the iterations of loops are counted."""

from __future__ import annotations

from crs_cc.ir.instruction import Block
from crs_cc.ir.program import Function


def loop_headers(function: Function) -> set[Block]:
    """Return blocks of which at least one is on every cycle.

    They are the targets of back edges in a depth-first traversal.
    """
    headers: set[Block] = set()
    entry = function.blocks[0]
    open_blocks, seen = {entry}, {entry}
    work = [(entry, iter(entry.successors()))]
    while work:
        block, rest = work[-1]
        for target in rest:
            if target in open_blocks:
                headers.add(target)
            elif target not in seen:
                seen.add(target)
                open_blocks.add(target)
                work.append((target, iter(target.successors())))
                break
        else:
            open_blocks.discard(block)
            work.pop()
    return headers
