"""Find loads whose check can be deferred: within the block the value is only stored elsewhere.

Such a load is not checked; a later use of the value is. There are two kinds.

- A copy: the value is stored unchanged, in the same width. The states of its bytes are stored with
  it, so that a loop which copies a struct byte by byte, or swaps two elements, is exact.
- A conversion: the value is stored after a change of its type. A flag is set if it was
  uninitialised; the stored value is then uninitialised too.

A value that reaches arithmetic, as in `p->count++`, a branch, an address, a comparison, a call, or
that is live after the block, is checked where it is loaded.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final

from crs_cc.ir.instruction import (
    Binary,
    Block,
    Constant,
    Instruction,
    Load,
    Move,
    Passed,
    Register,
    Store,
    Unary,
)
from crs_cc.ir.liveness import Liveness, all_instructions, reads, writes
from crs_cc.ir.program import Function
from crs_cc.ir.value_type import MEMORY_SIZE
from crs_cc.runtime.codegen import shadow
from crs_cc.runtime.codegen.registers import CHARGES

_NO_INDEX: Final = -1  # for registers that are not the IR function's


@dataclass(slots=True)
class _Flow:
    """The data flow of one block.

    Attributes:
        values: the load that each register's value comes from, and whether it is a copy.
        stores: the stores of each load's value.
        changed: the loads whose value is converted before it is stored.
        judged: the loads that must be checked.
        passed: the addresses of variable arguments, whose states are not those of copies.
    """

    values: dict[Register, tuple[Load, bool]] = field(default_factory=dict)
    stores: dict[Load, list[Store]] = field(default_factory=dict)
    changed: set[Load] = field(default_factory=set)
    judged: set[Load] = field(default_factory=set)
    passed: set[Register] = field(default_factory=set)

    def update(self, it: Instruction) -> None:
        """Follow values through an instruction."""
        used, made = reads(it), None
        if isinstance(it, Passed):
            self.passed.add(it.address)
        elif _passes_on(it):
            for register in used:
                made = self._passed_on(it, register) or made
            used = []
        elif isinstance(it, Store) and isinstance(it.source, Register):
            self._store(it, it.source)
            used = [each for each in (it.base, it.within) if isinstance(each, Register)]
        for register in used:
            if register in self.values:
                self.judged.add(self.values[register][0])
        target = writes(it)
        if target is not None:
            self.values.pop(target, None)
            if isinstance(it, Load) and not it.unjudged and it.base not in self.passed:
                self.values[target] = it, True
                self.stores[it] = []
            elif made is not None:
                self.values[target] = made

    def _passed_on(self, it: Instruction, source: Register) -> tuple[Load, bool] | None:
        known = self.values.get(source)
        return known and (known[0], known[1] and isinstance(it, Move))

    def _store(self, it: Store, source: Register) -> None:
        known = self.values.get(source)
        if known is not None:
            load, whole = known
            self.stores[load].append(it)
            if not whole or MEMORY_SIZE[load.memory] != MEMORY_SIZE[it.memory]:
                self.changed.add(load)

    def end(self, live: int) -> None:
        """Check the values that are live after the block."""
        for register, (load, _) in self.values.items():
            if live >> register.index & 1:
                self.judged.add(load)


class DeferredChecks:
    """The loads of a function whose checks are deferred, and the stores of their values.

    Attributes:
        registers: the registers that hold states and flags between load and store.
        changing: the loads of bytes that are stored to later in their block, and those stores.
        charge: the frame's charge for the maximum live at once, see `registers` [bytes].
    """

    def __init__(self, function: Function, liveness: Liveness, *, keep: bool) -> None:
        """Analyse all blocks; `keep` if the program may stop within one."""
        self.registers: list[Register] = []
        self.changing: dict[Load, Store] = {}
        self._keep = keep
        self._states: dict[Load, Register] = {}
        self._flags: dict[Load, Register] = {}
        self._copies: dict[Store, Load] = {}
        self._converted: dict[Store, Register] = {}
        self._unused: set[Load] = set()
        self._last: dict[Register, Store] = {}
        for block in function.blocks:
            self._find(block, liveness.at_end(block))
        self.charge = max(map(self._most, function.blocks), default=0)

    def states_of(self, load: Load) -> Register | None:
        """Return the register for the states of a loaded value, if it is copied."""
        return self._states.get(load)

    def flag_of(self, load: Load) -> Register | None:
        """Return the flag for an uninitialised value, if it is converted."""
        return self._flags.get(load)

    def copied_by(self, store: Store) -> Register | None:
        """Return the register with the states of the stored value, if it is a copy."""
        load = self._copies.get(store)
        return None if load is None else self._states[load]

    def converted_for(self, store: Store) -> Register | None:
        """Return the flag that is set if the stored value is uninitialised, and was converted."""
        return self._converted.get(store)

    def is_last(self, store: Store, register: Register) -> bool:
        """Return whether a store is the last use of states or a flag."""
        return not self._keep and self._last[register] is store

    def is_deferred(self, load: Load) -> bool:
        """Return whether a load is not checked."""
        return load in self._states or load in self._flags or load in self._unused

    def is_unused(self, load: Load) -> bool:
        """Return whether the loaded value is unused."""
        return load in self._unused

    def _find(self, block: Block, live: int) -> None:
        flow = _Flow()
        self.changing.update(_changing(block))
        for it in all_instructions(block):
            flow.update(it)
        flow.end(live)
        for load, stores in flow.stores.items():
            if load in flow.judged:
                continue
            if not stores:
                self._unused.add(load)
            elif load not in flow.changed:
                self._copy(load, stores)
            else:
                self._convert(load, stores)

    def _copy(self, load: Load, stores: list[Store]) -> None:
        states = Register(_NO_INDEX, shadow.kind(MEMORY_SIZE[load.memory]))
        self.registers.append(states)
        self._states[load] = states
        self._copies.update(dict.fromkeys(stores, load))
        self._last[states] = stores[-1]

    def _convert(self, load: Load, stores: list[Store]) -> None:
        flag = Register(_NO_INDEX, "i32")
        self.registers.append(flag)
        self._flags[load] = flag
        self._converted.update(dict.fromkeys(stores, flag))
        self._last[flag] = stores[-1]

    def _most(self, block: Block) -> int:
        """Return the maximum charge for the states and flags of a block live at once [bytes]."""
        size = most = 0
        live: set[Register] = set()
        for it in block.instructions:
            if isinstance(it, Load):
                register = self.states_of(it) or self.flag_of(it)
                if register is not None and register not in live:
                    live.add(register)
                    size += CHARGES[register.type]
                    most = max(most, size)
            elif isinstance(it, Store):
                register = self.copied_by(it) or self.converted_for(it)
                if register in live and self._last[register] is it:
                    live.remove(register)
                    size -= CHARGES[register.type]
        return most


def _changing(block: Block) -> dict[Load, Store]:
    """Return the loads in a block whose bytes are stored to later in it, and those stores."""
    found: dict[Load, Store] = {}
    seen: dict[Register, dict[tuple[int, int], Load]] = {}
    for it in block.instructions:
        if isinstance(it, Store) and isinstance(it.base, Register):
            load = seen.get(it.base, {}).get((it.offset, MEMORY_SIZE[it.memory]))
            if load is not None:
                found.setdefault(load, it)
        target = writes(it)
        if target is not None:
            seen.pop(target, None)
        if isinstance(it, Load) and isinstance(it.base, Register) and it.base is not it.result:
            seen.setdefault(it.base, {})[it.offset, MEMORY_SIZE[it.memory]] = it
    return found


def _passes_on(it: Instruction) -> bool:
    """Return whether an instruction propagates an uninitialised operand to its result."""
    if isinstance(it, Binary):  # a conversion to an unsigned type
        return it.op.endswith(".and") and isinstance(it.right, Constant)
    return isinstance(it, Move) or (isinstance(it, Unary) and not it.op.endswith("eqz"))
