"""Path formation without bodies: robots of chain.c that are points, of which none is in the way.

They walk, hear, join and leave as chain.c says, with its numbers and the places of path.xml; they
turn at once, do not avoid each other, measure without error, and hear a beacon at any time.
"""

from __future__ import annotations

import cmath
import math
import random
from dataclasses import dataclass
from typing import Final

ARENA_M: Final = 3.2, 3.0
NEST: Final = 0.8 + 1.5j
SOURCE: Final = 2.6 + 1.5j
RADIUS_M: Final = 0.3
START_M: Final = 0.6
"""Robots start within this distance of the nest."""
RANGE_M: Final = 0.6
LIMIT_M: Final = 0.5
BESIDE_M: Final = 0.25
BODY_M: Final = 0.06
SPEED_M_S: Final = 0.254
PERIOD_S: Final = 0.3
JOIN: Final = 1.0
LEAVE: Final = 0.1
SPREAD_RAD: Final = 0.8
WANDER_RAD: Final = 0.2


@dataclass
class _Robot:
    """A robot.

    Attributes:
        place: where it is [m].
        way: where it walks [rad].
        number: that of its beacon, -1 as long as it walks.
        before: of a beacon, the one before it; of a robot that walks, the beacon it was at last.
        found: whether its beacon belongs to a path.
        back: where it returns to if it hears nobody.
    """

    place: complex
    way: float
    number: int = -1
    before: _Robot | None = None
    found: bool = False
    back: complex = NEST


def formed_s(count: int, end_s: float, seed: int) -> float:
    """Return when robots have formed a path from the nest to the source, infinite for not [s].

    Args:
        count: how many robots there are beside the one in the nest.
        end_s: the end of the run.
        seed: of the random numbers.
    """
    draw = random.Random(seed)
    nest = _Robot(NEST, 0.0, number=0)
    robots = [
        _Robot(
            NEST + cmath.rect(START_M * math.sqrt(draw.random()), draw.uniform(-math.pi, math.pi)),
            draw.uniform(-math.pi, math.pi),
        )
        for _ in range(count)
    ]
    beacons = [nest]
    for period in range(round(end_s / PERIOD_S)):
        for robot in robots:
            heard = [
                each
                for each in beacons
                if each is not robot
                and each.number >= 0
                and abs(each.place - robot.place) < RANGE_M
            ]
            if robot.number >= 0:
                _stand(robot, heard, draw)
            else:
                _walk(robot, heard, draw)
        beacons = [nest, *(robot for robot in robots if robot.number >= 0)]
        if any(robot.before is nest and robot.found for robot in beacons):
            return (period + 1) * PERIOD_S
    return math.inf


def _stand(robot: _Robot, heard: list[_Robot], draw: random.Random) -> None:
    """Be a beacon for a period, or leave."""
    assert robot.before is not None
    if robot.before.number < 0:
        robot.number = -1
        return
    robot.before = min((robot.before, *heard), key=lambda each: each.number)
    robot.number = robot.before.number + 1
    after = [each for each in heard if each.before is robot]
    robot.found |= any(each.found for each in after)
    if not after and not robot.found and draw.random() < LEAVE * PERIOD_S:
        robot.number = -1


def _walk(robot: _Robot, heard: list[_Robot], draw: random.Random) -> None:
    """Walk for a period, or become a beacon."""
    if heard:
        at = max(heard, key=lambda each: (each.found, each.number))
        is_there = abs(robot.place - SOURCE) < RADIUS_M and not at.found
        away_m = abs(robot.place - at.place)
        is_outside = away_m > LIMIT_M and all(
            abs(robot.place - each.place) > LIMIT_M for each in heard
        )
        if is_there or (is_outside and not at.found and draw.random() < JOIN * PERIOD_S):
            robot.number, robot.before, robot.found = at.number + 1, at, is_there
            return
        if at is not robot.before:
            robot.way = (
                draw.uniform(-math.pi, math.pi)
                if at.before is None
                else cmath.phase(at.place - at.before.place) + draw.uniform(-SPREAD_RAD, SPREAD_RAD)
            )
        if away_m > LIMIT_M:
            robot.way = cmath.phase(at.place - robot.place)
            robot.way += draw.uniform(-SPREAD_RAD, SPREAD_RAD)
        robot.before, robot.back = at, at.place
        robot.way += draw.uniform(-WANDER_RAD, WANDER_RAD)
    else:
        if abs(robot.back - robot.place) < BESIDE_M:
            robot.back = NEST
        robot.way = cmath.phase(robot.back - robot.place)
    place = robot.place + cmath.rect(SPEED_M_S * PERIOD_S, robot.way)
    length_m, width_m = ARENA_M
    if BODY_M < place.real < length_m - BODY_M and BODY_M < place.imag < width_m - BODY_M:
        robot.place = place
    else:
        robot.way += draw.uniform(-math.pi, math.pi)
