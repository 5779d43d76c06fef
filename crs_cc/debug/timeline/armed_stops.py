"""The stop marks and watched memory of a run's programs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from crs_cc.debug.timeline.position import Position
from crs_cc.debug.timeline.run_event import RunEvent, StopRequest, WatchHit
from crs_cc.debug.watch import WatchSet
from crs_cc.debug.world_watch import WorldWatchSet
from crs_cc.runtime.executable import Executable
from crs_cc.runtime.site_tests import STOP, UNPASSED
from crs_cc.session.build import build_watching
from crs_cc.session.session import Session


class ArmedStops:
    """The stops of programs, and the accesses to watched memory.

    Attributes:
        request: what was asked for last.
    """

    def __init__(self, session: Session, robots: int) -> None:
        """Set no stops for a number of robots."""
        self._session = session
        self.request = StopRequest()
        self._armed: set[int] = set()  # robots whose programs may have marks or watched objects
        self._watching_builds: dict[int, Executable] = {}
        fleet = session.fleet
        self._watches = [WatchSet(fleet, robot) for robot in range(robots)]
        self._world_watches = WorldWatchSet()
        self._begun = fleet.slots["statements"].copy()  # by robot, at the start of the round

    @property
    def has_marks(self) -> bool:
        """Return whether marks alone decide where programs stop, so no program is stepping."""
        return not (self.request.all or self.request.everywhere)

    def arm(self, request: StopRequest, sites: Sequence[int]) -> None:
        """Set where programs stop.

        Args:
            request: where.
            sites: by robot, how many sites its program has.
        """
        self.request = request
        before, self._armed = self._armed, {*request.watched, *request.statements}
        for robot in sorted(before | self._armed):
            if robot >= len(sites):  # it was added, and may be so again
                self._armed.add(robot)
                continue
            self._watches[robot].arm(request.watched.get(robot, ()), self._watching)
            own = self._session.fleet.marks[robot]
            own[: sites[robot]] &= UNPASSED
            own[list(request.statements.get(robot, ()))] |= STOP
        self.update_slots()
        self._world_watches.arm(request.world)

    def update_slots(self) -> None:
        """Set the stop conditions in the programs' slots that their marks do not contain."""
        self.request.write_to(self._session.fleet.slots)

    def set_added_programs(self, first: int, executables: Sequence[Executable]) -> None:
        """Set the programs of the added robots, which are numbered from `first` on."""
        for robot, executable in enumerate(executables, first):
            if robot == len(self._watches) or not self._watches[robot].is_of(executable):
                self._watches[robot:] = [WatchSet(self._session.fleet, robot)]
        del self._watches[first + len(executables) :]

    def begin_round(self) -> None:
        """Record the start of a round."""
        self._begun = self._session.fleet.slots["statements"].copy()

    def reset_watches(self) -> None:
        """Take the current watched values as a reference: the programs did not change them."""
        self.begin_round()
        for watches in self._watches:
            watches.reset()
        self._world_watches.reset()

    def world_watch_hits(self, position: Position) -> tuple[WatchHit, ...]:
        """Return the changes of watched expressions that use the world."""
        return self._world_watches.drain(position)

    def with_accesses(self, event: RunEvent) -> RunEvent:
        """Add the accesses to watched objects to an event, as far as they are to be reported."""
        found = tuple(self._accesses(event))
        return replace(event, accesses=found) if found else event

    def _accesses(self, event: RunEvent) -> Iterator[WatchHit]:
        halted = self._session.state.halted
        for robot in self.request.watched:
            if self.request.at_once or robot == halted or robot in event.ended:
                for access in self._watches[robot].drain():
                    yield WatchHit(robot, access, self._last_before(event, robot))

    def _last_before(self, event: RunEvent, robot: int) -> Position:
        """Return the position before the statement that made an access in this round."""
        session = self._session
        round_ = session.state.rounds - (event.kind == "round")
        statement = int(session.fleet.watched[robot]["statement"][0])  # maybe one of the future
        begun = int(session.fleet.slots["statements"][robot])
        if not self._begun[robot] <= statement < begun:
            return Position(session.timesteps, round_)
        return Position(session.timesteps, round_, robot, statement)

    def _watching(self, executable: Executable) -> Executable:
        """Return the watching build of a program."""
        number = id(executable)
        if number not in self._watching_builds:
            self._watching_builds[number] = build_watching(executable)
        return self._watching_builds[number]
