"""The kernel that finds and applies changes of words, and its calls from Python, see `main.c`."""

from __future__ import annotations

import atexit
import functools
import struct
from pathlib import Path
from typing import TYPE_CHECKING, Final, NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from crs_cc.net.channel import HEAD_BYTES
from crs_cc.net.frames import GRANT_FRONT, RAN_FRONT
from crs_cc.requests import CODES, FAILED
from crs_cc.runtime.turns import RECORD

if TYPE_CHECKING:
    from crs_cc.runtime.executable import Executable
    from crs_cc.runtime.fleet import Fleet
    from crs_cc.runtime.kernel_instance import KernelInstance
    from crs_cc.runtime.partner import Partner, Turns

WORDS: Final = RECORD.itemsize // 8
"""Words of a row of a table."""

ROWS: Final = 10240
"""The maximum number of rows of a kernel, as in `kernels/main.c`."""

WORD_BYTES: Final = 8
_WRITE: Final = CODES["WRITE"]

Words: TypeAlias = npt.NDArray[np.uint64]

Table: TypeAlias = npt.NDArray[np.uint64]
"""A row of `WORDS` words for each program."""

_ADDRESSES, _PACK, _CHECK, _ENTER, _ENTER_ALL, _TURN, GRANT, TAKE = range(8)
_ARGUMENTS: Final = tuple(struct.Struct(f"<{1 + count}i") for count in range(5))
_RESULTS: Final = struct.Struct("<8i")
_TURN_RESULTS: Final = struct.Struct("<20x3i")
"""Whether any program may have failed, or writes output; an error; the number of words packed."""
_MAX_BYTES: Final = ROWS * (1 + WORDS) * WORD_BYTES
"""Of a content [bytes]."""
TOO_LONG: Final = "changes of a size other than announced"
ERRORS: Final = (
    "",
    "changes end early",
    "changes of words that are not there",
    "it has changed what is not its own, or a clock goes back",
    TOO_LONG,
    "reply to a different grant",
)


class Rules(NamedTuple):
    """Rules for the changes of a row: which are permitted, and which bits are looked for, by word.

    Attributes:
        fixed: the bits that must not change.
        maximum: the maximum value.
        monotonic: all bits if the value must not decrease, else none.
        wanted: the bits that are looked for.
    """

    fixed: Words
    maximum: Words
    monotonic: Words
    wanted: Words


