"""Depth-first traversals of graphs of blocks, and the loop headers that they find."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Protocol, Self, TypeVar

from crs_cc.ir.instruction import Block
from crs_cc.ir.program import Function


class _Node(Protocol):
    def successors(self) -> Sequence[Self]: ...


AnyNode = TypeVar("AnyNode", bound=_Node)


def postorder(entry: AnyNode) -> list[AnyNode]:
    """Return the reachable nodes, each after its successors except for back edges."""
    seen, order = {entry}, []
    work = [(entry, iter(entry.successors()))]
    while work:
        node, rest = work[-1]
        for target in rest:
            if target not in seen:
                seen.add(target)
                work.append((target, iter(target.successors())))
                break
        else:
            order.append(node)
            work.pop()
    return order


def edges(function: Function) -> Iterator[tuple[Block, Block, bool]]:
    """Yield source and target of the reachable edges, depth first, and whether they lead back."""
    entry = function.blocks[0]
    open_blocks, seen = {entry}, {entry}
    work = [(entry, iter(entry.successors()))]
    while work:
        block, rest = work[-1]
        for target in rest:
            yield block, target, target in open_blocks
            if target not in seen:
                seen.add(target)
                open_blocks.add(target)
                work.append((target, iter(target.successors())))
                break
        else:
            open_blocks.discard(block)
            work.pop()


def loop_headers(function: Function) -> set[Block]:
    """Return blocks of which at least one is on every cycle: the targets of back edges."""
    return {target for _, target, leads_back in edges(function) if leads_back}
