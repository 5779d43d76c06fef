"""Finds loads whose value is only stored elsewhere, in the same width: copies without a meaning.

What such a load finds is not judged; its state is stored with it. A loop that copies a struct byte
by byte, or swaps two elements of an array, works on bytes without a value too.
"""

from __future__ import annotations

from typing import Final

from crs_cc.ir.program import MEMORY_SIZE, Block, Function, Load, Register, Store
from crs_cc.ir.uses import Liveness, all_instructions, reads, writes
from crs_cc.runtime import shadow


class Carried:
    """The loads of a function that are not judged, and the stores that take their states.

    Attributes:
        registers: what holds the states between load and store.
        keep: whether the program may stop between them.
    """

    def __init__(self, function: Function, liveness: Liveness, *, keep: bool) -> None:
        self.keep = keep
        self.registers: list[Register] = []
        self._states: dict[Load, Register] = {}
        self._sources: dict[Store, Load] = {}
        self._unused: set[Load] = set()
        self._last: dict[Load, Store] = {}
        for block in function.blocks:
            self._find(block, liveness.at_end(block))

    def states_of(self, load: Load) -> Register | None:
        """Gives the register that takes the states of what is loaded, if they are carried."""
        return self._states.get(load)

    def source(self, store: Store) -> Load | None:
        """Gives the load whose value is stored, if its states are carried."""
        return self._sources.get(store)

    def is_last(self, store: Store) -> bool:
        """Tells whether the states that come with a store are not needed behind it."""
        return not self.keep and self._last[self._sources[store]] is store

    def is_unused(self, load: Load) -> bool:
        """Tells whether nobody looks at the loaded value."""
        return load in self._unused

    def _find(self, block: Block, alive_at_end: int) -> None:
        """Follows each loaded value through a block until it is used or overwritten."""
        following: dict[Register, tuple[Load, list[Store]]] = {}
        for it in all_instructions(block):
            used = reads(it)
            if (
                isinstance(it, Store)
                and isinstance(it.source, Register)
                and used != [it.source] * 2
            ):
                load, stores = following.get(it.source, (None, []))
                if load is not None and MEMORY_SIZE[load.memory] == MEMORY_SIZE[it.memory]:
                    stores.append(it)
                    used.remove(it.source)
            for register in used:
                following.pop(register, None)
            target = writes(it)
            if target is not None and target in following:
                self._enter(*following.pop(target))
            if isinstance(it, Load) and not it.unjudged:
                following[it.result] = it, []
        for register, rest in following.items():
            if not alive_at_end >> register.index & 1:
                self._enter(*rest)

    def _enter(self, load: Load, stores: list[Store]) -> None:
        if not stores:
            self._unused.add(load)
            return
        states = Register(_NO_INDEX, shadow.kind(MEMORY_SIZE[load.memory]))
        self.registers.append(states)
        self._states[load] = states
        self._sources.update(dict.fromkeys(stores, load))
        self._last[load] = stores[-1]


def _is_copy(load: Load, store: Store) -> bool:
    """Tells whether a store writes exactly the bytes that were loaded."""
    return MEMORY_SIZE[load.memory] == MEMORY_SIZE[store.memory]


_NO_INDEX: Final = -1  # they are not the IR function's
