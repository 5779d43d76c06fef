"""Ants without bodies, which are nothing but times and choices."""

from __future__ import annotations

import heapq
import math
import statistics
from collections.abc import Generator, Hashable, Sequence
from dataclasses import dataclass, field
from typing import Final

WINDOW_S: Final = 120.0
SMELL_S: Final = 0.46
"""How long a robot needs to turn to a way, and to smell."""


@dataclass
class Trail:
    """What lies at places.

    Attributes:
        evaporation_s: the time in which all but 1/e evaporates.
        laid: the amount at a place, and at what time it was that.
    """

    evaporation_s: float
    laid: dict[Hashable, tuple[float, float]] = field(default_factory=dict)

    def smell(self, place: Hashable, time_s: float) -> float:
        """Return the amount at a place and time."""
        amount, since_s = self.laid.get(place, (0.0, time_s))
        return amount * math.exp((since_s - time_s) / self.evaporation_s)

    def lay(self, place: Hashable, time_s: float, amount: float) -> None:
        """Add an amount at a place and time."""
        self.laid[place] = (self.smell(place, time_s) + amount, time_s)


@dataclass
class Found:
    """The ways that ants found: when [s], and how long they are [m]."""

    ways: list[tuple[float, float]] = field(default_factory=list)

    def medians_m(self, windows: int) -> list[float]:
        """Return the median length of the ways found in each window of time [m]."""
        return [
            statistics.median(
                length for time_s, length in self.ways if time_s // WINDOW_S == window
            )
            for window in range(windows)
        ]


Ant = Generator[float, float, None]
"""It yields how long each of its steps takes, to be sent the time at its end."""


def run(ants: Sequence[Ant], end_s: float) -> None:
    """Run ants until a time."""
    events = [(next(ant), number) for number, ant in enumerate(ants)]
    heapq.heapify(events)
    while events[0][0] < end_s:
        time_s, number = events[0]
        heapq.heapreplace(events, (time_s + ants[number].send(time_s), number))
