"""The results of the double bridge: what robots chose by minute, beside ants without bodies."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from bridge_model import SHORT_S, shares_by_minute

from crs_cc.sweeps.report.results import Group, Results
from crs_cc.sweeps.rows import Row

COLONIES: Final = 300
"""Colonies without bodies."""


def by_minute(rows: Sequence[Row]) -> Results:
    """Return the share of the branch that leads in the end, in each minute, for both colonies.

    Args:
        rows: the rows of the sweep.
    """
    rows = sorted(rows, key=lambda row: int(row["run"]))
    robots = [list(map(float, row["measures"]["north_by_minute"].split())) for row in rows]
    minutes = len(robots[0])
    ants = [shares_by_minute(SHORT_S, minutes, seed) for seed in range(COLONIES)]
    groups = []
    for colony, members, shares in (("robots", tuple(rows), robots), ("without bodies", (), ants)):
        leading = [_of_leader(each) for each in shares]
        for minute, values in enumerate(zip(*leading, strict=True), 1):
            names = {"minute": minute, "colony": colony}
            groups.append(Group(names, members, values, (True,) * len(values)))
    return Results("share", ("minute", "colony"), tuple(groups), 0)


def _of_leader(shares: list[float]) -> list[float]:
    """Return the shares of the branch that is chosen more often in the last minute."""
    return shares if shares[-1] >= 0.5 else [1.0 - each for each in shares]
