"""The requirements of checked builds on structs in registers, in functions that are not inlined.

A member in a register has no state. So a struct is in registers only if all of it has a value
wherever a member is read: then no read of it can fail, and a report can show all of it. And no
value is stored in it whose check is deferred, as it might have none.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from crs_cc.ir.instruction import (
    Block,
    Bounds,
    Instruction,
    Lifetime,
    Load,
    Register,
    Seal,
    Slot,
    Store,
)
from crs_cc.ir.liveness import all_instructions, reads, writes
from crs_cc.runtime.codegen.deferred_checks import DeferredChecks


def judged_in_memory(
    it: Instruction, holding: Mapping[Register, tuple[Slot, int]], deferred: DeferredChecks
) -> Slot | None:
    """Return the slot of which an instruction tests or notes what only memory has, if any.

    Args:
        it: the instruction.
        holding: the registers that hold the address of a slot.
        deferred: the loads whose checks are deferred.
    """
    match it:
        case Seal(slot=slot) | Bounds(base=Slot() as slot):
            return slot
        case Load() | Store():
            place = holding.get(it.base) if isinstance(it.base, Register) else None
            base = place[0] if place else it.base
            is_judged = it.within is not None or _is_deferred(it, deferred)
            return base if isinstance(base, Slot) and is_judged else None
    return None


def _is_deferred(it: Load | Store, deferred: DeferredChecks) -> bool:
    """Return whether a value is stored whose check is deferred."""
    if isinstance(it, Load):
        return False
    return bool(deferred.copied_by(it) or deferred.converted_for(it))


def read_unassigned(
    blocks: Sequence[Block], members: Mapping[tuple[Slot, int], Register]
) -> Slot | None:
    """Return a slot that is read where a part of it may have no value; None if there is none.

    Args:
        blocks: the blocks of the function, of which the first is the entry.
        members: the registers in the place of its slots' parts.
    """
    slots = {register.index: slot for (slot, _), register in members.items()}
    parts: dict[Slot, int] = {}
    for index, slot in slots.items():
        parts[slot] = parts.get(slot, 0) | 1 << index
    at_start = dict.fromkeys(blocks, 0)
    at_start[blocks[0]] = sum(parts.values())
    work, seen = [blocks[0]], set[Block]()
    while work:
        block = work.pop()
        seen.add(block)
        unset = at_start[block]
        for it in all_instructions(block):
            for slot in (slots[each.index] for each in reads(it) if each.index in slots):
                if unset & parts[slot]:
                    return slot
            unset = _after(it, unset, parts)
        for following in block.successors():
            if following not in seen or unset & ~at_start[following]:
                at_start[following] |= unset
                work.append(following)
    return None


def _after(it: Instruction, unset: int, parts: Mapping[Slot, int]) -> int:
    """Return the registers without a value after an instruction, given those before it."""
    target = writes(it)
    if target is not None:
        return unset & ~(1 << target.index)
    return unset | parts.get(it.slot, 0) if isinstance(it, Lifetime) else unset
