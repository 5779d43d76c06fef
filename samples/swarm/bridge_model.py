"""The double bridge without bodies: colonies of ants that are nothing but times and choices.

Ants choose by the function of Deneubourg and Goss, and mark the beginning of a branch when they
choose it, its end when they arrive there. All numbers are those of cross.c, and of one of its
robots alone in the world: ants do not hinder each other, smell without error, and need no room.
"""

from __future__ import annotations

import heapq
import random
from typing import Final

K: Final = 20.0
STEEP: Final = 2.0
MARKS: Final = 4.0
ANTS: Final = 10
RELEASE_S: Final = 3.0
DETOUR_RELEASE_S: Final = 1.45
"""From one ant to the next at the fork, if they leave as fast as robots can smell there."""
TURN_S: Final = 4.5
"""From the end of a branch to the nest or the food, and back to the choice."""
SHORT_S: Final = 10.5
LONG_S: Final = 20.8


def shares_by_minute(
    second_s: float, minutes: int, seed: int, release_s: float = RELEASE_S
) -> list[float]:
    """Return the share of choices of the first branch in each minute of a colony.

    Args:
        second_s: the time from one end of the second branch to the other [s]; that of the first is
            SHORT_S.
        minutes: how long the run is.
        seed: of the random numbers.
        release_s: the time between two ants that leave first [s].
    """
    draw = random.Random(seed)
    first, all_ = [0] * minutes, [0] * minutes
    marks = [[0.0, 0.0], [0.0, 0.0]]  # at both ends of the bridge, on both branches
    # of each ant: when, at which end, and the branch on which it arrives; None before it chooses
    events: list[tuple[float, int, int, int | None]] = [
        (release_s * ant, ant, 0, None) for ant in range(ANTS)
    ]
    while events[0][0] < 60.0 * minutes:
        time_s, ant, end, branch = heapq.heappop(events)
        if branch is None:
            branch = _choice(marks[end], draw)
            first[int(time_s) // 60] += branch == 0
            all_[int(time_s) // 60] += 1
            arrival_s = time_s + (second_s if branch else SHORT_S)
            heapq.heappush(events, (arrival_s, ant, 1 - end, branch))
        else:
            heapq.heappush(events, (time_s + TURN_S, ant, end, None))
        marks[end][branch] += MARKS
    return [one / of for one, of in zip(first, all_, strict=True)]


def _choice(marks: list[float], draw: random.Random) -> int:
    first, second = ((K + each) ** STEEP for each in marks)
    return int(draw.random() >= first / (first + second))
