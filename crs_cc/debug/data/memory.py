"""Access of expressions to a stopped program's memory, checked by the rules of C.

The side effects of an evaluation can be undone, byte states included: a failed evaluation has
none. Variables in registers are saved to the frame while the program is stopped; C cannot
reach these bytes, so the variables that an expression names are passed as `SavedRegister`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from typing import Final

import numpy as np

from crs_cc.core.arrays import ByteArray
from crs_cc.debug.data.expression_memory import EvaluationError
from crs_cc.debug.timeline.change import MemoryPatch
from crs_cc.ir.instruction import ByteState, plain_states
from crs_cc.ir.types import CType, EnumType, FloatType, IntegerType, PointerType
from crs_cc.ir.value_type import MEMORY_SIZE, VALUE_TYPE
from crs_cc.runtime.diagnosis.inspect import StoppedProgram
from crs_cc.runtime.layout import MEMORY_BYTES, NULL_SIZE

Explain = Callable[[int, int, bool], str]
"""Returns why C may not read (or else write) a number of bytes at an address."""

_VALUED: Final = bytes([ByteState.WITH_VALUE])


@dataclass(frozen=True, slots=True)
class SavedRegister:
    """A variable in a register, saved to the frame while the program is stopped.

    Attributes:
        name: the variable.
        ctype: its type.
        flag: the address of its initialised flag; None if it needs none.
        is_unset: whether it is certainly uninitialised.
    """

    name: str
    ctype: CType
    address: int
    flag: int | None = None
    is_unset: bool = False

    @property
    def end(self) -> int:
        """The address after it."""
        return self.address + self.ctype.size

    def has_value(self, memory: ByteArray) -> bool:
        """Return whether it is initialised."""
        if self.flag is None:
            return not self.is_unset
        return not self.is_unset and bool(memory[self.flag : self.flag + 4].any())

    def widened(self, content: bytes) -> bytes:
        """Return the whole register for a value, as the program stores it."""
        ctype = self.ctype
        if not isinstance(ctype, IntegerType | FloatType | EnumType | PointerType):
            return content
        size = MEMORY_SIZE[VALUE_TYPE[ctype.memory]]
        signed = isinstance(ctype, IntegerType | EnumType) and ctype.signed
        value = int.from_bytes(content[: ctype.size], "little", signed=signed)
        return value.to_bytes(size, "little", signed=signed)


@dataclass(slots=True)
class MemoryReads:
    """What an evaluation reads of a program's memory.

    Attributes:
        spans: first address and size of each part.
        is_unset: whether a part without a value was used.
    """

    spans: set[tuple[int, int]] = field(default_factory=set)
    is_unset: bool = False

    def in_program(self) -> tuple[tuple[int, int], ...]:
        """Return the objects in the program's memory, in the order of addresses."""
        inside = (each for each in self.spans if each[0] >= NULL_SIZE and sum(each) <= MEMORY_BYTES)
        return tuple(sorted(inside))


