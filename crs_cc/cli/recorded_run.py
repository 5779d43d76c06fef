"""A run that is debugged and was recorded: its input, and whether it is the same run."""

from __future__ import annotations

from typing import TYPE_CHECKING

from crs_cc.cli.changed_run import ChangedRun, recorded_changes, recorded_notes, recorded_stops
from crs_cc.cli.messages import show
from crs_cc.cli.rerun import RecordedInput
from crs_cc.core.source import Diagnostic, Location
from crs_cc.debug.errors import DebugError
from crs_cc.debug.saved_breakpoints import restore_breakpoints
from crs_cc.debug.timeline.position import BEGINNING
from crs_cc.recording.digest import digest

if TYPE_CHECKING:
    from collections.abc import Callable

    from crs_cc.debug.engine import Debugger
    from crs_cc.recording.recording import Recording
    from crs_cc.session.session import Session
    from crs_cc.sim.engine.step import Step


class RecordedRunCheck:
    """Replays the recorded input of a run, and warns once if the run diverges.

    Attributes:
        warned: is called when it does, besides a warning on standard error.
    """

    def __init__(self, recording: Recording) -> None:
        """Read input and hashes; raise RecordingError if they are damaged."""
        self.warned: Callable[[str], None] = lambda _text: None
        self._path = recording.path
        self._input = RecordedInput(recording)
        self._changes = recorded_changes(recording)
        self._notes = recorded_notes(recording)
        self._stops = recorded_stops(recording)
        self._expected: dict[int, object] = {}
        for each in recording.hashes():
            self._expected[each.timesteps] = each.digest
        self._session: Session | None = None
        self._has_warned = False

    def begin(self, debugger: Debugger) -> None:
        """Compare this run, give it notes and breakpoints, and make the changes by hand."""
        self._session = debugger.session
        debugger.notes.extend(self._notes)
        if self._changes:
            self._change(debugger)
        restore_breakpoints(debugger.stop_points, self._stops, len(debugger.names))

    def _change(self, debugger: Debugger) -> None:
        """Make the changes by hand again."""
        changed = ChangedRun(debugger, self._changes)
        try:
            changed.finish()
        except DebugError as error:
            self._warn(f"a recorded change cannot be repeated: {error}")
        debugger.goto(BEGINNING)

    @property
    def time_s(self) -> float:
        """The time of the run [s]."""
        return 0.0 if self._session is None else self._session.time_s

    def read(self, robot: int, wanted: int) -> bytes:
        """Return a piece of a program's recorded input."""
        return self._input.read(robot, wanted)

    def waiting(self, robot: int, clock_s: float, _read: int = 0) -> tuple[int, float]:
        """Return the recorded state of a program's input at a time."""
        return self._input.waiting(robot, clock_s)

    def step(self, _step: Step) -> None:
        """Compare the state after a timestep with its recorded hash, if there is one."""
        session = self._session
        if session is None or self._has_warned:
            return
        expected = self._expected.get(session.timesteps)
        if expected is not None and expected != digest(session):
            self._warn(f"the run differs from its recording at {session.time_s:.2f} s")

    def _warn(self, text: str) -> None:
        self._has_warned = True
        self.warned(text)
        hint = "it has been changed, or was recorded by another version: see crs replay"
        show([Diagnostic("warning", Location(str(self._path)), text, hint=hint)])
