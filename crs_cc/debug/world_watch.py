"""Watched expressions that use the world or several programs.

What they use is no memory that could be watched, so they are evaluated at the start of each
timestep, forward and backward.
"""

from __future__ import annotations

from collections.abc import Sequence

from crs_cc.debug.data.observation import Content
from crs_cc.debug.timeline.position import Position
from crs_cc.debug.timeline.run_event import WatchHit
from crs_cc.debug.watch import MemoryAccess, WatchedWorld


class WorldWatchSet:
    """The watched expressions of a run that use the world."""

    def __init__(self) -> None:
        self._wanted: tuple[WatchedWorld, ...] = ()
        self._seen: dict[int, Content] = {}

    def arm(self, wanted: Sequence[WatchedWorld]) -> None:
        """Set the watched expressions; the last values of those that remain are kept."""
        if tuple(wanted) != self._wanted:
            self._wanted = tuple(wanted)
            self.reset()

    def reset(self) -> None:
        """Take the values of now as the last ones: the run was moved."""
        self._seen = {each.number: each.observe() for each in self._wanted}

    def drain(self, position: Position) -> tuple[WatchHit, ...]:
        """Return the changes since the last values, which are seen at a position."""
        before = self._seen
        self.reset()
        pairs = ((each, before[each.number], self._seen[each.number]) for each in self._wanted)
        return tuple(
            WatchHit(each.robot, MemoryAccess(each, "change", old, new), position)
            for each, old, new in pairs
            if old != new and (any(new[0]) or not each.rises)
        )
