"""The kernel that finds and writes changed words, and its calls from Python, see `main.c`."""

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
"""Rows that the kernel takes at most, as in `kernels/main.c`."""

WORD_BYTES: Final = 8
_WRITE: Final = CODES["WRITE"]

Words: TypeAlias = npt.NDArray[np.uint64]

Table: TypeAlias = npt.NDArray[np.uint64]
"""A row of `WORDS` words for each program."""

_ADDRESSES, _PACK, _CHECK, _ENTER, _ENTER_ALL, _TURN, GRANT, TAKE = range(8)
_ARGUMENTS: Final = tuple(struct.Struct(f"<{1 + count}i") for count in range(5))
_RESULTS: Final = struct.Struct("<8i")
_TURNED: Final = struct.Struct("<20x3i")
"""Whether any program may have failed, or asks to write; an error; and words that are packed."""
_MOST: Final = ROWS * (1 + WORDS) * WORD_BYTES
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
    """The rules for the words of a row, a number for each: permitted changes, searched values.

    Attributes:
        fixed: the bits that never change.
        most: the greatest value.
        rising: all bits if the value never becomes less, else none.
        wanted: the bits that are looked for.
    """

    fixed: Words
    most: Words
    rising: Words
    wanted: Words


class WordKernel:
    """An instance of the kernel.

    Attributes:
        memory: all that it has.
        known: the rows that both sides know.
        now: the same rows, where changes are to be packed.
        rules: the table of two rules: if programs have run, and if not.
        room: where a grant may be received, with its head.
        places: the addresses of changes, of a turn, of the list of members, and of hosts.
    """

    def __init__(self, rows: int, instance: KernelInstance | None = None) -> None:
        """Begin with rows of zeros.

        Args:
            rows: how many there are, `ROWS` at most.
            instance: an instance of the kernel that has just been started, by default a new one.
        """
        if instance is None:
            # Not needed by a run whose programs are all in its process.
            from crs_cc.runtime.kernel_instance import KernelInstance

            instance = KernelInstance(_executable())
        self.memory, self._resume = instance.memory.data, instance.resume
        self._place = int(instance.message[0])
        rules, known, now, *places, _ = self.call(_ADDRESSES, rows)

        def table(begin: int, rows: int) -> Table:
            end = begin + rows * WORDS * WORD_BYTES
            return instance.memory[begin:end].view(np.uint64).reshape(rows, WORDS)

        self.known, self.now = table(known, rows), table(now, rows)
        self.rules = table(rules, 2 * len(Rules._fields))
        self.places = tuple(places)
        self._traffic, self._turn, *_ = places
        self._most = rows * (1 + WORDS) * WORD_BYTES
        end = self._traffic + self._most
        self.room = self.memory[self._traffic - GRANT_FRONT : end]
        self._rows, self._now = rows, now
        self._rules: Rules | None = None  # in the table

    def pack(self, rows: int) -> bytes:
        """Return what differs in rows from those that are known, and make it known."""
        words = self.call(_PACK, rows)[1]
        return bytes(self.memory[self._traffic : self._traffic + words * WORD_BYTES])

    def check(self, content: memoryview, rows: int, rules: Rules | None) -> tuple[int, bool]:
        """Check changes of known rows, which `enter` then enters.

        Args:
            content: the changes; others may follow.
            rows: how many rows they are about.
            rules: what may be changed; everything if None.

        Returns:
            How much of the content is about these rows [bytes], and whether any bit is there that
            the rules want.

        Raises:
            ValueError: the content is not valid, or not allowed.
        """
        _, _, _, used, is_found, *_ = self._read(_CHECK, content, rows, rules)
        return used * WORD_BYTES, bool(is_found)

    def enter(self, rows: int) -> None:
        """Enter changes that have just been checked."""
        self.call(_ENTER, rows)

    def enter_all(self, content: memoryview, rows: int, rules: Rules | None) -> bool:
        """Check and enter changes, all of which are about known rows.

        Returns:
            Whether any bit is there that the rules want.

        Raises:
            ValueError: the content is not valid, or not allowed.
        """
        if len(content) > _MOST:
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
        """Return what runs programs, whose rows these are, in turn with this, which is theirs."""
        return partner.turns(self._turn, self._now, self._rows)

    def take_turn(self, turns: Turns, content: memoryview) -> tuple[int, memoryview, bool]:
        """Have programs run rounds with a grant.

        Args:
            turns: what runs them.
            content: the grant; it may be in `room`.

        Returns:
            rounds that have been run and of which the answer does not tell, 0 unless a program has
            trapped; the answer, behind room for a head; and whether any program may have failed, or
            asks to write.

        Raises:
            ValueError: the content is not valid.
        """
        size = HEAD_BYTES + len(content) - GRANT_FRONT
        if size % WORD_BYTES or size > self._most:
            raise ValueError(TOO_LONG if size > self._most else ERRORS[1])
        memory, place = self.memory, self._place
        if content.obj is not memory.obj:
            self.room[HEAD_BYTES : HEAD_BYTES + len(content)] = content
        words = size // WORD_BYTES
        _ARGUMENTS[4].pack_into(memory, place, _TURN, self._rows, words, _WRITE, FAILED)
        untold = turns.take()
        is_told, error, words = _TURNED.unpack_from(memory, place)
        if error:
            raise ValueError(ERRORS[error])
        begin = self._traffic
        return untold, memory[begin - RAN_FRONT : begin + words * WORD_BYTES], bool(is_told)

    def _take(self, content: memoryview) -> int:
        """Take what may be entered; return its size [words]."""
        size = min(len(content), _MOST)
        self.memory[self._traffic : self._traffic + size] = content[:size]
        return size // WORD_BYTES

    def call(self, kind: int, *arguments: int) -> tuple[int, ...]:
        """Run the kernel; return its result."""
        _ARGUMENTS[len(arguments)].pack_into(self.memory, self._place, kind, *arguments)
        self._resume()
        return _RESULTS.unpack_from(self.memory, self._place)


def partner_of(fleet: Fleet) -> Partner | None:
    """Return a kernel as the partner of a fleet's programs, if they can have one."""
    return fleet.partner(_executable()) if len(fleet) <= ROWS else None


@functools.cache
def _executable() -> Executable:
    from crs_cc.toolchain.kernels import build_kernels

    return build_kernels(Path(__file__).parent / "kernels")


@atexit.register
def _release() -> None:
    """Release the program while wasmtime can still do so."""
    _executable.cache_clear()
