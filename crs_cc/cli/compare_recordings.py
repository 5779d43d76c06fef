"""Run two recorded runs again side by side, up to the first timestep in which they differ."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Final

from crs_cc.cli.changed_run import ChangedRun, recorded_changes
from crs_cc.cli.load import load
from crs_cc.cli.make_debugger import make_debugger
from crs_cc.cli.rerun import RecordedInput, extracted_run
from crs_cc.cli.run_options import RunOptions
from crs_cc.core.errors import RecordingError, ReplayMismatch
from crs_cc.core.source import Diagnostics, Location
from crs_cc.debug.branch_comparison import Difference, Facts, facts, variables
from crs_cc.debug.errors import DebugError
from crs_cc.debug.first_difference import FirstDifference
from crs_cc.recording.hashes import common_until
from crs_cc.recording.mcap_records import NS
from crs_cc.workbench.exact_comparison import ComparedPart, difference_rows

if TYPE_CHECKING:
    from crs_cc.debug.engine import Debugger
    from crs_cc.recording.recording import Recording

_PIECE: Final = 20
"""The number of timesteps by which each run advances before the other one."""


@dataclass(frozen=True, slots=True)
class Comparison:
    """How two runs compare.

    Attributes:
        timestep: the first one at whose start they differ; if they do not, how far both go.
        time_s: its start [s].
        before_s: the start of the timestep before [s].
        found: the differences, the first run `here`; none if the runs are the same so far.
        ends_s: the end of each recording [s].
        variables: the global variables of programs, by robot and name.
        later: if none of the differences is one of a variable, the first such ones.
        later_s: when these are [s], or up to when there are none.
    """

    timestep: int
    time_s: float
    before_s: float
    found: tuple[Difference, ...]
    ends_s: tuple[float, float]
    variables: frozenset[tuple[str, str]] = frozenset()
    later: tuple[Difference, ...] = ()
    later_s: float = 0.0


def compare(here: Recording, there: Recording, *, onward: bool = False) -> Comparison:
    """Compare two recorded runs, by the state of their robots and all global variables.

    Args:
        here: a recorded run.
        there: another one.
        onward: whether to look on for a variable, if none differs at the first difference.

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
    with rerun(here) as left, rerun(there) as right:
        search = FirstDifference(left, right, common_until(here.hashes(), there.hashes()))
        while search.search(last, _PIECE):
            pass
        known = left.variables()
        is_of_variables = any((each.robot, each.name) in known for each in search.found)
        later = None
        if onward and search.found and not is_of_variables:
            both = ComparedPart(left, known.__contains__), ComparedPart(right, known.__contains__)
            later = FirstDifference(*both, search.timestep)
            while later.search(last, _PIECE):
                pass
    timestep = min(search.timestep, last)
    ends_s = here.end_ns / NS, there.end_ns / NS
    rest = ((), 0.0) if later is None else (later.found, min(later.timestep, last) * timestep_s)
    before_s = max(timestep - 1, 0) * timestep_s
    return Comparison(timestep, timestep * timestep_s, before_s, search.found, ends_s, known, *rest)


def exact_rows(found: Comparison) -> dict[str, Any]:
    """Return the results in the form of a page, see `ExactComparison.go_on`."""
    is_variable = found.variables.__contains__
    at_s = max(found.time_s, found.later_s)
    return {
        "t": at_s,
        "until": min(found.ends_s),
        "is_done": True,
        "found": difference_rows(found.found, found.time_s, is_variable)
        + difference_rows(found.later, found.later_s, is_variable),
        "wrong": "",
    }


class Rerun:
    """A recorded run that is repeated in a debugger."""

    def __init__(self, recording: Recording, debugger: Debugger) -> None:
        self._recording, self._debugger = recording, debugger
        self._changed = ChangedRun(debugger, recorded_changes(recording))

    def facts(self, timesteps: Sequence[int]) -> list[Facts]:
        """Go forward to the starts of timesteps, and return what can be compared there."""
        found = []
        for timestep in timesteps:
            try:
                self._changed.advance_to(timestep)
            except DebugError as error:
                raise ReplayMismatch.at(Location(str(self._recording.path)), str(error)) from None
            found.append(facts(self._debugger.view))
        return found

    def variables(self) -> frozenset[tuple[str, str]]:
        """Return the global variables of its programs, by robot and name."""
        return variables(self._debugger.view)


@contextmanager
def rerun(recording: Recording) -> Iterator[Rerun]:
    """Run a recorded run again, at its start.

    Raises:
        CrsError: the programs or the world cannot be loaded.
    """
    given = RecordedInput(recording)
    with extracted_run(recording, RunOptions) as options:
        loaded = load(options, Diagnostics(), debug=True)
        debugger = make_debugger(
            loaded, options, lambda *_output: None, given.read, waiting=given.waiting
        )
        yield Rerun(recording, debugger)


def _timesteps(recording: Recording) -> int:
    """Return the number of timesteps of a recorded run."""
    return round(recording.end_ns / NS / recording.description.timestep_s)
