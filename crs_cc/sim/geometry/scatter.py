"""Random positions for identical objects, without overlaps.

Candidates are drawn one after another, and each that is free is taken (random sequential
adsorption). A candidate depends on the seed and its number only, so the first places are the same
however many are wanted. Things are taken as round.

>>> from crs_cc.sim.model.world import Area
>>> region = Region(((0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (0.0, 1.0)))
>>> taken = Taken(Area(0.0, 0.0, 2.0, 2.0), ())
>>> places_m = taken.place(3, 0.2, region, KeyedUniform(seed=1, stream=STREAM), key=0)
>>> places_m.shape, bool((places_m[:, 1] <= 1.0).all())
((3, 2), True)
>>> len(taken.place(100, 0.2, region, KeyedUniform(seed=1, stream=STREAM), key=1)) < 100
True
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, Int64Array
from crs_cc.core.keyed_random import KeyedUniform
from crs_cc.sim.geometry.cell_list import Discs, overlapping
from crs_cc.sim.geometry.placement import disc_around, distance_from_m
from crs_cc.sim.kernels import exact
from crs_cc.sim.model.polygon import distances_m
from crs_cc.sim.model.world import Area, Robot, Solid

STREAM: Final = 30
"""Key of random numbers for places, beside those in `state.random_streams`."""

_X, _Y, _HEADING = range(3)

_FIRST_TRIES: Final = 64
_MAX_BATCH: Final = 1 << 14
_GROWTH: Final = 4
_MAX_TRIES: Final = 200_000
_TRIES_EACH: Final = 10
"""Candidates: an initial number, then increasing numbers at once, up to a total that bounds the
work, or until none of the most at once is free."""


@dataclass(frozen=True, slots=True)
class Region:
    """The region of the centres of objects, and their distribution in it.

    Attributes:
        corners_m: the corners of a polygon around them.
        centre_m: the centre of a disc or a normal distribution; None for all of the polygon.
        radius_m: radius of the disc, in which they are even.
        deviation_m: standard deviation in x and in y of the normal distribution, if not 0.
    """

    corners_m: tuple[tuple[float, float], ...]
    centre_m: tuple[float, float] | None = None
    radius_m: float = 0.0
    deviation_m: float = 0.0

    def draw(self, uniform: KeyedUniform, key: int, numbers: Int64Array) -> FloatArray:
        """Return the candidates with these numbers, (k, 2); they may be outside of the polygon."""
        one, other = uniform.draw(key, numbers, _X), uniform.draw(key, numbers, _Y)
        if self.centre_m is None:
            corners = np.array(self.corners_m)
            low, high = corners.min(axis=0), corners.max(axis=0)
            return np.asarray(low + (high - low) * np.column_stack([one, other]))
        if self.deviation_m > 0.0:
            away = exact.normal_pairs(one, other) * self.deviation_m
        else:
            away = exact.turn(math.tau * other) * (self.radius_m * np.sqrt(one))
        return np.asarray(np.column_stack([away.real, away.imag]) + np.array(self.centre_m))

    def contains(self, places_m: FloatArray) -> BoolArray:
        """Return whether the polygon contains each of k places."""
        corners, count = np.array(self.corners_m), len(places_m)
        counts = np.full(count, len(corners))
        away_m = distances_m(places_m, np.tile(corners, (count, 1)), counts)
        return np.asarray(away_m <= 0.0)


class Taken:
    """The occupied space in an area: by its solids, by robots, by objects placed before."""

    def __init__(self, area: Area, solids: Sequence[Solid], robots: Sequence[Robot] = ()) -> None:
        self._area, self._solids = area, solids
        self._around = Discs(*np.array([disc_around(each) for each in solids]).reshape(-1, 3).T)
        self._discs = np.array(
            [(each.start.x_m, each.start.y_m, each.model.radius_m) for each in robots]
        ).reshape(-1, 3)

    def place(
        self, count: int, radius_m: float, region: Region, uniform: KeyedUniform, key: int
    ) -> FloatArray:
        """Take places for discs, and return their centres, (count, 2); fewer if there is no room.

        Args:
            count: their number.
            radius_m: their radius.
            region: where.
            uniform: the random numbers.
            key: the key of this group of discs.
        """
        found, most = _Apart(2.0 * radius_m), _MAX_TRIES + _TRIES_EACH * count
        tried, tries = 0, min(max(_FIRST_TRIES, 2 * count), _MAX_BATCH)
        while len(found.places_m) < count and tried < most:
            numbers = np.arange(tried, min(tried + tries, most))
            candidates = region.draw(uniform, key, numbers)
            candidates = candidates[region.contains(candidates)]
            candidates = candidates[self._is_free(candidates, radius_m)]
            before = len(found.places_m)
            found.add(candidates.tolist(), count)
            if len(found.places_m) == before and tries == _MAX_BATCH:
                break
            tried, tries = tried + tries, min(tries * _GROWTH, _MAX_BATCH)
        places_m = np.array(found.places_m).reshape(-1, 2)
        discs = np.column_stack([places_m, np.full(len(places_m), radius_m)])
        self._discs = np.concatenate([self._discs, discs])
        return places_m

    def _is_free(self, places_m: FloatArray, radius_m: float) -> BoolArray:
        """Return whether a disc at each of k places would be inside of the area, on free ground."""
        area, x_m, y_m = self._area, places_m[:, 0], places_m[:, 1]
        free = (x_m >= area.x_min_m + radius_m) & (x_m <= area.x_max_m - radius_m)
        free &= (y_m >= area.y_min_m + radius_m) & (y_m <= area.y_max_m - radius_m)
        discs = Discs(x_m, y_m, np.full(len(x_m), radius_m))
        for _, near in overlapping(Discs(*self._discs.T), discs):
            free[near] = False
        for solid_of, near in overlapping(self._around, discs):
            for number in sorted(set(solid_of.tolist())):
                those = near[solid_of == number]
                away_m = distance_from_m(self._solids[number], x_m[those], y_m[those])
                free[those[away_m < radius_m]] = False
        return free


class _Apart:
    """Places that are a distance apart, in a grid with cells of that size."""

    def __init__(self, distance_m: float) -> None:
        self.places_m: list[tuple[float, float]] = []
        self._distance_m = distance_m
        self._cells: dict[tuple[int, int], list[tuple[float, float]]] = {}

    def add(self, places_m: Sequence[tuple[float, float]], most: int) -> None:
        """Add places one by one, without those too near to others, up to a number in all."""
        for x_m, y_m in places_m:
            if len(self.places_m) == most:
                return
            column, row = int(x_m // self._distance_m), int(y_m // self._distance_m)
            around = (
                place
                for i in (column - 1, column, column + 1)
                for j in (row - 1, row, row + 1)
                for place in self._cells.get((i, j), ())
            )
            apart_m2 = self._distance_m * self._distance_m
            if all((x_m - x) * (x_m - x) + (y_m - y) * (y_m - y) >= apart_m2 for x, y in around):
                self.places_m.append((x_m, y_m))
                self._cells.setdefault((column, row), []).append((x_m, y_m))


def headings_rad(count: int, uniform: KeyedUniform, key: int) -> FloatArray:
    """Return random headings for a group of objects."""
    return np.asarray(math.tau * uniform.draw(key, np.arange(count), _HEADING))
