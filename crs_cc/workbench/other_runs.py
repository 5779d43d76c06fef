"""Recorded runs that pages compare with the one that is shown: opened here, or sent by a page."""

from __future__ import annotations

import tempfile
import threading
from base64 import b64decode
from binascii import Error as Base64Error
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final

from crs_cc.core.errors import CrsError
from crs_cc.debug.errors import DebugError
from crs_cc.recording.mcap_records import NS
from crs_cc.recording.recording import Recording
from crs_cc.workbench.feed import Feed
from crs_cc.workbench.recorded_content import events_in, frame_blocks, output_in

if TYPE_CHECKING:
    from collections.abc import Callable
    from contextlib import AbstractContextManager

    from crs_cc.debug.first_difference import ComparedRun

MAX_RUNS: Final = 4
MAX_BYTES: Final = 64 * 2**20
"""Of a recording that a page sends; chosen by us. Larger ones are named in the command line."""

MAX_PIECE: Final = 48_000
"""Characters of a piece of it, as base 64."""

MAX_FRAMES: Final = 128 * 2**20
"""Of frames of a run that are kept in memory."""

_NUMBERS: Final = 2**24  # of blocks: those of each run begin at another multiple
_MAX_TEXT: Final = 80


@dataclass(frozen=True, slots=True)
class OtherRun:
    """A recorded run.

    Attributes:
        name: that of its file.
        title: its programs, world and seed.
        feed: what is recorded.
        recording: the recording itself.
    """

    name: str
    title: str
    feed: Feed
    recording: Recording

    @property
    def timestep_s(self) -> float:
        """The length of a timestep [s]."""
        return self.recording.description.timestep_s


class OtherRuns:
    """Recorded runs, by name.

    Attributes:
        runs_again: has the programs of a recorded run run again; None where nothing can.
        own: the displayed recording; None for a live run.
        compared: what is known of runs that were compared: pages may fetch their frames.
    """

    def __init__(self) -> None:
        self.runs_again: Callable[[Recording], AbstractContextManager[ComparedRun]] | None = None
        self.own: Recording | None = None
        self.compared: dict[str, Feed] = {}
        self._runs: dict[str, OtherRun] = {}
        self._opened = self._begun = 0
        self._lock = threading.Lock()
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        self._sent: tuple[str, Path, int] | None = None  # the one that a page sends: so far

    def open(self, path: Path, name: str = "") -> OtherRun:
        """Open a recording; one of the same name is closed.

        Raises:
            CrsError: it is damaged, or has no frames.
            DebugError: there are too many.
        """
        name = name or path.name
        if name not in self._runs and len(self._runs) >= MAX_RUNS:
            raise DebugError(f"at most {MAX_RUNS} recordings: close one first")
        recording = Recording(path)
        try:
            feed = recorded_feed(recording, (self._opened + 1) * _NUMBERS)
        except CrsError:
            recording.close()
            raise
        self._opened += 1
        if name in self._runs:
            self.close(name)
        self._runs[name] = OtherRun(name, title_of(recording), feed, recording)
        return self._runs[name]

    def add_piece(self, name: str, offset: int, data: str) -> None:
        """Append a piece of a recording that a page uploads; thread-safe.

        Raises:
            ValueError: it is no piece of a recording, or does not follow what has come.
        """
        if not name.endswith(".mcap") or name != Path(name).name or len(name) > _MAX_TEXT:
            raise ValueError(f"'{name[:_MAX_TEXT]}' is not the name of a recording (NAME.mcap)")
        try:
            content = b64decode(data, validate=True)
        except (Base64Error, ValueError):
            raise ValueError("the part is not valid base64") from None
        with self._lock:
            if offset == 0:
                self._folder = self._folder or tempfile.TemporaryDirectory(prefix="crs-compare-")
                self._drop()
                self._begun += 1
                self._sent = name, Path(self._folder.name, f"{self._begun}.mcap"), 0
            if self._sent is None or self._sent[0] != name or self._sent[2] != offset:
                raise ValueError("the part does not follow the previous one")
            if offset + len(content) > MAX_BYTES:
                self._drop()
                raise ValueError("the recording is too large: name it by crs view --compare")
            with self._sent[1].open("ab") as file:
                file.write(content)
            self._sent = name, self._sent[1], offset + len(content)

    def _drop(self) -> None:
        """Forget a recording of which not all has been uploaded."""
        if self._sent is not None:
            self._sent[1].unlink(missing_ok=True)
        self._sent = None

    def open_sent(self, name: str) -> OtherRun:
        """Open the recording that a page has sent.

        Raises:
            DebugError: nothing of this name was sent, or it is no recording.
        """
        with self._lock:
            sent, self._sent = self._sent, None
        if sent is None or sent[0] != name:
            raise DebugError(f"no recording '{name[:_MAX_TEXT]}' has been uploaded")
        try:
            return self.open(sent[1], name)
        except (CrsError, DebugError) as error:
            sent[1].unlink(missing_ok=True)
            text = error.diagnostics[0].text if isinstance(error, CrsError) else str(error)
            raise DebugError(f"{name}: {text}") from None

    def find(self, name: str) -> OtherRun | None:
        """Return the run with a name; None if there is none."""
        return self._runs.get(name)

    def block(self, number: int) -> bytes | None:
        """Return a block of frames of a run that was compared; thread-safe."""
        contents = (each.frames.content(number) for each in list(self.compared.values()))
        return next((each for each in contents if each is not None), None)

    def listing(self) -> list[dict[str, Any]]:
        """Return the runs as pages list them."""
        return [
            {"name": each.name, "title": each.title, "end": each.feed.end_s}
            for each in self._runs.values()
        ]

    def close(self, name: str) -> None:
        """Close a recording; raise DebugError if there is none of this name."""
        if name not in self._runs:
            raise DebugError(f"no recording '{name[:_MAX_TEXT]}' is open")
        self.compared.pop(name, None)
        recording = self._runs.pop(name).recording
        recording.close()
        if self._folder is not None and recording.path.parent == Path(self._folder.name):
            recording.path.unlink(missing_ok=True)


def recorded_feed(recording: Recording, first: int = 0) -> Feed:
    """Return the recorded data; its blocks are numbered from a number on.

    Raises:
        RecordingError: it is damaged, or has no frames.
    """
    blocks, _ = frame_blocks(recording, MAX_FRAMES)
    if not blocks:
        raise recording.mcap.error("no frames: there is nothing to compare")
    feed = Feed({}, recording.description.frame_s, first)
    feed.end_s = recording.end_ns / NS
    for begin_s, end_s, content in blocks:
        feed.frames.add_packed(begin_s, end_s, content)
    for roster in recording.rosters:
        feed.roster(roster.time_ns / NS, roster.robots, roster.objects)
    feed.fill(events_in(recording)[0], output_in(recording)[0])
    return feed


def title_of(recording: Recording) -> str:
    """Return the programs, the world and the seed of a recorded run."""
    run = recording.description
    names = ", ".join(dict.fromkeys(Path(source).name for source in run.sources)) or "programs"
    return f"{names} in {Path(run.world).name or 'an empty world'}, seed {run.seed}"
