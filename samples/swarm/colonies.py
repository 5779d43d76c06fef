"""How colonies do over time: those of robots, beside those that are computed without bodies."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from crs_cc.sweeps.report.results import Group, Results
from crs_cc.sweeps.rows import Row

ROBOTS = "robots"


def over_time(
    measure: str,
    rows: Sequence[Row],
    colonies: Mapping[str, Sequence[Sequence[float]]],
    window_min: int = 1,
) -> Results:
    """Return a measure of colonies in each window of time.

    Args:
        measure: its name.
        rows: the rows of the sweep, which are those of the colonies of ROBOTS.
        colonies: by their kind, the values of each colony by window.
        window_min: the length of a window [min].
    """
    groups = []
    for kind, runs in colonies.items():
        members = tuple(rows) if kind == ROBOTS else ()
        for window, values in enumerate(zip(*runs, strict=True), 1):
            names = {"minute": window * window_min, "colony": kind}
            groups.append(Group(names, members, values, (True,) * len(values)))
    return Results(measure, ("minute", "colony"), tuple(groups), 0)


def numbers(rows: Sequence[Row], measure: str) -> list[list[float]]:
    """Return a measure that is several numbers, of each row."""
    return [list(map(float, row["measures"][measure].split())) for row in rows]
