"""Scalar replacement: the members of structs in a frame become registers.

It applies to functions that are inlined, so that nobody sees their frames: to all their slots,
parameters and local variables, if none is used but by loads and stores of 4 or 8 bytes and copies
of whole members. A copy out of a slot becomes stores of its members.

In other functions it applies to those slots that need no memory. In checked builds these have their
values before they are read, and none is stored in them whose check is deferred.
"""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Final

from crs_cc.core.source import Location
from crs_cc.ir.instruction import (
    VARARGS,
    Address,
    Block,
    Bounds,
    Constant,
    Copy,
    Fill,
    Instruction,
    Lifetime,
    Load,
    Move,
    Operand,
    Register,
    SameObject,
    Seal,
    Slot,
    Store,
    Variable,
)
from crs_cc.ir.liveness import Liveness, all_instructions, reads, writes
from crs_cc.ir.program import Function, Parameter, renumber
from crs_cc.ir.types import INT
from crs_cc.ir.value_type import VALUE_TYPE, MemoryType
from crs_cc.runtime.codegen.deferred_checks import DeferredChecks
from crs_cc.runtime.codegen.fuel_charges import FREE_BYTES
from crs_cc.runtime.codegen.known_values import judged_in_memory, read_unassigned
from crs_cc.runtime.codegen.slot_uses import NotReplaceableError, Place, Uses

MAX_FIELDS: Final = 32
"""The limit on the registers that replace the slots of a function."""

MAX_BYTES: Final = 128
"""Larger slots of a function that is not inlined stay in memory."""

_UNKNOWN: Final = Variable("", INT, Location(""))
"""The variable of fields that are not passed, of which `Assignments` finds early reads."""


@dataclass(slots=True, eq=False)
class WriteCheck(Instruction):
    """A check that `size` bytes at `target` can be written; unchecked builds have none."""

    target: Register
    size: int


@dataclass(slots=True, eq=False)
class ReadCheck(Instruction):
    """A check that a struct of `size` bytes at `target` can be passed by value."""

    target: Register
    size: int


@dataclass(frozen=True, slots=True)
class Member:
    """A member of a struct that is passed by value, and the register that takes its place."""

    offset: int
    memory: MemoryType
    register: Register


@dataclass(slots=True, eq=False)
class Replaced:
    """A function without slots.

    Attributes:
        function: the function; its blocks are copies.
        fuel: the fuel of the original of each block.
        members: for each parameter that is a struct, its members that are used.
    """

    function: Function
    fuel: dict[Block, int]
    members: dict[Parameter, list[Member]]


@dataclass(slots=True, eq=False)
class PartiallyReplaced:
    """A function without some of its slots.

    Attributes:
        function: the function; its blocks are copies.
        fuel: the fuel of the original of each block.
        homes: for each register in a slot's place, the slot and the offset in it.
    """

    function: Function
    fuel: dict[Block, int]
    homes: dict[Register, tuple[Slot, int]]


def replace_slots(function: Function, fuel: Mapping[Block, int]) -> Replaced | None:
    """Return a function without its slots; None if there is one that must be in memory.

    Args:
        function: the function.
        fuel: the fuel of each block.
    """
    try:
        return _Replacement(function, fuel).run()
    except NotReplaceableError:
        return None


def replace_some(
    function: Function, fuel: Mapping[Block, int], *, checked: bool
) -> PartiallyReplaced | None:
    """Return a function without those slots that need no memory; None if all do.

    Args:
        function: the function.
        fuel: the fuel of each block.
        checked: whether it is for a checked build, which tests that what is read has a value.
    """
    deferred = DeferredChecks(function, Liveness(function), keep=False) if checked else None
    kept: set[Slot] = {VARARGS}
    kept.update(each.place for each in function.parameters if isinstance(each.place, Slot))
    kept.update(slot for slot in function.slots if slot.size > MAX_BYTES)
    while not kept.issuperset(function.slots):
        replacement = _Replacement(function, fuel, kept=kept, loads=not checked, deferred=deferred)
        try:
            replaced = replacement.run()
        except NotReplaceableError as error:
            if error.slot is None:
                return None
            kept.add(error.slot)
        else:
            homes = {made: place for place, made in replacement.registers.items()}
            return PartiallyReplaced(replaced.function, replaced.fuel, homes)
    return None


