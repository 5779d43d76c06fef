"""Navigation of a run, forward and backward, to the next stop.

Forward, events are examined one after the other. Backward, the same is done from an earlier
snapshot, and the last reason to stop before the current position is the one. So both directions
stop at the same positions.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Final

from crs_cc.debug.breakpoints import BreakpointHit
from crs_cc.debug.searched_parts import SearchedPart, SearchedParts
from crs_cc.debug.skips import Skips
from crs_cc.debug.step_conditions import (
    ActiveCalls,
    ProgramPoint,
    ReverseStepCondition,
    StepCondition,
)
from crs_cc.debug.stop import Reason, Stop
from crs_cc.debug.stop_points import StopPoints
from crs_cc.debug.timeline.position import BEGINNING, Position
from crs_cc.debug.timeline.recorded_run import InterruptedRunError, RecordedRun
from crs_cc.debug.timeline.run_event import RunEvent, StopRequest
from crs_cc.ir.names import in_library
from crs_cc.runtime.diagnosis.inspect import StackFrame

_MAX_TOLD: Final = 5
_FIRST_WINDOW: Final = 8
_WIDER: Final = 16


@dataclass(frozen=True, slots=True)
class _StopCandidate:
    """A reason to stop in the past.

    Attributes:
        target: the position to move to: for an access, before it, maybe before the whole round.
        function: the function that it is about, see `Stop`.
    """

    stop: Stop
    target: Position
    function: str = ""

    def may_count_with(self, later: _StopCandidate) -> bool:
        """Return whether this may be skipped for a later candidate in the same round.

        Of repeated hits of one program the last is enough: there may be very many.
        """
        mine, its = self.stop, later.stop
        if (mine.robot, mine.breakpoints) == (its.robot, its.breakpoints):
            return False
        return self.target >= Position(later.target.timestep, later.target.round)


class Navigator:
    """Moves a run to its next or previous stop.

    Attributes:
        skips: the functions and files that steps by lines do not enter.
    """

    def __init__(self, run: RecordedRun, stop_points: StopPoints) -> None:
        """Store the run and its breakpoints."""
        self._run = run
        self._breakpoints = stop_points.breakpoints
        self._accept = stop_points.accepts
        self._describe_hit = stop_points.describe_hit
        self._set_tests = stop_points.set_tests
        self.skips = Skips()
        self._active: ActiveCalls | None = None  # at the start of a step that skips something

    # -- forward -----------------------------------------------------------------------------

    def forward(self, aim: StepCondition | None = None, until: Position | None = None) -> Stop:
        """Run forward to the first reason to stop.

        Args:
            aim: the condition of a step command; None to continue.
            until: the start of a timestep to stop at.
        """
        run = self._run
        self._begin(aim)
        self._arm(self._marks(aim))
        try:
            while run.can_advance:
                stop = self._reason(run.advance(), aim)
                if stop is None and until is not None and run.position >= until:
                    stop = self.stop("tick")
                if stop is not None:
                    return stop
        except InterruptedRunError:
            return self.stop("interrupt")
        is_cut = run.session.timesteps >= run.last_timestep
        return self.stop("end", text=f"the run ends at {run.session.time_s:g} s" * is_cut)

    def _begin(self, aim: StepCondition | ReverseStepCondition | None) -> None:
        """Record in which calls a step begins, if it is to skip others."""
        self._active = None
        if aim is not None and aim.by_lines and any(each.enabled for each in self.skips):
            self._active = ActiveCalls.of(self._run.stopped(aim.robot).stack)

    def _is_skipped(self, robot: int) -> bool:
        """Return whether a program is inside of a call that the current step skips."""
        if self._active is None:
            return False
        return self.skips.cover(self._run.stopped(robot).stack, self._active)

    def stop(self, reason: Reason, robot: int = -1, text: str = "") -> Stop:
        """Return a stop at the current position."""
        session = self._run.session
        robot = robot if robot >= 0 or session.state.halted is None else session.state.halted
        time_s = self._run.time_s(robot)
        return Stop(reason, self._run.position, time_s, robot, (), text)

    def _arm(self, request: StopRequest) -> None:
        """Set where programs stop, and where they test a condition first."""
        self._run.arm(request)
        for robot, conditions in request.tests.items():
            self._set_tests(robot, conditions)

    def _marks(self, aim: StepCondition | None) -> StopRequest:
        robots = range(len(self._run.programs))
        statements = {robot: self._breakpoints.statements(robot) for robot in robots}
        tests = {robot: self._breakpoints.conditions(robot) for robot in robots}
        watched = {robot: self._breakpoints.watched(robot) for robot in robots}
        marks = StopRequest(
            statements,
            watched={key: some for key, some in watched.items() if some},
            world=self._breakpoints.watched_world(),
            tests=tests,
        )
        if aim is None:
            return marks
        if aim.calls is None:
            return replace(marks, all=frozenset({aim.robot}))
        functions, own = aim.calls.functions, tests[aim.robot]
        inside = frozenset(self._inside(aim.robot, functions, after_calls=aim.after_calls))
        statements[aim.robot] |= inside
        tests[aim.robot] = {key: some for key, some in own.items() if key not in inside}
        return marks

    def _inside(self, robot: int, functions: frozenset[str], *, after_calls: bool) -> Iterator[int]:
        """Return the numbers of the statements in some functions, and of returns from calls."""
        sites = self._run.programs[robot].executable.detail().compiled.statements
        return (
            number
            for number, site in enumerate(sites)
            if site.function in functions and site.after_call <= after_calls
        )

    def _reason(self, event: RunEvent, aim: StepCondition | None) -> Stop | None:
        """Return the reason to stop at an event; None if there is none."""
        hits = [
            *self._breakpoints.breakpoint_hits(self._run, event),
            *self._breakpoints.watchpoint_hits(event),
        ]
        stop = _merge_stops(self._failure(event), self._hit(hits, counts=True))
        if stop is not None:
            return stop
        if event.kind == "statement" and aim is not None:
            program_point = self.program_point(aim.robot)
            if program_point is None or self._is_skipped(aim.robot):
                return None
            if aim.reached(program_point):
                return self.stop("step", aim.robot)
        if event.over:
            return self.stop("end")
        if aim is not None and aim.robot in event.ended and self._run.session.state.running:
            return self.stop("exit", aim.robot)
        return None

    def _failure(self, event: RunEvent) -> Stop | None:
        run = self._run
        failed = [robot for robot in event.ended if run.has_failed(robot)]
        if not failed:
            return None
        texts = [run.session.fleet.report(robot).text for robot in failed]
        if len(failed) > 1:
            pairs = zip(failed, texts, strict=True)
            texts = [f"{run.name(robot)}: {text}" for robot, text in pairs]
        return self.stop("error", failed[0], "; ".join(texts))

    def _hit(self, met: list[BreakpointHit], *, counts: bool) -> Stop | None:
        """Return the stop for the accepted ones of some hits; None if there are none."""
        hits: list[BreakpointHit] = []
        texts: list[str] = []
        for hit in met:
            stops, text = self._accept(hit, counts)
            if stops:
                hits.append(hit)
                shown = self._describe_hit(hit) if hit.watch_hit else hit.text
                texts.extend(each for each in (shown, text) if each)
        if not hits:
            return None
        first = hits[0]
        stop = self.stop(first.breakpoint.kind, first.robot, _join_texts(texts))
        numbers = dict.fromkeys(each.breakpoint.number for each in hits)
        return replace(stop, breakpoints=tuple(numbers))

    def program_point(self, robot: int) -> ProgramPoint | None:
        """Return the point of a program that has stopped at a site, else None."""
        run = self._run
        site = run.site(robot)
        if site is None:
            return None
        frame = run.innermost(robot)
        assert frame is not None
        number = int(run.session.fleet.slots["stopped"][robot]) - 1
        place = (frame.function, frame.fp, frame.entered, number, site.location)
        return ProgramPoint(*place, run.sites_passed(robot))

    def calls(self, robot: int, callee: StackFrame | None = None) -> ActiveCalls:
        """Return a program's active calls of the user's functions.

        Args:
            robot: the robot that runs the program.
            callee: a frame to exclude, with those inside it.
        """
        stack = self._run.stopped(robot).stack
        lowest_fp = -1 if callee is None else callee.fp
        return ActiveCalls.of(
            each for each in stack if each.fp > lowest_fp and not in_library(each.location)
        )

    # -- backward ----------------------------------------------------------------------------

    def backward(self) -> Stop:
        """Run backward to the previous reason to stop, or to the start."""
        run, start = self._run, self._run.position
        if not any(each.enabled for each in self._breakpoints) and not run.any_failed():
            run.seek(BEGINNING)
            return self.stop("beginning")
        try:
            for part in SearchedParts(run, self._breakpoints).back_from(start):
                found = self._last(part, start)
                if found is not None:
                    return self._move_to(found)
        except InterruptedRunError:
            run.seek(start)
            return self.stop("interrupt")
        run.seek(BEGINNING)
        return self.stop("beginning")

    def _last(self, part: SearchedPart, start: Position) -> _StopCandidate | None:
        """Return the last reason to stop in a part of the past, but before `start`.

        Others may be passed on the way to it, of robots that ran before it in the same round: they
        are reported with it.

        Args:
            part: the part.
            start: where the search began.
        """
        run, found = self._run, list[_StopCandidate]()
        begin, limit = run.replay_start(part.begin, part.first, part.limit), part.limit
        self._arm(replace(self._marks(None), at_once=True))
        needs_world = self._breakpoints.need_world(run.session.environment.names)
        for event in run.replay(begin, limit, needs_world=needs_world, robots=part.robots):
            for each in (self._breakpoint_candidate(event), *self._watch_candidates(event)):
                if each is not None and each.target < start:
                    found = [*(one for one in found if one.may_count_with(each)), each]
        return _merge_candidates(found) if found else None

    def _breakpoint_candidate(self, event: RunEvent) -> _StopCandidate | None:
        hit = self._hit(self._breakpoints.breakpoint_hits(self._run, event), counts=False)
        stop = _merge_stops(self._failure(event), hit)
        return None if stop is None else _StopCandidate(stop, stop.position)

    def _watch_candidates(self, event: RunEvent) -> Iterator[_StopCandidate]:
        """Return the candidates of watchpoints."""
        hits = self._breakpoints.watchpoint_hits(event)
        for before in sorted({each.watch_hit.before for each in hits if each.watch_hit}):
            own = [each for each in hits if each.watch_hit and each.watch_hit.before == before]
            stop = self._hit(own, counts=False)
            touch = own[0].watch_hit
            if stop is not None and touch is not None:
                yield _StopCandidate(stop, before, touch.access.function)

    def _move_to(self, found: _StopCandidate) -> Stop:
        """Move to a candidate and return its stop."""
        run = self._run
        run.seek(found.target)
        here = replace(found.stop, position=run.position, time_s=run.time_s(found.stop.robot))
        return replace(here, function=found.function)

    def backward_to(self, aim: ReverseStepCondition) -> Stop:
        """Step backward in one program until a condition is met."""
        run, start = self._run, self._run.position
        self._begin(aim)
        try:
            found = self._find_back(aim)
            if found is not None:
                self.goto_statement(aim.robot, found.statements)
                return self.stop("step", aim.robot)
        except InterruptedRunError:
            run.seek(start)
            return self.stop("interrupt")
        run.seek(BEGINNING)
        return self.stop("beginning")

    def _find_back(self, aim: ReverseStepCondition) -> ProgramPoint | None:
        best: ProgramPoint | None = None
        functions = None if aim.calls is None else aim.calls.functions
        for program_point in self._program_points_back(aim.robot, functions, aim.after_calls):
            if not aim.belongs(program_point):
                continue
            if not aim.can_advance(program_point):
                return best
            best = program_point
        return best

    def _program_points_back(
        self, robot: int, functions: frozenset[str] | None, after_calls: bool
    ) -> Iterator[ProgramPoint]:
        """Return the points of a program before the current position, the last one first.

        The run has moved after each of them.

        Args:
            robot: the robot that runs the program.
            functions: the functions that count; None for all.
            after_calls: whether returns from calls in these functions count, too.
        """
        run = self._run
        end, width = run.sites_passed(robot), _FIRST_WINDOW
        limit = run.position
        while end > 0:
            first = max(0, end - width)
            if functions is None:
                request = StopRequest(all=frozenset({robot}), since={robot: first})
            else:
                inside = self._inside(robot, functions, after_calls=after_calls)
                request = StopRequest({robot: inside}, since={robot: first})
            spots = self._window(robot, request, end, limit)
            yield from reversed(spots)
            end, width = first, width * _WIDER

    def _window(
        self, robot: int, request: StopRequest, end: int, limit: Position
    ) -> list[ProgramPoint]:
        """Return the requested points of a program at which fewer than `end` sites were passed."""
        run, spots = self._run, []
        run.arm(request)
        begin = self._snapshot(robot, request.since[robot], limit)
        for event in run.replay(begin, limit, robots=[robot]):
            if run.sites_passed(robot) >= end:
                break
            program_point = self.program_point(robot) if event.kind == "statement" else None
            if program_point is not None and not self._is_skipped(robot):
                spots.append(program_point)
        return spots

    def _snapshot(self, robot: int, statements: int, before: Position) -> Position:
        """Return the latest snapshot with at most this number of sites passed."""
        run = self._run
        places = run.history.snapshots_before(before) or [BEGINNING]

        def begun(place: Position) -> int:
            return int(run.history.at(place).session.programs[robot].slot["statements"][0])

        return places[max(0, bisect_right(places, statements, key=begun) - 1)]

    def goto_timestep(self, timestep: int) -> Stop:
        """Run forward to the start of a timestep, or to the end of the run."""
        run = self._run
        run.arm(StopRequest())
        try:
            while run.position.timestep < timestep and run.can_advance:
                run.advance()
        except InterruptedRunError:
            return self.stop("interrupt")
        return self.stop("goto" if run.position.timestep == timestep else "end")

    def goto_statement(self, robot: int, statements: int) -> bool:
        """Go to a site of a program, by the number of sites passed before.

        Return False if the program ends before.

        Raises:
            InterruptedRunError: the user interrupts; the run is somewhere on the way.
        """
        run = self._run

        def is_there() -> bool:
            return run.session.state.halted == robot and run.sites_passed(robot) == statements

        if run.is_off_timeline or (run.sites_passed(robot) >= statements and not is_there()):
            run.history.visit(run.position)
            run.restore(run.history.at(self._snapshot(robot, statements, run.position)))
        if is_there():  # the user has changed something there, so there is a snapshot
            return True
        run.arm(StopRequest(everywhere=frozenset({robot}), since={robot: statements}))
        while run.can_advance and not run.is_over(robot):
            if run.advance().kind == "statement" and run.sites_passed(robot) == statements:
                return True
        return False


def _merge_candidates(found: list[_StopCandidate]) -> _StopCandidate:
    """Merge the last reason to stop with those before it."""
    stops = [each.stop for each in found if each.target >= found[-1].target]
    numbers = dict.fromkeys(number for each in stops for number in each.breakpoints)
    text = "; ".join(each.text for each in stops if each.text)
    return replace(found[-1], stop=replace(stops[-1], breakpoints=tuple(numbers), text=text))


def _join_texts(texts: list[str]) -> str:
    """Join simultaneous events into one line, of many only the first."""
    more = [f"and {len(texts) - _MAX_TOLD} more"] if len(texts) > _MAX_TOLD else []
    return "; ".join(texts[:_MAX_TOLD] + more)


def _merge_stops(failure: Stop | None, hit: Stop | None) -> Stop | None:
    """Merge the stop of an error with that of breakpoints hit at the same time."""
    if failure is None or hit is None:
        return failure or hit
    text = "; ".join(each for each in (failure.text, hit.text) if each)
    return replace(failure, breakpoints=hit.breakpoints, text=text)
