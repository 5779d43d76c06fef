"""How long the ways of robots are, beside those of ants without bodies, with trails and without."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Final

from ants_model import WINDOW_S
from colonies import ROBOTS, numbers, over_time

from crs_cc.sweeps.report.results import Results
from crs_cc.sweeps.rows import Row

COLONIES: Final = 300
"""Colonies without bodies, of each kind."""


def over_shortest(
    rows: Sequence[Row],
    lengths_m: Callable[[int, int], list[float]],
    unmarked_m: Callable[[int, int], list[float]],
    shortest_m: float,
) -> Results:
    """Return the length of ways over that of the shortest one, in each window of time.

    Args:
        rows: the rows of the sweep.
        lengths_m: returns what a colony without bodies finds, by the number of windows and a seed.
        unmarked_m: the same of ants that leave no trails.
        shortest_m: the length of the shortest way [m].
    """
    robots = numbers(rows, "lengths_m")
    windows = len(robots[0])
    colonies = {
        ROBOTS: robots,
        "without bodies": [lengths_m(windows, seed) for seed in range(COLONIES)],
        "without trails": [unmarked_m(windows, seed) for seed in range(COLONIES)],
    }
    ratios = {
        kind: [[round(each / shortest_m, 3) for each in run] for run in runs]
        for kind, runs in colonies.items()
    }
    return over_time("length over the shortest", rows, ratios, round(WINDOW_S / 60.0))
