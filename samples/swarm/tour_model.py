"""The tour without bodies: ants of the Ant System that are nothing but times and choices.

All numbers are those of tour.c and tour.xml; the times are those of one of its robots alone in the
world. Ants do not hinder each other, and smell without error exactly what lies on a way.
"""

from __future__ import annotations

import itertools
import math
import random
from collections.abc import Sequence
from typing import Final

from ants_model import SMELL_S, WINDOW_S, Ant, Found, Trail, run

STATIONS: Final = (
    (3.2, 2.4),
    (1.0, 2.0),
    (2.6, 0.5),
    (3.4, 1.5),
    (1.5, 2.8),
    (2.4, 2.9),
    (1.6, 0.5),
)
"""Where the stations are [m]."""

ALPHA: Final = 2.0
BETA: Final = 3.0
UNMARKED: Final = 1.0
MARKS_M: Final = 40.0
EVAPORATION_S: Final = 300.0
ANTS: Final = 8
SPEED_M_S: Final = 0.356


def distance_m(one: int, other: int) -> float:
    """Return the distance between two stations."""
    return math.dist(STATIONS[one], STATIONS[other])


def length_m(tour: Sequence[int]) -> float:
    """Return the length of a tour."""
    return sum(distance_m(tour[at - 1], tour[at]) for at in range(len(tour)))


def shortest_m() -> float:
    """Return the length of the shortest tour, of all tours."""
    return min(length_m((0, *rest)) for rest in itertools.permutations(range(1, len(STATIONS))))


def lengths_m(windows: int, seed: int, marks: float = MARKS_M) -> list[float]:
    """Return the median length of the tours that a colony finds in each window of time [m].

    Args:
        windows: how many windows the run has.
        seed: of the random numbers.
        marks: what an ant lays on a way, times the length of its tour [m]; 0 for no trails.
    """
    draw = random.Random(seed)
    trail, found = Trail(EVAPORATION_S), Found()
    ants = [_ant(number % len(STATIONS), trail, draw, found, marks) for number in range(ANTS)]
    run(ants, windows * WINDOW_S)
    return found.medians_m(windows)


def _ant(start: int, trail: Trail, draw: random.Random, found: Found, marks_m: float) -> Ant:
    """Walk tours, and mark them."""
    time_s = yield 0.0
    while True:
        tour = [start]
        while left := [station for station in range(len(STATIONS)) if station not in tour]:
            there = _choice(tour[-1], left, trail, time_s, draw)
            time_s = yield SMELL_S * len(left) + distance_m(tour[-1], there) / SPEED_M_S
            tour.append(there)
        time_s = yield distance_m(tour[-1], start) / SPEED_M_S
        found.ways.append((time_s, length_m(tour)))
        for here, there in itertools.pairwise([*tour, start]):
            trail.lay(frozenset((here, there)), time_s, marks_m / length_m(tour))
            time_s = yield distance_m(here, there) / SPEED_M_S


def _choice(here: int, left: list[int], trail: Trail, time_s: float, draw: random.Random) -> int:
    weights = [
        (UNMARKED + trail.smell(frozenset((here, there)), time_s)) ** ALPHA
        / distance_m(here, there) ** BETA
        for there in left
    ]
    return draw.choices(left, weights)[0]
