"""The double bridge without bodies: colonies of ants that are nothing but times and choices.

Ants choose by the function of Deneubourg and Goss, and mark both ends of a branch. All numbers are
those of cross.c, and of one of its robots alone in the world, but for the time between two ants,
which is that of ten: ants do not hinder each other, smell without error, and need no room.
"""

from __future__ import annotations

import heapq
import random
from dataclasses import dataclass
from typing import Final

K: Final = 20.0
STEEP: Final = 2.0
MARKS: Final = 4.0
ANTS: Final = 10
SHORT_S: Final = 10.75
"""From one end of a branch to the other."""
TURN_S: Final = 3.6
"""From the end of a branch to the nest or the food, and back to the choice."""
MARK_AFTER_S: Final = 2.75
"""From a choice until the cell at the beginning of the branch is crossed, by half."""
MARK_BEFORE_S: Final = 1.7
"""From when the cell at the end of a branch is crossed, by half, until the end is reached."""


@dataclass(frozen=True)
class Bridge:
    """What tells bridges apart.

    Attributes:
        second_s: from one end of the second branch to the other; that of the first is SHORT_S [s].
        release_s: from one ant to the next at the fork, when they leave first [s].
    """

    second_s: float = SHORT_S
    release_s: float = 1.43


EQUAL: Final = Bridge(release_s=3.0)
DETOUR: Final = Bridge(21.7)
FAR_DETOUR: Final = Bridge(41.7)


def shares_by_minute(bridge: Bridge, minutes: int, seed: int) -> list[float]:
    """Return the share of choices of the first branch in each minute of a colony.

    Args:
        bridge: the bridge.
        minutes: how long the run is.
        seed: of the random numbers.
    """
    draw = random.Random(seed)
    first, all_ = [0] * minutes, [0] * minutes
    marks = [[0.0, 0.0], [0.0, 0.0]]  # at both ends of the bridge, on both branches
    # when, of which ant, what it does at which end, and its branch: first ants choose, then arrive
    events: list[tuple[float, int, str, int, int]] = [
        (bridge.release_s * ant, ant, "chooses", 0, 0) for ant in range(ANTS)
    ]
    while events[0][0] < 60.0 * minutes:
        time_s, ant, does, end, branch = heapq.heappop(events)
        if does == "chooses":
            branch = _choice(marks[end], draw)
            first[int(time_s) // 60] += branch == 0
            all_[int(time_s) // 60] += 1
            arrival_s = time_s + (bridge.second_s if branch else SHORT_S)
            heapq.heappush(events, (arrival_s, ant, "arrives", 1 - end, branch))
            heapq.heappush(events, (time_s + MARK_AFTER_S, ant, "marks", end, branch))
            heapq.heappush(events, (arrival_s - MARK_BEFORE_S, ant, "marks", 1 - end, branch))
        elif does == "arrives":
            heapq.heappush(events, (time_s + TURN_S, ant, "chooses", end, 0))
        else:
            marks[end][branch] += MARKS
    return [one / of for one, of in zip(first, all_, strict=True)]


def _choice(marks: list[float], draw: random.Random) -> int:
    first, second = ((K + each) ** STEEP for each in marks)
    return int(draw.random() >= first / (first + second))
