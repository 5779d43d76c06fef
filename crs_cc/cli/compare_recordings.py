"""Run two recorded runs again side by side, up to the first timestep in which they differ."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from crs_cc.cli.changed_run import ChangedRun, recorded_changes
from crs_cc.cli.load import load
from crs_cc.cli.make_debugger import make_debugger
from crs_cc.cli.rerun import RecordedInput, unpacked
from crs_cc.cli.run_options import RunOptions
from crs_cc.core.errors import RecordingError, ReplayMismatch
from crs_cc.core.source import Diagnostics, Location
from crs_cc.debug.branch_comparison import Difference, differences, facts
from crs_cc.debug.errors import DebugError
from crs_cc.recording.mcap_records import NS

if TYPE_CHECKING:
    from crs_cc.debug.engine import Debugger
    from crs_cc.recording.recording import Recording

_OF_PROGRAMS: Final = frozenset({"program", "clock"})
"""What differs between programs that do the same: where they lie, and how long they compute."""


@dataclass(frozen=True, slots=True)
class Comparison:
    """How two runs compare.

    Attributes:
        timestep: the first one at whose start they differ; if they do not, how far both go.
        time_s: its start [s].
        before_s: the start of the timestep before [s].
        found: the differences, the first run `here`; none if the runs are the same so far.
        ends_s: the end of each recording [s].
    """

    timestep: int
    time_s: float
    before_s: float
    found: tuple[Difference, ...]
    ends_s: tuple[float, float]


def compare(here: Recording, there: Recording) -> Comparison:
    """Return how two recorded runs compare, by the state of their robots and all global variables.

    Raises:
        ReplayMismatch: a run takes another course now than when it was recorded.
        RecordingError: a recording is not valid, or the runs have different timesteps.
        CrsError: the programs or a world cannot be loaded.
    """
    timestep_s = here.description.timestep_s
    if there.description.timestep_s != timestep_s:
        text = f"its timestep is {there.description.timestep_s:g} s, not {timestep_s:g} s"
        raise RecordingError.at(Location(str(there.path)), text, "only runs with the same compare")
    last = min(_timesteps(here), _timesteps(there))
    found: tuple[Difference, ...] = ()
    with _rerun(here) as left, _rerun(there) as right:
        for timestep in range(_same_until(here, there), last + 1):
            found = tuple(
                each
                for each in differences(left.facts_at(timestep), right.facts_at(timestep))
                if each.name not in _OF_PROGRAMS
            )
            if found:
                break
    ends_s = here.end_ns / NS, there.end_ns / NS
    before_s = max(timestep - 1, 0) * timestep_s
    return Comparison(timestep, timestep * timestep_s, before_s, found, ends_s)


class _Rerun:
    """A recorded run that goes on once more, in a debugger."""

    def __init__(self, recording: Recording, debugger: Debugger) -> None:
        self._recording, self._debugger = recording, debugger
        self._changed = ChangedRun(debugger, recorded_changes(recording))

    def facts_at(self, timestep: int) -> dict[tuple[str, str], str]:
        """Go forward to the start of a timestep, and return what can be compared there."""
        try:
            self._changed.advance_to(timestep)
        except DebugError as error:
            raise ReplayMismatch.at(Location(str(self._recording.path)), str(error)) from None
        return facts(self._debugger.view)


@contextmanager
def _rerun(recording: Recording) -> Iterator[_Rerun]:
    given = RecordedInput(recording)
    with unpacked(recording, RunOptions) as options:
        loaded = load(options, Diagnostics(), debug=True)
        debugger = make_debugger(
            loaded, options, lambda *_output: None, given.read, waiting=given.waiting
        )
        yield _Rerun(recording, debugger)


def _timesteps(recording: Recording) -> int:
    """Return the number of timesteps of a recorded run."""
    return round(recording.end_ns / NS / recording.description.timestep_s)


def _same_until(here: Recording, there: Recording) -> int:
    """Return a timestep up to which runs of the same programs are known to be the same."""
    same = 0
    for left, right in zip(here.hashes(), there.hashes(), strict=False):
        if left != right:
            break
        if left.state:
            same = left.timesteps
    return same
