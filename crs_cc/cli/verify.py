"""Run a recorded run again, and compare it with the recording second by second."""

from __future__ import annotations

import zlib
from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from crs_cc.cli.changed_run import ChangedRun, recorded_changes
from crs_cc.cli.load import Loaded, load
from crs_cc.cli.rerun import RecordedInput, extracted_run
from crs_cc.cli.run_options import RunOptions
from crs_cc.core.errors import ReplayMismatch
from crs_cc.core.source import Diagnostics, Location
from crs_cc.debug.errors import DebugError
from crs_cc.debug.timeline.position import Position
from crs_cc.debug.uploads import Uploads
from crs_cc.debug.world.run_edits import edit_run
from crs_cc.recording.description import versions
from crs_cc.recording.digest import digest
from crs_cc.recording.hashes import DIGEST_BITS, STATE_DIGITS
from crs_cc.session.session import Session

if TYPE_CHECKING:
    from crs_cc.debug.timeline.change import Change
    from crs_cc.recording.recording import Recording


@dataclass(frozen=True, slots=True)
class Verification:
    """What has been compared.

    Attributes:
        hashes: how many hashes.
        states: how many of them of all state.
        simulated_s: up to when.
    """

    hashes: int
    states: int
    simulated_s: float


def verify(recording: Recording) -> Verification:
    """Run a recorded run again, from its own files, and compare the hashes.

    Raises:
        ReplayMismatch: it takes another course.
        RecordingError: the recording is not valid.
        CrsError: the programs or the world cannot be loaded.
    """
    changes = recorded_changes(recording)
    with extracted_run(recording, RunOptions) as options:
        loaded = load(options, Diagnostics(), debug=recording.description.for_debugger)
        return _Rerun(recording, loaded, options, changes).compare()


class _OutputDigest:
    """The checksum of what programs have written."""

    def __init__(self) -> None:
        self.crc = 0

    def write(self, _robot: int, _stream: int, content: bytes) -> None:
        self.crc = zlib.crc32(content, self.crc)


class _Rerun:
    def __init__(
        self, recording: Recording, loaded: Loaded, options: RunOptions, changes: Sequence[Change]
    ) -> None:
        self._recording = recording
        self._output = _OutputDigest()
        given = RecordedInput(recording)
        self._changed: ChangedRun | None = None
        self._changes = deque(changes)
        self._uploads = Uploads(debug=False)
        if recording.description.for_debugger:  # its changes can be anywhere in a program
            from crs_cc.cli.make_debugger import make_debugger

            debugger = make_debugger(
                loaded, options, self._output.write, given.read, waiting=given.waiting
            )
            debugger.run.console.shows_new = True
            self._changed = ChangedRun(debugger, changes)
            self._session = debugger.session
            return
        self._session = Session(
            loaded.world,
            loaded.executables,
            seed=options.seed,
            arguments=loaded.arguments,
            output=self._output.write,
            read=given.read,
            waiting=given.waiting,
            files=loaded.files,
            client=options.client,
        )

    def compare(self) -> Verification:
        hashes = states = 0
        for expected in self._recording.hashes():
            timesteps = expected.timesteps
            if timesteps < self._session.timesteps:
                raise self._recording.mcap.error("the hashes are not in order")
            try:
                self._run_to(timesteps)
            except DebugError as error:
                raise self._mismatch(timesteps, str(error)) from None
            if self._session.timesteps != timesteps or expected.digest != digest(self._session):
                raise self._mismatch(timesteps, "the state differs")
            if expected.output != self._output.crc & DIGEST_BITS:
                raise self._mismatch(timesteps, "the programs' output differs")
            hashes += 1
            if expected.state:
                states += 1
                if expected.state != self._session.state_hash()[:STATE_DIGITS]:
                    raise self._mismatch(timesteps, "the programs' memory differs")
        return Verification(hashes, states, self._session.time_s)

    def _run_to(self, timesteps: int) -> None:
        session = self._session
        if self._changed is not None:
            self._changed.advance_to(timesteps)
            return
        while session.timesteps < timesteps:
            until = timesteps
            while self._changes and (at := self._changes[0].position).timestep < timesteps:
                if at.timestep > session.timesteps:
                    until = at.timestep
                    break
                change = self._changes.popleft()
                if change.patches or at != Position(at.timestep, 0):
                    raise DebugError(f"{change.text[:80]!r} was not made between two timesteps")
                self._apply_change(change)
            if not session.advance(until - session.timesteps, calmly=True):
                return

    def _apply_change(self, change: Change) -> None:
        """Make a change again, with the program that it brings."""
        fleet = self._session.fleet
        if change.program is not None:
            self._uploads.add(*change.program)
        programs = [fleet.executable(robot) for robot in range(len(fleet))]
        edit_run(self._session, change.text, [*programs, *self._uploads.executables()])

    def _mismatch(self, timesteps: int, what: str) -> ReplayMismatch:
        theirs, ours = self._recording.versions, {**_crs(), **versions()}
        differ = [
            f"{name} {theirs.get(name, '?')[:40]} (here {value})"
            for name, value in ours.items()
            if theirs.get(name) != value
        ]
        if lost := self._lost_host(timesteps):
            hint = lost
        elif differ:
            hint = f"recorded with {', '.join(differ)}"
        else:
            same = ", ".join(f"{name} {value}" for name, value in ours.items())
            hint = f"recorded with the same versions as here: {same}"
        at_s = timesteps * self._recording.description.timestep_s
        text = f"the run differs from its recording at {at_s:.2f} s: {what}"
        return ReplayMismatch.at(Location(str(self._recording.path)), text, hint)

    def _lost_host(self, timesteps: int) -> str:
        """Return the recorded loss of a host before a timestep, if the run did not wait for it."""
        from crs_cc.net.host_link import HOST_LOST
        from crs_cc.recording import topics

        until_ns = round(timesteps * self._recording.description.timestep_s * 1e9)
        for time_ns, event in self._recording.data(topics.EVENT.topic, until_ns=until_ns):
            if event["kind"] == "failed" and f": {HOST_LOST}: " in event["text"]:
                robot = self._recording.roster_at(time_ns).robots[event["robot"]]
                return (
                    f"{robot} lost its host at {time_ns / 1e9:.2f} s, and was stopped: such a loss"
                    " is not an input to the run, which cannot be repeated"
                )
        return ""


def _crs() -> dict[str, str]:
    from crs_cc import __version__

    return {"crs": __version__}
