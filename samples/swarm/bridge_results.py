"""The results of the double bridge: what robots chose by minute, beside ants without bodies."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from bridge_model import DETOUR, EQUAL, FAR_DETOUR, Bridge, shares_by_minute
from colonies import ROBOTS, numbers, over_time

from crs_cc.sweeps.report.results import Results
from crs_cc.sweeps.rows import Row

COLONIES: Final = 300
"""Colonies without bodies."""
_SHORT: Final = "share of the short branch"


def of_leader(rows: Sequence[Row]) -> Results:
    """Return the share of the branch that leads in the end, of two equal ones.

    Args:
        rows: the rows of the sweep.
    """
    colonies = _beside(EQUAL, numbers(rows, "north_by_minute"))
    leading = {kind: [_of_leader(run) for run in runs] for kind, runs in colonies.items()}
    return over_time("share", rows, leading)


def of_short(rows: Sequence[Row]) -> Results:
    """Return the share of the short branch, if the southern one is twice as long.

    Args:
        rows: the rows of the sweep.
    """
    return over_time(_SHORT, rows, _beside(DETOUR, numbers(rows, "north_by_minute")))


def of_very_short(rows: Sequence[Row]) -> Results:
    """Return the share of the short branch, if the northern one is four times as long.

    Args:
        rows: the rows of the sweep.
    """
    north = numbers(rows, "north_by_minute")
    return over_time(_SHORT, rows, _beside(FAR_DETOUR, [[1.0 - s for s in run] for run in north]))


def _beside(bridge: Bridge, robots: list[list[float]]) -> dict[str, list[list[float]]]:
    """Return the shares of a branch in colonies of robots, and in those without bodies."""
    ants = [shares_by_minute(bridge, len(robots[0]), seed) for seed in range(COLONIES)]
    return {ROBOTS: robots, "without bodies": ants}


def _of_leader(shares: list[float]) -> list[float]:
    """Return the shares of the branch that is chosen more often in the last minute."""
    return shares if shares[-1] >= 0.5 else [1.0 - each for each in shares]
