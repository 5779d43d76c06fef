"""Where a function pays the fuel of its blocks: in advance, and so less often.

A block costs its number of IR instructions. Where control surely passes from one block to another
the first pays for both, and of two branches it pays what both cost. The fuel is exact again
wherever it can be seen: the tests in loops and the failures take into account what has been
prepaid, and nothing is prepaid across a call, a request or the function's end.

All edges into a block must prepay the same amount, and so must all edges out of one. Edges are
joined into groups by this, each of which prepays the least that its targets cost. Behind the header
of a loop nothing is prepaid, so that the blocks before it pay for all of it.
"""

from __future__ import annotations

from collections.abc import Container, Mapping
from dataclasses import dataclass
from typing import Final

from crs_cc.ir.instruction import Block, Branch, Jump, Switch
from crs_cc.ir.loops import postorder
from crs_cc.ir.program import Function
from crs_cc.runtime.codegen.indices import FUEL
from crs_cc.runtime.wasm import Instr

FREE_BYTES: Final = 256
"""Bytes moved per unit of fuel, a power of 2; fewer cost nothing."""


@dataclass(frozen=True, slots=True)
class FuelCharges:
    """The fuel charged in each block.

    Attributes:
        charges: the fuel that a block subtracts at its start.
        prepaid: how much of that is for blocks after it.
        received: how much the blocks before it have paid for it.
    """

    charges: dict[Block, int]
    prepaid: dict[Block, int]
    received: dict[Block, int]


def exact_charges(function: Function) -> FuelCharges:
    """Return charges without prepayment: the fuel can be seen at any instruction."""
    nothing = dict.fromkeys(function.blocks, 0)
    return FuelCharges({block: block.fuel for block in function.blocks}, nothing, nothing)


def early_charges(
    function: Function, headers: Container[Block], fuel: Mapping[Block, int]
) -> FuelCharges:
    """Return charges with as much prepayment as is possible; `fuel` is what each block costs."""
    blocks = function.blocks
    into = _groups(function)
    members: dict[Block, list[Block]] = {}
    for block, group in into.items():
        members.setdefault(group, []).append(block)
    paid = {into[blocks[0]]: 0}
    for block in blocks:
        if block in headers or not isinstance(block.terminator, Jump | Branch | Switch):
            paid.update((into[target], 0) for target in block.successors())
    prepaid: dict[Block, int] = {}
    for block in postorder(function.blocks[0]):
        targets = block.successors()
        if not targets:
            prepaid[block] = 0
            continue
        group = into[targets[0]]
        if group not in paid:
            paid[group] = min(fuel[each] + prepaid.get(each, 0) for each in members[group])
        prepaid[block] = paid[group]
    received = {block: paid.get(into[block], 0) for block in blocks}
    charges = {
        block: fuel[block] + prepaid.setdefault(block, 0) - received[block] for block in blocks
    }
    return FuelCharges(charges, prepaid, received)


def _groups(function: Function) -> dict[Block, Block]:
    """Return a representative of the blocks that share a predecessor with each, transitively."""
    parent = {block: block for block in function.blocks}

    def find(block: Block) -> Block:
        while parent[block] is not block:
            parent[block] = block = parent[parent[block]]
        return block

    for block in function.blocks:
        targets = block.successors()
        for target in targets[1:]:
            parent[find(target)] = find(targets[0])
    return {block: find(block) for block in function.blocks}


def charge(fuel: int) -> list[Instr]:
    """Return the code that subtracts from the fuel."""
    if fuel == 0:
        return []
    return [("local.get", FUEL), ("i64.const", fuel), ("i64.sub",), ("local.set", FUEL)]
