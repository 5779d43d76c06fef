"""The parts of the past that may contain a reason to stop, latest first.

They end at snapshots, and leave out what is known to be of no use: where no program has passed a
site that has a breakpoint, and none has ended (`timeline.passed_sites`).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from crs_cc.debug.breakpoints import Breakpoints
from crs_cc.debug.timeline.passed_sites import STRETCH
from crs_cc.debug.timeline.position import Position
from crs_cc.debug.timeline.recorded_run import RecordedRun


@dataclass(frozen=True, slots=True)
class SearchedPart:
    """A part of the past that is to be searched.

    Attributes:
        begin: where it begins, at a snapshot.
        limit: where it ends.
        robots: those whose programs may have given a reason to stop.
        first: before this position none has.
    """

    begin: Position
    limit: Position
    robots: frozenset[int]
    first: Position


class SearchedParts:
    """The parts of a run's past that are searched for hits of breakpoints, and for errors."""

    def __init__(self, run: RecordedRun, breakpoints: Breakpoints) -> None:
        """Find out which programs may have given a reason to stop before now, and where."""
        self._run = run
        robots = range(len(run.programs))
        # to stay stopped by an error is a state: a program that is not in it has not failed
        own = [each for each in robots if breakpoints.may_stop(each) or run.has_failed(each)]
        self._robots = frozenset(own)
        self._everywhere = frozenset(each for each in own if self._is_unknown(breakpoints, each))
        self._sites = {
            each: sorted(breakpoints.statements(each))
            for each in own
            if each not in self._everywhere
        }
        self._known: dict[int, frozenset[int]] = {}  # by stretch, the robots

    def _is_unknown(self, breakpoints: Breakpoints, robot: int) -> bool:
        """Return whether a program may have given a reason to stop without passing a known site."""
        return robot >= self._run.world_robots or breakpoints.stops_anywhere(robot)

    def back_from(self, start: Position) -> Iterator[SearchedPart]:
        """Return the parts before a position; the run may be moved after each."""
        history, limit = self._run.history, start
        for begin in history.back_from(start):
            part: SearchedPart | None = None
            while limit > begin:
                place = history.last_before(limit)
                found = self._part(place, limit)
                if found is None and part is not None:
                    yield part
                    part = None
                elif found is not None and part is not None:
                    robots = part.robots | found.robots
                    part = replace(found, limit=part.limit, robots=robots)
                else:
                    part = found
                limit = place
            if part is not None:
                yield part

    def _part(self, begin: Position, limit: Position) -> SearchedPart | None:
        """Return the part to be searched from a snapshot on; None for nothing."""
        if self._everywhere:
            return SearchedPart(begin, limit, self._robots, begin)
        is_inside = limit > Position(limit.timestep, 0)
        last = (limit.timestep + is_inside - 1) // STRETCH
        some = [each for each in range(begin.timestep // STRETCH, last + 1) if self._in(each)]
        if not some:
            return None
        robots = frozenset[int]().union(*map(self._in, some))
        first = max(begin, Position(some[0] * STRETCH, 0))
        return SearchedPart(begin, min(limit, Position((some[-1] + 1) * STRETCH, 0)), robots, first)

    def _in(self, stretch: int) -> frozenset[int]:
        """Return the robots whose programs may have given a reason to stop in a stretch."""
        if stretch not in self._known:
            found = self._run.passed_sites.passed(stretch * STRETCH, self._sites)
            self._known[stretch] = self._robots if found is None else frozenset(found)
        return self._known[stretch]
