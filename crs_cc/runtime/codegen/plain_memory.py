"""Unchecked memory access: for unchecked builds, and for the allocator in all builds.

`CheckedMemory` does the same with checks. The one that a `Selector` has decides how `Load`,
`Store` and operations on ranges are generated.
"""

from __future__ import annotations

from crs_cc.core.source import Location
from crs_cc.ir.instruction import (
    Base,
    Block,
    Bounds,
    ByteState,
    Callers,
    Constant,
    Copy,
    Fill,
    Instruction,
    Lifetime,
    Load,
    Mark,
    MarkUnset,
    Operand,
    Passed,
    Register,
    SameObject,
    Seal,
    Slot,
    State,
    Store,
)
from crs_cc.requests import MESSAGE
from crs_cc.runtime.codegen import indices, inline_ranges, same_object, shadow
from crs_cc.runtime.codegen.indices import ADDRESS, FP, MEMORY, OUTSIDE, SHADOW, SP
from crs_cc.runtime.codegen.inline_ranges import short
from crs_cc.runtime.codegen.memory_instructions import LOADS, STORES
from crs_cc.runtime.codegen.scalar_replacement import ReadCheck, WriteCheck
from crs_cc.runtime.codegen.writer import Writer
from crs_cc.runtime.layout import NULL_SIZE
from crs_cc.runtime.sites import Access, Site
from crs_cc.runtime.wasm import Instr


