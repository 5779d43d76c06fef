"""Checks of pointers that need no state of bytes: bounds, pairs of pointers, variable arguments.

An index is compared with the length of its array, and an address with the bounds of the object that
it was computed from, see `ir.pointer_bases`. Whether two pointers are to one object is looked up,
see `same_object`; variable arguments have states that say as what they were passed.
"""

from __future__ import annotations

from collections.abc import Container, Mapping

from crs_cc.ir.instruction import (
    Base,
    Block,
    Bounds,
    ByteState,
    Load,
    Passed,
    Register,
    SameObject,
    Slot,
    Store,
    passed_state,
)
from crs_cc.ir.names import in_library
from crs_cc.ir.pointer_bases import NEAR
from crs_cc.ir.value_type import MEMORY_SIZE
from crs_cc.requests import slot_offset, timing_offset
from crs_cc.runtime.codegen import same_object
from crs_cc.runtime.codegen.indices import (
    ADDRESS,
    MAILBOX,
    MEMORY,
    SHADOW,
    SLOT_GLOBAL,
    SP,
    STATES,
    UNRELATED,
)
from crs_cc.runtime.codegen.known_memory import KnownMemory
from crs_cc.runtime.codegen.writer import Writer
from crs_cc.runtime.layout import ASKED, MEMORY_BYTES
from crs_cc.runtime.sites import Access, Site
from crs_cc.runtime.wasm import UNLIKELY, Instr


