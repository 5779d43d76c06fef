"""The programs of a host, with the rows of their slots that both ends of the connection know.

In one thread, a kernel takes turns with them: a grant is one call from Python. Programs that
compute for long are moved to a fleet with as many threads as there are processors, once that is
known: a program can be moved wherever it has stopped, and nothing depends on the threads.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

from crs_cc.net.changed_words import KnownRows, Table
from crs_cc.net.frames import RAN_FRONT
from crs_cc.net.word_kernel import WordKernel, partner_of
from crs_cc.runtime.fleet import Fleet
from crs_cc.runtime.workers import default_threads

if TYPE_CHECKING:
    from crs_cc.runtime.executable import Driver, Executable

SPREAD_S: Final = 0.001
"""Processor time of a round from which on several threads are worth while [s]: some times of what
they cost, which is a call of each shard from Python in place of one, and waking the threads.
Chosen by us."""

_SHARE: Final = 1 / 8
"""Of a round in the mean of the last ones."""


class HostedPrograms:
    """Programs that run when they are granted time.

    Attributes:
        fleet: the programs; another one once they are moved.
        known: the rows that both ends know.
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
        self._partner = partner_of(fleet)
        kernel = None if self._partner is None else WordKernel(len(fleet), self._partner.instance)
        self.known = KnownRows(len(fleet), kernel)

    def set(self, rows: Table) -> None:
        """Set slots and clocks to the values that the other end has."""
        self._table[:] = rows
        self.known.set(rows)

    @property
    def room(self) -> memoryview:
        """Where `run` takes its changes from, behind room of `GRANT_FRONT`."""
        return self.known.kernels[0].room

    def run(self, content: memoryview, end_s: float) -> tuple[int, memoryview, bool]:
        """Run rounds with what has been changed in rows.

        Args:
            content: the changes; they may be in `room`, if that has room for all rows.
            end_s: the end of the cycle [s].

        Returns:
            how many rounds have been run; what has changed since, behind room of `RAN_FRONT`; and
            whether any program may have failed, or asks to write.

        Raises:
            ValueError: the content is not valid.
        """
        if self._most_threads > 1:
            if self._round_s > SPREAD_S:
                content = memoryview(bytes(content))  # its room goes
                self._spread()
            began_s = time.thread_time()
            ran = self._run(content, end_s)
            took_s = (time.thread_time() - began_s) / max(ran[0], 1)
            self._round_s += (took_s - self._round_s) * _SHARE
            return ran
        return self._run(content, end_s)

    def _run(self, content: memoryview, end_s: float) -> tuple[int, memoryview, bool]:
        if self._partner is None:
            self.known.enter(content)
            self._table[...] = self.known.table()
            return self._run_rounds(end_s), self._packed(), True
        [kernel] = self.known.kernels
        rounds, changes, is_told = kernel.take_turn(self.fleet, self._partner, content, end_s)
        return rounds, self._packed() if changes is None else changes, is_told

    def _packed(self) -> memoryview:
        return memoryview(bytearray(RAN_FRONT) + self.known.pack(self._table))

    def _run_rounds(self, end_s: float) -> int:
        """Run rounds until a program asks for something; return how many."""
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
