"""The registers that instructions read and write, and liveness analysis.

>>> from crs_cc.core.source import Location
>>> from crs_cc.ir.instruction import Binary, Constant, Register
>>> a, b = Register(0, "i32"), Register(1, "i32")
>>> add = Binary(Location("x.c"), b, "i32.add", a, Constant("i32", 1))
>>> [register.index for register in reads(add)], writes(add).index
([0], 1)
"""

from __future__ import annotations

from collections.abc import Callable
from operator import attrgetter
from typing import Any, Final

from crs_cc.ir import instruction as ir
from crs_cc.ir.program import Function

_OPERANDS: Final[dict[type[ir.Instruction], tuple[str, ...]]] = {
    ir.Move: ("source",),
    ir.Unary: ("source",),
    ir.Binary: ("left", "right"),
    ir.Load: ("base", "within"),
    ir.Address: ("base",),
    ir.SameObject: ("left", "right"),
    ir.Passed: ("address",),
    ir.Store: ("base", "source", "within"),
    ir.Copy: ("target", "source", "size"),
    ir.Fill: ("target", "value", "size"),
    ir.Mark: ("target", "size"),
    ir.MarkUnset: ("target", "size", "origin"),
    ir.Callers: ("target",),
    ir.State: ("address",),
    ir.Stop: ("value",),
    ir.Branch: ("condition",),
    ir.Switch: ("value",),
    ir.Return: ("value",),
    ir.Request: ("code", "message"),
    ir.SetJump: ("buffer", "activation"),
    ir.LongJump: ("activation", "place", "value"),
}
"""The fields of instructions with the operands that they read."""

_ASSIGNING: Final = frozenset(
    {ir.Move, ir.Unary, ir.Binary, ir.Load, ir.Address, ir.State, ir.Call, ir.Request, ir.SetJump}
)
"""The instructions with a result; looking up the class is faster than `match`."""


def _reader(names: tuple[str, ...]) -> Callable[[ir.Instruction], list[ir.Register]]:
    """Return a function that returns the registers in these fields."""
    if len(names) == 1:
        field: Callable[[ir.Instruction], object] = attrgetter(*names)
        return lambda it: [value] if isinstance(value := field(it), ir.Register) else []
    fields: Callable[[ir.Instruction], tuple[object, ...]] = attrgetter(*names)
    return lambda it: [value for value in fields(it) if isinstance(value, ir.Register)]


def _read_by_call(call: ir.Call) -> list[ir.Register]:
    values = [call.callee, *[argument.value for argument in call.arguments]]
    return [value for value in values if isinstance(value, ir.Register)]


def _read_by_bounds(bounds: ir.Bounds) -> list[ir.Register]:
    values = [bounds.index, bounds.base, bounds.element and bounds.element[0]]
    return [value for value in values if isinstance(value, ir.Register)]


_READERS: Final[dict[type[ir.Instruction], Callable[[Any], list[ir.Register]]]] = {
    **{kind: _reader(names) for kind, names in _OPERANDS.items()},
    ir.Bounds: _read_by_bounds,
    ir.Call: _read_by_call,
}


def reads(instruction: ir.Instruction) -> list[ir.Register]:
    """Return the registers that the instruction reads."""
    reader = _READERS.get(instruction.__class__)
    return reader(instruction) if reader else []


def writes(instruction: ir.Instruction) -> ir.Register | None:
    """Return the register that the instruction writes, if any."""
    if instruction.__class__ not in _ASSIGNING:
        return None
    result: ir.Register | None = instruction.result  # type: ignore[attr-defined]
    return result


def all_instructions(block: ir.Block) -> list[ir.Instruction]:
    """Return the block's instructions with its terminator as the last."""
    return block.instructions if block.terminator is None else [*block.instructions,
                                                                block.terminator]  # fmt: skip


class Liveness:
    """The live registers, whose values may still be read, at the start of each block.

    Attributes:
        shared: the bit set (by register index) of registers that are live across blocks.
    """

    def __init__(self, function: Function) -> None:
        self._gen: dict[ir.Block, int] = {}
        self._kill: dict[ir.Block, int] = {}
        self._live: dict[ir.Block, int] = {}
        for block in function.blocks:
            self._summarise(block)
        self._solve(function)
        self.shared = 0
        for live in self._live.values():
            self.shared |= live

    def at_start(self, block: ir.Block) -> int:
        """Return the bit set of registers that are live at the start of the block."""
        return self._live[block]

    def at_end(self, block: ir.Block) -> int:
        """Return the bit set of registers that are live after the block's terminator."""
        live = 0
        for successor in block.successors():
            live |= self._live[successor]
        return live

    def _summarise(self, block: ir.Block) -> None:
        gen = kill = 0
        for instruction in all_instructions(block):
            for register in reads(instruction):
                gen |= (1 << register.index) & ~kill
            target = writes(instruction)
            if target is not None:
                kill |= 1 << target.index
        self._gen[block], self._kill[block], self._live[block] = gen, kill, gen

    def _solve(self, function: Function) -> None:
        changed = True
        while changed:
            changed = False
            for block in reversed(function.blocks):
                live = self._gen[block] | (self.at_end(block) & ~self._kill[block])
                if live != self._live[block]:
                    self._live[block] = live
                    changed = True


def live_before(block: ir.Block, liveness: Liveness) -> list[int]:
    """Return the bit sets of registers that are live before each instruction and the terminator."""
    live = liveness.at_end(block)
    out = []
    for instruction in reversed(all_instructions(block)):
        target = writes(instruction)
        if target is not None:
            live &= ~(1 << target.index)
        for register in reads(instruction):
            live |= 1 << register.index
        out.append(live)
    return out[::-1]
