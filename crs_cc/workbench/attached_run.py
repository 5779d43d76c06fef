"""A run that another command runs and pages look at: they may pause it and set its speed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from crs_cc.debug.errors import DebugError
from crs_cc.workbench.robot_table import status
from crs_cc.workbench.run import Halt

if TYPE_CHECKING:
    from crs_cc.debug.commands.shell import Shell
    from crs_cc.debug.engine import Debugger
    from crs_cc.session.session import Session
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.workbench.branches import KnownBranches


class AttachedRun:
    """A session that goes forward only.

    Attributes:
        can: it plays and pauses.
        timestep_s: the length of a timestep.
        halt: why it stands.
    """

    can = frozenset({"play"})

    def __init__(self, session: Session) -> None:
        """Store the session."""
        self.halt = Halt()
        self.timestep_s = session.environment.timestep_s
        self._session = session
        self._robot = 0

    @property
    def stands(self) -> bool:
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
        raise DebugError(f"this run goes on by itself, not by {timesteps} timesteps")

    def seek(self, time_s: float) -> None:
        """Raise DebugError: it goes forward only."""
        raise DebugError(f"this run cannot go to {time_s:g} s: it goes forward only")

    def interrupt(self) -> None:
        """Do nothing: between two timesteps it hears."""

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

    def panel(self) -> dict[str, Any] | None:
        """Return None: it cannot be changed."""
        return None

    def branches(self) -> KnownBranches:
        """Raise DebugError: there is no engine."""
        raise DebugError("this run is not debugged: start it with crs view")

    def switch(self, name: str) -> None:
        """Raise DebugError: there is no engine."""
        raise DebugError(f"this run has no branch {name}: start it with crs view")

    def new_world(self) -> dict[str, Any] | None:
        """Return None: its robots are known."""
        return None

    def stand(self) -> None:
        """Raise DebugError: there is no engine."""
        raise DebugError("this run is not debugged: start it with crs view")

    def debugger(self) -> Debugger:
        """Raise DebugError: there is no engine."""
        raise DebugError("this run is not debugged: start it with crs view")

    def settle(self) -> None:
        """Do nothing: pages change nothing."""
