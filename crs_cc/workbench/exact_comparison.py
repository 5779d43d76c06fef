"""The first instant and variable in which another run differs: both run again, by pieces."""

from __future__ import annotations

import time
from contextlib import ExitStack
from typing import TYPE_CHECKING, Any, Final

from crs_cc.core.errors import CrsError
from crs_cc.debug.branch_comparison import variables
from crs_cc.debug.difference_text import by, narrowed
from crs_cc.debug.errors import DebugError
from crs_cc.debug.first_difference import FirstDifference
from crs_cc.recording.hashes import common_until
from crs_cc.workbench.comparison import common_robots

if TYPE_CHECKING:
    from collections.abc import Callable, Sequence

    from crs_cc.debug.branch_comparison import Difference, Facts
    from crs_cc.debug.first_difference import ComparedRun
    from crs_cc.workbench.branches import BranchFeeds
    from crs_cc.workbench.feed import Feed
    from crs_cc.workbench.other_runs import OtherRun, OtherRuns
    from crs_cc.workbench.run import Run

MAX_FOUND: Final = 40

_PIECE: Final = 200  # of timesteps of robots
_AT_ONCE_S: Final = 0.3  # of real time
_MAX_TEXT: Final = 120  # characters of a value

Key = tuple[str, str]
"""A robot, and what of it."""


class ExactComparison:
    """Two runs that are run again side by side.

    Attributes:
        name: that of the other run.
    """

    def __init__(self, run: Run, feed: Feed, others: OtherRuns, name: str) -> None:
        """Compare the run that is shown with another one, from where they may differ.

        Args:
            run: the run that is shown.
            feed: what is known of it.
            others: recorded runs.
            name: that of one of them, or of a branch.

        Raises:
            DebugError: they cannot be compared so, or the other one cannot be run again.
        """
        self.name = name
        self._run, self._feed, self._others, self._stack = run, feed, others, ExitStack()
        debugger = run.debugger()
        self._timestep_s = debugger.session.environment.timestep_s
        branches = run.branches()
        self._branch = branches.current
        other = others.find(name)
        self._other = branches.feed(name) if other is None else other.feed
        self._robots = frozenset(common_robots(feed, self._other))
        self._variables = variables(debugger.view)
        self._here: ComparedRun = _Branch(branches, self._branch)
        self._there: ComparedRun
        if other is None:
            self._there = _Branch(branches, name)
            begin = max(0, int(branches.common_until_s(name) / self._timestep_s) - 1)
        else:
            self._there = self._run_again(other)
            begin = self._same_until(other)
        self._of_all = FirstDifference(*self._only(self._is_common), begin)
        self._of_variables: FirstDifference | None = None

    def _only(self, keeps: Callable[[Key], bool]) -> tuple[ComparedRun, ComparedRun]:
        return ComparedPart(self._here, keeps), ComparedPart(self._there, keeps)

    def _is_common(self, key: Key) -> bool:
        return key[0] in self._robots

    def _is_variable(self, key: Key) -> bool:
        return key[0] in self._robots and key in self._variables

    def _run_again(self, other: OtherRun) -> ComparedRun:
        if other.timestep_s != self._timestep_s:
            raise DebugError(
                f"the timestep of {other.name} is {other.timestep_s:g} s, not"
                f" {self._timestep_s:g} s: variables of such runs are not compared"
            )
        again = self._others.runs_again
        if again is None:
            raise DebugError("recorded programs cannot be run again here: start it with crs view")
        try:
            return self._stack.enter_context(again(other.recording))
        except CrsError as error:
            text = error.diagnostics[0].text
            raise DebugError(f"the programs of {other.name} cannot be run again: {text}") from None

    def _same_until(self, other: OtherRun) -> int:
        own = self._others.own
        if own is None or self._run.changes():
            return 0
        return common_until(own.hashes(), other.recording.hashes())

    def is_of(self, name: str) -> bool:
        """Return whether it compares the run that is shown with another one."""
        return name == self.name and self._branch == self._run.branches().current

    def continue_search(self) -> dict[str, Any]:
        """Continue the search for a fraction of a second; return its progress and results.

        First for anything that differs, and from there on for a variable of a program.

        Raises:
            DebugError: one of the runs cannot be run again.
        """
        end = int(min(self._feed.end_s, self._other.end_s) / self._timestep_s + 1e-6)
        until_s = time.monotonic() + _AT_ONCE_S
        goes_on = True
        try:
            while goes_on and time.monotonic() < until_s:
                goes_on = self._search(end)
        except CrsError as error:
            text = error.diagnostics[0].text
            raise DebugError(f"{self.name} cannot be run again: {text}") from None
        search = self._of_variables or self._of_all
        return {
            "t": min(search.timestep, end) * self._timestep_s,
            "until": end * self._timestep_s,
            "is_done": not goes_on,
            "found": self._rows(self._of_all)
            + ([] if self._of_variables is None else self._rows(self._of_variables)),
        }

    def _search(self, end: int) -> bool:
        """Compare some timesteps; return whether there are more to compare."""
        piece = max(1, _PIECE // len(self._robots))
        if self._of_variables is not None:
            return self._of_variables.search(end, piece)
        if self._of_all.search(end, piece):
            return True
        found = self._of_all.found
        if not found or any(self._is_variable((each.robot, each.name)) for each in found):
            return False
        both = self._only(self._is_variable)
        self._of_variables = FirstDifference(*both, self._of_all.timestep)
        return True

    def _rows(self, search: FirstDifference) -> list[dict[str, Any]]:
        """Return the differences that a search has found, variables at first."""
        time_s = search.timestep * self._timestep_s
        return difference_rows(search.found, time_s, self._is_variable)

    def close(self) -> None:
        """Forget the programs that were run again."""
        self._stack.close()


def difference_rows(
    found: Sequence[Difference], time_s: float, is_variable: Callable[[Key], bool]
) -> list[dict[str, Any]]:
    """Return differences at a time as pages show them, variables at first."""
    are = [is_variable((each.robot, each.name)) for each in found]
    rows = [
        {
            "t": time_s,
            "robot": each.robot,
            "what": each.name,
            "here": _shown(each.here),
            "there": _shown(each.there),
            "by": by(each.here, each.there),
            "is_variable": is_one,
        }
        for each, is_one in zip(map(narrowed, found), are, strict=True)
    ]
    return sorted(rows, key=lambda each: not each["is_variable"])[:MAX_FOUND]


class _Branch:
    """A branch of the run that is shown."""

    def __init__(self, branches: BranchFeeds, name: str) -> None:
        self._branches, self._name = branches, name

    def facts(self, timesteps: Sequence[int]) -> list[Facts]:
        """Return what can be compared at the starts of timesteps."""
        return self._branches.facts(self._name, timesteps)


class ComparedPart:
    """Some of what can be compared of a run."""

    def __init__(self, run: ComparedRun, keeps: Callable[[Key], bool]) -> None:
        self._run, self._keeps = run, keeps

    def facts(self, timesteps: Sequence[int]) -> list[Facts]:
        """Return what can be compared at the starts of timesteps."""
        return [
            {key: text for key, text in each.items() if self._keeps(key)}
            for each in self._run.facts(timesteps)
        ]


def _shown(text: str) -> str:
    return text[:_MAX_TEXT] or "nothing"