def _held_everywhere(function: Function, kept: Container[Slot]) -> dict[Register, Place]:
    """Return the registers that hold the address of a slot wherever they are used.

    These are the parameters of expanded calls: they are assigned once, the address in the same
    block, or another of these registers.
    """
    count: dict[Register, int] = {}
    moves: list[tuple[Register, Register | Place]] = []
    for block in function.blocks:
        holding: dict[Register, Place] = {}
        for it in all_instructions(block):
            target = writes(it)
            if target is None:
                continue
            count[target] = count.get(target, 0) + 1
            is_variable = target.variable is not None  # it may be read without a value
            if isinstance(it, Move) and isinstance(it.source, Register) and not is_variable:
                moves.append((target, holding.get(it.source, it.source)))
            holding.pop(target, None)
            if isinstance(it, Address) and isinstance(it.base, Slot) and it.base not in kept:
                holding[target] = it.base, it.offset
    passed = {each.place for each in function.parameters}
    held: dict[Register, Place] = {}
    for target, source in moves:  # callers before their callees
        place = held.get(source) if isinstance(source, Register) else source
        if place is not None and count[target] == 1 and target not in passed:
            held[target] = place
    return held


def _check_lifetime(
    it: Instruction, holding: Mapping[Register, Place], ended: set[Register]
) -> None:
    """Refuse the use of an address whose object has ended, which is an error to be found."""
    if isinstance(it, Lifetime) and not it.begins:
        ended.update(each for each, (slot, _) in holding.items() if slot is it.slot)
    used = [it.target] if isinstance(it, ReadCheck | WriteCheck) else reads(it)
    for register in used:
        if register in ended and register in holding:
            raise NotReplaceableError(holding[register][0])


