"""The results of the double bridge: what robots chose by minute, beside ants without bodies."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from bridge_model import LONG_S, SHORT_S, shares_by_minute

from crs_cc.sweeps.report.results import Group, Results
from crs_cc.sweeps.rows import Row

COLONIES: Final = 300
"""Colonies without bodies."""

_BRANCHES: Final = {"equal": SHORT_S, "unequal": LONG_S}
"""By DETOUR in cross.c: the name of the bridge, and the time over its second branch [s]."""


def by_minute(rows: Sequence[Row]) -> Results:
    """Return the share of the shorter branch in each minute, of equal ones that of the leading one.

    Args:
        rows: the rows of the sweep.
    """
    groups = []
    for detour, (branches, second_s) in enumerate(_BRANCHES.items()):
        chosen = [row for row in rows if row["parameters"]["define.DETOUR"] == detour]
        chosen.sort(key=lambda row: int(row["seed"]))
        robots = [list(map(float, row["measures"]["north_by_minute"].split())) for row in chosen]
        minutes = len(robots[0])
        ants = [shares_by_minute(second_s, minutes, seed) for seed in range(COLONIES)]
        for colony, members, of_colony in (
            ("robots", tuple(chosen), robots),
            ("without bodies", (), ants),
        ):
            shares = of_colony if detour else [_of_leader(each) for each in of_colony]
            for minute, values in enumerate(zip(*shares, strict=True), 1):
                names = {"minute": minute, "branches": branches, "colony": colony}
                groups.append(Group(names, members, values, (True,) * len(values)))
    return Results("share", ("minute", "branches", "colony"), tuple(groups), 0)


def _of_leader(shares: list[float]) -> list[float]:
    """Return the shares of the branch that is chosen more often in the last minute."""
    return shares if shares[-1] >= 0.5 else [1.0 - each for each in shares]
