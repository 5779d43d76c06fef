"""Definite assignment analysis of variables in registers.

A variable that is assigned before every read, on every path, needs no check. Any other gets a flag
beside its register, which is tested at the reads that may come too early. Moving or storing a value
is not a read: its flag is moved, or its state is stored, with it.

A debugger may read a variable wherever the program can stop. Where it depends on the path whether
the variable has a value there, it has a flag, too.

>>> from crs_cc.ir.instruction import *
>>> from crs_cc.ir.program import Function
>>> from crs_cc.ir.types import INT
>>> from crs_cc.core.source import Location
>>> here = Location("sum.c", 1, 1)
>>> n = Register(0, "i32", Variable("n", INT, here))
>>> m = Register(1, "i32", Variable("m", INT, here))
>>> block = Block("entry", [Binary(here, m, "i32.add", n, n)], Return(here, m))
>>> found = Assignments(Function("sum", here, registers=[n, m], blocks=[block]))
>>> [variable.name for _, variable in found.tests[block.instructions[0]]]
['n']
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from crs_cc.ir.instruction import (
    Block,
    Call,
    Instruction,
    Move,
    Register,
    Request,
    SetJump,
    Statement,
    Store,
    Variable,
)
from crs_cc.ir.liveness import all_instructions, reads, writes
from crs_cc.ir.program import Function

_STOPS: Final = (Statement, Call, Request, SetJump)
"""Where a program can stop, beside the starts of blocks."""


@dataclass(frozen=True, slots=True)
class FlagChange:
    """The change of a flag when its register is written.

    Attributes:
        source: the flag whose value it takes; None if the register now has a value.
    """

    flag: Register
    source: Register | None


class Assignments:
    """The flags that a function needs, their tests and their changes.

    Attributes:
        flags: the flag of each register that needs one: not zero if the register has a value.
        tests: the registers to test before an instruction, each with the variable to report.
        changes: the changes by an instruction.
        stored: the flag of the value that a store writes, if it may have none.
        unset: the variables that never have a value before an instruction where a debugger may
            read them.
    """

    def __init__(self, function: Function, *, steps: bool = False) -> None:
        """Analyse a function; `steps` if a debugger may stop in it."""
        self.flags: dict[Register, Register] = {}
        self.tests: dict[Instruction, list[tuple[Register, Variable]]] = {}
        self.changes: dict[Instruction, FlagChange] = {}
        self.stored: dict[Store, Register] = {}
        self.unset: dict[Instruction, frozenset[Register]] = {}
        self._variables: dict[Register, Variable] = {}
        passed = {each.place for each in function.parameters}
        start = 0
        for register in function.registers:
            if register.variable is not None and register not in passed:
                start |= 1 << register.index
                self._variables[register] = register.variable
        if start and function.blocks:
            at_start, wanted = _solve(function, start), dict[Register, None]()
            if steps:
                self._look(function, at_start, wanted)
            self._find(function, at_start, wanted)

    def _look(
        self, function: Function, at_start: dict[Block, int], wanted: dict[Register, None]
    ) -> None:
        """Find what a debugger can read, and add flags where the state is unknown."""
        assigned = _assigned(function)
        for block in function.blocks:
            unset, given = at_start[block], assigned[block]
            for number, it in enumerate(all_instructions(block)):
                if unset and (number == 0 or isinstance(it, _STOPS)):
                    seen = [
                        (register, given >> register.index & 1)
                        for register, variable in self._variables.items()
                        if unset >> register.index & 1 and variable.is_visible(it.location)
                    ]
                    self.unset[it] = frozenset(each for each, doubt in seen if not doubt)
                    wanted.update((each, None) for each, doubt in seen if doubt)
                unset, given = _after(it, unset), given | _written(it)

    def _find(
        self, function: Function, at_start: dict[Block, int], wanted: dict[Register, None]
    ) -> None:
        """Collect the reads that may come too early, and the moves that lead to them."""
        moves: dict[Instruction, Register] = {}
        for block in function.blocks:
            unset = at_start[block]
            for it in all_instructions(block):
                if not unset:
                    break
                early = [each for each in dict.fromkeys(_uses(it)) if unset >> each.index & 1]
                if early:
                    self.tests[it] = [(each, self._variables[each]) for each in early]
                    wanted.update(dict.fromkeys(early))
                source = _moved(it)
                if source is not None and unset >> source.index & 1:
                    self._move(it, source, moves, wanted)
                unset = _after(it, unset)
        _add_sources(moves, wanted)
        self.flags = {register: Register(-1, "i32") for register in wanted}
        if self.flags:
            self._record(function, moves)

    def _record(self, function: Function, moves: dict[Instruction, Register]) -> None:
        """Record where flags are stored and changed."""
        for it, source in moves.items():
            if isinstance(it, Store):
                self.stored[it] = self.flags[source]
        for block in function.blocks:
            for it in all_instructions(block):
                target = writes(it)
                if target in self.flags:
                    copied = self.flags[moves[it]] if it in moves else None
                    self.changes[it] = FlagChange(self.flags[target], copied)

    def _move(
        self,
        it: Instruction,
        source: Register,
        moves: dict[Instruction, Register],
        wanted: dict[Register, None],
    ) -> None:
        """Record that a value that may be undefined is moved to another register, or stored."""
        moves[it] = source
        target = writes(it)
        if target is None:
            wanted[source] = None
        else:
            self._variables[target] = target.variable or self._variables[source]


def _add_sources(moves: dict[Instruction, Register], wanted: dict[Register, None]) -> None:
    """Add flags for the sources of all moves to registers with flags."""
    grown = True
    while grown:
        grown = False
        for move, source in moves.items():
            if source not in wanted and writes(move) in wanted:
                wanted[source] = None
                grown = True


def _moved(it: Instruction) -> Register | None:
    """Return the register whose value an instruction moves without using it."""
    if isinstance(it, Move | Store) and isinstance(it.source, Register):
        return it.source
    return None


def _uses(it: Instruction) -> list[Register]:
    """Return the registers whose values an instruction uses."""
    used = reads(it)
    source = _moved(it)
    if source is not None:
        used.remove(source)
    return used


def _after(it: Instruction, unset: int) -> int:
    """Return the registers that may have no value after an instruction, given those before it."""
    for register in _uses(it):  # the flag was tested
        unset &= ~(1 << register.index)
    target = writes(it)
    if target is not None:
        source = _moved(it)
        moves_nothing = source is not None and unset >> source.index & 1
        unset &= ~(1 << target.index)
        if moves_nothing:
            unset |= 1 << target.index
    return unset


def _written(it: Instruction) -> int:
    """Return the bit of the register that an instruction writes; 0 if there is none."""
    target = writes(it)
    return 0 if target is None else 1 << target.index


def _assigned(function: Function) -> dict[Block, int]:
    """Return the bit set of registers that may have been written at the start of each block."""
    at_start = dict.fromkeys(function.blocks, 0)
    work = list(function.blocks)
    while work:
        block = work.pop()
        given = at_start[block]
        for it in all_instructions(block):
            given |= _written(it)
        for target in block.successors():
            if given & ~at_start[target]:
                at_start[target] |= given
                work.append(target)
    return at_start


def _solve(function: Function, start: int) -> dict[Block, int]:
    """Return the bit set of registers that may have no value at the start of each block."""
    at_start = dict.fromkeys(function.blocks, 0)
    at_start[function.blocks[0]] = start
    seen: set[Block] = set()
    work = [function.blocks[0]]
    while work:
        block = work.pop()
        seen.add(block)
        unset = at_start[block]
        for it in all_instructions(block):
            if not unset:
                break
            unset = _after(it, unset)
        for target in block.successors():
            if target not in seen or unset & ~at_start[target]:
                at_start[target] |= unset
                work.append(target)
    return at_start
