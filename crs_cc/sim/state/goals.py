"""How far the goals of a world are met."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import accumulate, pairwise
from typing import TYPE_CHECKING, Final, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, Int64Array
from crs_cc.sim.model.goals import Cover, Goal, Visit, cells_of

if TYPE_CHECKING:
    from crs_cc.sim.model.world import Area, WorldModel

OPEN, MET, FAILED = range(3)
"""The status of a goal; one that is met or failed stays so."""

ABSENT: Final = -1


@dataclass(slots=True)
class GoalState:
    """The state of all goals, g of them.

    Instants other than `at_s` are numbers of timesteps since the start.

    Attributes:
        status: `OPEN`, `MET` or `FAILED`, (g,).
        at_s: when each was met or failed, infinite for neither, (g,).
        since: since when each robot has been in the place, `ABSENT` for not, (robots, g).
        done: whether each robot has met it, (robots, g).
        brought: since when the objects of a `Bring` have been in their place, (g,).
        right: timesteps in which the distance of a `Follow` was right, (g,).
        counted: timesteps that count for a `Follow`, (g,).
        marks: the places that have been visited and the cells that have been covered, of all goals,
            see `mark_ranges`.
    """

    status: Int64Array
    at_s: FloatArray
    since: Int64Array
    done: BoolArray
    brought: Int64Array
    right: Int64Array
    counted: Int64Array
    marks: BoolArray

    @classmethod
    def at_start(cls, world: WorldModel) -> Self | None:
        """Return the state before the first timestep; None for a world without goals."""
        goals, robots = len(world.goals), len(world.robots)
        if not goals:
            return None
        return cls(
            np.zeros(goals, np.int64),
            np.full(goals, np.inf),
            np.full((robots, goals), ABSENT, np.int64),
            np.zeros((robots, goals), np.bool_),
            np.full(goals, ABSENT, np.int64),
            np.zeros(goals, np.int64),
            np.zeros(goals, np.int64),
            np.zeros(mark_ranges(world)[-1].stop, np.bool_),
        )


def mark_ranges(world: WorldModel) -> list[slice]:
    """Return the range of each goal's marks; many goals have none."""
    ends = [0, *accumulate(_marks(goal, world.area) for goal in world.goals)]
    return [slice(start, stop) for start, stop in pairwise(ends)]


def _marks(goal: Goal, area: Area) -> int:
    match goal.condition:
        case Visit(places):
            return len(places)
        case Cover(cell_m=cell_m):
            columns, rows = cells_of(cell_m, area.length_m, area.width_m)
            return columns * rows
    return 0
