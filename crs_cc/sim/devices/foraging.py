"""Sources and nests: where robots with a carrier take items, and where they drop them.

A robot is in a place while its centre is within the radius. In a source that is not full, an item
appears whenever the time `refill` has passed since the last one did, or since it was full. That
time is rounded to whole timesteps, at least one, and counted on request, so a source that is
not visited costs nothing. Where several places overlap, an item is taken from the first source of
the world file that has one, and dropped in the first nest. The models were chosen by us.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, Int64Array
from crs_cc.sim.state.foraging import UNLIMITED, capacities

if TYPE_CHECKING:
    from crs_cc.sim.model.foraging import Nest, Source
    from crs_cc.sim.model.world import WorldModel
    from crs_cc.sim.state.env_state import EnvState
    from crs_cc.sim.state.foraging import ForagingState


@dataclass(frozen=True, slots=True)
class SourceResult:
    """The status of a source.

    Attributes:
        id: its name in the world.
        taken: the items that robots have taken from it.
        left: the items that it has now; None if it never runs out.
    """

    id: str
    taken: int
    left: int | None


@dataclass(frozen=True, slots=True)
class NestResult:
    """The status of a nest.

    Attributes:
        id: its name in the world.
        brought: the items that robots have dropped in it.
    """

    id: str
    brought: int


class Foraging:
    """The sources and nests of a world."""

    def __init__(self, world: WorldModel) -> None:
        self._world = world
        self._sources, self._nests = _discs(world.sources), _discs(world.nests)
        self._most = capacities(world)
        refill_s = np.array([source.refill_s for source in world.sources])
        cycles = np.clip(np.rint(refill_s / world.timestep_s), 1, UNLIMITED)
        self._refill = cycles.astype(np.int64)

    def in_source(self, place_m: FloatArray) -> BoolArray:
        """Return which points are in which sources, (k, sources)."""
        return _inside(self._sources, place_m)

    def in_nest(self, place_m: FloatArray) -> BoolArray:
        """Return which points are in which nests, (k, nests)."""
        return _inside(self._nests, place_m)

    def take(self, state: EnvState, there: BoolArray) -> Source | None:
        """Take an item, and return its place; None if there is none.

        Args:
            state: changed in place.
            there: the sources to take it from, (sources,).
        """
        found = np.flatnonzero(there & (self._left(state) > 0))
        if state.foraging is None or not len(found):
            return None
        self._refill_up(state.foraging, state.cycle)
        source = int(found[0])
        if state.foraging.left[source] == self._most[source]:
            state.foraging.since[source] = state.cycle
        if self._most[source] != UNLIMITED:
            state.foraging.left[source] -= 1
        state.foraging.taken[source] += 1
        return self._world.sources[source]

    def drop(self, state: EnvState, there: BoolArray) -> Nest | None:
        """Drop an item, and return where; None if there is no nest.

        Args:
            state: changed in place.
            there: the nests to drop it in, (nests,).
        """
        found = np.flatnonzero(there)
        if state.foraging is None or not len(found):
            return None
        nest = int(found[0])
        state.foraging.brought[nest] += 1
        return self._world.nests[nest]

    def sources(self, state: EnvState) -> tuple[SourceResult, ...]:
        """Return the current status of the sources."""
        foraging = state.foraging
        if foraging is None:
            return ()
        counts = zip(foraging.taken.tolist(), self._left(state).tolist(), strict=True)
        return tuple(
            SourceResult(source.id, taken, None if source.items is None else left)
            for source, (taken, left) in zip(self._world.sources, counts, strict=True)
        )

    def nests(self, state: EnvState) -> tuple[NestResult, ...]:
        """Return the current status of the nests."""
        foraging = state.foraging
        if foraging is None:
            return ()
        brought = zip(self._world.nests, foraging.brought.tolist(), strict=True)
        return tuple(NestResult(nest.id, items) for nest, items in brought)

    def _left(self, state: EnvState) -> Int64Array:
        """Return the items in each source at the current cycle, (sources,)."""
        foraging = state.foraging
        if foraging is None:
            return self._most
        return np.asarray(np.minimum(foraging.left + self._new(foraging, state.cycle), self._most))

    def _new(self, foraging: ForagingState, cycle: int) -> Int64Array:
        """Return the number of items due so far in each source, (sources,)."""
        return (cycle - foraging.since) // self._refill

    def _refill_up(self, foraging: ForagingState, cycle: int) -> None:
        """Count the items that have appeared until a cycle."""
        new = self._new(foraging, cycle)
        foraging.left = np.minimum(foraging.left + new, self._most)
        foraging.since = foraging.since + new * self._refill


def _discs(places: Sequence[Source | Nest]) -> FloatArray:
    """Return the centre and radius of places, (places, 3)."""
    discs = [[place.x_m, place.y_m, place.radius_m] for place in places]
    return np.array(discs, dtype=np.float64).reshape(-1, 3)


def _inside(discs: FloatArray, place_m: FloatArray) -> BoolArray:
    """Return which points are in which discs, (points, discs)."""
    x_m, y_m = (place_m[:, None, :] - discs[:, :2]).transpose(2, 0, 1)
    inside: BoolArray = x_m * x_m + y_m * y_m <= discs[:, 2] * discs[:, 2]
    return inside
