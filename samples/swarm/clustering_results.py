"""The results of clustering, in the words of docs/swarms.md, beside pucks without bodies."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from clustering_model import sizes

from crs_cc.sweeps.report.results import Group, Results, results
from crs_cc.sweeps.rows import Row

RUNS: Final = 300
"""Runs without bodies."""


def of_clusters(rows: Sequence[Row]) -> Results:
    """Return the number of clusters, by the number of robots and whether they leave pucks.

    Args:
        rows: the rows of the sweep.
    """
    found = results(rows, "clusters")
    groups = [replace(group, parameters=_named(group)) for group in found.groups]
    model = tuple(float(len(sizes(seed))) for seed in range(RUNS))
    names = {"robots": "without bodies", "leave": "yes"}
    groups.append(Group(names, (), model, (True,) * RUNS))
    return replace(found, varied=tuple(names), groups=tuple(groups))


def _named(group: Group) -> dict[str, int | float | str]:
    leave = ("no", "yes")[int(group.parameters["define.LEAVE"])]
    return {"robots": group.parameters["world.pusher.count"], "leave": leave}
