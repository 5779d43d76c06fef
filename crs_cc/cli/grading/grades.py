"""Grades: the points of a submission, over all worlds and seeds."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from crs_cc.cli.grading.job import GradedRun, Result
from crs_cc.cli.grading.submissions import Submission
from crs_cc.sim.engine.goals import GoalResult
from crs_cc.sim.model.goals import Goal


@dataclass(frozen=True, slots=True)
class Case:
    """A world with a seed, in which every submission is run.

    Attributes:
        name: its name for people, unlike all others: that of the world's file, and the seed if
            there are several.
        world: the world file.
        seed: the random seed; None for the world's.
        goals: the world's goals.
    """

    name: str
    world: Path
    seed: int | None
    goals: tuple[Goal, ...]


@dataclass(frozen=True, slots=True)
class Grade:
    """What a submission achieved.

    Attributes:
        submission: the submission.
        cases: what it was run in.
        runs: the outcome of each of these runs.
        identical: the names of submissions with the same program, apart from names and comments.
        files: the recording of each run, relative to the folder of runs; empty for none.
    """

    submission: Submission
    cases: tuple[Case, ...]
    runs: tuple[GradedRun, ...]
    identical: tuple[str, ...] = ()
    files: tuple[str, ...] = ()

    @property
    def earned(self) -> float:
        """The points in all runs."""
        return sum(run.earned for run in self.runs)

    @property
    def possible(self) -> float:
        """The points of all goals, in all runs."""
        return sum(goal.points for case in self.cases for goal in case.goals)

    @property
    def percent(self) -> float:
        """The share of the points, 0 to 100; 0 if nothing is worth a point."""
        return 100.0 * self.earned / self.possible if self.possible else 0.0

    @property
    def worst(self) -> GradedRun:
        """The first run that did not just end, else the first."""
        return next((run for run in self.runs if run.result != "ended"), self.runs[0])

    @property
    def result(self) -> Result:
        """The result of the first run that did not end normally, else of the first."""
        return self.worst.result

    @property
    def message(self) -> str:
        """What went wrong, with file and line."""
        return self.worst.text

    def outcomes(self, case: int) -> list[GoalResult | None]:
        """Return the status of the goals of a case; None where it was not run."""
        goals = self.runs[case].goals
        return list(goals) if goals else [None] * len(self.cases[case].goals)


def identical_programs(
    runs: Sequence[Sequence[GradedRun]], names: Sequence[str]
) -> list[tuple[str, ...]]:
    """Return for each submission the names of the others that are the same program."""
    groups: dict[str, list[int]] = defaultdict(list)
    for number, own in enumerate(runs):
        fingerprint = next((run.fingerprint for run in own if run.fingerprint), "")
        if fingerprint:  # a run that is stopped from outside has none, another can
            groups[fingerprint].append(number)
    found: list[tuple[str, ...]] = [()] * len(runs)
    for group in groups.values():
        for number in group:
            found[number] = tuple(names[other] for other in group if other != number)
    return found
