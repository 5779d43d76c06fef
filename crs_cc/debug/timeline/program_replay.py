"""Replay of programs from their logged input, while the world does not change.

A program is a function of what it is given, so those of some robots can run without the others.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from crs_cc.core.arrays import BoolArray, IndexArray
from crs_cc.debug.timeline.input_log import RoundInput
from crs_cc.debug.timeline.run_event import PostedRequests, RunEvent
from crs_cc.requests import CODES, SUSPENDED
from crs_cc.session.result import SessionSnapshot
from crs_cc.session.session import Session


class ProgramReplay:
    """The programs of a session that are replayed."""

    def __init__(self, session: Session) -> None:
        """Store the session; all its programs are chosen."""
        self._session = session
        self._chosen: BoolArray | None = None  # by robot; None for all

    def restore_programs(self, snapshot: SessionSnapshot, robots: Iterable[int] | None) -> None:
        """Restore programs from a snapshot.

        Args:
            snapshot: the snapshot.
            robots: those whose programs are to run; None for all.
        """
        chosen = set(range(len(snapshot.programs)))
        self._chosen = None
        if robots is not None:
            chosen &= {*robots, -1 if snapshot.halted is None else snapshot.halted}
            self._chosen = np.zeros(len(self._session.fleet), np.bool_)
            self._chosen[list(chosen)] = True
        self._session.state.restore_programs(snapshot, sorted(chosen))

    def begin(self, round_: RoundInput) -> bool:
        """Repeat the programs' input of a round; return whether any program runs in it."""
        state = self._session.state
        given = round_.feed(self._session.fleet, state.clock_s, state.pending, self._chosen)
        return bool(given.size)

    def end(self, round_: RoundInput) -> RunEvent:
        """Return the event of a round in which the programs have run."""
        robots: IndexArray = round_.robots
        if self._chosen is not None:
            robots = robots[self._chosen[robots]]
        slots = self._session.fleet.slots
        codes = slots["code"][robots]
        over = (slots["status"][robots] != SUSPENDED) | (codes == CODES["EXIT"])
        return RunEvent("round", PostedRequests(robots, codes), tuple(robots[over].tolist()))
