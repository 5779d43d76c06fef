"""Checked memory access: the shadow memory is tested before each access not known to be valid.

Known facts need no test: a constant offset in an object that is named, and
whatever was tested before in the same block and cannot have changed since. Only allocation, calls
and ends of scopes make bytes inaccessible, and only copies of uninitialised bytes make them so.

A value that is loaded only to be stored elsewhere is not checked: its state is copied with it. So
`t = a[i]; a[i] = a[j]; a[j] = t` works on uninitialised bytes, as it does in C.
"""

from __future__ import annotations

from collections.abc import Container, Mapping
from dataclasses import dataclass, field
from typing import Final, TypeAlias

from crs_cc.core.source import Location
from crs_cc.ir.definite_assignment import Assignments
from crs_cc.ir.instruction import (
    Base,
    Block,
    ByteState,
    Constant,
    Copy,
    Fill,
    Instruction,
    Lifetime,
    Load,
    Operand,
    Register,
    Seal,
    Slot,
    Store,
)
from crs_cc.ir.value_type import MEMORY_SIZE
from crs_cc.requests import MESSAGE, slot_offset
from crs_cc.runtime.codegen import indices, inline_ranges, origins, same_object, shadow
from crs_cc.runtime.codegen.checked_pointers import CheckedPointers
from crs_cc.runtime.codegen.deferred_checks import DeferredChecks
from crs_cc.runtime.codegen.indices import (
    ADDRESS,
    MAILBOX,
    MEMORY,
    SHADOW,
    SLOT_GLOBAL,
    SP,
    STATES,
    WIDE_STATES,
)
from crs_cc.runtime.codegen.memory_instructions import LOADS, STORES
from crs_cc.runtime.codegen.value_numbering import KnownBytes
from crs_cc.runtime.codegen.writer import Writer
from crs_cc.runtime.layout import NULL_SIZE
from crs_cc.runtime.sites import Access, Site
from crs_cc.runtime.wasm import UNLIKELY, Instr

LAST_BYTES: Final = -8
"""The first address at which a load of eight states could exceed the shadow memory."""

_At: TypeAlias = tuple[Instr, int]
"""An instruction that pushes an address, and the static offset to use with it."""


@dataclass(frozen=True, slots=True)
class _StoredStates:
    """The states of a stored value, as code.

    Attributes:
        states: code that pushes them.
        joined: code that combines them with those on the stack, valid if both are.
        uninitialised: code that makes the i32 on the stack not zero if the value may be that.
    """

    states: list[Instr]
    joined: list[Instr] = field(default_factory=list)
    uninitialised: list[Instr] = field(default_factory=list)

    @property
    def is_initialised(self) -> bool:
        """Return whether the value is known to be initialised."""
        return len(self.states) == 1 and not self.joined


