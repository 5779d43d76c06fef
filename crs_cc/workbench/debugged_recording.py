"""A recorded run whose programs can be stepped: they are run again, as far as a user looks.

What is recorded is shown at once. The programs follow when they are asked for: they run up to the
time that is shown, with the recorded input. From a change on (or beyond the end of the recording)
the run is another one, and they lead.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from crs_cc.workbench.run import Halt

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from crs_cc.debug.commands.shell import Shell
    from crs_cc.debug.engine import Debugger
    from crs_cc.debug.timeline.change import Change
    from crs_cc.session.session import Session
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.workbench.branches import BranchFeeds
    from crs_cc.workbench.debugged_run import DebuggedRun
    from crs_cc.workbench.playback import Playback


class DebuggedRecording:
    """A recorded run, and the same run in the debugger.

    Attributes:
        can: it plays, goes to other times, is changed, and is debugged.
        timestep_s: the time between two frames.
    """

    can = frozenset({"play", "seek", "change", "debug"})

    def __init__(self, playback: Playback, make: Callable[[], DebuggedRun]) -> None:
        """Store the recording, and the function that loads the programs.

        Args:
            playback: what is recorded.
            make: returns the run at its start; raises DebugError if it cannot be run again.
        """
        self.timestep_s = playback.timestep_s
        self._playback, self._make = playback, make
        self._debugged: DebuggedRun | None = None
        self._leads = False
        self._is_here = False

    @property
    def is_inspectable(self) -> bool:
        """Whether the programs are at the displayed time."""
        return self._is_here

    @property
    def world(self) -> WorldModel:
        """Its world, with the robots that have joined."""
        return self._playback.world if self._debugged is None else self._debugged.world

    @property
    def time_s(self) -> float:
        """The simulated time [s]."""
        debugged = self._inspectable_run()
        return self._playback.time_s if debugged is None else debugged.time_s

    @property
    def halt(self) -> Halt:
        """The reason of the current or the last stop."""
        debugged = self._inspectable_run()
        return self._playback.halt if debugged is None else debugged.halt

    def _inspectable_run(self) -> DebuggedRun | None:
        """Return the programs if they are at the displayed time."""
        return self._debugged if self._is_here else None

    def advance(self, timesteps: int) -> bool:
        """Advance by at most a number of timesteps; return whether it can continue."""
        if self._leads and self._debugged is not None:
            own = timesteps * self.timestep_s / self._debugged.timestep_s
            return self._debugged.advance(max(1, round(own)))
        self._is_here = False
        return self._playback.advance(timesteps)

    def seek(self, time_s: float) -> None:
        """Go to a time."""
        if self._leads and self._debugged is not None:
            self._debugged.seek(time_s)
            return
        self._playback.seek(time_s)
        self._is_here = False

    def sync_programs(self) -> None:
        """Run the programs to the time that is shown."""
        debugged, time_s = self._opened(), self._playback.time_s
        if self._is_here:
            return
        debugged.seek(time_s)
        is_near = time_s - debugged.time_s < debugged.timestep_s
        self._is_here = is_near or debugged.halt.reason == "end"  # or else it was interrupted
        if self._is_here:
            self._playback.seek(debugged.time_s)

    def interrupt(self) -> None:
        """Request an interrupt; thread-safe."""
        if self._debugged is not None:
            self._debugged.interrupt()

    def forget_interrupt(self) -> None:
        """Discard an interrupt that arrived too late."""
        if self._debugged is not None:
            self._debugged.forget_interrupt()

    def select(self, robot: int) -> None:
        """Select a robot; raise DebugError if there is no such robot."""
        self._playback.select(robot)
        if self._debugged is not None:
            self._debugged.select(robot)

    def status(self, *, is_playing: bool) -> dict[str, Any]:
        """Return the table of the robots."""
        return (self._inspectable_run() or self._playback).status(is_playing=is_playing)

    def where(self) -> dict[str, Any] | None:
        """Return the location of the selected robot's program; None if it is at another time."""
        debugged = self._inspectable_run()
        return None if debugged is None else debugged.where()

    def shell(self) -> Shell:
        """Return the command line of the debugger, at the time that is shown."""
        self.sync_programs()
        return self._opened().shell()

    def debugger(self) -> Debugger:
        """Return the debugger, at any position."""
        return self._opened().debugger()

    def session(self) -> Session:
        """Return the run, at the time that is shown."""
        self.sync_programs()
        return self._opened().session()

    def edit(self, text: str, *, is_playing: bool) -> str:
        """Change the run where it is shown: from there on, it is another one."""
        self.sync_programs()
        return self._opened().edit(text, is_playing=is_playing)

    def changes(self) -> Sequence[Change]:
        """Return the changes of this branch."""
        return self._opened().changes()

    def panel(self) -> dict[str, Any] | None:
        """Return the contents of the control panel; None while the programs are at another time."""
        debugged = self._inspectable_run()
        return None if debugged is None else debugged.panel()

    def branches(self) -> BranchFeeds:
        """Return the branches that changes in the past have made."""
        return self._opened().branches()

    def switch(self, name: str) -> None:
        """Go to another branch; raise DebugError if there is none of this name."""
        self.sync_programs()
        self._opened().switch(name)
        self._leads = True

    def new_world(self) -> dict[str, Any] | None:
        """Return the world for pages if robots have been added since the last call."""
        return None if self._debugged is None else self._debugged.new_world()

    def refresh(self) -> None:
        """Update after a command of the debugger."""
        debugged = self._debugged
        if debugged is None or not self._is_here:
            return
        debugged.refresh()
        if debugged.has_changed or debugged.time_s > self._playback.end_s + debugged.timestep_s:
            self._leads = True
        else:
            self._playback.seek(debugged.time_s)

    def _opened(self) -> DebuggedRun:
        if self._debugged is None:
            self._debugged = self._make()
            self._debugged.select(self._playback.robot)
        return self._debugged
