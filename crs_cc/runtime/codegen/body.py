"""A small function as it is inlined, see `small_functions`."""

from __future__ import annotations

from dataclasses import dataclass

from crs_cc.ir.definite_assignment import Assignments
from crs_cc.ir.instruction import Binary, Block, Move, Register
from crs_cc.ir.liveness import reads
from crs_cc.ir.program import Function, Parameter
from crs_cc.ir.value_type import MEMORY_SIZE
from crs_cc.runtime.codegen.deferred_checks import DeferredChecks
from crs_cc.runtime.codegen.registers import Registers
from crs_cc.runtime.codegen.scalar_replacement import Member, ReadCheck


@dataclass(slots=True)
class Body:
    """A function that can be inlined, analysed.

    Attributes:
        function: the function, without slots and calls.
        fuel: the fuel of each block.
        members: for each parameter that is a struct, its members that are used.
        registers: its registers by lifetime.
        assigned: which of its registers may be uninitialised: none.
        deferred: its loads whose checks are deferred.
        can_fail: whether it has a check that can fail.
        can_fail_inside: whether it has one that is not of a struct which it takes or returns.
        has_effects: whether it changes memory.
    """

    function: Function
    fuel: dict[Block, int]
    members: dict[Parameter, list[Member]]
    registers: Registers
    assigned: Assignments
    deferred: DeferredChecks
    can_fail: bool = False
    can_fail_inside: bool = False
    has_effects: bool = False

    @property
    def charge(self) -> int:
        """The charge of the frame for its locals, see `registers` [bytes]."""
        return self.registers.charge + self.deferred.charge

    def may_pass_uninitialised(self) -> bool:
        """Return whether a call may succeed although not all of a struct passed is initialised.

        It fails if every member is an operand in the first block.
        """
        used: set[Register] = set()
        moved: dict[Register, Register] = {}
        for it in self.function.blocks[0].instructions:
            if isinstance(it, Move) and isinstance(it.source, Register):
                moved[it.result] = moved.get(it.source, it.source)
            elif isinstance(it, Binary):
                used.update(moved.get(each, each) for each in reads(it))
        for parameter, members in self.members.items():
            size = sum(MEMORY_SIZE[each.memory] for each in members)
            if size < parameter.size or any(each.register not in used for each in members):
                return True
        return any(
            isinstance(it, ReadCheck) for block in self.function.blocks for it in block.instructions
        )
