"""A run that continues where a recording ends: it is repeated up to there, bit for bit."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Final

from crs_cc.cli.changed_run import recorded_changes
from crs_cc.cli.messages import say
from crs_cc.cli.rerun import RecordedInput
from crs_cc.core.errors import ReplayMismatch
from crs_cc.core.source import Location
from crs_cc.debug.errors import DebugError
from crs_cc.debug.world.run_edits import edit_run
from crs_cc.recording.digest import digest
from crs_cc.recording.recording import Recording

if TYPE_CHECKING:
    from crs_cc.debug.timeline.change import Change
    from crs_cc.session.session import Session

_NS: Final = 1e-9


class Resumption:
    """The recorded first part of a run.

    Attributes:
        given: what its programs read.
        end_s: when the recording ends [s].
    """

    def __init__(self, path: Path) -> None:
        """Read a recording.

        Raises:
            RecordingError: it is not valid.
            OSError: it cannot be read.
        """
        self._path = path
        recording = Recording(path)
        try:
            self.given = RecordedInput(recording)
            self.end_s = recording.end_ns * _NS
            self._expected = deque(recording.hashes())
            self._changes = deque(recorded_changes(recording))
        finally:
            recording.close()

    @property
    def absent(self) -> frozenset[str]:
        """The robots that wait for their programs when the recording ends."""
        found: set[str] = set()
        for verb, _, names in (each.text.partition(" ") for each in self._changes):
            if verb == "delay":
                found.update(names.split())
            elif verb == "join":
                found.difference_update(names.split())
        return frozenset(found)

    def timesteps_left(self, session: Session) -> int | None:
        """Return the number of timesteps to the next comparison or change; None without any."""
        ends = [each.timesteps for each in list(self._expected)[:1]]
        ends += [each.position.timestep for each in list(self._changes)[:1]]
        return max(1, min(ends) - session.timesteps) if ends else None

    def change(self, session: Session, made: Callable[[Change], None]) -> None:
        """Make the recorded changes of this timestep again.

        Args:
            session: the run.
            made: is called with each.

        Raises:
            ReplayMismatch: one is not possible now: the run takes another course.
        """
        while self._changes and self._changes[0].position.timestep <= session.timesteps:
            change = self._changes.popleft()
            try:
                edit_run(session, change.text)
            except DebugError as error:
                raise self._mismatch(session, str(error)) from None
            made(change)

    def compare(self, session: Session) -> None:
        """Compare a run with the recording, where that has a hash.

        Raises:
            ReplayMismatch: the run takes another course.
        """
        while self._expected and self._expected[0].timesteps <= session.timesteps:
            expected = self._expected.popleft()
            if expected.timesteps < session.timesteps or expected.digest != digest(session):
                raise self._mismatch(session)
            if not self._expected:
                say(f"crs: the run continues at {session.time_s:.2f} s, the end of {self._path}")

    def _mismatch(self, session: Session, reason: str = "") -> ReplayMismatch:
        text = f"the run differs from its recording at {session.time_s:.2f} s"
        hint = "it can only continue with the same world, seed, programs and version"
        return ReplayMismatch.at(
            Location(str(self._path)), f"{text}: {reason}" if reason else text, hint
        )
