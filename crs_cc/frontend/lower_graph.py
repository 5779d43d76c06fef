"""Tidies a function's graph: no unreachable blocks, no empty ones, no needless jumps.

Every block costs fuel, and every jump time.
"""

from __future__ import annotations

from collections import Counter

from crs_cc.ir.program import Block, Branch, Call, Function, Jump, Request, Switch


def tidy(function: Function) -> set[Block]:
    """Cleans a function's graph, keeping the order of its blocks.

    Returns:
        The blocks whose instructions are still there, if perhaps in another block.
    """
    for block in function.blocks:
        _shorten(block)
    function.blocks = _reachable(function)
    kept = set(function.blocks)
    _join(function)
    return kept


def _destination(block: Block) -> Block:
    """Follows empty blocks to where they lead; an endless ring of them stays as it is."""
    seen = {id(block)}
    while not block.instructions and isinstance(block.terminator, Jump):
        block = block.terminator.target
        if id(block) in seen:
            break
        seen.add(id(block))
    return block


def _shorten(block: Block) -> None:
    """Lets a terminator go past empty blocks."""
    match block.terminator:
        case Jump() as jump:
            jump.target = _destination(jump.target)
        case Branch() as branch:
            branch.then = _destination(branch.then)
            branch.otherwise = _destination(branch.otherwise)
        case Switch() as switch:
            switch.cases = [(value, _destination(each)) for value, each in switch.cases]
            switch.default = _destination(switch.default)
        case Call() | Request() as call:
            call.then = _destination(call.then)


def _reachable(function: Function) -> list[Block]:
    """Gives the blocks that can be reached, in their order."""
    reached = {id(function.blocks[0])}
    waiting = [function.blocks[0]]
    while waiting:
        for block in waiting.pop().successors():
            if id(block) not in reached:
                reached.add(id(block))
                waiting.append(block)
    return [block for block in function.blocks if id(block) in reached]


def _join(function: Function) -> None:
    """Appends each block to the one before it, if that alone goes there and nowhere else."""
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
