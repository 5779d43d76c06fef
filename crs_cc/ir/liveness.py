"""The registers that instructions read and write, and liveness analysis.

>>> from crs_cc.core.source import Location
>>> from crs_cc.ir.program import Binary, Constant, Register
>>> a, b = Register(0, "i32"), Register(1, "i32")
>>> add = Binary(Location("x.c"), b, "i32.add", a, Constant("i32", 1))
>>> [register.index for register in reads(add)], writes(add).index
([0], 1)
"""

from __future__ import annotations

from collections.abc import Callable
from operator import attrgetter
from typing import Final

from crs_cc.ir.program import (
    Address,
    Binary,
    Block,
    Bounds,
    Branch,
    Call,
    Callers,
    Copy,
    Fill,
    Function,
    Instruction,
    Load,
    LongJump,
    Mark,
    Move,
    Register,
    Request,
    Return,
    SetJump,
    State,
    Stop,
    Store,
    Switch,
    Unary,
)

_OPERANDS: Final[dict[type[Instruction], tuple[str, ...]]] = {
    Move: ("source",),
    Unary: ("source",),
    Binary: ("left", "right"),
    Load: ("base",),
    Address: ("base",),
    Bounds: ("index", "base"),
    Store: ("base", "source"),
    Copy: ("target", "source", "size"),
    Fill: ("target", "value", "size"),
    Mark: ("target", "size"),
    Callers: ("target",),
    State: ("address",),
    Stop: ("value",),
    Branch: ("condition",),
    Switch: ("value",),
    Return: ("value",),
    Call: ("callee",),
    Request: ("code", "message"),
    SetJump: ("buffer", "activation"),
    LongJump: ("activation", "place", "value"),
}
"""The fields of instructions with the operands that they read, except a call's arguments."""

_ASSIGNING: Final = frozenset({Move, Unary, Binary, Load, Address, State, Call, Request, SetJump})
"""The instructions with a result; looking up the class is faster than `match`."""


def _reader(names: tuple[str, ...]) -> Callable[[Instruction], list[Register]]:
    """Return a function that returns the registers in these fields."""
    if len(names) == 1:
        field: Callable[[Instruction], object] = attrgetter(*names)
        return lambda it: [value] if isinstance(value := field(it), Register) else []
    fields: Callable[[Instruction], tuple[object, ...]] = attrgetter(*names)
    return lambda it: [value for value in fields(it) if isinstance(value, Register)]


_READERS: Final = {kind: _reader(names) for kind, names in _OPERANDS.items()}


def reads(instruction: Instruction) -> list[Register]:
    """Return the registers that the instruction reads."""
    reader = _READERS.get(instruction.__class__)
    if reader is None:
        return []
    found = reader(instruction)
    if isinstance(instruction, Call):
        values = [argument.value for argument in instruction.arguments]
        found += [value for value in values if isinstance(value, Register)]
    elif isinstance(instruction, Bounds) and instruction.element is not None:
        found.append(instruction.element[0])
    return found


def writes(instruction: Instruction) -> Register | None:
    """Return the register that the instruction writes, if any."""
    if instruction.__class__ not in _ASSIGNING:
        return None
    result: Register | None = instruction.result  # type: ignore[attr-defined]
    return result


def all_instructions(block: Block) -> list[Instruction]:
    """Return the block's instructions with its terminator as the last."""
    return block.instructions if block.terminator is None else [*block.instructions,
                                                                block.terminator]  # fmt: skip


class Liveness:
    """The live registers, whose values may still be read, at the start of each block.

    Attributes:
        shared: the bit set (by register index) of registers that are live across blocks.
    """

    def __init__(self, function: Function) -> None:
        self._gen: dict[Block, int] = {}
        self._kill: dict[Block, int] = {}
        self._alive: dict[Block, int] = {}
        for block in function.blocks:
            self._summarise(block)
        self._solve(function)
        self.shared = 0
        for alive in self._alive.values():
            self.shared |= alive

    def at_start(self, block: Block) -> int:
        """Return the bit set of registers that are live at the start of the block."""
        return self._alive[block]

    def at_end(self, block: Block) -> int:
        """Return the bit set of registers that are live after the block's terminator."""
        alive = 0
        for successor in block.successors():
            alive |= self._alive[successor]
        return alive

    def _summarise(self, block: Block) -> None:
        gen = kill = 0
        for instruction in all_instructions(block):
            for register in reads(instruction):
                gen |= (1 << register.index) & ~kill
            target = writes(instruction)
            if target is not None:
                kill |= 1 << target.index
        self._gen[block], self._kill[block], self._alive[block] = gen, kill, gen

    def _solve(self, function: Function) -> None:
        changed = True
        while changed:
            changed = False
            for block in reversed(function.blocks):
                alive = self._gen[block] | (self.at_end(block) & ~self._kill[block])
                if alive != self._alive[block]:
                    self._alive[block] = alive
                    changed = True


def alive_before(block: Block, liveness: Liveness) -> list[int]:
    """Return the bit sets of registers that are live before each instruction and the terminator."""
    alive = liveness.at_end(block)
    out = []
    for instruction in reversed(all_instructions(block)):
        target = writes(instruction)
        if target is not None:
            alive &= ~(1 << target.index)
        for register in reads(instruction):
            alive |= 1 << register.index
        out.append(alive)
    return out[::-1]
