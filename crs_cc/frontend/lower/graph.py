"""Simplify a function's graph: remove unreachable and empty blocks, and jumps between them.

Every block costs fuel, and every jump costs time.
"""

from __future__ import annotations

from collections import Counter

from crs_cc.ir.instruction import Block, Branch, Call, Jump, Request, SetJump, Switch
from crs_cc.ir.program import Function


def simplify(function: Function) -> set[Block]:
    """Simplify a function's graph, keeping the order of its blocks.

    Returns:
        The blocks whose instructions remain, although perhaps in another block.
    """
    ends: dict[Block, Block] = {}
    for block in function.blocks:
        _thread_jumps(block, ends)
    function.blocks = _reachable(function)
    kept = set(function.blocks)
    _join(function)
    return kept


def _destination(block: Block, ends: dict[Block, Block]) -> Block:
    """Return the block that a chain of empty blocks leads to; a cycle of them is left as it is."""
    passed: dict[Block, None] = {}
    while not block.instructions and isinstance(jump := block.terminator, Jump):
        if block in ends:
            block = ends[block]
            break
        if block in passed:
            break
        passed[block] = None
        block = jump.target
    ends.update(dict.fromkeys(passed, block))
    return block


def _thread_jumps(block: Block, ends: dict[Block, Block]) -> None:
    """Make a terminator skip empty blocks."""
    match block.terminator:
        case Jump() as jump:
            jump.target = _destination(jump.target, ends)
        case Branch() as branch:
            branch.then = _destination(branch.then, ends)
            branch.otherwise = _destination(branch.otherwise, ends)
        case Switch() as switch:
            switch.cases = [(value, _destination(each, ends)) for value, each in switch.cases]
            switch.default = _destination(switch.default, ends)
        case Call() | Request() | SetJump() as call:
            call.then = _destination(call.then, ends)


def _reachable(function: Function) -> list[Block]:
    """Return the reachable blocks in their order."""
    reached = {id(function.blocks[0])}
    waiting = [function.blocks[0]]
    while waiting:
        for block in waiting.pop().successors():
            if id(block) not in reached:
                reached.add(id(block))
                waiting.append(block)
    return [block for block in function.blocks if id(block) in reached]


def _join(function: Function) -> None:
    """Append each block to the one before it if they can only follow each other."""
    uses = Counter(id(each) for block in function.blocks for each in block.successors())
    uses[id(function.blocks[0])] += 1
    joined = [function.blocks[0]]
    for block in function.blocks[1:]:
        before = joined[-1]
        jump = before.terminator
        if isinstance(jump, Jump) and jump.target is block and uses[id(block)] == 1:
            before.instructions.extend(block.instructions)
            before.terminator = block.terminator
        else:
            joined.append(block)
    function.blocks = joined
