"""The results of the double bridge: what robots chose by minute, beside ants without bodies."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from bridge_model import DETOUR_RELEASE_S, LONG_S, SHORT_S, shares_by_minute
from colonies import ROBOTS, numbers, over_time

from crs_cc.sweeps.report.results import Results
from crs_cc.sweeps.rows import Row

COLONIES: Final = 300
"""Colonies without bodies."""


def of_leader(rows: Sequence[Row]) -> Results:
    """Return the share of the branch that leads in the end, of two equal ones.

    Args:
        rows: the rows of the sweep.
    """
    robots = numbers(rows, "north_by_minute")
    ants = [shares_by_minute(SHORT_S, len(robots[0]), seed) for seed in range(COLONIES)]
    colonies = {ROBOTS: robots, "without bodies": ants}
    leading = {kind: [_of_leader(run) for run in runs] for kind, runs in colonies.items()}
    return over_time("share", rows, leading)


def of_short(rows: Sequence[Row]) -> Results:
    """Return the share of the short branch, if the other is twice as long.

    Args:
        rows: the rows of the sweep.
    """
    robots = numbers(rows, "north_by_minute")
    ants = [
        shares_by_minute(LONG_S, len(robots[0]), seed, DETOUR_RELEASE_S) for seed in range(COLONIES)
    ]
    return over_time("share of the short branch", rows, {ROBOTS: robots, "without bodies": ants})


def _of_leader(shares: list[float]) -> list[float]:
    """Return the shares of the branch that is chosen more often in the last minute."""
    return shares if shares[-1] >= 0.5 else [1.0 - each for each in shares]