class CheckedPointers(KnownMemory):
    """Writes these checks.

    Attributes:
        lasting: the slots whose lifetime is that of the function.
    """

    def __init__(
        self, writer: Writer, sole: Mapping[Block, Block], lasting: Container[Slot]
    ) -> None:
        super().__init__(writer, sole)
        self.lasting = lasting

    def bounds(self, it: Bounds) -> None:
        """Write the comparison of an index with the length of an array.

        If the whole array is accessible, so is the element.
        """
        length = it.array.length or 0
        root, constant = self.places.value(it.index)
        place = root, constant + it.shift
        if self.facts.indices.get(place, length + 1) > length:
            self._compare_index(it, length)
            self.facts.indices[place] = length
        if it.element is None:
            return
        self.facts.within.add(self.places.of(*it.element), it.array.element.size, valued=False)
        if self._accessible(it.base, it.offset, it.array.size):
            valued = self._valued(it.base, it.offset, it.array.size)
            where = self.places.of(*it.element)
            self.proved.add(where, it.array.element.size, valued=valued)
            if self._writable(it.base, it.offset, it.array.size):
                self.facts.writable.add(where, it.array.element.size, valued=False)

    def _compare_index(self, it: Bounds, length: int) -> None:
        writer, push = self.writer, [self.writer.value(it.index)]
        if it.shift:
            push += [("i32.const", it.shift), ("i32.add",)]
        writer.code += [*push, ("i32.const", length), ("i32.ge_u",), UNLIKELY]
        if writer.side_exit is None:
            writer.code.append(("global.get", SLOT_GLOBAL))
            writer.address(it.base, it.offset)
            writer.code.append(("i32.store", MAILBOX, slot_offset("error_base")))
        writer.fail(Site("out of bounds", it.location, array=it.array), push)
        writer.code.append(("end",))

    def same_object(self, it: SameObject) -> None:
        """Write the check that two pointers are to one object, unless they are known to be.

        A comparison of others does not stop the program; the first one is noted.
        """
        (left, _), (right, _) = self.places.value(it.left), self.places.value(it.right)
        if left == right:
            return
        writer, push = self.writer, (self.writer.value(it.left), self.writer.value(it.right))
        writer.code += [*same_object.is_new(*push), UNLIKELY]
        writer.code += [*push, ("i32.const", it.size), ("call", UNRELATED), UNLIKELY]
        site = Site("unrelated pointers", it.location)
        if it.is_order:
            self._note_order(site, push)
        else:
            if writer.side_exit is None:
                writer.code += [("global.get", SLOT_GLOBAL), push[1]]
                writer.code.append(("i32.store", MAILBOX, slot_offset("error_base")))
            writer.fail(site, [push[0]])
        writer.code += [("end",), ("end",)]

    def _note_order(self, site: Site, pointers: tuple[Instr, Instr]) -> None:
        """Note a comparison, if it is the first one."""
        slot: Instr = ("global.get", SLOT_GLOBAL)
        noted = timing_offset("compared_site")
        code = [slot, ("i32.load", MAILBOX, noted), ("i32.eqz",), ("if",)]
        code += [slot, ("i32.const", self.writer.names.number(site) + 1)]
        code += [("i32.store", MAILBOX, noted)]
        for name, pointer in zip(("compared_left", "compared_right"), pointers, strict=True):
            code += [slot, pointer, ("i32.store", MAILBOX, timing_offset(name))]
        self.writer.code += [*code, ("end",)]

    def passed(self, it: Passed) -> None:
        """Write the check that a variable argument was passed as some type.

        An integer 0 may be passed for a pointer. The library reads both alike.
        """
        writer, push = self.writer, self.writer.value(it.address)
        state = passed_state(it.ctype)
        found: Instr = ("local.get", STATES)
        writer.code += [push, ("i32.load8_u", SHADOW, 0), ("local.tee", STATES)]
        writer.code += [("i32.const", state or 0), ("i32.ne",), UNLIKELY]
        least, end = ByteState.PASSED_STRUCT, ByteState.CONSTANT
        is_known: list[Instr] = [found, ("i32.const", least), ("i32.sub",)]
        is_known += [("i32.const", end - least), ("i32.lt_u",)]
        writer.code += is_known
        integer, pointer = ByteState.PASSED_INTEGER, ByteState.PASSED_POINTER
        if in_library(it.location) and state in (integer, pointer):
            other = pointer if state is integer else integer
            writer.code += [found, ("i32.const", other), ("i32.ne",), ("i32.and",)]
        elif state is pointer:
            writer.code += [push, ("local.get", SP), *is_known, ("select",)]
            writer.code += [("i32.load", MEMORY, 0), ("i32.const", 0), ("i32.ne",)]
            writer.code += [found, ("i32.const", integer), ("i32.ne",), ("i32.or",), ("i32.and",)]
        writer.fail_if(Site("mismatched argument", it.location, ctype=it.ctype), [push])
        writer.code.append(("end",))

    def stay_within(self, it: Load | Store, access: Access) -> None:
        """Write the check that an access is inside the object that its address comes from.

        Of a heap block that is its requested size, which the allocator keeps. One that was freed
        is found by other checks.
        """
        size, where = MEMORY_SIZE[it.memory], self.places.of(it.base, it.offset)
        base, writer = it.within, self.writer
        if base is None or self.facts.within.has(where, size, valued=False):
            return
        room = self._room(base)
        if 0 <= room < size:
            return
        near = where[0], where[1] - NEAR  # what is no further is in the object, or found elsewhere
        self.facts.within.add(near, size + 2 * NEAR, valued=False)
        if not isinstance(base, Register) and where[0] is base and 0 <= where[1] <= room - size:
            return
        writer.address(it.base, it.offset)
        writer.address(base, 0)
        writer.code.append(("i32.sub",))
        last = self._last(base) if isinstance(base, Register) else [("i32.const", room - size)]
        writer.code += [*last, ("i32.gt_u",), UNLIKELY]
        if writer.side_exit is None:
            writer.code.append(("global.get", SLOT_GLOBAL))
            writer.address(base, 0)
            writer.code.append(("i32.store", MAILBOX, slot_offset("error_base")))
        site = Site("out of bounds", it.location, access, size)
        writer.address(it.base, it.offset)
        writer.code.append(("local.set", ADDRESS))
        writer.fail(site, [("local.get", ADDRESS)])
        writer.code.append(("end",))
        if isinstance(base, str) or base in self.lasting:
            self.proved.add(where, size, valued=False)
            if self._changes(base):  # type: ignore[arg-type]
                self.facts.writable.add(where, size, valued=False)

    def _room(self, base: Base) -> int:
        """Return the size of a base; 0 if it has no known one, -1 if it is that of a heap block."""
        if isinstance(base, Register):
            return -1 if self.writer.names.keeps_sizes else 0
        if isinstance(base, str):
            return self.writer.names.sizes.get(base, 0)
        return base.size if base in self.writer.frame.offsets else 0

    def _last(self, block: Register) -> list[Instr]:
        """Push the last offset in a heap block; any is in it if its address is null.

        The address of its size is masked to be in memory.
        """
        at = [self.writer.value(block), ("i32.const", ASKED), ("i32.add",)]
        at += [("i32.const", MEMORY_BYTES - 1), ("i32.and",), ("i32.load", MEMORY, 0)]
        return [*at, ("i32.const", 1), ("i32.sub",)]
