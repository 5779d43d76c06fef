"""The goals of a world as rows: the status of each, and the time of its decision."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from crs_cc.debug.world.rows import Row, instant

if TYPE_CHECKING:
    from crs_cc.sim.engine.goals import GoalResult


def goal_rows(goals: Sequence[GoalResult]) -> list[Row]:
    """Return a row for each goal, and one for the points; none for a world without goals."""
    if not goals:
        return []
    earned, total = sum(goal.earned for goal in goals), sum(goal.points for goal in goals)
    return [
        *(Row(goal.title, _text(goal)) for goal in goals),
        Row("points", f"{earned:g} of {total:g}"),
    ]


def _text(goal: GoalResult) -> str:
    text: str = goal.status
    if goal.at_s is not None:
        text += f" at {instant(goal.at_s)}"
    if goal.progress:
        text += f", {goal.progress}"
    return f"{text} ({goal.points:g} {'point' if goal.points == 1 else 'points'})"
