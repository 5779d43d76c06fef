"""A run that another command runs and pages look at: they may pause it, set its speed, change it.

Changes are made between two timesteps, before the run continues, and are recorded with the run.
They cannot be undone, since the run only goes forward.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from crs_cc.debug.errors import DebugError
from crs_cc.debug.timeline.change import Change
from crs_cc.debug.timeline.position import Position
from crs_cc.debug.world.edits import words_of
from crs_cc.debug.world.run_edits import edit_run
from crs_cc.workbench.control import panel
from crs_cc.workbench.robot_table import status
from crs_cc.workbench.run import Halt

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from crs_cc.debug.commands.shell import Shell
    from crs_cc.debug.engine import Debugger
    from crs_cc.session.session import Session
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.workbench.branches import BranchFeeds
    from crs_cc.workbench.watcher import Watcher


class AttachedRun:
    """A session that goes forward only.

    Attributes:
        can: it plays and pauses, and is changed.
        timestep_s: the length of a timestep.
        halt: why it is stopped.
    """

    can = frozenset({"play", "change"})

    def __init__(
        self,
        session: Session,
        watcher: Watcher,
        changed: Callable[[Change], None],
        repeats_until_s: float = 0.0,
    ) -> None:
        """Store the session.

        Args:
            session: the run.
            watcher: reports its progress to pages.
            changed: is called with each change that is made here; calls `note`.
            repeats_until_s: up to when it is a recorded run again [s], so that nothing may change.
        """
        self.halt = Halt()
        self.timestep_s = session.environment.timestep_s
        self._session, self._watcher = session, watcher
        self._changed, self._repeats_until_s = changed, repeats_until_s
        self._changes: list[Change] = []
        self._robot = 0

    @property
    def is_inspectable(self) -> bool:
        """Return False: its programs are not asked."""
        return False

    @property
    def world(self) -> WorldModel:
        """Its world, with the robots that have joined."""
        return self._session.environment.world

    @property
    def time_s(self) -> float:
        """The simulated time [s]."""
        return self._session.time_s

    def advance(self, timesteps: int) -> bool:
        """Raise DebugError: another command advances it."""
        raise DebugError(f"this run cannot be advanced by {timesteps} timesteps: it runs by itself")

    def seek(self, time_s: float) -> None:
        """Raise DebugError: it goes forward only."""
        raise DebugError(f"this run cannot go to {time_s:g} s: it goes forward only")

    def interrupt(self) -> None:
        """Do nothing: requests are processed between two timesteps."""

    def forget_interrupt(self) -> None:
        """Do nothing."""

    def select(self, robot: int) -> None:
        """Select a robot; raise DebugError if there is no such robot."""
        if not 0 <= robot < len(self._session.fleet):
            raise DebugError(f"no robot {robot}")
        self._robot = robot

    def status(self, *, is_playing: bool) -> dict[str, Any]:
        """Return the table of the robots."""
        return status(self._session, None, self._robot, is_playing=is_playing)

    def where(self) -> dict[str, Any] | None:
        """Return None: programs that are not built for it cannot be asked."""
        return None

    def shell(self) -> Shell:
        """Raise DebugError: there is no engine."""
        raise DebugError("this run is not debugged: start it with crs view")

    def session(self) -> Session:
        """Return the run."""
        return self._session

    def edit(self, text: str, *, is_playing: bool) -> str:  # noqa: ARG002
        """Change it at the start of this timestep; raise DebugError if that is not possible."""
        session = self._session
        if words_of(text)[:1] in (["join"], ["delay"]):
            raise DebugError("robots cannot be added to a run that only goes forward: use crs view")
        if session.time_s < self._repeats_until_s:
            until = f"{self._repeats_until_s:.2f} s"
            raise DebugError(f"this run repeats a recorded one until {until}: change it then")
        done = edit_run(session, text)
        self._changed(Change(Position(session.timesteps, 0), text))
        return done

    def note(self, change: Change) -> None:
        """Record a change, of any origin."""
        self._changes.append(change)

    def changes(self) -> Sequence[Change]:
        """Return the changes."""
        return self._changes

    def panel(self) -> dict[str, Any] | None:
        """Return the changes, the degradations and the blocked links."""
        return panel(self._session.environment, self._changes)

    def branches(self) -> BranchFeeds:
        """Raise DebugError: there is no engine."""
        raise DebugError("this run is not debugged: start it with crs view")

    def switch(self, name: str) -> None:
        """Raise DebugError: there is no engine."""
        raise DebugError(f"this run has no branch {name}: start it with crs view")

    def new_world(self) -> dict[str, Any] | None:
        """Return None: its robots are known."""
        return None

    def sync_programs(self) -> None:
        """Raise DebugError: there is no engine."""
        raise DebugError("this run is not debugged: start it with crs view")

    def debugger(self) -> Debugger:
        """Raise DebugError: there is no engine."""
        raise DebugError("this run is not debugged: start it with crs view")

    def refresh(self) -> None:
        """Show the effect of a change."""
        self._watcher.show()
