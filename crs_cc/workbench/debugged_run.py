"""A run that is debugged: it goes to any instant, and its programs stop at any statement."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Final

from crs_cc.debug.commands.shell import Shell
from crs_cc.debug.errors import DebugError
from crs_cc.debug.timeline.position import Position
from crs_cc.workbench import sources
from crs_cc.workbench.allowed import check_command
from crs_cc.workbench.branches import BranchFeeds
from crs_cc.workbench.control import begin, panel
from crs_cc.workbench.recorded_content import MAX_NOTES
from crs_cc.workbench.robot_table import status
from crs_cc.workbench.run import Halt
from crs_cc.workbench.world_data import world_data

if TYPE_CHECKING:
    from collections.abc import Sequence

    from crs_cc.debug.engine import Debugger
    from crs_cc.debug.stop import Stop
    from crs_cc.debug.timeline.change import Change
    from crs_cc.session.session import Session
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.workbench.watcher import Watcher

_GOES_ON: Final = frozenset({"tick", "step", "goto", "start", "beginning", "interrupt"})
"""Reasons of stops at which nothing has happened that a user must see."""


class DebuggedRun:
    """A run of the debug engine.

    Attributes:
        can: it plays, goes to other times, is changed, and is debugged.
        timestep_s: the length of a timestep.
        halt: why it is stopped, or was stopped last.
        has_changed: whether a user has changed it here.
    """

    can = frozenset({"play", "seek", "change", "debug"})

    def __init__(self, debugger: Debugger, watcher: Watcher) -> None:
        """Store the engine and what watches its session."""
        self.has_changed = False
        self._debugger = debugger
        self._changes = debugger.run.history.changes
        self.halt = Halt("start", "ready to run")
        self.timestep_s = debugger.session.environment.world.timestep_s
        self._shell = Shell(debugger, check_command)
        self._known = set(debugger.names)
        self._watcher = watcher
        self._branches = BranchFeeds(debugger, watcher)

    @property
    def is_inspectable(self) -> bool:
        """Return True: its programs are always where it is."""
        return True

    @property
    def world(self) -> WorldModel:
        """Its world, with the robots that have joined."""
        return self._debugger.session.environment.world

    @property
    def time_s(self) -> float:
        """The simulated time [s]."""
        return self._debugger.session.time_s

    def advance(self, timesteps: int) -> bool:
        """Advance by at most a number of timesteps; return whether it can continue."""
        stop = self._debugger.tick(timesteps)
        self._arrive(stop)
        return stop.reason == "tick"

    def seek(self, time_s: float) -> None:
        """Go to a time; at the start, to the first statement."""
        stop = self._debugger.goto_time(time_s)
        self._arrive(begin(self._debugger) if stop.reason == "beginning" else stop)

    def interrupt(self) -> None:
        """Request an interrupt; thread-safe."""
        self._debugger.interrupt()

    def forget_interrupt(self) -> None:
        """Discard an interrupt that arrived too late."""
        self._debugger.forget_interrupt()

    def select(self, robot: int) -> None:
        """Select a robot; raise DebugError if there is no such robot."""
        self._debugger.view.select_robot(robot)

    def sync_programs(self) -> None:
        """Do nothing: the programs are always at the displayed time."""

    def shell(self) -> Shell:
        """Return the command line of the debugger."""
        return self._shell

    def panel(self) -> dict[str, Any] | None:
        """Return the changes, the degradations and the outages."""
        shown = panel(self._debugger.session.environment, self.changes())
        notes = [
            {"t": each.time_s, "robot": each.robot, "text": each.text}
            for each in self._debugger.notes[-MAX_NOTES:]
        ]
        return shown | {"branches": self._branches.listing(), "notes": notes}

    def session(self) -> Session:
        """Return the run."""
        return self._debugger.session

    def edit(self, text: str, *, is_playing: bool) -> str:
        """Change the run at the start of this timestep, at any position of its programs."""
        debugger = self._debugger
        here = debugger.position
        if here != Position(here.timestep, 0):
            debugger.goto_timestep(here.timestep)
        try:
            done = debugger.edit_world(text)
        except DebugError:
            debugger.goto(here)
            raise
        if here.timestep == 0 and not is_playing:
            begin(debugger)
        return done

    def changes(self) -> Sequence[Change]:
        """Return all changes of this branch."""
        return self._debugger.run.history.changes

    def branches(self) -> BranchFeeds:
        """Return the branches that changes in the past have made."""
        return self._branches

    def switch(self, name: str) -> None:
        """Go to another branch; raise DebugError if there is none of this name."""
        self._branches.switch(name)
        self._changes = self._debugger.run.history.changes

    def new_world(self) -> dict[str, Any] | None:
        """Return the world for pages if robots have been added since the last call."""
        world = self._debugger.session.environment.world
        names = [robot.id for robot in world.robots]
        if self._known.issuperset(names):
            return None
        self._known.update(names)
        return world_data(world, names)

    def debugger(self) -> Debugger:
        """Return the debugger."""
        return self._debugger

    def refresh(self) -> None:
        """Update after a command of the debugger."""
        self._branches.store_left_branch()
        changes = self._debugger.run.history.changes
        if changes is not self._changes:
            first = next((new for new in changes if new not in self._changes), None)
            self.has_changed, self._changes = True, changes
            self._watcher.truncate(None if first is None else first.position.timestep)
        self._arrive(self._debugger.stop)

    def status(self, *, is_playing: bool) -> dict[str, Any]:
        """Return the table of the robots."""
        run = self._debugger.run
        return status(run.session, run, self._debugger.view.robot, is_playing=is_playing)

    def where(self) -> dict[str, Any] | None:
        """Return the current location of the selected robot's program."""
        return sources.where(self._shell)

    def _arrive(self, stop: Stop) -> None:
        reason, text = stop.reason, stop.why
        if reason in {"tick", "interrupt"}:
            text = ""
        is_plain = reason in _GOES_ON
        self.halt = Halt("paused" if is_plain else reason, text, stop.robot)
        self._watcher.report_ends()
        self._watcher.show(is_last=reason != "tick")
