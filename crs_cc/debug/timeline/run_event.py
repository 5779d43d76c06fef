"""Where a run should stop, and the events that it advances to."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

from crs_cc.core.arrays import IndexArray, Int32Array, Records
from crs_cc.debug.timeline.position import Position
from crs_cc.debug.watch import MemoryAccess, Watched, WatchedWorld
from crs_cc.sim.engine.step import Step


@dataclass(frozen=True, slots=True)
class StopRequest:
    """Where programs stop.

    Attributes:
        statements: by robot, the numbers of statements before which it stops.
        all: the robots that stop before every statement.
        everywhere: the robots that stop behind every call, too.
        since: by robot, how many sites must have been passed before it stops at all.
        watched: by robot, what is watched: it stops after accesses to that.
        world: the watched expressions that use the world.
        at_once: whether accesses are reported at the end of the round, and not only where the
            program has stopped for them: for backward searches.
        tests: by robot and statement, the conditions of which one must be true to stop.
    """

    statements: Mapping[int, Iterable[int]] = field(default_factory=dict)
    all: frozenset[int] = frozenset()
    everywhere: frozenset[int] = frozenset()
    since: Mapping[int, int] = field(default_factory=dict)
    watched: Mapping[int, Sequence[Watched]] = field(default_factory=dict)
    world: Sequence[WatchedWorld] = ()
    at_once: bool = False
    tests: Mapping[int, Mapping[int, tuple[str, ...]]] = field(default_factory=dict)

    def write_to(self, slots: Records) -> None:
        """Set the stop conditions in the programs' slots that their marks do not contain."""
        slots["stop_before_all"] = 0
        slots["stop_from"] = 0
        for wanted, robots in enumerate((self.all, self.everywhere), start=1):
            for robot in robots:  # one that was added may be gone
                slots["stop_before_all"][robot : robot + 1] = wanted
        for robot, statements in self.since.items():
            slots["stop_from"][robot : robot + 1] = statements


@dataclass(frozen=True, slots=True)
class WatchHit:
    """An access of a program to a watched object.

    Attributes:
        robot: the robot that runs the program.
        before: the last position before it: before its statement, or else before the round; for a
            change of the world, the start of the timestep that shows it.
    """

    robot: int
    access: MemoryAccess
    before: Position


@dataclass(frozen=True, slots=True, eq=False)
class PostedRequests:
    """The requests that programs have posted in a round; few ask for them.

    >>> import numpy as np
    >>> list(PostedRequests(np.array([2, 5, 7]), np.array([4, 0, 9], np.int32)))
    [(2, 4), (7, 9)]

    Attributes:
        robots: the robots that have run, ascending.
        codes: what each has posted; 0 for nothing.
    """

    robots: IndexArray
    codes: Int32Array

    def __iter__(self) -> Iterator[tuple[int, int]]:
        pairs = zip(self.robots.tolist(), self.codes.tolist(), strict=True)
        return ((robot, code) for robot, code in pairs if code)


@dataclass(frozen=True, slots=True)
class RunEvent:
    """The event to which a run has advanced.

    Attributes:
        kind: a program stopped before a `statement`; a `round` or a `timestep` has ended; the
            `limit` has been passed; or the run is at an `edit` of the user's.
        posted: the requests posted in the round: robot and code of each, ascending.
        ended: the programs that ended or failed in the round, or whose robots left with the
            timestep.
        step: the result of the timestep.
        over: whether no program is left.
        accesses: the accesses to what is watched.
    """

    kind: Literal["statement", "round", "timestep", "limit", "edit"]
    posted: Iterable[tuple[int, int]] = ()
    ended: tuple[int, ...] = ()
    step: Step | None = None
    over: bool = False
    accesses: tuple[WatchHit, ...] = ()
