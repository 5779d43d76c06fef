"""The programs of a host, and the rows of their slots as both ends of the connection know them.

With one thread, a kernel takes turns with the programs, so that a grant is one call from Python.
Programs that turn out to compute for long are moved to a fleet with as many threads as there are
processors: a stopped program can be moved, and no result depends on the threads.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from crs_cc.net.changed_words import KnownRows, Table
from crs_cc.net.channel import HEAD_BYTES
from crs_cc.net.frames import GRANT, RAN, RAN_FRONT
from crs_cc.net.word_kernel import WordKernel, partner_of
from crs_cc.runtime.fleet import Fleet
from crs_cc.runtime.workers import default_threads

if TYPE_CHECKING:
    from crs_cc.runtime.executable import Driver, Executable
    from crs_cc.runtime.partner import Turns

SPREAD_S: Final = 0.001
"""Processor time of a round from which several threads are worthwhile [s]: several times their
overhead, which is a call from Python for each shard, and waking the threads. Chosen by us."""

_SHARE: Final = 1 / 8
"""The weight of a round in the mean of the last ones."""


class HostedPrograms:
    """Programs that run as granted.

    Attributes:
        fleet: the programs; another one once they are moved.
        known: the rows that both ends know.
        buffer: a buffer for grants, with their headers.
    """

    def __init__(
        self, executables: Sequence[Executable], driver: Driver, threads: int | None
    ) -> None:
        """Load the programs.

        Args:
            executables: one for each robot.
            driver: the module that runs rounds.
            threads: how many threads may run programs; by default one, and as many as `Fleet` has
                by default if they compute for long.
        """
        self._executables, self._driver = executables, driver
        self._most_threads = default_threads(executables) if threads is None else 0
        self._round_s = 0.0
        self._use(Fleet(executables, driver, 1 if threads is None else threads))

    def _use(self, fleet: Fleet) -> None:
        self.fleet = fleet
        self._table: Table = fleet.table()
        kernel: WordKernel | None = None
        self._turns: Turns | None = None
        if (partner := partner_of(fleet)) is not None:
            kernel = WordKernel(len(fleet), partner.instance)
            self._turns = kernel.turns(partner)
        self.known = KnownRows(len(fleet), kernel)
        self._kernel = self.known.kernels[0]
        self.buffer = self._kernel.buffer

    def set(self, rows: Table) -> None:
        """Set slots and clocks to the values that the other end has sent."""
        self._table[:] = rows
        self.known.set(rows)

    def run(self, content: memoryview) -> tuple[memoryview, bool]:
        """Run rounds with a grant.

        Args:
            content: the grant; it may be in `buffer`, if that has space for all rows.

        Returns:
            the answer, preceded by space for a header; and whether any program may have failed, or
            requests output.

        Raises:
            ValueError: the content is not valid.
        """
        if self._most_threads <= 1:
            return self._run(content)
        if self._round_s > SPREAD_S:
            content = memoryview(bytes(content))  # its buffer is released
            self._spread()
        began_s = time.thread_time()
        frame, is_notable = self._run(content)
        rounds = RAN.unpack_from(frame, HEAD_BYTES)[1]
        took_s = (time.thread_time() - began_s) / max(rounds, 1)
        self._round_s += (took_s - self._round_s) * _SHARE
        return frame, is_notable

    def _run(self, content: memoryview) -> tuple[memoryview, bool]:
        if self._turns is None:
            number, end_s, _ = GRANT.unpack_from(content)
            self.known.enter(content[GRANT.size :])
            self._table[...] = self.known.table()
            rounds = self._run_rounds(end_s)
        else:
            number = GRANT.unpack_from(content)[0]  # before the answer takes its place
            rounds, frame, is_notable = self._kernel.take_turn(self._turns, content)
            if not rounds:
                return frame, is_notable
        frame = memoryview(bytearray(RAN_FRONT) + self.known.pack(self._table))
        RAN.pack_into(frame, HEAD_BYTES, number, rounds)
        return frame, True

    def _run_rounds(self, end_s: float) -> int:
        """Run rounds until a program makes a request; return their number."""
        total = 0
        while rounds := self.fleet.run_rounds(end_s):
            total += rounds
            if self.fleet.is_whole or self.fleet.timing["asks"].any():
                break
        return total

    def _spread(self) -> None:
        """Move the programs to a fleet with several threads."""
        old, rows, known = self.fleet, self._table.copy(), self.known.table().copy()
        fleet = Fleet(self._executables, self._driver, self._most_threads)
        for robot in range(len(old)):
            fleet.restore(robot, old.snapshot(robot))
        self._use(fleet)
        self._table[:] = rows
        self.known.set(known)
        self._most_threads = 0