class PlainMemory:
    """Writes unchecked accesses.

    Attributes:
        shadowed: whether there is a shadow memory to be updated.
    """

    def __init__(self, writer: Writer, *, shadowed: bool) -> None:
        self.writer = writer
        self.shadowed = shadowed

    def forget(self) -> None:
        """Discard known facts at a join of control flow."""

    def begin(self, block: Block) -> None:
        """Restore the facts at the start of a block."""

    def end(self, block: Block) -> None:
        """Record the facts known at the end of a block."""

    def before(self, it: Instruction) -> None:
        """Check the registers that an instruction reads."""

    def after(self, it: Instruction) -> None:
        """Update known facts after an instruction."""

    def place(self, base: Base, offset: int) -> tuple[Instr, int]:
        """Return an instruction that pushes an address, and the static offset to use with it.

        The code written before it may change local `ADDRESS`.
        """
        writer = self.writer
        if isinstance(base, Slot):
            return ("local.get", SP), writer.frame.offsets[base] + offset
        if isinstance(base, str):
            return ("i32.const", writer.names.addresses[base] + offset), 0
        push = writer.value(base)
        if 0 <= offset < NULL_SIZE:
            return push, offset
        writer.code += [push, ("i32.const", offset), ("i32.add",), ("local.set", ADDRESS)]
        return ("local.get", ADDRESS), 0

    def bounds(self, it: Bounds) -> None:
        """Check that an index is that of an element of an array."""

    def same_object(self, it: SameObject) -> None:
        """Check that two pointers are to one object."""

    def passed(self, it: Passed) -> None:
        """Check that a variable argument was passed as some type."""

    def load(self, it: Load) -> None:
        """Write `result = *(base + offset)`."""
        push, offset = self.place(it.base, it.offset)
        self.writer.code += [push, (LOADS[it.memory], MEMORY, offset)]
        self.writer.pop(it.result)

    def store(self, it: Store) -> None:
        """Write `*(base + offset) = source`."""
        push, offset = self.place(it.base, it.offset)
        self.writer.code += [push, self.writer.value(it.source)]
        self.writer.code.append((STORES[it.memory], MEMORY, offset))

    def copy(self, it: Copy) -> None:
        """Write a `memmove`."""
        writer = self.writer
        writer.charge(it.size)
        size = short(it.size, inline_ranges.MAX_COPIED)
        target, source = writer.value(it.target), writer.value(it.source)
        for memory in (MEMORY, SHADOW) if self.shadowed else (MEMORY,):
            if size:
                change = shadow.unsealing if memory == SHADOW else None
                writer.code += inline_ranges.copy(memory, target, source, size, change=change)
                continue
            writer.code += [writer.value(each) for each in (it.target, it.source, it.size)]
            writer.code.append(("memory.copy", memory, memory))

    def fill(self, it: Fill) -> None:
        """Write a `memset`."""
        writer = self.writer
        writer.charge(it.size)
        size = short(it.size, inline_ranges.MAX_FILLED)
        if size and isinstance(it.value, Constant):
            target, value = writer.value(it.target), int(it.value.value)
            writer.code += inline_ranges.fill(MEMORY, target, 0, size, value)
        else:
            writer.code += [writer.value(each) for each in (it.target, it.value, it.size)]
            writer.code.append(("memory.fill", MEMORY))
        self.set_states(it.target, it.size, ByteState.WITH_VALUE)

    def argument(self, value: Operand, offset: int, size: Operand, location: Location) -> None:
        """Copy a struct to the arguments of a call, at SP + `offset`."""
        writer = self.writer
        self.check_range(value, size, location, "read")
        writer.charge(size)
        few = short(size, inline_ranges.MAX_COPIED)
        sp, source = ("local.get", SP), writer.value(value)
        for memory in (MEMORY, SHADOW) if self.shadowed else (MEMORY,):
            if few:
                change = shadow.unsealing if memory == SHADOW else None
                writer.code += inline_ranges.copy(memory, sp, source, few, offset, change=change)
                continue
            writer.code += [sp, ("i32.const", offset), ("i32.add",), source, writer.value(size)]
            writer.code.append(("memory.copy", memory, memory))

    def check_range(
        self, address: Operand, size: Operand, location: Location, access: Access
    ) -> None:
        """Check that `size` bytes at `address` are accessible."""

    def writable(self, it: WriteCheck) -> None:
        """Check that a struct can be written."""
        self.check_range(it.target, Constant("i32", it.size), it.location, "write")

    def readable(self, it: ReadCheck) -> None:
        """Check that a struct can be passed, and charge for it."""
        size = Constant("i32", it.size)
        self.check_passed(it.target, size, it.location)
        self.writer.charge(size)

    def check_passed(self, address: Register, size: Constant, location: Location) -> None:
        """Check that a struct that an inlined function is passed is initialised."""

    def check_message(self, address: Operand, location: Location) -> None:
        """Check that the message of a request is in memory."""
        writer = self.writer
        size = ("i32.const", MESSAGE.itemsize)
        writer.code += [writer.value(address), size, ("call", OUTSIDE)]
        writer.fail_if(Site("memory", location, "read"), [writer.value(address)])

    def set_message(self, address: Operand) -> None:
        """Set the states of the message of a request that was answered."""
        if self.shadowed:
            push, state = self.writer.value(address), ByteState.WITH_VALUE
            self.writer.code += inline_ranges.fill_wide(SHADOW, push, MESSAGE.itemsize, state)

    def set_states(self, address: Operand, size: Operand, state: int) -> None:
        """Set the states of bytes, if there is a shadow memory."""
        few = short(size, inline_ranges.MAX_FILLED)
        if self.shadowed and few:
            self.writer.code += shadow.fill(self.writer.value(address), 0, few, state)
        elif self.shadowed:
            writer = self.writer
            writer.code += [writer.value(address), ("i32.const", state), writer.value(size)]
            writer.code.append(("memory.fill", SHADOW))

    def mark(self, it: Mark) -> None:
        """Set the states of a heap block."""
        self.writer.charge(it.size)
        self.set_states(it.target, it.size, it.state)
        if self.shadowed and it.state == ByteState.INACCESSIBLE:
            self.writer.code += same_object.forget_at(self.writer.value(it.target))

    def mark_unset(self, it: MarkUnset) -> None:
        """Make bytes of a heap block accessible, without value."""
        writer = self.writer
        writer.charge(it.size)
        if self.shadowed:
            writer.code += [writer.value(each) for each in (it.target, it.size, it.origin)]
            writer.code.append(("call", indices.UNSET))

    def callers(self, it: Callers) -> None:
        """Store the call sites on the stack."""
        if self.shadowed:
            writer = self.writer
            writer.code += [("local.get", FP), writer.value(it.target)]
            writer.code += [("i32.const", it.count), ("call", indices.CALLERS)]

    def state(self, it: State) -> None:
        """Load the state of a byte."""
        writer = self.writer
        if self.shadowed:
            writer.code += [writer.value(it.address), ("i32.load8_u", SHADOW, 0)]
        else:
            writer.push(Constant("i32", ByteState.INACCESSIBLE))
        writer.pop(it.result)

    def lifetime(self, it: Lifetime) -> None:
        """Start or end the lifetime of an object in a slot."""

    def seal(self, it: Seal) -> None:
        """Make an object in a slot constant."""