class WordKernel:
    """An instance of the kernel.

    Attributes:
        memory: its memory.
        known: the rows as both sides know them.
        now: the current rows, which differ where changes are to be packed.
        rules: two sets of rules: for an answer after some rounds, and after none.
        buffer: the buffer for a grant, with its header.
        addresses: the addresses of changes, of a turn, of the list of members, and of hosts.
    """

    def __init__(self, rows: int, instance: KernelInstance | None = None) -> None:
        """Create rows of zeros.

        Args:
            rows: the number of rows, `ROWS` at most.
            instance: an instance of the kernel that has just been started; by default a new one.
        """
        if instance is None:
            # Not needed by a run whose programs are all in its process.
            from crs_cc.runtime.kernel_instance import KernelInstance

            instance = KernelInstance(_executable())
        self.memory, self._resume = instance.memory.data, instance.resume
        self._message_address = int(instance.message[0])
        rules, known, now, *addresses, _ = self.call(_ADDRESSES, rows)

        def table(begin: int, rows: int) -> Table:
            end = begin + rows * WORDS * WORD_BYTES
            return instance.memory[begin:end].view(np.uint64).reshape(rows, WORDS)

        self.known, self.now = table(known, rows), table(now, rows)
        self.rules = table(rules, 2 * len(Rules._fields))
        self.addresses = tuple(addresses)
        self._traffic, self._turn, *_ = addresses
        self._max_bytes = rows * (1 + WORDS) * WORD_BYTES
        end = self._traffic + self._max_bytes
        self.buffer = self.memory[self._traffic - GRANT_FRONT : end]
        self._rows, self._now = rows, now
        self._rules: Rules | None = None  # in the table

    def pack(self, rows: int) -> bytes:
        """Return the changes of the first rows, which are known from now on."""
        words = self.call(_PACK, rows)[1]
        return bytes(self.memory[self._traffic : self._traffic + words * WORD_BYTES])

    def check(self, content: memoryview, rows: int, rules: Rules | None) -> tuple[int, bool]:
        """Check changes of the first known rows, for `enter`.

        Args:
            content: the changes, which changes of further rows may follow.
            rows: the number of rows.
            rules: the permitted changes; all if None.

        Returns:
            The size of the changes of these rows [bytes], and whether any has a bit that the rules
            look for.

        Raises:
            ValueError: the content is invalid, or a change not permitted.
        """
        _, _, _, used, is_found, *_ = self._read(_CHECK, content, rows, rules)
        return used * WORD_BYTES, bool(is_found)

    def enter(self, rows: int) -> None:
        """Apply changes that have just been checked."""
        self.call(_ENTER, rows)

    def enter_all(self, content: memoryview, rows: int, rules: Rules | None) -> bool:
        """Check and apply changes of the first known rows.

        Returns:
            Whether any has a bit that the rules look for.

        Raises:
            ValueError: the content is invalid, or a change not permitted.
        """
        if len(content) > _MAX_BYTES:
            raise ValueError(TOO_LONG)
        return bool(self._read(_ENTER_ALL, content, rows, rules)[4])

    def _read(
        self, kind: int, content: memoryview, rows: int, rules: Rules | None
    ) -> tuple[int, ...]:
        if rules is not None and rules is not self._rules:
            self.rules[: len(Rules._fields)] = self._rules = rules
        results = self.call(kind, rows, self._take(content), rules is not None)
        if results[0]:
            raise ValueError(ERRORS[results[0]])
        return results

    def turns(self, partner: Partner) -> Turns:
        """Return an object that runs the programs of these rows in turn with this kernel.

        Args:
            partner: this kernel as their partner.
        """
        return partner.turns(self._turn, self._now, self._rows)

    def take_turn(self, turns: Turns, content: memoryview) -> tuple[int, memoryview, bool]:
        """Run rounds of programs with a grant.

        Args:
            turns: what runs them.
            content: the grant; it may be in `buffer`.

        Returns:
            the number of rounds if a program has trapped, so that there is no valid answer, else 0;
            the answer, with space for its header; and whether any program may have failed, or
            writes output.

        Raises:
            ValueError: the content is invalid.
        """
        size = HEAD_BYTES + len(content) - GRANT_FRONT
        if size % WORD_BYTES or size > self._max_bytes:
            raise ValueError(TOO_LONG if size > self._max_bytes else ERRORS[1])
        memory, address = self.memory, self._message_address
        if content.obj is not memory.obj:
            self.buffer[HEAD_BYTES : HEAD_BYTES + len(content)] = content
        words = size // WORD_BYTES
        _ARGUMENTS[4].pack_into(memory, address, _TURN, self._rows, words, _WRITE, FAILED)
        unanswered = turns.take()
        is_notable, error, words = _TURN_RESULTS.unpack_from(memory, address)
        if error:
            raise ValueError(ERRORS[error])
        begin = self._traffic
        return unanswered, memory[begin - RAN_FRONT : begin + words * WORD_BYTES], bool(is_notable)

    def _take(self, content: memoryview) -> int:
        """Copy changes into the kernel's memory; return their size [words]."""
        size = min(len(content), _MAX_BYTES)
        self.memory[self._traffic : self._traffic + size] = content[:size]
        return size // WORD_BYTES

    def call(self, kind: int, *arguments: int) -> tuple[int, ...]:
        """Call the kernel; return its results."""
        _ARGUMENTS[len(arguments)].pack_into(self.memory, self._message_address, kind, *arguments)
        self._resume()
        return _RESULTS.unpack_from(self.memory, self._message_address)


def partner_of(fleet: Fleet) -> Partner | None:
    """Return a new kernel as the partner of a fleet's programs; None if they can have none."""
    return fleet.partner(_executable()) if len(fleet) <= ROWS else None


@functools.cache
def _executable() -> Executable:
    from crs_cc.toolchain.kernels import build_kernels

    return build_kernels(Path(__file__).parent / "kernels")


@atexit.register
def _release() -> None:
    """Release the program while wasmtime can still do so."""
    _executable.cache_clear()
