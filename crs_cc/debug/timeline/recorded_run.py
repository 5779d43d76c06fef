"""A run that can be moved to any position: forward by running, backward by replaying.

`advance` runs the session to the next event: a program has stopped before a requested statement, a
round has ended, a timestep has ended. Snapshots are kept on the way. `seek` moves to any position:
back to the latest snapshot before it and forward from there with only that position requested.

Where the user has changed something, only the snapshot made after the change leads on from
there; the history keeps it, and running through that position restores it.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, Final

import numpy as np

from crs_cc.debug.program import DebugProgram
from crs_cc.debug.timeline.armed_stops import ArmedStops
from crs_cc.debug.timeline.change import Change, MemoryPatch, write
from crs_cc.debug.timeline.console import CurrentConsole, ReplayConsole
from crs_cc.debug.timeline.history import History, RunSnapshot
from crs_cc.debug.timeline.input_log import InputLog
from crs_cc.debug.timeline.passed_sites import STRETCH, PassedSites
from crs_cc.debug.timeline.position import BEGINNING, Position
from crs_cc.debug.timeline.program_replay import ProgramReplay
from crs_cc.debug.timeline.run_event import PostedRequests, RunEvent, StopRequest
from crs_cc.debug.uploads import Uploads
from crs_cc.debug.world.event_history import EventHistory
from crs_cc.requests import FAILED
from crs_cc.runtime.diagnosis.inspect import StackFrame, StoppedProgram
from crs_cc.runtime.executable import Executable
from crs_cc.runtime.sites import StatementSite
from crs_cc.session.result import Added
from crs_cc.session.session import Session
from crs_cc.sim.engine.step import Step
from crs_cc.sim.model.world import WorldModel


class InterruptedRunError(Exception):
    """The user has interrupted the run."""


_STATEMENT: Final = RunEvent("statement")
_LIMIT: Final = RunEvent("limit")


class _LatestStep:
    """Receives the events of a timestep from the session."""

    received: Step | None = None

    def step(self, step: Step) -> None:
        self.received = step


class RecordedRun:
    """A run of programs in a world.

    Attributes:
        session: the session; only this class advances it.
        history: its snapshots.
        event_history: its events.
        input_log: the input of the programs in each round.
        passed_sites: the sites that programs have passed.
        programs: by robot, its program.
        uploads: programs that the user has brought.
        world_robots: how many robots the world has; others may have been added.
        last_timestep: at whose start the run ends, even if programs could continue.
        interrupted: set to make `advance` raise `InterruptedRunError`.
        is_off_timeline: whether the state is no state of the run: programs ran too far, or
            without the world. Then only `seek` or `restore` lead on.
    """

    def __init__(
        self,
        world: WorldModel,
        programs: Sequence[DebugProgram],
        seed: int,
        console: ReplayConsole,
        history: History,
        **options: Any,
    ) -> None:
        """Load the programs into the world.

        Args:
            world: the world.
            programs: one for each robot.
            seed: the random seed.
            console: their standard streams.
            history: stores the snapshots.
            options: further options of `Session`.
        """
        self.programs = list(programs)
        self.uploads = Uploads()
        self.world_robots = len(programs)
        self._streams = CurrentConsole(console)
        self.history = history
        self.event_history = EventHistory()
        self.input_log = InputLog()
        self.passed_sites = PassedSites()
        self.interrupted = False
        self.last_timestep = math.inf
        self._latest = _LatestStep()
        self._stopped: dict[int, StoppedProgram] = {}  # by robot, until the run moves
        self.is_off_timeline = False
        self.session = Session(
            world,
            [program.executable for program in programs],
            seed,
            output=self._streams.write,
            read=self._streams.read,
            waiting=self._streams.waiting,
            trace=self._latest,
            **options,
        )
        self._replay = ProgramReplay(self.session)
        self._stops = ArmedStops(self.session, len(programs))
        self.history.keep(BEGINNING, self._snapshot())
        self._scan_marks()

    @property
    def console(self) -> ReplayConsole:
        """The output and input of the programs."""
        return self._streams.console

    @property
    def position(self) -> Position:
        """The position of the run."""
        session = self.session
        if session.state.halted is None:
            return Position(session.timesteps, session.state.rounds)
        statements = int(session.fleet.slots["statements"][session.state.halted])
        return Position(session.timesteps, session.state.rounds, session.state.halted, statements)

    @property
    def can_advance(self) -> bool:
        """Whether programs are running or robots have yet to join."""
        session = self.session
        is_before_end = session.timesteps < self.last_timestep
        return is_before_end and (session.state.running > 0 or session.environment.expects_robots)

    def name(self, robot: int) -> str:
        """Return a robot's name."""
        return self.session.environment.world.robots[robot].id

    def time_s(self, robot: int = -1) -> float:
        """Return a program's clock [s], stopped at its end; the world's before it starts."""
        session = self.session
        if robot < 0:
            return session.time_s
        if not session.state.alive[robot]:
            return session.state.robot_result(robot).time_s
        now_s = session.now_s(robot)
        return now_s if math.isfinite(now_s) else session.time_s

    def sites_passed(self, robot: int) -> int:
        """Return the number of passed sites of a program: statements and returns from calls."""
        return int(self.session.fleet.slots["statements"][robot])

    # -- where programs stop -----------------------------------------------------------------

    def arm(self, marks: StopRequest) -> None:
        """Set where programs stop.

        Accesses to objects that stay watched are reported even if they were made before, but not
        if the run has moved since.
        """
        self._stopped.clear()  # a program may move to another build
        self._stops.arm(marks, self._sites())
        if not self._stops.has_marks:
            self.passed_sites.invalidate()

    def _sites(self) -> list[int]:
        """Return the number of sites of each program."""
        return [len(each.executable.detail().compiled.statements) for each in self.programs]

    def _scan_marks(self) -> None:
        """Scan the marks of all programs if a stretch ends at this timestep."""
        if self.session.timesteps % STRETCH == 0 and self._stops.has_marks:
            self.passed_sites.begin_stretch(
                self.session.timesteps, self.session.fleet, self._sites()
            )

    # -- continuing --------------------------------------------------------------------------

    def advance(self, limit: Position | None = None) -> RunEvent:
        """Advance to the next event.

        Args:
            limit: the position to stop at. If no program stops there, the run is off its timeline:
                `seek` must follow.

        Raises:
            InterruptedRunError: the user interrupts.
        """
        self._answer_interrupt()
        return self._advance(limit)

    def _advance(self, limit: Position | None) -> RunEvent:
        before = self.position
        self._streams.place = Position(before.timestep, before.round)
        self._stopped.clear()
        edit = self.history.next_edit(before)
        if not self.session.begin_round():
            event = self._end_cycle()
        else:
            if before.robot < 0:
                state = self.session.state
                self.input_log.record_round(
                    before, state.pending, state.clock_s, self.session.fleet
                )
                self._stops.begin_round()
            self.session.run_programs()
            if edit is not None and self._has_passed(edit):
                event = _STATEMENT
                if self.position == edit:
                    event = self._stops.with_accesses(event)
                self.restore(self.history.at(edit))
                return event
            if limit is not None and self._has_passed(limit) and self.position != limit:
                self.is_off_timeline = True
                return _LIMIT
            event = self._end_round() if self.session.state.halted is None else _STATEMENT
            event = self._stops.with_accesses(event)
        position = self.position
        self.history.farthest = max(self.history.farthest, position)
        self._note_passed(position, event)
        if edit == position:
            self.restore(self.history.at(position))
        elif position.round == 0 and position.robot < 0 and self.history.should_keep(position):
            self.history.keep(position, self._snapshot())
        return event

    def _note_passed(self, position: Position, event: RunEvent) -> None:
        """Record the sites that programs have passed, up to a position."""
        if event.ended:
            self.passed_sites.end_programs(event.ended)
        if position.robot >= 0:
            self.passed_sites.record_halt(self.session.fleet, position.robot)
        elif position.round == 0:
            self._scan_marks()

    def replay(
        self,
        begin: Position,
        limit: Position,
        *,
        needs_world: bool = False,
        robots: Iterable[int] | None = None,
    ) -> Iterator[RunEvent]:
        """Replay a part of the past up to a position.

        As far as the input of the programs is logged only they run, and the world stays where
        it is. The run is off its timeline after that: `seek` must follow.

        Args:
            begin: the start, at a snapshot.
            limit: the end; programs may run a little further.
            needs_world: whether the steps of the world are needed, too.
            robots: those whose programs matter; others run only where they must. None for all.

        Raises:
            InterruptedRunError: the user interrupts.
        """
        edit = self.history.next_edit(begin)
        is_plain = edit is None or edit >= limit
        if needs_world or not is_plain or not self.input_log.covers(begin, limit):
            self.restore(self.history.at(begin))
            while self.position < limit:
                ahead = self.advance(limit)
                if ahead.kind == "limit":
                    break
                yield ahead
            self.is_off_timeline = True
            return
        self.is_off_timeline = True
        self._restore_programs(begin, robots)
        while self.position < limit:
            self._answer_interrupt()
            event = self._replay_round(limit)
            if event is None:
                return
            yield event

    def replay_start(self, begin: Position, first: Position, limit: Position) -> Position:
        """Return the position of a snapshot from which a part of the past is replayed.

        Where the world has to run, too, the way to what matters is gone once, and not again.

        Args:
            begin: an earlier snapshot.
            first: before this position nothing matters.
            limit: the end of the part.
        """
        if first <= begin or self.input_log.covers(begin, limit):
            return begin
        self.seek(first)
        if self.position != first:
            return begin
        self.history.keep(first, self._snapshot())
        return first

    def _restore_programs(self, begin: Position, robots: Iterable[int] | None) -> None:
        """Restore only programs from a snapshot."""
        self._stopped.clear()
        self._replay.restore_programs(self.history.at(begin).session, robots)
        self._stops.update_slots()
        self._reset_watches()

    def _replay_round(self, limit: Position) -> RunEvent | None:
        """Replay one round of the programs, or a part of it; None at the limit."""
        session, place = self.session, self.position
        self._stopped.clear()
        round_ = self.input_log.round_at(place)
        if place.robot < 0:
            if place.round == self.input_log.rounds_in(place.timestep):
                session.state.timesteps, session.state.rounds = place.timestep + 1, 0
                return RunEvent("timestep", ended=self.input_log.ended_in(place.timestep))
            assert round_ is not None
            if not self._replay.begin(round_):
                session.state.rounds += 1
                return RunEvent("round")
            self._stops.begin_round()
        session.run_programs()
        if self._has_passed(limit) and self.position != limit:
            return None
        if session.state.halted is not None:
            return self._stops.with_accesses(_STATEMENT)
        session.state.rounds += 1
        assert round_ is not None
        return self._stops.with_accesses(self._replay.end(round_))

    def _answer_interrupt(self) -> None:
        if self.interrupted:
            self.interrupted = False
            raise InterruptedRunError

    def _has_passed(self, place: Position) -> bool:
        """Return whether a position inside the round that has just run is in the past."""
        session = self.session
        if (session.timesteps, session.state.rounds) != (place.timestep, place.round):
            return False
        if place.robot < 0:
            return False
        halted = session.state.halted
        return halted is None or (halted, self.sites_passed(halted)) >= (
            place.robot,
            place.statements,
        )

    def _end_round(self) -> RunEvent:
        session = self.session
        slots = session.fleet.slots
        ran = np.flatnonzero(session.state.pending)
        posted = PostedRequests(ran, slots["code"][ran])
        session.end_round()
        ended = ran[~session.state.alive[ran]]
        return RunEvent("round", posted, tuple(ended.tolist()))

    def _end_cycle(self) -> RunEvent:
        session, state = self.session, self.session.state
        timestep, rounds, alive = session.timesteps, state.rounds, state.alive.copy()
        can_advance = session.end_cycle()
        ended = tuple(np.flatnonzero(alive & ~state.alive).tolist())
        self.input_log.end(timestep, rounds, ended)
        step = self._latest.received
        assert step is not None
        self.event_history.record_step(step, session.environment)
        changes = self._stops.world_watch_hits(self.position)
        return RunEvent("timestep", (), ended, step, not can_advance, changes)

    # -- going anywhere ----------------------------------------------------------------------

    def seek(self, target: Position) -> None:
        """Move to a recorded position; cannot be interrupted."""
        position, snapshot = self.history.before(target)
        if self.is_off_timeline or not position <= self.position <= target:
            self.restore(snapshot)
        everywhere, since = frozenset[int](), {}
        if target.robot >= 0:
            everywhere, since = frozenset({target.robot}), {target.robot: target.statements}
        self.arm(StopRequest(everywhere=everywhere, since=since))
        while self.position < target and self.can_advance:
            self._advance(target)

    def restore(self, snapshot: RunSnapshot) -> None:
        """Restore a snapshot."""
        self.is_off_timeline = False
        self._stopped.clear()
        self.session.restore(snapshot.session)
        self._set_added_programs(snapshot.session.added)
        self.console.restore(snapshot.console)
        self._stops.update_slots()
        self._reset_watches()

    def switch_history(
        self, history: History, console: ReplayConsole, event_history: EventHistory
    ) -> None:
        """Switch to another history; `seek` must follow."""
        console.is_live = self.console.is_live
        self.history, self.event_history = history, event_history
        self._streams.console = console
        self.input_log, self.passed_sites = InputLog(), PassedSites()
        self.is_off_timeline = True

    def executables(self) -> list[Executable]:
        """Return the programs that robots can run, in their plain builds: first their own."""
        return [each.executable for each in (*self.programs, *self.uploads.programs.values())]

    def _set_added_programs(self, added: Sequence[Added]) -> None:
        """Set the programs of the robots that have been added."""
        programs, count = (*self.programs, *self.uploads.programs.values()), self.world_robots
        known = {id(each.executable): each for each in programs}
        self.programs[count:] = [known[id(each.executable)] for each in added]
        self._stops.set_added_programs(count, [each.executable for each in added])

    def revert(self, place: Position) -> None:
        """Go to a position as if nothing had been changed there or later; discard the future."""
        self.history.revert(place)
        self.is_off_timeline = True
        self.seek(place)
        self._discard_future()

    def _discard_future(self) -> None:
        self._reset_watches()
        self.console.truncate()
        self.event_history.truncate(self.position.timestep)
        self.input_log.truncate(self.position)
        self.passed_sites.truncate(self.position.timestep)

    def record_change(self, change: Change) -> None:
        """Record a change that the user has made here: discard the future of the history."""
        self.console.insert(change.robot, change.printed)
        snapshot = self._snapshot()
        self._set_added_programs(snapshot.session.added)
        self._discard_future()
        self.history.branch(change, snapshot)

    def patch(self, robot: int, patches: Sequence[MemoryPatch]) -> None:
        """Write bytes to a program's memory.

        Raises:
            ValueError: there is no such program or memory; nothing is written.
        """
        if not 0 <= robot < len(self.programs):
            raise ValueError("a change to the memory of a robot that does not exist")
        write(patches, self.stopped(robot).memory, self.stopped(robot).shadow)

    def _reset_watches(self) -> None:
        """Reset the watched values after the programs have been moved."""
        self.passed_sites.invalidate()
        self._stops.reset_watches()

    def _snapshot(self) -> RunSnapshot:
        return RunSnapshot(self.session.snapshot(), self.console.snapshot())

    # -- the position of a program -------------------------------------------------------------

    def stopped(self, robot: int) -> StoppedProgram:
        """Return a program's memory and stack; cached until it moves."""
        if robot not in self._stopped:
            fleet = self.session.fleet
            failed = fleet.failure(robot).stopped if self.has_failed(robot) else None
            self._stopped[robot] = fleet.stopped(robot) if failed is None else failed
        return self._stopped[robot]

    def site(self, robot: int) -> StatementSite | None:
        """Return the site at which a program has stopped, or None."""
        if self.session.state.halted != robot:
            return None
        number = int(self.session.fleet.slots["stopped"][robot]) - 1
        return self.programs[robot].executable.detail().compiled.statements[number]

    def innermost(self, robot: int) -> StackFrame | None:
        """Return the innermost frame of a program."""
        stack = self.stopped(robot).stack
        return stack[0] if stack else None

    def any_failed(self) -> bool:
        """Return whether any program was stopped by an error."""
        return bool((self.session.fleet.slots["status"] == FAILED).any())

    def is_over(self, robot: int) -> bool:
        """Return whether a program has started and ended."""
        session = self.session
        joined_s = session.environment.state.presence.joined_s[robot]
        return math.isfinite(joined_s) and not session.state.alive[robot]

    def has_failed(self, robot: int) -> bool:
        """Return whether a program was stopped by an error."""
        return bool(self.session.fleet.slots["status"][robot] == FAILED)
