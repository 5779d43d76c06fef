"""The sites that the programs of a run have passed, by part of the run.

To go back to a breakpoint, the programs run again from earlier and earlier snapshots. Where no
program has passed a breakpoint's site that is of no use, and mostly that is nearly everywhere. So
the marks of all sites say whether they were passed (`site_tests.UNPASSED`), and are looked at every
few timesteps.

Stretches begin at fixed timesteps, so running through one again finds the same. One that was not
run through from its start to its end, or in which a program was stepping, is not known.
"""

from __future__ import annotations

import zlib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate
from typing import Final

import numpy as np

from crs_cc.runtime.fleet import Fleet
from crs_cc.runtime.site_tests import UNPASSED

STRETCH: Final = 16
"""The length of a stretch [timesteps]; chosen by us: many times what looking at the marks costs."""

MAX_BYTES: Final = 16 * 2**20
"""Memory for stretches [bytes]; the oldest are forgotten when there are more."""

_HELD: Final = 400
"""What a stretch takes besides its bits, about [bytes]."""


@dataclass(frozen=True, slots=True)
class _Stretch:
    """What programs did in a stretch.

    Attributes:
        ends: by robot, where its bits end [bytes]: one for each site, packed.
        packed: the bits of all robots, compressed.
        ended: the robots whose programs ended.
    """

    ends: tuple[int, ...]
    packed: bytes
    ended: frozenset[int]

    @property
    def size(self) -> int:
        """Return its size [bytes]."""
        return _HELD + len(self.packed) + 8 * len(self.ended)

    def passed(self, wanted: Mapping[int, Iterable[int]]) -> set[int]:
        """Return the robots whose programs passed one of their wanted sites."""
        bits, ends = zlib.decompress(self.packed), self.ends
        found = set[int]()
        for robot, sites in wanted.items():
            if robot >= len(ends):
                continue
            first = 8 * (ends[robot - 1] if robot else 0)
            for place in (first + site for site in sites):
                if bits[place >> 3] >> (place & 7) & 1:
                    found.add(robot)
                    break
        return found


class PassedSites:
    """The stretches of a run that are known."""

    def __init__(self, most_bytes: int = MAX_BYTES) -> None:
        """Start without records, and limit their memory to a number of bytes."""
        self._most_bytes = most_bytes
        self._stretches: dict[int, _Stretch] = {}  # by number; the oldest is the first
        self._bytes = 0
        self._number: int | None = None  # of the one that the run is in, from its start on
        self._ended: set[int] = set()
        self._ends: tuple[int, ...] = ()

    def invalidate(self) -> None:
        """Discard the current stretch, as the run has moved."""
        self._number = None

    def end_programs(self, robots: Iterable[int]) -> None:
        """Record that programs have ended."""
        self._ended.update(robots)

    def record_halt(self, fleet: Fleet, robot: int) -> None:
        """Record that a program has stopped before a site, possibly without a mark."""
        fleet.marks[robot][int(fleet.slots["stopped"][robot]) - 1] &= UNPASSED - 1

    def begin_stretch(self, timestep: int, fleet: Fleet, sites: Sequence[int]) -> None:
        """Complete the previous stretch, and begin a new one.

        Args:
            timestep: the number of its first timestep.
            fleet: the programs.
            sites: by robot, how many sites its program has.
        """
        number = timestep // STRETCH - 1
        if self._number == number and number not in self._stretches:
            self._keep(number, fleet, sites)
        self._number = number + 1
        self._ended.clear()
        for marks, count in zip(fleet.marks, sites, strict=False):
            marks[:count] |= UNPASSED

    def _keep(self, number: int, fleet: Fleet, sites: Sequence[int]) -> None:
        rows = [
            np.packbits(marks[:count] < UNPASSED, bitorder="little")
            for marks, count in zip(fleet.marks, sites, strict=False)
        ]
        ends = tuple(accumulate(map(len, rows)))
        if ends == self._ends:
            ends = self._ends  # which is shared
        self._ends = ends
        packed = zlib.compress(b"".join(each.tobytes() for each in rows), 1)
        self._stretches[number] = kept = _Stretch(ends, packed, frozenset(self._ended))
        self._bytes += kept.size
        while self._bytes > self._most_bytes:
            self._drop(next(iter(self._stretches)))

    def _drop(self, number: int) -> None:
        self._bytes -= self._stretches.pop(number).size

    def truncate(self, timestep: int) -> None:
        """Discard the stretches that contain a timestep, or are later."""
        self.invalidate()
        for number in [each for each in self._stretches if each >= timestep // STRETCH]:
            self._drop(number)

    def passed(self, timestep: int, wanted: Mapping[int, Iterable[int]]) -> set[int] | None:
        """Return the robots whose programs passed one of some sites in the stretch of a timestep.

        Args:
            timestep: the timestep.
            wanted: by robot, the sites; for those alone.

        Returns:
            These robots, and those of `wanted` whose programs ended; None if it is not known.
        """
        known = self._stretches.get(timestep // STRETCH)
        if known is None:
            return None
        return known.passed(wanted) | (known.ended & wanted.keys())