class CheckedMemory(CheckedPointers):
    """Writes checked accesses.

    Attributes:
        deferred: the loads whose states are copied, and their targets.
        assignments: the variables in registers that may be uninitialised.
    """

    def __init__(
        self,
        writer: Writer,
        deferred: DeferredChecks,
        assignments: Assignments,
        sole: Mapping[Block, Block],
        lasting: Container[Slot] = (),
    ) -> None:
        super().__init__(writer, sole, lasting)
        self.deferred = deferred
        self.assignments = assignments
        self._taken: set[Register] = set()

    def before(self, it: Instruction) -> None:
        """Check that the registers read by an instruction are initialised, and update the flags."""
        writer, found = self.writer, self.assignments
        for register, variable in found.tests.get(it, ()):
            writer.code += [writer.value(found.flags[register]), ("i32.eqz",)]
            site = Site("uninitialised read", it.location, "", 0, variable)
            writer.fail_if(site, [("i32.const", 0)])
        change = found.changes.get(it)
        if change is not None:
            one = ("i32.const", 1)
            writer.code.append(one if change.source is None else writer.value(change.source))
            writer.pop(change.flag)

    # -- tests -------------------------------------------------------------------------------

    def place(self, base: Base, offset: int) -> tuple[Instr, int]:
        """Return an instruction that pushes an address, and the static offset to use with it.

        A pointer that was not checked may wrap around when the offset is added.
        """
        writer = self.writer
        if not isinstance(base, Register) or offset == 0:
            return super().place(base, offset)
        if 0 < offset < NULL_SIZE and self._accessible(base, 0, 1):
            return writer.value(base), offset
        writer.code += [writer.value(base), ("i32.const", offset), ("i32.add",)]
        writer.code.append(("local.set", ADDRESS))
        return ("local.get", ADDRESS), 0

    def _test(self, states: list[Instr], test: list[Instr], site: Site, at: _At) -> None:
        """Stop the program if `test` fails on the pushed states."""
        push, offset = at
        blamed = [push, ("i32.const", offset), ("i32.add",)] if offset else [push]
        self.writer.code += [*states, *test]
        self.writer.fail_if(site, blamed)

    def _exclude_last_bytes(self, push: Instr, site: Site) -> None:
        """Leave an inlined call before an access to the shadow memory that would trap.

        A trap is explained from the stack, on which inlined calls are not, see `diagnosis.trap`.
        """
        if self.writer.side_exit is not None:
            self.writer.code += [push, ("i32.const", LAST_BYTES), ("i32.ge_u",)]
            self.writer.fail_if(site, [])

    def load(self, it: Load) -> None:
        """Write `result = *(base + offset)`."""
        if it.within is not None:
            self.stay_within(it, "read")
        if not self._valued(it.base, it.offset, MEMORY_SIZE[it.memory]):
            self._test_load(it)
        else:
            self._load(it, self.place(it.base, it.offset))

    def _load(self, it: Load, at: _At) -> None:
        push, offset = at
        self.writer.code += [push, (LOADS[it.memory], MEMORY, offset)]
        self.writer.pop(it.result)

    def _test_load(self, it: Load) -> None:
        size = MEMORY_SIZE[it.memory]
        where = self.places.of(it.base, it.offset)
        accessible = self._accessible(it.base, it.offset, size)
        at = push, offset = self.place(it.base, it.offset)
        site = Site("memory", it.location, "read", size)
        if not accessible:
            self._exclude_last_bytes(push, site)
        found = [push, shadow.load(size, offset)]
        changing = self.deferred.changing.get(it)
        copied, flag = self.deferred.states_of(it), self.deferred.flag_of(it)
        if copied is not None:
            self.writer.code += found
            self.writer.pop(copied)
            self._taken.add(copied)
            found = [self.writer.value(copied)]
        unjudged = it.unjudged or copied is not None or self.deferred.is_unused(it)
        if flag is not None:
            self._set_flag(flag, found, site, None if accessible else at)
        elif not unjudged:
            self._test_readable(found, site, at, changing, is_const=it.is_const)
        elif not accessible:
            bits = shadow.ACCESSIBLE if changing is None else shadow.WRITABLE
            self._test(found, shadow.any_without(bits, size), site, at)
        if changing is not None and flag is None and not (unjudged and accessible):
            self.facts.writable.add(where, size, valued=False)
        self.proved.add(where, size, valued=flag is None and not unjudged)
        self._load(it, at)

    def _test_readable(
        self,
        found: list[Instr],
        site: Site,
        at: _At,
        changing: Store | None,
        *,
        is_const: bool,
    ) -> None:
        """Stop the program unless the states are those of readable bytes.

        Args:
            found: code that pushes the states.
            site: the site to report.
            at: the address of the bytes.
            changing: the store to the same bytes that follows; they must be writable for it.
            is_const: whether they are likely to be constant.
        """
        size, code = site.size, self.writer.code
        if is_const:
            self._test(found, shadow.any_without(shadow.READABLE, size), site, at)
            return
        local = WIDE_STATES if size == 8 else STATES
        code += [*found, ("local.tee", local), *shadow.not_all_valid(size), UNLIKELY]
        states: list[Instr] = [("local.get", local)]
        self._test(states, shadow.any_without(shadow.READABLE, size), site, at)
        if changing is not None:
            written = Site("memory", changing.location, "write", size)
            self._test(states, shadow.any_without(shadow.WRITABLE, size), written, at)
        code.append(("end",))

    def _set_flag(self, flag: Register, found: list[Instr], site: Site, at: _At | None) -> None:
        """Set a flag if the states loaded include an uninitialised byte.

        Args:
            flag: the flag.
            found: code that pushes the states.
            site: the site to report if the bytes are inaccessible.
            at: their address; None if they are known to be accessible.
        """
        writer = self.writer
        if flag not in self._taken:
            writer.push(Constant("i32", 0))
            writer.pop(flag)
            self._taken.add(flag)
        local = WIDE_STATES if site.size == 8 else STATES
        writer.code += [*found, ("local.tee", local), *shadow.not_all_valid(site.size), UNLIKELY]
        states: list[Instr] = [("local.get", local)]
        if at is not None:
            self._test(states, shadow.any_without(shadow.ACCESSIBLE, site.size), site, at)
        writer.code += [
            writer.value(flag),
            *states,
            *shadow.any_without(shadow.READABLE, site.size),
        ]
        writer.code.append(("i32.or",))
        writer.pop(flag)
        writer.code.append(("end",))

    def store(self, it: Store) -> None:
        """Write `*(base + offset) = source`."""
        size, code = MEMORY_SIZE[it.memory], self.writer.code
        if it.within is not None:
            self.stay_within(it, "write")
        where = self.places.of(it.base, it.offset)
        accessible = self._writable(it.base, it.offset, size)
        accessible |= not isinstance(it.base, Register) and self._inside(it.base, it.offset, size)
        valued = self._valued(it.base, it.offset, size)
        at = push, offset = self.place(it.base, it.offset)
        given = self._stored_states(it, size)
        if accessible and not (valued and given.is_initialised):
            code += [push, *given.states, shadow.store(size, offset)]
        elif not accessible:
            self._test_store(it, at, given)
        if not given.is_initialised:
            self.proved.forget_value(where)
        self.proved.add(where, size, valued=given.is_initialised)
        self.facts.writable.add(where, size, valued=False)
        code += [push, self.writer.value(it.source), (STORES[it.memory], MEMORY, offset)]

    def _stored_states(self, it: Store, size: int) -> _StoredStates:
        """Return the states of the stored value."""
        value = shadow.repeated(ByteState.WITH_VALUE, size)
        none = origins.states_of(it, self.writer.names)
        copied, flag = self.deferred.copied_by(it), self.deferred.converted_for(it)
        assigned = self.assignments.stored.get(it)
        if copied in self._taken:
            states = [self.writer.value(self._last_use(copied, it)), *shadow.unsealing(size)]
            return _StoredStates(states, [*states, (f"{shadow.kind(size)}.and",)])
        if flag in self._taken:
            push = self.writer.value(self._last_use(flag, it))
            return _StoredStates([none, value, push, ("select",)], [], [push, ("i32.or",)])
        if assigned is not None:
            push = self.writer.value(assigned)
            uninitialised = [push, ("i32.eqz",), ("i32.or",)]
            return _StoredStates([value, none, push, ("select",)], [], uninitialised)
        return _StoredStates([value])

    def _last_use(self, register: Register | None, it: Store) -> Register:
        """Return a register with states, or a flag, and release it at its last use."""
        assert register is not None
        if self.deferred.is_last(it, register):
            self._taken.discard(register)
            self.writer.release(register)
        return register

    def _test_store(self, it: Store, at: _At, given: _StoredStates) -> None:
        """Check an address and set the states of the value stored there.

        In the common case, initialised before and after, there is a single test.
        """
        size, code = MEMORY_SIZE[it.memory], self.writer.code
        push, offset = at
        local = WIDE_STATES if size == 8 else STATES
        site = Site("memory", it.location, "write", size)
        self._exclude_last_bytes(push, site)
        code += [push, shadow.load(size, offset), ("local.tee", local), *given.joined]
        code += [*shadow.not_all_valid(size), *given.uninitialised, UNLIKELY]
        self._test([("local.get", local)], shadow.any_without(shadow.WRITABLE, size), site, at)
        code += [push, *given.states, shadow.store(size, offset), ("end",)]

    def check_range(
        self, address: Operand, size: Operand, location: Location, access: Access
    ) -> None:
        """Check that `size` bytes at `address` are accessible."""
        writes = access == "write"
        if isinstance(size, Constant) and isinstance(address, Register):
            where, length = self.places.of(address, 0), int(size.value)
            known = self._writable if writes else self._accessible
            if length == 0 or known(address, 0, length):
                return
            self.proved.add(where, length, valued=False)
            if writes:
                self.facts.writable.add(where, length, valued=False)
        bits = shadow.WRITABLE if writes else shadow.ACCESSIBLE
        writer = self.writer
        self._exclude_last_bytes(writer.value(address), Site("memory", location, access))
        few = inline_ranges.short(size, inline_ranges.MAX_COPIED)
        if few:
            push = writer.value(address)
            for test in shadow.any_in_range_without(bits, push, few):
                writer.code += test
                writer.fail_if(Site("memory", location, access, few), [push])
            return
        self._check_many(address, size, location, access, bits)

    def _check_many(
        self, address: Operand, size: Operand, location: Location, access: Access, bits: int
    ) -> None:
        """Check that each of many bytes has a bit; leave the result in `WIDE_STATES`."""
        writer = self.writer
        writer.code += [writer.value(address), writer.value(size), shadow.repeated(bits, 8)]
        writer.code += [("call", indices.INACCESSIBLE), ("local.tee", WIDE_STATES)]
        writer.code += [("i64.const", 0), ("i64.ge_s",), UNLIKELY]
        writer.code += [("global.get", SLOT_GLOBAL), writer.value(size)]
        writer.code.append(("i32.store", MAILBOX, slot_offset("error_size")))
        first = [("local.get", WIDE_STATES), ("i32.wrap_i64",)]
        writer.fail(Site("memory", location, access), first)
        writer.code.append(("end",))

    def check_passed(self, address: Register, size: Constant, location: Location) -> None:
        """Check that a struct that an inlined function is passed is initialised.

        If not all of it is, the call is made: a member may never be used.
        """
        few = inline_ranges.short(size, inline_ranges.MAX_COPIED)
        if not few:
            self.check_range(address, size, location, "read")
        elif not self._valued(address, 0, few):
            writer, site = self.writer, Site("memory", location, "read", few)
            push = writer.value(address)
            self._exclude_last_bytes(push, site)
            for test in shadow.any_in_range_without(shadow.READABLE, push, few):
                writer.code += test
                writer.fail_if(site, [push])
            self.proved.add(self.places.of(address, 0), few, valued=True)

    def copy(self, it: Copy) -> None:
        """Write a `memmove`, which copies states too."""
        self.check_range(it.target, it.size, it.location, "write")
        if inline_ranges.short(it.size, inline_ranges.MAX_COPIED):
            self.check_range(it.source, it.size, it.location, "read")
            super().copy(it)
        else:
            self._copy_many(it)
        self.proved.forget_values()

    def _copy_many(self, it: Copy) -> None:
        """Write a long copy; constant bytes become writable in it."""
        root = self.places.of(it.source, 0)[0] if isinstance(it.source, Register) else None
        size = int(it.size.value) if isinstance(it.size, Constant) else 0
        if size and self._changes(root) and self._accessible(it.source, 0, size):  # type: ignore[arg-type]
            super().copy(it)
            return
        writer = self.writer
        self._check_many(it.source, it.size, it.location, "read", shadow.ACCESSIBLE)
        super().copy(it)
        writer.code += [("local.get", WIDE_STATES), ("i64.const", shadow.SOME_CONSTANT)]
        writer.code += [("i64.eq",), UNLIKELY, writer.value(it.target), writer.value(it.size)]
        writer.code += [("call", indices.UNSEALED), ("end",)]

    def fill(self, it: Fill) -> None:
        """Write a `memset`."""
        self.check_range(it.target, it.size, it.location, "write")
        super().fill(it)
        if isinstance(it.size, Constant) and isinstance(it.target, Register):
            where = self.places.of(it.target, 0)
            self.proved.add(where, int(it.size.value), valued=True)
            self.facts.writable.add(where, int(it.size.value), valued=False)

    def check_message(self, address: Operand, location: Location) -> None:
        """Check that the message of a request is accessible, its first word alone as elsewhere."""
        push, size = self.writer.value(address), MESSAGE.itemsize
        first = [push, shadow.load(8, 0), *shadow.any_without(shadow.WRITABLE, 8)]
        for test in (first, inline_ranges.some_clear(SHADOW, push, size, shadow.WRITABLE)):
            self.writer.code += test
            self.writer.fail_if(Site("memory", location, "read", size), [push])

    def lifetime(self, it: Lifetime) -> None:
        """Start or end the lifetime of an object in a slot."""
        offset, writer = self.writer.frame.offsets[it.slot], self.writer
        if it.begins:
            writer.code += origins.begin(it.slot, offset, it.location, writer.names)
            self.facts.ended.discard(it.slot)
            self.proved.forget_value((it.slot, 0))
        else:
            gone = ByteState.INACCESSIBLE
            writer.code += shadow.fill(("local.get", SP), offset, it.slot.size, gone)
            self.facts.ended.add(it.slot)
            self.writer.code += same_object.forget_last()
            # also of elements, at computed addresses
            self.facts.proved, self.facts.writable = KnownBytes(), KnownBytes()

    def seal(self, it: Seal) -> None:
        """Make an object in a slot constant."""
        offset = self.writer.frame.offsets[it.slot]
        state = ByteState.CONSTANT
        self.writer.code += shadow.fill(("local.get", SP), offset, it.slot.size, state)
        self.facts.writable.forget(it.slot)
