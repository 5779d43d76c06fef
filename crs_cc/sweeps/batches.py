"""Runs in batches of one variant, each of which one process does at one go.

What a batch costs beside its runs is shared by them: the way to a process and back, the collection
of garbage, and what copying a process for the user's measures costs it afterwards. But its rows
come together, so a batch is short.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Final

from crs_cc.sweeps.plan import PlannedRun

_BATCH_S: Final = 0.4
"""Real time that a batch should take: what an interruption may cost."""

MAX_BATCH: Final = 8
"""Runs in a batch: the sessions of all of them may be in memory."""


class Batches:
    """Runs that follow each other and have the same parameters, in batches."""

    def __init__(self, runs: Iterable[PlannedRun], most: int = MAX_BATCH) -> None:
        """Set the runs.

        Args:
            runs: the runs, which are taken when they are needed.
            most: how many a batch has at most.
        """
        self._runs, self._most = iter(runs), most
        self._run_s: float | None = None

    def add_duration(self, run_s: float | None) -> None:
        """Record the duration of a run [s], None if it is unknown."""
        self._run_s = run_s

    def __iter__(self) -> Iterator[list[PlannedRun]]:
        """Yield the batches; each has the length that is right when it is wanted."""
        batch: list[PlannedRun] = []
        size = 1
        for run in self._runs:
            if batch and (len(batch) == size or run.parameters != batch[0].parameters):
                yield batch
                batch = []
            if not batch:
                size = self._size()
            batch.append(run)
        if batch:
            yield batch

    def _size(self) -> int:
        if self._run_s is None:
            return 1
        return max(1, min(self._most, int(_BATCH_S / max(self._run_s, 1e-3))))
