"""What the screen shows: a run that is debugged, that another command runs, or a recorded one."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Protocol

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.debug.commands.shell import Shell
    from crs_cc.debug.engine import Debugger
    from crs_cc.debug.timeline.change import Change
    from crs_cc.session.session import Session
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.workbench.branches import BranchFeeds


@dataclass(frozen=True, slots=True)
class Halt:
    """The reason of a stop.

    Attributes:
        reason: a word: `paused`, `breakpoint`, `error`, `end`, ...
        text: a sentence; empty if the reason needs none.
        robot: the robot that it is about; -1 for none.
    """

    reason: str = "paused"
    text: str = ""
    robot: int = -1


class Run(Protocol):
    """A run; its methods are called in its thread, except `interrupt`.

    Attributes:
        can: what can be done with it: `play` and pause, `seek` other times, `change`, `debug`.
        timestep_s: the length of a timestep.
    """

    can: frozenset[str]
    timestep_s: float

    @property
    def halt(self) -> Halt:
        """The reason of the current or the last stop."""

    @property
    def is_inspectable(self) -> bool:
        """Whether its programs are at the displayed time, so that they can be inspected."""

    @property
    def world(self) -> WorldModel:
        """Its world, with the robots that have joined."""

    @property
    def time_s(self) -> float:
        """The simulated time [s]."""

    def advance(self, timesteps: int) -> bool:
        """Advance by at most a number of timesteps; return whether it can continue."""

    def seek(self, time_s: float) -> None:
        """Go to a time."""

    def interrupt(self) -> None:
        """Request an interrupt; thread-safe."""

    def forget_interrupt(self) -> None:
        """Discard an interrupt that arrived too late."""

    def select(self, robot: int) -> None:
        """Select a robot."""

    def status(self, *, is_playing: bool) -> dict[str, Any]:
        """Return the table of the robots."""

    def where(self) -> dict[str, Any] | None:
        """Return the location of the selected robot's program; None if it is not known."""

    def sync_programs(self) -> None:
        """Move the programs to the displayed time; raise DebugError if this is impossible."""

    def shell(self) -> Shell:
        """Return the command line of the debugger there; raise DebugError if there is none."""

    def debugger(self) -> Debugger:
        """Return the debugger, at any position; raise DebugError if there is none."""

    def session(self) -> Session:
        """Return the run at the time that is shown; raise DebugError if it does not get there."""

    def edit(self, text: str, *, is_playing: bool) -> str:
        """Change it at the start of this timestep; return a description of the change.

        Args:
            text: the change, see `run_edits.ALL_EDITS`.
            is_playing: whether it is running.

        Raises:
            DebugError: the change is invalid or impossible; nothing has changed.
        """

    def changes(self) -> Sequence[Change]:
        """Return the user's changes, in the order of time; raise DebugError like `session`."""

    def panel(self) -> dict[str, Any] | None:
        """Return the contents of the control panel; None for runs that it cannot change."""

    def branches(self) -> BranchFeeds:
        """Return its branches; raise DebugError if it has none."""

    def switch(self, name: str) -> None:
        """Go to another branch; raise DebugError if there is none of this name."""

    def new_world(self) -> dict[str, Any] | None:
        """Return the world for pages if robots have been added since the last call."""

    def refresh(self) -> None:
        """Update after a command of the debugger."""
