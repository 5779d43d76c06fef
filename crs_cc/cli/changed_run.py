"""A run that was changed in the debugger, repeated with the same changes."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from crs_cc.debug import saved_breakpoints
from crs_cc.debug.timeline.change import Change
from crs_cc.debug.timeline.note import KIND, Note
from crs_cc.debug.timeline.position import Position
from crs_cc.recording import topics

if TYPE_CHECKING:
    from crs_cc.debug.engine import Debugger
    from crs_cc.recording.recording import Recording


class ChangedRun:
    """Moves a debugger forward, and replays recorded changes."""

    def __init__(
        self,
        debugger: Debugger,
        changes: Iterable[Change],
        changed: Callable[[Change], None] = lambda _change: None,
    ) -> None:
        """Start at the beginning.

        Args:
            debugger: has the programs and the world of the run.
            changes: all changes, in their order.
            changed: is called with each change that has been made.
        """
        self._debugger = debugger
        self._left = deque(changes)
        self._changed = changed

    def advance_to(self, timestep: int) -> None:
        """Run to the start of a timestep, before changes made at that point.

        Raises:
            DebugError: a change cannot be made again.
        """
        target = Position(timestep, 0)
        while self._left and self._left[0].position < target:
            self._repeat(self._left.popleft())
        self._debugger.run.seek(target)

    def finish(self) -> None:
        """Run to the last change and make it; raise DebugError if one cannot be made again."""
        while self._left:
            self._repeat(self._left.popleft())

    def _repeat(self, change: Change) -> None:
        self._debugger.repeat(change)
        self._changed(change)


def recorded_changes(recording: Recording) -> list[Change]:
    """Return the changes of a recorded run; raise RecordingError if they are invalid."""
    found = []
    for _, data in recording.data(topics.INPUT.topic):
        if data.get("kind") == "change":
            with recording.errors():
                found.append(Change.of(data))
    return found


def recorded_stops(recording: Recording) -> list[dict[str, Any]]:
    """Return the user's breakpoints in a recorded run, as data that may not be valid."""
    inputs = (data for _, data in recording.data(topics.INPUT.topic))
    return [each for each in inputs if each.get("kind") == saved_breakpoints.KIND]


def recorded_notes(recording: Recording) -> list[Note]:
    """Return the user's notes on a recorded run; raise RecordingError if they are not valid."""
    found = []
    for _, data in recording.data(topics.INPUT.topic):
        if data.get("kind") == KIND:
            with recording.errors():
                found.append(Note.of(data))
    return found
