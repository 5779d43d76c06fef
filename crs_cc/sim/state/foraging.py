"""The items in the sources and nests of a world."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, Self

import numpy as np

from crs_cc.core.arrays import Int64Array

if TYPE_CHECKING:
    from crs_cc.sim.model.world import WorldModel

UNLIMITED: Final = 2**53
"""Items in a source without a limit."""


@dataclass(slots=True)
class ForagingState:
    """The items in all sources, s of them, and all nests, n of them.

    Attributes:
        left: the items in each source at the cycle in `since`, (s,).
        since: the cycle from which the time for the next item counts, (s,).
        taken: the items that robots have taken from each source, (s,).
        brought: the items that robots have dropped in each nest, (n,).
    """

    left: Int64Array
    since: Int64Array
    taken: Int64Array
    brought: Int64Array

    @classmethod
    def at_start(cls, world: WorldModel) -> Self | None:
        """Return the state before the first cycle; None for a world without such places."""
        if not (world.sources or world.nests):
            return None
        sources = len(world.sources)
        return cls(
            capacities(world),
            np.zeros(sources, np.int64),
            np.zeros(sources, np.int64),
            np.zeros(len(world.nests), np.int64),
        )


def capacities(world: WorldModel) -> Int64Array:
    """Return the most items that each source holds, (s,)."""
    return np.array([s.items or UNLIMITED for s in world.sources], dtype=np.int64)
