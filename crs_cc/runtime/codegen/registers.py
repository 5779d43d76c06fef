"""The registers of a function that need a spill slot in its frame, or a local of their own.

The host spills locals to its own frames, in debug builds each
up to three times. Its stack is three times the program's, see `executable`; if a frame is charged
8 bytes for an integer and 16 for a floating-point number, the program's stack overflows first.
"""

from __future__ import annotations

from collections.abc import Container, Sequence
from typing import Final

from crs_cc.ir.instruction import Block, Call, Register, Request, SetJump, Statement
from crs_cc.ir.liveness import Liveness, all_instructions, live_before, reads, writes
from crs_cc.ir.loops import loop_headers
from crs_cc.ir.program import Function

CHARGES: Final = {"i32": 8, "i64": 8, "f32": 16, "f64": 16}
"""The charge of a frame for a local [bytes], by its type."""


class Registers:
    """The registers of a function, by lifetime.

    Attributes:
        headers: the blocks where the function may be suspended when it is out of fuel.
        saved: the registers that must survive a suspension, and all that hold variables.
        lasting: the registers that keep their local through the whole function.
        charge: the frame's charge for these and the maximum of others live at once [bytes].
    """

    def __init__(
        self,
        function: Function,
        liveness: Liveness,
        more: Sequence[Register],
        *,
        inlined: Container[Call],
        debug: bool,
    ) -> None:
        """Find the lifetimes.

        Args:
            function: the function.
            liveness: its live registers.
            more: registers of the code generator that must survive a suspension.
            inlined: its calls in which it cannot be suspended.
            debug: whether it can be suspended before every statement and behind every call.
        """
        self.headers = loop_headers(function)
        self._last: dict[Block, list[list[Register]]] = {}
        live = 0
        for block in function.blocks:
            if block in self.headers:
                live |= liveness.at_start(block)
            end = block.terminator
            is_inlined = isinstance(end, Call) and end in inlined
            if isinstance(end, Call | Request | SetJump) and not is_inlined:
                behind = liveness.at_end(block)
                result = writes(end)  # known only when the function continues
                if result is not None and not (debug and isinstance(end, Call)):
                    behind &= ~(1 << result.index)
                live |= behind
                kept = [end.callee] if isinstance(end, Call) else reads(end)
                for register in kept:
                    live |= 1 << register.index if isinstance(register, Register) else 0
            if debug:
                before = live_before(block, liveness)
                for instruction, bits in zip(block.instructions, before, strict=False):
                    live |= bits if isinstance(instruction, Statement) else 0
        saved = [each for each in function.registers if live >> each.index & 1 or each.variable]
        self.saved = list(dict.fromkeys([*saved, *more]))
        shared = [each for each in function.registers if liveness.shared >> each.index & 1]
        self.lasting = dict.fromkeys([*self.saved, *shared])
        self.charge = sum(CHARGES[register.type] for register in self.lasting)
        self.charge += max(map(self._most, function.blocks), default=0)

    def _most(self, block: Block) -> int:
        """Return the maximum charge for the registers of a block that are live at once [bytes]."""
        size = most = 0
        live: set[Register] = set()
        for instruction, last in zip(all_instructions(block), self.last_uses(block), strict=True):
            target = writes(instruction)
            if target is not None and target not in live and target not in self.lasting:
                live.add(target)
                size += CHARGES[target.type]
            most = max(most, size)
            for register in last:
                live.discard(register)
                size -= CHARGES[register.type]
        return most

    def last_uses(self, block: Block) -> list[list[Register]]:
        """Return, for each instruction, the short-lived registers whose last use it is."""
        if block in self._last:
            return self._last[block]
        instructions = all_instructions(block)
        last: list[list[Register]] = [[] for _ in instructions]
        seen: set[Register] = set()
        for number in range(len(instructions) - 1, -1, -1):
            registers = reads(instructions[number])
            target = writes(instructions[number])
            if target:
                registers.append(target)
            for register in registers:
                if register not in seen and register not in self.lasting:
                    seen.add(register)
                    last[number].append(register)
        self._last[block] = last
        return last