class StoppedMemory:
    """The memory of a stopped program; stays valid when the program resumes.

    Attributes:
        trusting: whether inaccessible bytes may be accessed, as by the allocator.
        reads: records what is read, if set. Then all memory may be read, whether or not it has a
            value, so that an evaluation depends on nothing but the bytes recorded.
    """

    def __init__(self, stopped: StoppedProgram, explain: Explain) -> None:
        self.trusting = False
        self.reads: MemoryReads | None = None
        self._memory, self._shadow = stopped.memory, stopped.shadow
        self._explain = explain
        self._saved: dict[int, SavedRegister] = {}
        self._journal: list[tuple[int, bytes, bytes]] = []

    def begin(self, saved: Iterable[SavedRegister]) -> None:
        """Start an evaluation that may use these variables."""
        self._saved = {each.address: each for each in saved}
        self._journal = []

    def undo(self) -> None:
        """Undo all changes since `begin`."""
        while self._journal:
            address, content, states = self._journal.pop()
            self._put(address, content, states)

    def has_changed(self) -> bool:
        """Return whether bytes or states have changed since `begin`."""
        before: dict[int, tuple[int, int]] = {}
        for address, content, states in reversed(self._journal):
            known = states or _VALUED * len(content)
            pairs = zip(content, known, strict=True)
            before.update((address + n, pair) for n, pair in enumerate(pairs))
        return any(
            (int(self._memory[at]), int(self._shadow[at]) if len(self._shadow) else 255) != pair
            for at, pair in before.items()
        )

    def patches(self) -> tuple[MemoryPatch, ...]:
        """Return the memory written since `begin`, with its current values."""
        spans = {
            (address, len(content), bool(states)) for address, content, states in self._journal
        }
        return tuple(
            MemoryPatch(
                address,
                self._memory[address : address + size].tobytes(),
                self._shadow[address : address + size].tobytes() if has_states else b"",
            )
            for address, size, has_states in sorted(spans)
        )

    def read(self, address: int, size: int, *, judged: bool = True) -> bytes:
        """Return bytes; they must be initialised if `judged`.

        Raises:
            EvaluationError: C may not read them.
        """
        content = self._memory[address : address + size].tobytes()
        saved = self._saved_at(address, size)
        if self.reads is not None:
            self._record(address, size, judged=judged)
        elif saved is not None:
            if judged and not saved.has_value(self._memory):
                raise EvaluationError(f"'{saved.name}' is uninitialised")
        else:
            states = self.states(address, size)
            if states != _VALUED * size and not self.trusting:
                self._refuse(address, size, states, judged=judged)
        return content

    def _record(self, address: int, size: int, *, judged: bool) -> None:
        assert self.reads is not None
        self.reads.spans.add((address, size))
        if address < NULL_SIZE or address + size > len(self._memory):
            raise EvaluationError(self._explain(address, size, True))
        if judged and not self.has_value(address, size):
            self.reads.is_unset = True

    def has_value(self, address: int, size: int) -> bool:
        """Return whether bytes are initialised."""
        saved = self._saved_at(address, size)
        if saved is not None:
            return saved.has_value(self._memory)
        return self.states(address, size) == _VALUED * size

    def _refuse(self, address: int, size: int, states: bytes, *, judged: bool) -> None:
        is_there = len(states) == size and ByteState.INACCESSIBLE not in states
        if judged or not is_there:
            raise EvaluationError(self._explain(address, size, True))

    def states(self, address: int, size: int) -> bytes:
        """Return the states of bytes, fewer at the end of the memory."""
        if len(self._shadow):
            return plain_states(self._shadow[address : address + size].tobytes())
        inside = min(address + size, MEMORY_BYTES) - max(address, NULL_SIZE)
        return _VALUED * inside if address >= NULL_SIZE else b""

    def _saved_at(self, address: int, size: int) -> SavedRegister | None:
        """Return the saved register that contains bytes."""
        for each in self._saved.values():
            if each.address <= address and address + size <= each.end:
                return each
        return None

    def write(self, address: int, content: bytes, states: bytes = b"") -> None:
        """Write bytes; they become initialised unless `states` says otherwise.

        Raises:
            EvaluationError: C may not write them.
        """
        size = len(content)
        found = self._saved_at(address, size)
        if found is not None:
            whole = self._memory[found.address : found.address + found.ctype.size].copy()
            whole[address - found.address :][:size] = np.frombuffer(content, np.uint8)
            self._change(found.address, found.widened(whole.tobytes()), b"")
            if found.flag is not None:
                self._change(found.flag, b"\1\0\0\0", b"")
            self._saved[found.address] = replace(found, is_unset=False)
            return
        known = self.states(address, size)
        if not self.trusting and (len(known) < size or ByteState.INACCESSIBLE in known):
            raise EvaluationError(self._explain(address, size, False))
        is_own = self.trusting and ByteState.INACCESSIBLE in known
        self._change(address, content, known if is_own else states or _VALUED * size)

    def state(self, address: int) -> int:
        """Return the state of a byte."""
        return plain_states(self._shadow[address : address + 1].tobytes() or b"\0")[0]

    def mark(self, address: int, size: int, state: int) -> None:
        """Set the states of bytes."""
        if len(self._shadow):
            content = self._memory[address : address + size].tobytes()
            self._change(address, content, bytes([state]) * len(content))

    def _change(self, address: int, content: bytes, states: bytes) -> None:
        """Write bytes, and states if given, and record the old ones."""
        part = slice(address, address + len(content))
        known = self._shadow[part].tobytes() if states and len(self._shadow) else b""
        self._journal.append((address, self._memory[part].tobytes(), known))
        self._put(address, content, states)

    def _put(self, address: int, content: bytes, states: bytes) -> None:
        part = slice(address, address + len(content))
        self._memory[part] = np.frombuffer(content, np.uint8)
        if states and len(self._shadow):
            self._shadow[part] = np.frombuffer(states, np.uint8)
