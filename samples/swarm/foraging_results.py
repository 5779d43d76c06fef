"""The results of foraging with trails, in the words of docs/swarms.md."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from crs_cc.sweeps.report.results import Results, results
from crs_cc.sweeps.rows import Row

_MEASURE: Final = "items_per_min"


def with_trails(rows: Sequence[Row]) -> Results:
    """Return the items per minute, by the number of robots, with and without trails."""
    found = results(rows, _MEASURE)
    groups = tuple(
        replace(
            group,
            parameters={
                "robots": group.parameters["world.ant.count"],
                "trails": ("no", "yes")[int(group.parameters["define.TRAILS"])],
            },
        )
        for group in found.groups
    )
    return replace(found, varied=("robots", "trails"), groups=groups)
