"""The rows of all robots of a run; each host has those of its own robots.

The session reads and writes one table, which is in the memory of a kernel: nothing is copied before
changes are packed, or after those of hosts have been applied. Each of the two steps of a round,
packing grants and applying answers, is one call of the kernel for all hosts.

>>> import numpy as np
>>> from crs_cc.net.changed_words import KnownRows
>>> from crs_cc.requests import timing_offset
>>> shared = SharedRows(3)
>>> some, other = shared.add(np.array([0, 2])), shared.add(np.array([1]))
>>> shared.table[2, timing_offset("due_s") // 8] = 0x7FF << 52      # nothing is due
>>> shared.table[2, timing_offset("alive") // 8] = 1
>>> shared.grant(0.05, is_new=True) == [some]
True
>>> there = KnownRows(2)
>>> there.enter(shared.packed(some)[GRANT_FRONT:]), there.table()[1].any().item()
(False, True)
"""

from __future__ import annotations

import struct
from typing import Final

from crs_cc.core.arrays import IndexArray
from crs_cc.net.channel import HEAD_BYTES
from crs_cc.net.frames import FRONT_WORDS, GRANT_FRONT, RAN_FRONT
from crs_cc.net.slot_rules import IDLE_RULES, RULES
from crs_cc.net.word_kernel import (
    ERRORS,
    GRANT,
    ROWS,
    TAKE,
    TOO_LONG,
    WORD_BYTES,
    WORDS,
    Table,
    WordKernel,
)

_INTS: Final = "first", "count", "words", "error", "granted", "round"
"""What the kernel has of each host, as in `kernels/main.c`; 64-bit numbers of grants follow."""

_BEGIN: Final = struct.Struct("<iid")
_NOTHING: Final = -1


class SharedRows:
    """The table of a session, and the hosts that have rows of it.

    Attributes:
        table: a row of `WORDS` words for each robot.
    """

    def __init__(self, robots: int) -> None:
        """Create rows of zeros.

        Raises:
            ValueError: there are more robots than the kernel has space for.
        """
        if robots > ROWS:
            raise ValueError(f"{robots} robots, but {ROWS} at most can have programs on hosts")
        self._kernel = kernel = WordKernel(robots)
        self.table = kernel.now
        kernel.rules[:] = *RULES, *IDLE_RULES
        self._traffic, self._turn, members, hosts = kernel.addresses
        end = hosts + 4 * ROWS * len(_INTS)
        parts = [
            kernel.memory[begin : begin + 4 * ROWS].cast("i")
            for begin in range(hosts, end, 4 * ROWS)
        ]
        self._first, self._count, self._words, self._error, self._granted, *_ = parts
        self._last_grant = kernel.memory[end : end + 8 * ROWS].cast("Q")
        self._members = kernel.memory[members : members + 4 * ROWS].cast("i")
        self._hosts: list[IndexArray] = []
        self._addresses: list[int] = []  # of changes of a host, in the memory
        self._buffers: list[memoryview] = []
        self._used = 0

    def add(self, robots: IndexArray) -> int:
        """Add a host with robots that no other host has; return its number."""
        number, first, rows = len(self._hosts), self._used, len(robots)
        self._used += rows
        for member, robot in enumerate(robots.tolist(), first):
            self._members[member] = robot
        self._first[number], self._count[number] = first, rows
        self._words[number] = _NOTHING
        self._hosts.append(robots)
        begin = self._traffic + (first * (1 + WORDS) + number * FRONT_WORDS) * WORD_BYTES
        most = rows * (1 + WORDS) * WORD_BYTES
        self._addresses.append(begin)
        self._buffers.append(self._kernel.memory[begin - RAN_FRONT : begin + most])
        return number

    def remove(self, host: int) -> None:
        """Exclude a host from further rounds."""
        self._count[host], self._words[host] = 0, _NOTHING

    def known(self, host: int) -> Table:
        """Return a copy of the rows that a host has."""
        return self._kernel.known[self._hosts[host]]

    def last_grant(self, host: int) -> int:
        """Return the number of a host's last grant, 0 before any."""
        return self._last_grant[host]

    # -- a round ---------------------------------------------------------------------------------

    def grant(self, end_s: float, *, is_new: bool) -> list[int]:
        """Pack a grant for each host whose programs can run before the end of the cycle.

        Args:
            end_s: the end of the cycle [s].
            is_new: whether this is a new cycle.

        Returns:
            these hosts.
        """
        _BEGIN.pack_into(self._kernel.memory, self._turn, 0, _NOTHING, end_s)
        count = self._kernel.call(GRANT, len(self._hosts), is_new)[0]
        return self._granted[:count].tolist()

    def packed(self, host: int) -> memoryview:
        """Return the grant that has been packed for a host, with space for its header."""
        begin = self._addresses[host]
        end = begin + self._words[host] * WORD_BYTES
        self._words[host] = _NOTHING
        return self._kernel.memory[begin - GRANT_FRONT : end]

    def buffer(self, host: int) -> memoryview:
        """Return the buffer for a host's answer, with its header."""
        return self._buffers[host]

    def put_received(self, host: int, size: int) -> None:
        """Note that a host's answer is in its buffer, for `take`.

        Args:
            host: the host.
            size: the size of the message with its header [bytes].

        Raises:
            ValueError: the size is invalid.
        """
        size -= RAN_FRONT
        if size < 0 or size % WORD_BYTES:
            raise ValueError(ERRORS[1])
        self._words[host] = size // WORD_BYTES

    def put(self, host: int, content: bytes) -> None:
        """Copy a host's answer into its buffer, for `take`.

        Raises:
            ValueError: its size is invalid.
        """
        buffer, size = self._buffers[host], HEAD_BYTES + len(content)
        if size > len(buffer):
            raise ValueError(TOO_LONG)
        buffer[HEAD_BYTES:size] = content
        self.put_received(host, size)

    def take(self, before: int) -> tuple[int, bool] | None:
        """Apply the answers to the table, up to the first round with a request.

        The changes of hosts that are ahead of this round are kept for a later call.

        Args:
            before: the round up to which the table has all changes.

        Returns:
            the round up to which the table has all changes now, and whether there were any; None if
            an answer is invalid, or to another grant, see `error`: then it is ignored, and the
            table does not change.
        """
        bad, reached, is_any, *_ = self._kernel.call(TAKE, len(self._hosts), before)
        return None if bad else (reached, bool(is_any))

    def error(self, host: int) -> str:
        """Return an error message for a host's answer; empty if it is valid."""
        return ERRORS[self._error[host]]
