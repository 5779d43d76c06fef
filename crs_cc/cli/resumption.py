"""A run that goes on where a recording of it ends: it is run again, to the same bits."""

from __future__ import annotations

from collections import deque
from pathlib import Path
from typing import TYPE_CHECKING, Final

from crs_cc.cli.messages import say
from crs_cc.cli.rerun import RecordedInput
from crs_cc.core.errors import ReplayMismatch
from crs_cc.core.source import Location
from crs_cc.recording.digest import digest
from crs_cc.recording.recording import Recording

if TYPE_CHECKING:
    from crs_cc.session.session import Session

_NS: Final = 1e-9


class Resumption:
    """What a recording says of the first part of a run.

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
        finally:
            recording.close()

    def timesteps_left(self, session: Session) -> int | None:
        """Return the number of timesteps to the next comparison; None if there is none."""
        return max(1, self._expected[0].timesteps - session.timesteps) if self._expected else None

    def compare(self, session: Session) -> None:
        """Compare a run with the recording, where that has a hash.

        Raises:
            ReplayMismatch: the run takes another course.
        """
        while self._expected and self._expected[0].timesteps <= session.timesteps:
            expected = self._expected.popleft()
            if expected.timesteps < session.timesteps or expected.digest != digest(session):
                text = f"the run differs from its recording at {session.time_s:.2f} s"
                hint = "it goes on with the same world, seed, programs and version only"
                raise ReplayMismatch.at(Location(str(self._path)), text, hint)
            if not self._expected:
                say(f"crs: the run goes on at {session.time_s:.2f} s, where {self._path} ends")
