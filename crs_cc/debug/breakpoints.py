"""Breakpoints, and which of them are hit."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from crs_cc.debug.errors import DebugError
from crs_cc.debug.locations import BreakpointLocation
from crs_cc.debug.run_values import mentions_world
from crs_cc.debug.watch import Watched, WatchedWorld
from crs_cc.debug.world.events import is_of, world_events
from crs_cc.ir.names import plain_name

if TYPE_CHECKING:
    from crs_cc.debug.timeline.recorded_run import RecordedRun
    from crs_cc.debug.timeline.run_event import RunEvent, WatchHit
    from crs_cc.debug.watchpoints import Watchpoint

BreakpointKind = Literal["breakpoint", "watchpoint", "catchpoint"]


@dataclass(slots=True)
class Breakpoint:
    """A breakpoint, watchpoint or catchpoint.

    Attributes:
        number: its number, from 1; all kinds share one sequence. Those of commands such as
            `advance` have negative ones, so that the user's are consecutive.
        text: the location, expression or event kind as the user wrote it.
        location: the location of a breakpoint; None for the other kinds.
        watch: what a watchpoint watches; None for the other kinds.
        condition: a C expression that must not be 0; empty for none.
        ignore: how many hits are still ignored.
        every: only every n-th hit stops the run.
        hits: how often it was hit, ignored hits included.
        temporary: whether it is deleted when hit.
        stops_left: after how many more stops it is disabled, 0 if it is; None for never.
        enabled: whether it is enabled.
        robot: the only robot that it stops; None for all robots.
        log: the message to log instead of stopping, with C expressions in braces; empty to stop.
    """

    number: int
    kind: BreakpointKind
    text: str
    location: BreakpointLocation | None = None
    watch: Watchpoint | None = None
    condition: str = ""
    ignore: int = 0
    every: int = 1
    hits: int = 0
    temporary: bool = False
    stops_left: int | None = None
    enabled: bool = True
    robot: int | None = None
    log: str = ""

    def count_stop(self) -> None:
        """Count a stop, and disable it after the last one that it was enabled for."""
        if self.stops_left is not None:
            self.stops_left = max(0, self.stops_left - 1)
            self.enabled = self.stops_left > 0

    def concerns(self, robot: int) -> bool:
        """Return whether it is enabled for a robot."""
        return self.enabled and self.robot in {None, robot}


@dataclass(frozen=True, slots=True)
class BreakpointHit:
    """A hit of a breakpoint.

    Attributes:
        robot: the robot that hit it; -1 for none.
        text: a description.
        watch_hit: the access to the watched object.
    """

    breakpoint: Breakpoint
    robot: int
    text: str = ""
    watch_hit: WatchHit | None = None


class Breakpoints:
    """All breakpoints of a run, by their numbers."""

    def __init__(self) -> None:
        self._all: dict[int, Breakpoint] = {}
        self._made = 0

    def __iter__(self) -> Iterator[Breakpoint]:
        return iter(tuple(self._all.values()))

    @property
    def next_number(self) -> int:
        """The number of the next one."""
        return self._made + 1

    @property
    def next_internal(self) -> int:
        """The number of the next one that belongs to a command."""
        return min((0, *self._all)) - 1

    def add(
        self, breakpoint_: Callable[[int], Breakpoint], *, internal: bool = False
    ) -> Breakpoint:
        """Add the breakpoint that is created with the next number, or below 0 if internal."""
        number = self.next_internal if internal else self.next_number
        self._all[number] = breakpoint_(number)
        self._made = max(self._made, number)
        return self._all[number]

    def get(self, number: int) -> Breakpoint:
        """Return a breakpoint; raise DebugError if it does not exist."""
        if number not in self._all:
            raise DebugError(f"no breakpoint {number}")
        return self._all[number]

    def remove(self, number: int) -> None:
        """Remove a breakpoint; raise DebugError if it does not exist."""
        self.get(number)
        del self._all[number]

    def statements(self, robot: int) -> frozenset[int]:
        """Return the numbers of the statements with breakpoints in a robot's program."""
        places = [each.location for each in self._all.values() if each.concerns(robot)]
        return frozenset().union(*(each.statements.get(robot, ()) for each in places if each))

    def may_stop(self, robot: int) -> bool:
        """Return whether a robot's program may hit any of them."""
        return any(
            each.concerns(robot)
            and (
                each.kind == "catchpoint"
                or each.watch is not None
                or (each.location is not None and bool(each.location.codes))
                or (each.location is not None and bool(each.location.statements.get(robot)))
            )
            for each in self._all.values()
        )

    def stops_anywhere(self, robot: int) -> bool:
        """Return whether any may be hit somewhere else than at its site or at the end."""
        return any(
            each.concerns(robot)
            and (
                (each.kind == "catchpoint" and each.text != "exit")
                or each.watch is not None
                or (each.location is not None and bool(each.location.codes))
            )
            for each in self._all.values()
        )

    def conditions(self, robot: int) -> dict[int, tuple[str, ...]]:
        """Return the conditions of statements with breakpoints that all have conditions."""
        found: dict[int, list[str]] = {}
        for each in self._all.values():
            if each.location and each.concerns(robot):
                for number in each.location.statements.get(robot, ()):
                    found.setdefault(number, []).append(each.condition)
        return {number: tuple(texts) for number, texts in found.items() if all(texts)}

    def need_world(self, names: Sequence[str]) -> bool:
        """Return whether any of them catches an event of the world, or depends on its state.

        Args:
            names: the names of all objects of the world.
        """
        return bool(self.watched_world()) or any(
            (each.kind == "catchpoint" and each.text != "exit")
            or mentions_world(each.condition, names)
            for each in self._all.values()
            if each.enabled
        )

    def watched(self, robot: int) -> tuple[Watched, ...]:
        """Return the watched ranges of a robot's memory."""
        points = [each.watch for each in self._all.values() if each.concerns(robot)]
        watched = (each.watched for each in points if each)
        return tuple(each for each in watched if not isinstance(each, WatchedWorld))

    def watched_world(self) -> tuple[WatchedWorld, ...]:
        """Return the watched expressions that use the world."""
        watched = [each.watch.watched for each in self._all.values() if each.watch and each.enabled]
        return tuple(each for each in watched if isinstance(each, WatchedWorld))

    def watchpoint_hits(self, event: RunEvent) -> list[BreakpointHit]:
        """Return the hits of watchpoints, whatever their conditions."""
        return [
            BreakpointHit(self._all[each.access.watched.number], each.robot, watch_hit=each)
            for each in event.accesses
        ]

    def breakpoint_hits(self, run: RecordedRun, event: RunEvent) -> list[BreakpointHit]:
        """Return the hits of the other breakpoints, whatever their conditions."""
        match event.kind:
            case "statement":
                return self._at_statement(run)
            case "round":
                return self._at_requests(run, event)
            case "timestep":
                return self._at_timestep(run, event)
        return []

    def _at_statement(self, run: RecordedRun) -> list[BreakpointHit]:
        robot = run.session.state.halted
        assert robot is not None
        number = int(run.session.fleet.slots["stopped"][robot]) - 1
        return [
            BreakpointHit(each, robot)
            for each in self._all.values()
            if each.location
            and each.concerns(robot)
            and number in each.location.statements.get(robot, ())
        ]

    def _at_requests(self, run: RecordedRun, event: RunEvent) -> list[BreakpointHit]:
        hits = []
        for each in self._all.values():
            if each.location is None or not each.location.codes:
                continue
            for robot, code in event.posted:
                if code in each.location.codes and each.concerns(robot):
                    stack = run.stopped(robot).stack
                    if any(plain_name(frame.function) == each.location.function for frame in stack):
                        name = run.name(robot)
                        hits.append(
                            BreakpointHit(each, robot, f"{name} called '{each.location.function}'")
                        )
        return hits + self._at_ends(run, event.ended)

    def _at_ends(self, run: RecordedRun, ended: Sequence[int]) -> list[BreakpointHit]:
        return [
            BreakpointHit(each, robot, f"the program of {run.name(robot)} ended")
            for each in self._all.values()
            for robot in ended
            if each.kind == "catchpoint" and each.text == "exit" and each.concerns(robot)
        ]

    def _at_timestep(self, run: RecordedRun, event: RunEvent) -> list[BreakpointHit]:
        ends = self._at_ends(run, event.ended)
        wanted = [each for each in self._all.values() if each.kind == "catchpoint" and each.enabled]
        kinds = tuple(dict.fromkeys(each.text for each in wanted if each.text != "exit"))
        if not kinds or event.step is None:
            return ends
        happened = world_events(event.step, run.session.environment.world, kinds)
        return ends + [
            BreakpointHit(each, one.robot, one.text)
            for each in wanted
            for one in happened
            if is_of(one.kind, [each.text]) and each.robot in {None, one.robot}
        ]