class _Replacement:
    """Replaces the slots of one function."""

    def __init__(
        self,
        function: Function,
        fuel: Mapping[Block, int],
        *,
        kept: Container[Slot] = (),
        loads: bool = False,
        deferred: DeferredChecks | None = None,
    ) -> None:
        """Set what to replace.

        Args:
            function: the function.
            fuel: the fuel of each block.
            kept: the slots that stay in memory.
            loads: whether what is copied into a slot may be loaded, though it may have no value.
            deferred: the loads whose checks are deferred; None unless what is read in the function
                must be known to have a value.
        """
        self.function = function
        self.fuel = fuel
        self.kept = kept
        self.loads = loads
        self.deferred = deferred
        self.held = _held_everywhere(function, kept)
        self.uses = Uses()
        self.places: dict[Instruction, dict[Register, Place]] = {}
        self.registers: dict[tuple[Slot, int], Register] = {}

    def run(self) -> Replaced:
        """Return the function without slots."""
        function, liveness = self.function, Liveness(self.function)
        for block in function.blocks:
            self._look(block, liveness.at_end(block))
        self.uses.close()
        registers = list(function.registers)
        passed = {parameter.place for parameter in function.parameters}
        for slot, rows in self.uses.fields.items():
            is_assigned = slot in passed or self.loads or self.deferred is not None
            variable = None if is_assigned else _UNKNOWN
            for at, memory in sorted(rows.items()):
                made = Register(len(registers), VALUE_TYPE[memory], variable)
                self.registers[slot, at] = made
                registers.append(made)
        if len(self.registers) > MAX_FIELDS:
            raise NotReplaceableError(None)
        copied = {block: Block(block.label) for block in function.blocks}
        for block, copy in copied.items():
            copy.instructions = [made for it in block.instructions for made in self._rewrite(it)]
            copy.terminator = renumber(block.terminator, copied.__getitem__)
        if self.deferred is not None:
            self._refuse(read_unassigned(list(copied.values()), self.registers))
            for copy in copied.values():
                copy.instructions = [it for it in copy.instructions if not self._begins(it)]
        changed = replace(
            function,
            slots=[each for each in function.slots if each in self.kept],
            registers=registers,
            blocks=list(copied.values()),
        )
        fuel = {copy: self.fuel[block] for block, copy in copied.items()}
        return Replaced(changed, fuel, self._members())

    def _members(self) -> dict[Parameter, list[Member]]:
        """Return the members of parameters that are structs."""
        found: dict[Parameter, list[Member]] = {}
        for parameter in self.function.parameters:
            slot = parameter.place
            if isinstance(slot, Slot) and slot not in self.kept:
                rows = sorted(self.uses.fields.get(slot, {}).items())
                found[parameter] = [
                    Member(at, memory, self.registers[slot, at]) for at, memory in rows
                ]
                if parameter.memory is not None:
                    raise NotReplaceableError(slot)
        return found

    # -- what is done with slots -----------------------------------------------------------------

    def _look(self, block: Block, live: int) -> None:
        """Collect the uses of slots in a block, and which registers hold their addresses."""
        holding = dict(self.held)
        ended: set[Register] = set()
        for it in all_instructions(block):
            _check_lifetime(it, holding, ended)
            if self.deferred is not None:
                self._refuse(judged_in_memory(it, holding, self.deferred))
            self._use(it, holding)
            target = writes(it)
            if target is not None and target not in self.held:
                holding.pop(target, None)
                ended.discard(target)
                if isinstance(it, Address) and isinstance(it.base, Slot):
                    if it.base in self.kept:
                        continue
                    holding[target] = it.base, it.offset
        for each, (slot, _) in holding.items():
            if live >> each.index & 1 and each not in self.held:
                raise NotReplaceableError(slot)

    def _refuse(self, slot: Slot | None) -> None:
        if slot is not None and slot not in self.kept:
            raise NotReplaceableError(slot)

    def _use(self, it: Instruction, holding: dict[Register, Place]) -> None:
        if self._use_held(it, holding) or (isinstance(it, Bounds | SameObject) and self.loads):
            return
        match it:
            case Load(base=Slot() as slot) | Store(base=Slot() as slot):
                if slot not in self.kept:
                    if isinstance(it, Load) and it.unjudged:
                        raise NotReplaceableError(slot)
                    self.uses.access(slot, it.offset, it.memory)
            case Copy(size=Constant(value=size)):
                self._use_copy(it, int(size), holding)
                return
            case Fill(
                target=Register() as target, value=Constant(value=0), size=Constant() as size
            ):
                if target in holding and size.value < FREE_BYTES:
                    self.places[it] = {target: holding[target]}
                    return
        for register in reads(it):
            if register in holding:
                raise NotReplaceableError(holding[register][0])

    def _use_held(self, it: Instruction, holding: dict[Register, Place]) -> bool:
        """Note a use that only expanded calls make of an address, and return whether it is one."""
        match it:
            case Load(base=Register() as base) | Store(base=Register() as base) if base in holding:
                slot, start = holding[base]
                self.uses.access(slot, start + it.offset, it.memory)
                self.places[it] = {base: holding[base]}
                return isinstance(it, Load) or it.source not in holding
            case ReadCheck(target=base) | WriteCheck(target=base) if base in holding:
                self.places[it] = {base: holding[base]}
                return True
            case Move(result=target, source=Register()):
                return target in self.held
        return False

    def _use_copy(self, it: Copy, size: int, holding: dict[Register, Place]) -> None:
        target, source = self._held(it.target, holding), self._held(it.source, holding)
        for slot, _ in (each for each in (target, source) if each is not None):
            if size >= FREE_BYTES:
                raise NotReplaceableError(slot)
        if target is not None and source is not None:
            if target[0] is source[0] and 0 < abs(target[1] - source[1]) < size:
                raise NotReplaceableError(target[0])
            self.uses.copies.append((target, source, size))
        elif source is not None:
            self.uses.whole.append((source, size))
        elif target is not None:
            if not self.loads:
                raise NotReplaceableError(target[0])
            self.uses.whole.append((target, size))
        self.places[it] = {each: holding[each] for each in reads(it) if each in holding}

    def _held(self, operand: Operand, holding: dict[Register, Place]) -> Place | None:
        return holding.get(operand) if isinstance(operand, Register) else None

    # -- the new instructions ----------------------------------------------------------------------

    def _rewrite(self, it: Instruction) -> Iterable[Instruction]:
        """Return what an instruction becomes."""
        if self._stays(it):
            return [it]
        if (
            isinstance(it, Bounds | SameObject) and self.loads
        ):  # they have no effect in unchecked builds
            return []
        if it in self.places and not isinstance(it, Copy | Fill):
            return self._rewrite_held(it)
        match it:
            case Lifetime() | Seal() | Address(base=Slot()):
                return []
            case Move(result=result) if result in self.held:
                return []
            case Load(base=Slot() as slot):
                return [Move(it.location, it.result, self.registers[slot, it.offset])]
            case Store(base=Slot() as slot):
                return [Move(it.location, self.registers[slot, it.offset], it.source)]
            case Copy() if self.places.get(it):
                return self._copy(it)
            case Fill(target=Register() as target, size=Constant(value=size)) if it in self.places:
                return self._clear(it.location, self.places[it][target], int(size))
        return [it]

    def _rewrite_held(self, it: Instruction) -> list[Instruction]:
        """Return what an instruction of an expanded call becomes."""
        match it:
            case Load(base=Register() as base):
                return [Move(it.location, it.result, self._field(it, base))]
            case Store(base=Register() as base):
                return [Move(it.location, self._field(it, base), it.source)]
        return []

    def _begins(self, it: Instruction) -> bool:
        """Return whether an instruction is the start of an object that is replaced."""
        return isinstance(it, Lifetime) and it.begins and it.slot not in self.kept

    def _stays(self, it: Instruction) -> bool:
        """Return whether an instruction remains: about a slot in memory, or a start."""
        if self.deferred is not None and self._begins(it):
            return True
        match it:
            case Lifetime(slot=slot) | Address(base=Slot() as slot):
                return slot in self.kept
            case Load(base=Slot() as slot) | Store(base=Slot() as slot):
                return slot in self.kept
        return False

    def _field(self, it: Load | Store, base: Register) -> Register:
        slot, start = self.places[it][base]
        return self.registers[slot, start + it.offset]

    def _copy(self, it: Copy) -> Iterator[Instruction]:
        places = self.places[it]
        assert isinstance(it.size, Constant)
        assert isinstance(it.source, Register)
        assert isinstance(it.target, Register)
        size = int(it.size.value)
        if it.source not in places:
            target, to = places[it.target]
            for at, memory in self.uses.within(target, to, size):
                yield Load(it.location, self.registers[target, at], it.source, at - to, memory)
            return
        source, start = places[it.source]
        rows = self.uses.within(source, start, size)
        if it.target in places:
            target, to = places[it.target]
            for at, _ in rows:
                made = self.registers[target, at - start + to]
                yield Move(it.location, made, self.registers[source, at])
            return
        yield WriteCheck(it.location, it.target, size)
        for at, memory in rows:
            yield Store(it.location, it.target, at - start, self.registers[source, at], memory)

    def _clear(self, location: Location, place: Place, size: int) -> Iterator[Instruction]:
        slot, start = place
        for at, memory in self.uses.within(slot, start, size):
            kind = VALUE_TYPE[memory]
            zero = Constant(kind, 0 if kind[0] == "i" else 0.0)
            yield Move(location, self.registers[slot, at], zero)
