"""Branches: alternative histories of a run.

A branch has a history of its own and a position in it. A new one starts as a copy of the history
up to the current position; the session itself is shared and switched between them.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Final

from crs_cc.core.suggest import unknown
from crs_cc.debug.errors import DebugError
from crs_cc.debug.timeline.console import ReplayConsole
from crs_cc.debug.timeline.history import History
from crs_cc.debug.timeline.position import Position
from crs_cc.debug.timeline.recorded_run import RecordedRun
from crs_cc.debug.world.event_history import EventHistory

FIRST: Final = "main"
"""The name of the branch that a run begins as."""

MAX_KEPT: Final = 6
"""Branches at most, if changes in the past make them; chosen by us."""


@dataclass(frozen=True, slots=True)
class Checkpoint:
    """A saved position.

    Attributes:
        number: from 1 in each branch.
        name: the user's name for it; may be empty.
        time_s: the clock of the robot selected then [s].
    """

    number: int
    name: str
    position: Position
    time_s: float


@dataclass(slots=True)
class Branch:
    """An alternative history.

    Attributes:
        history: its snapshots.
        console: its output and input.
        event_history: its events.
        position: where the user left it; outdated while it is the current one.
        checkpoints: saved positions in it.
    """

    name: str
    history: History
    console: ReplayConsole
    event_history: EventHistory
    position: Position
    checkpoints: list[Checkpoint] = field(default_factory=list)


class Branches:
    """All branches of a run.

    Attributes:
        current: the current one.
        keeps_past: whether a change in the past goes into a new branch, so that the run stays in
            the one before as it was.
    """

    def __init__(self, run: RecordedRun) -> None:
        self._run = run
        self.current = Branch(FIRST, run.history, run.console, run.event_history, run.position)
        self._all = {FIRST: self.current}
        self._count = 1
        self.keeps_past = False

    def names(self) -> tuple[str, ...]:
        """Return the names of all branches, in order of creation."""
        return tuple(self._all)

    def add(self, name: str) -> Branch:
        """Create a branch here and switch to it.

        Raises:
            DebugError: a branch of that name exists.
        """
        if not name.strip() or name in self._all:
            raise DebugError(f"branch '{name}' already exists" if name else "a branch needs a name")
        run, here = self._run, self._run.position
        history, console = run.history.fork(here), run.console.fork()
        event_history = run.event_history.fork(here.timestep)
        checkpoints = [each for each in self.current.checkpoints if each.position <= here]
        self.current.position = here
        self.current = self._all[name] = Branch(
            name, history, console, event_history, here, checkpoints
        )
        run.switch_history(history, console, event_history)
        return self.current

    def leave_past(self) -> None:
        """Keep the future of this branch, if there is one, and continue in a new branch.

        Of many branches, the oldest that a user can do without is discarded.
        """
        run = self._run
        if not self.keeps_past or run.event_history.timesteps <= run.position.timestep + 1:
            return
        while len(self._all) >= MAX_KEPT:
            oldest = next(each for each in self._all if each not in (FIRST, self.current.name))
            self._all.pop(oldest).history.release()
        self._count += 1
        self.add(f"run{self._count}")
        run.is_off_timeline = False  # the new branch continues from this state

    def switch(self, name: str) -> Branch:
        """Switch to another branch, where the user left it.

        Raises:
            DebugError: it does not exist.
        """
        self.visit(name)
        self._run.seek(self.current.position)
        return self.current

    def visit(self, name: str) -> None:
        """Switch to another branch without a position; `seek` must follow.

        Raises:
            DebugError: it does not exist.
        """
        if name not in self._all:
            raise DebugError(unknown("branch", name, self.names()))
        self.current.position = self._run.position
        self.current = self._all[name]
        own = self.current
        self._run.switch_history(own.history, own.console, own.event_history)

    def discard_checkpoints(self) -> None:
        """Discard checkpoints after a change."""
        here = self._run.position
        self.current.checkpoints[:] = [
            each for each in self.current.checkpoints if each.position <= here
        ]

    def add_checkpoint(self, name: str, time_s: float) -> Checkpoint:
        """Save the current position as a checkpoint."""
        own = self.current.checkpoints
        number = max((each.number for each in own), default=0) + 1
        own.append(Checkpoint(number, name, self._run.position, time_s))
        return own[-1]

    def checkpoint(self, number: int) -> Checkpoint:
        """Return a checkpoint of this branch; raise DebugError if it does not exist."""
        for each in self.current.checkpoints:
            if each.number == number:
                return each
        raise DebugError(f"no checkpoint {number} in branch '{self.current.name}'")
