"""The results of path formation: when there is a path, beside robots without bodies."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from chain_model import formed_s

from crs_cc.sweeps.report.results import Group, Results
from crs_cc.sweeps.rows import Row

RUNS: Final = 40
"""Runs without bodies."""
_MEASURE: Final = "goal.path.at_s"
"""Named as the time of a goal: some runs end before there is a path."""


def of_paths(rows: Sequence[Row]) -> Results:
    """Return when there is a path, by the number of robots, with and without bodies.

    Args:
        rows: the rows of the sweep.
    """
    counts = sorted({row["parameters"]["world.ant.count"] for row in rows})
    groups = []
    for count in counts:
        mine = tuple(row for row in rows if row["parameters"]["world.ant.count"] == count)
        measures = [row["measures"] for row in mine]
        times_s = tuple(each["path_s"] for each in measures)
        names = {"robots": count, "kind": "robots"}
        groups.append(Group(names, mine, times_s, tuple(each["has_path"] > 0 for each in measures)))
    end_s = rows[0]["simulated_s"]
    for count in counts:
        model = [formed_s(count, end_s, seed) for seed in range(RUNS)]
        times_s = tuple(min(each, end_s) for each in model)
        names = {"robots": count, "kind": "without bodies"}
        groups.append(Group(names, (), times_s, tuple(each < end_s for each in model)))
    return Results(_MEASURE, ("robots", "kind"), tuple(groups), 0)
