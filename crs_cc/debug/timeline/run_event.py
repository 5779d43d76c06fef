"""Where programs stop, and what a run has come to when they have."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from crs_cc.debug.timeline.position import Position
    from crs_cc.debug.watch import MemoryAccess, WatchedObject
    from crs_cc.sim.engine.step import Step


@dataclass(frozen=True, slots=True)
class StopRequest:
    """Where programs stop.

    Attributes:
        statements: by robot, the numbers of statements before which it stops.
        all: the robots that stop before every statement.
        since: by robot, how many statements must have begun before it stops at all.
        watched: by robot, what is watched in its memory: it stops behind accesses, too.
        at_once: whether accesses are told when the round has ended, and not only where the program
            has stopped for them: for who looks back.
    """

    statements: Mapping[int, Iterable[int]] = field(default_factory=dict)
    all: frozenset[int] = frozenset()
    since: Mapping[int, int] = field(default_factory=dict)
    watched: Mapping[int, Sequence[WatchedObject]] = field(default_factory=dict)
    at_once: bool = False


@dataclass(frozen=True, slots=True)
class WatchHit:
    """What a program did to what is watched.

    Attributes:
        robot: whose program.
        access: what it did.
        before: the last instant before: its statement was about to begin, or else the round was.
    """

    robot: int
    access: MemoryAccess
    before: Position


@dataclass(frozen=True, slots=True)
class RunEvent:
    """What a run has come to.

    Attributes:
        kind: a program stopped before a `statement`; a `round` or a `timestep` has ended; or the
            `limit` has been passed.
        posted: the requests that programs posted in the round: robot and code of each, rising.
        ended: the programs that ended in the round, or failed; those whose robots left with the
            timestep.
        step: what happened in the timestep.
        over: whether the timestep was the last one, as no program is left.
        accesses: what happened to what is watched.
    """

    kind: Literal["statement", "round", "timestep", "limit"]
    posted: tuple[tuple[int, int], ...] = ()
    ended: tuple[int, ...] = ()
    step: Step | None = None
    over: bool = False
    accesses: tuple[WatchHit, ...] = ()
