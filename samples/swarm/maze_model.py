"""The maze without bodies: ants of S-ACO that are nothing but times and choices.

All numbers are those of maze.c and maze.xml; the times are those of one of its robots alone in the
world. Ants do not hinder each other, and smell without error.
"""

from __future__ import annotations

import random
from collections import deque
from typing import Final

from ants_model import SMELL_S, WINDOW_S, Ant, Found, Trail, run

MAZE: Final = (
    "+-+-+-+-+-+-+-+",
    "|             |",
    "+ +-+-+-+-+-+ +",
    "|     | |     |",
    "+-+-+ + + +-+-+",
    "|     | | |   |",
    "+ + +-+ + + + +",
    "| |     |   | |",
    "+ + + + +-+-+ +",
    "|             |",
    "+-+-+-+-+-+-+-+",
)
"""Cells are at odd places, walls between them; the first row is the northern one."""

Cell = tuple[int, int]

NEST: Final[Cell] = (0, 2)
FOOD: Final[Cell] = (6, 2)
CELL_M: Final = 0.6
ALPHA: Final = 2.0
UNMARKED: Final = 1.0
MARKS: Final = 40.0
EVAPORATION_S: Final = 150.0
ANTS: Final = 8
RELEASE_S: Final = 3.0
STEP_S: Final = 2.43
"""From one cell to the next."""


def neighbours(cell: Cell) -> list[Cell]:
    """Return the cells to which corridors lead from a cell."""
    column, row = 2 * cell[0] + 1, len(MAZE) - 2 - 2 * cell[1]
    return [
        (cell[0] + east, cell[1] + north)
        for east, north in ((1, 0), (0, 1), (-1, 0), (0, -1))
        if MAZE[row - north][column + east] == " "
    ]


def shortest_m() -> float:
    """Return the length of the shortest way from nest to food, by breadth-first search."""
    steps = {NEST: 0}
    waiting = deque([NEST])
    while FOOD not in steps:
        cell = waiting.popleft()
        for other in neighbours(cell):
            if other not in steps:
                steps[other] = steps[cell] + 1
                waiting.append(other)
    return steps[FOOD] * CELL_M


def lengths_m(windows: int, seed: int, marks: float = MARKS) -> list[float]:
    """Return the median length of the ways that a colony finds in each window of time [m].

    Args:
        windows: how many windows the run has.
        seed: of the random numbers.
        marks: what an ant lays in a cell, times the cells of its way; 0 for no trails.
    """
    draw = random.Random(seed)
    trail, found = Trail(EVAPORATION_S), Found()
    ants = [_ant(RELEASE_S * number, trail, draw, found, marks) for number in range(ANTS)]
    run(ants, windows * WINDOW_S)
    return found.medians_m(windows)


def _ant(start_s: float, trail: Trail, draw: random.Random, found: Found, marks: float) -> Ant:
    """Walk to the food, and back without the loops of the way."""
    time_s = yield start_s
    while True:
        way, before = [NEST], NEST
        while way[-1] != FOOD:
            here = way[-1]
            ahead = [cell for cell in neighbours(here) if cell != before] or [before]
            weights = [(UNMARKED + trail.smell(cell, time_s)) ** ALPHA for cell in ahead]
            before, there = here, draw.choices(ahead, weights)[0]
            time_s = yield STEP_S + (SMELL_S * len(ahead) if len(ahead) > 1 else 0.0)
            way = [*way[: way.index(there)], there] if there in way else [*way, there]
        found.ways.append((time_s, (len(way) - 1) * CELL_M))
        for cell in reversed(way[:-1]):
            time_s = yield STEP_S
            trail.lay(cell, time_s, marks / (len(way) - 1))
