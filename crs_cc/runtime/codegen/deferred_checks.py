"""Find loads whose check can be deferred: within the block the value is only stored elsewhere.

Such a load is not checked; a later use of the value is. There are two kinds.

- A copy: the value is stored unchanged, in the same width. The states of its bytes are stored with
  it, so that a loop which copies a struct byte by byte, or swaps two elements, is exact.
- A computation: the value is stored after arithmetic, as in `p->count++`. A flag is set
  if an operand was uninitialised; the stored value is then uninitialised too.

A value that reaches a branch, an address, a comparison, a division, a call, or that is live after
the block, is checked where it is loaded.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final, TypeAlias

from crs_cc.ir.instruction import Binary, Block, Instruction, Load, Move, Register, Store, Unary
from crs_cc.ir.liveness import Liveness, all_instructions, reads, writes
from crs_cc.ir.program import Function
from crs_cc.ir.value_type import MEMORY_SIZE
from crs_cc.runtime.codegen import shadow
from crs_cc.runtime.codegen.registers import CHARGES

_ARITHMETIC: Final = frozenset({"add", "sub", "mul", "and", "or", "xor", "shl", "shr_s", "shr_u"})
_NO_INDEX: Final = -1  # for registers that are not the IR function's

Loads: TypeAlias = "dict[Load, None]"
"""An ordered set of loads."""


@dataclass(slots=True)
class _Flow:
    """The data flow of one block.

    Attributes:
        values: the loads that each register's value depends on, and whether it is a copy.
        stores: the stores of each load's value.
        judged: the loads that must be checked.
    """

    values: dict[Register, tuple[Loads, bool]] = field(default_factory=dict)
    stores: dict[Load, list[Store]] = field(default_factory=dict)
    changed: set[Load] = field(default_factory=set)
    judged: set[Load] = field(default_factory=set)

    def follow(self, it: Instruction) -> None:
        """Follow values through an instruction."""
        used, made, whole = reads(it), dict[Load, None](), False
        if _passes_on(it):
            counts = [it.right] if isinstance(it, Binary) and _is_shift(it) else []
            used = [register for register in used if register not in counts]
            for register in used:
                loads, as_it_was = self.values.get(register, ({}, False))
                made.update(loads)
                whole = as_it_was and isinstance(it, Move)
            used = [register for register in counts if isinstance(register, Register)]
        elif isinstance(it, Store) and isinstance(it.source, Register):
            self._store(it, it.source)
            used = [it.base] if isinstance(it.base, Register) else []
        for register in used:
            self.judged.update(self.values.get(register, ({}, False))[0])
        target = writes(it)
        if target is not None:
            self.values.pop(target, None)
            if isinstance(it, Load) and not it.unjudged:
                self.values[target] = {it: None}, True
                self.stores[it] = []
            elif made:
                self.values[target] = made, whole

    def _store(self, it: Store, source: Register) -> None:
        loads, whole = self.values.get(source, ({}, False))
        for load in loads:
            self.stores[load].append(it)
            if not whole or MEMORY_SIZE[load.memory] != MEMORY_SIZE[it.memory]:
                self.changed.add(load)

    def end(self, alive: int) -> None:
        """Check the values that are live after the block."""
        for register, (loads, _) in self.values.items():
            if alive >> register.index & 1:
                self.judged.update(loads)


class DeferredChecks:
    """The loads of a function whose checks are deferred, and the stores of their values.

    Attributes:
        registers: the registers that hold states and flags between load and store.
        charge: the frame's charge for the maximum live at once, see `registers` [bytes].
    """

    def __init__(self, function: Function, liveness: Liveness, *, keep: bool) -> None:
        """Analyse all blocks; `keep` if the program may stop within one."""
        self.registers: list[Register] = []
        self._keep = keep
        self._states: dict[Load, Register] = {}
        self._flags: dict[Load, Register] = {}
        self._copies: dict[Store, Load] = {}
        self._computed: dict[Store, Register] = {}
        self._joined: dict[Register, Register] = {}
        self._unused: set[Load] = set()
        self._last: dict[Register, Store] = {}
        for block in function.blocks:
            self._find(block, liveness.at_end(block))
        self._resolve(function)
        self.charge = max(map(self._most, function.blocks), default=0)

    def states_of(self, load: Load) -> Register | None:
        """Return the register for the states of a loaded value, if it is copied."""
        return self._states.get(load)

    def flag_of(self, load: Load) -> Register | None:
        """Return the flag for an uninitialised value, if it is used in a computation."""
        return self._flags.get(load)

    def copied_by(self, store: Store) -> Register | None:
        """Return the register with the states of the stored value, if it is a copy."""
        load = self._copies.get(store)
        return None if load is None else self._states[load]

    def computed_for(self, store: Store) -> Register | None:
        """Return the flag that is set if the stored value depends on an uninitialised one."""
        return self._computed.get(store)

    def is_last(self, store: Store, register: Register) -> bool:
        """Return whether a store is the last use of states or a flag."""
        return not self._keep and self._last[register] is store

    def is_deferred(self, load: Load) -> bool:
        """Return whether a load is not checked."""
        return load in self._states or load in self._flags or load in self._unused

    def is_unused(self, load: Load) -> bool:
        """Return whether the loaded value is unused."""
        return load in self._unused

    def _find(self, block: Block, alive: int) -> None:
        flow = _Flow()
        for it in all_instructions(block):
            flow.follow(it)
        flow.end(alive)
        for load, stores in flow.stores.items():
            if load in flow.judged:
                continue
            if not stores:
                self._unused.add(load)
            elif load not in flow.changed:
                self._copy(load, stores)
            else:
                self._compute(load, stores)

    def _copy(self, load: Load, stores: list[Store]) -> None:
        states = Register(_NO_INDEX, shadow.kind(MEMORY_SIZE[load.memory]))
        self.registers.append(states)
        self._states[load] = states
        self._copies.update(dict.fromkeys(stores, load))
        self._last[states] = stores[-1]

    def _compute(self, load: Load, stores: list[Store]) -> None:
        """Assign a flag to a load, shared with the other loads that reach the same stores."""
        computed = [self._computed[each] for each in stores if each in self._computed]
        shared = list(dict.fromkeys(map(self._representative, computed)))
        if shared:
            flag = shared[0]
        else:
            flag = Register(_NO_INDEX, "i32")
            self.registers.append(flag)
        self._flags[load] = flag
        self._joined.update(dict.fromkeys(shared[1:], flag))
        self._computed.update(dict.fromkeys(stores, flag))

    def _representative(self, flag: Register) -> Register:
        """Return the representative of a flag (union-find with path compression)."""
        end = flag
        while end in self._joined:
            end = self._joined[end]
        while flag is not end:
            self._joined[flag], flag = end, self._joined[flag]
        return end

    def _resolve(self, function: Function) -> None:
        """Replace all flags by their representatives, and note the last store of each."""
        self.registers = [each for each in self.registers if each not in self._joined]
        self._flags = {load: self._representative(flag) for load, flag in self._flags.items()}
        for block in function.blocks:
            for it in block.instructions:
                if isinstance(it, Store) and it in self._computed:
                    flag = self._computed[it] = self._representative(self._computed[it])
                    self._last[flag] = it

    def _most(self, block: Block) -> int:
        """Return the maximum charge for the states and flags of a block live at once [bytes]."""
        size = most = 0
        alive: set[Register] = set()
        for it in block.instructions:
            if isinstance(it, Load):
                register = self.states_of(it) or self.flag_of(it)
                if register is not None and register not in alive:
                    alive.add(register)
                    size += CHARGES[register.type]
                    most = max(most, size)
            elif isinstance(it, Store):
                register = self.copied_by(it) or self.computed_for(it)
                if register in alive and self._last[register] is it:
                    alive.remove(register)
                    size -= CHARGES[register.type]
        return most


def _is_shift(it: Binary) -> bool:
    """Return whether the right operand of an operation is checked, see `checked_arithmetic`."""
    return it.checked and it.op.partition(".")[2] in {"shl", "shr_s", "shr_u"}


def _passes_on(it: Instruction) -> bool:
    """Return whether an instruction propagates uninitialised operands to its result."""
    if isinstance(it, Binary):
        kind, _, op = it.op.partition(".")
        return op in _ARITHMETIC or (kind in {"f32", "f64"} and op in {"div", "copysign"})
    return isinstance(it, Move) or (isinstance(it, Unary) and not it.op.endswith("eqz"))
