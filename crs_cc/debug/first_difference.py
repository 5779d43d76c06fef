"""The first timestep at whose start two runs differ, searched piece by piece."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, Protocol

from crs_cc.debug.branch_comparison import Difference, Facts, differences

_OF_PROGRAMS: Final = frozenset({"program", "clock"})
"""What differs between programs that do the same: where they lie, and how long they compute."""


class ComparedRun(Protocol):
    """A run that returns its state at timesteps, in increasing order."""

    def facts(self, timesteps: Sequence[int]) -> list[Facts]:
        """Return the comparable states at the starts of timesteps, in order."""


class FirstDifference:
    """Searches for the first difference between two runs.

    Attributes:
        timestep: the next one that is looked at; that of the difference, if one is found.
        found: the differences there, the first run `here`; none so far.
    """

    def __init__(self, here: ComparedRun, there: ComparedRun, begin: int) -> None:
        """Compare two runs that are the same up to a timestep."""
        self.timestep = begin
        self.found: tuple[Difference, ...] = ()
        self._here, self._there = here, there

    def search(self, end: int, most: int) -> bool:
        """Compare some more timesteps; return whether there are any left.

        Args:
            end: the last timestep that is looked at.
            most: how many timesteps are looked at now.
        """
        if self.found or self.timestep > end:
            return False
        timesteps = range(self.timestep, min(self.timestep + most, end + 1))
        both = zip(self._here.facts(timesteps), self._there.facts(timesteps), strict=True)
        for timestep, (here, there) in zip(timesteps, both, strict=True):
            found = differences(here, there)
            self.found = tuple(each for each in found if each.name not in _OF_PROGRAMS)
            self.timestep = timestep
            if self.found:
                return False
        self.timestep = timesteps[-1] + 1
        return self.timestep <= end
