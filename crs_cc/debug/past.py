"""Queries about the recorded past: the run is replayed and then restored to its position.

Nothing is shown of the output of the programs, and breakpoints do not count. Only the programs run
again where that is enough, see `timeline.input_log`.
"""

from __future__ import annotations

import contextlib
import math
from bisect import bisect_right
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Final

from crs_cc.core.source import Location
from crs_cc.debug.breakpoints import Breakpoint
from crs_cc.debug.data.observation import UNREADABLE as UNREADABLE_NOW
from crs_cc.debug.data.observation import Content
from crs_cc.debug.data.values import Value
from crs_cc.debug.errors import DebugError
from crs_cc.debug.locations import BreakpointLocation
from crs_cc.debug.run_values import mentions_world
from crs_cc.debug.stop_points import StopPoints
from crs_cc.debug.timeline.position import BEGINNING, Position
from crs_cc.debug.timeline.recorded_run import InterruptedRunError, RecordedRun
from crs_cc.debug.timeline.run_event import RunEvent, StopRequest
from crs_cc.debug.view import View
from crs_cc.debug.watch import MemoryAccess, Watched, WatchedExpression, WatchedWorld
from crs_cc.debug.watchpoints import UNREADABLE, content_value
from crs_cc.debug.world.events import WorldEvent, is_of
from crs_cc.ir.instruction import plain_states

_STOPS: Final = frozenset({"stop", "error"})
"""Events of timelines that are not of the world."""
_SLACK: Final = 1e-9  # of a timestep
_PIECE: Final = 400
"""So many timesteps are replayed at once, about: for each it is decided whether the world must."""
MAX_INSTANTS: Final = 100_000
"""More answers to one question are refused; chosen by us, some tens of megabytes."""


@dataclass(frozen=True, slots=True)
class Instant:
    """A position in the past, with its description.

    Attributes:
        position: where to go to see it: before the statement that did it, if there is one.
        time_s: the clock of the robot's program then, or that of the world [s].
        text: the value, or the message.
        number: the value, if it is a number.
        location: the location of the statement; None if there is none.
        robot: the robot in whose program it is; -1 for none.
        function: the function of the statement, by the linker's name; empty if unknown.
    """

    position: Position
    time_s: float
    text: str
    number: float | None = None
    location: Location | None = None
    robot: int = -1
    function: str = ""


@dataclass(frozen=True, slots=True)
class Range:
    """A part of the recorded past, from the start of a timestep to a position."""

    begin: Position
    end: Position


class Past:
    """The recorded past of a run."""

    def __init__(self, view: View, stop_points: StopPoints) -> None:
        self._view = view
        self._run: RecordedRun = view.run
        self._stop_points = stop_points

    def whole(self) -> Range:
        """Return all that has been recorded, also after the current position."""
        return Range(BEGINNING, self._run.history.farthest)

    def part(self, from_s: float | None, to_s: float | None) -> Range:
        """Return the recorded past between two times [s]; None for its start or its end.

        Raises:
            DebugError: it ends before it begins.
        """
        whole, timestep_s = self.whole(), self._view.session.environment.timestep_s
        first_s = from_s or 0.0
        if to_s is not None and to_s < first_s:
            raise DebugError(f"the range {first_s:g}..{to_s:g} ends before it starts")
        begin = Position(math.floor(first_s / timestep_s + _SLACK), 0)
        end = whole.end if to_s is None else Position(math.ceil(to_s / timestep_s - _SLACK), 0)
        return Range(min(begin, whole.end), min(end, whole.end))

    def values(self, expression: str, part: Range) -> list[Instant]:
        """Return the values of an expression: the first one, and each change.

        Raises:
            DebugError: it cannot be watched, or changes too often.
        """
        found = self._changes(expression, part, lambda _: True)
        return found[1:] if len(found) > 1 and found[0].text == UNREADABLE else found

    def times(self, condition: str, part: Range) -> list[Instant]:
        """Return when a condition became true, or was true at the start.

        Raises:
            DebugError: it cannot be watched.
        """
        return self._changes(f"!!({condition})", part, lambda value: bool(value and value.number))

    def messages(self, place: BreakpointLocation, text: str, part: Range) -> list[Instant]:
        """Return the messages that a log point would have printed.

        Args:
            place: where it is.
            text: its message, with expressions in braces.
            part: when.
        """
        run, found = self._run, list[Instant]()
        with self._excursion(part):
            for robot in self._visits(place, part, text):
                if site := run.site(robot):
                    said = self._stop_points.log_message(text, robot)
                    at = run.position, run.time_s(robot)
                    _keep(found, Instant(*at, said, None, site.location, robot))
        return found

    def values_at(self, place: BreakpointLocation, expression: str, part: Range) -> list[Instant]:
        """Return the values of an expression whenever a program was at a place.

        Args:
            place: where it is evaluated.
            expression: the expression, in the scope of the function there.
            part: when.
        """
        run, found = self._run, list[Instant]()
        with self._excursion(part):
            for robot in self._visits(place, part, expression):
                text, number = self._value_here(expression, robot)
                site = run.site(robot)
                location = None if site is None else site.location
                at = run.position, run.time_s(robot)
                _keep(found, Instant(*at, text, number, location, robot))
        return found

    def hits(self, wanted: Breakpoint, part: Range) -> list[Instant]:
        """Return when a breakpoint was hit, or would have been; ignored hits count.

        Raises:
            DebugError: it is a function of the robot, or its condition is invalid.
        """
        match wanted.kind:
            case "watchpoint":
                return self.values(wanted.text, part)[1:]
            case "catchpoint":
                robots = (-1, wanted.robot)
                found = self.events(wanted.text, part)
                return [each for each, _ in found if wanted.robot is None or each.robot in robots]
        place, run, instants = wanted.location, self._run, list[Instant]()
        if place is None or place.codes:
            raise DebugError(f"the hits of '{wanted.text}' cannot be listed: it is not at a line")
        with self._excursion(part):
            for robot in self._visits(place, part, wanted.condition):
                site = run.site(robot)
                if wanted.robot not in {None, robot} or not self._holds(wanted.condition, robot):
                    continue
                location = None if site is None else site.location
                at = run.position, run.time_s(robot)
                _keep(instants, Instant(*at, wanted.text, None, location, robot))
        return instants

    def _holds(self, condition: str, robot: int) -> bool:
        return not condition or self._view.evaluator(robot).holds(condition, None)

    def _visits(self, place: BreakpointLocation, part: Range, asked: str) -> Iterator[int]:
        """Replay a part; yield the robot whenever its program is at a place.

        Args:
            place: the place.
            part: the part.
            asked: the expressions that are evaluated there.
        """
        marks, names = StopRequest(place.statements), self._view.session.environment.names
        uses_world = mentions_world(asked, names)
        events = self._events(marks, part.end) if uses_world else self._replayed(marks, part)
        for event in events:
            robot = self._run.session.state.halted
            if event.kind == "statement" and robot is not None:
                yield robot

    def _value_here(self, expression: str, robot: int) -> tuple[str, float | None]:
        """Return the value of an expression where the run is, as text and as a number."""
        try:
            frame = self._view.first_own_frame(robot)
            value = self._view.evaluate_pure(expression, robot=robot, frame=frame)
        except DebugError as error:
            return f"<{error}>", None
        return value.text, value.number

    def printed(self, line: int) -> tuple[int, int]:
        """Return the robot that printed a line, and the number of the statement that did, from 1.

        Args:
            line: the number of the line in the output of all robots, from 1.

        Raises:
            DebugError: no such line has been printed.
        """
        run, end = self._run, self.whole().end
        try:
            robot, piece = run.console.origin(line)
        except IndexError:
            raise DebugError(f"no line {line} has been printed") from None
        places = run.history.snapshots_before(end)
        before = bisect_right(places, piece, key=lambda each: run.history.at(each).console.written)
        with self._excursion(Range(places[max(0, before - 1)], end)):
            for _ in self._events(StopRequest(), end):
                if run.console.piece_count > piece:
                    return robot, run.sites_passed(robot)
        raise DebugError(f"no line {line} has been printed")

    def events(self, kind: str, part: Range) -> list[tuple[Instant, WorldEvent]]:
        """Return the events of the world of a kind, or of all kinds, where they would be caught."""
        found = []
        for timestep, each in self._run.event_history.by_timestep():
            position = Position(timestep + 1, 0)
            is_wanted = each.kind not in _STOPS if not kind else is_of(each.kind, [kind])
            if is_wanted and part.begin < position <= part.end:
                found.append((Instant(position, each.time_s, each.text, robot=each.robot), each))
        return found

    def _changes(
        self, expression: str, part: Range, wanted: Callable[[Value | None], bool]
    ) -> list[Instant]:
        """Return the first value of an expression, and the requested number of its changes."""
        robot, point = self._stop_points.resolve(0, expression, self._view.robot)
        watched, run, found = point.watched, self._run, list[Instant]()
        last: Content | None = None
        is_world = isinstance(watched, WatchedWorld)

        def note(content: Content, position: Position, access: MemoryAccess | None = None) -> None:
            nonlocal last
            value = content_value(self._view.evaluator(robot).inspector(), point, content)
            if content != last and wanted(value):
                text, number = (value.text, value.number) if value else (UNREADABLE, None)
                time_s = run.time_s(-1 if is_world else robot)
                at = (None, "") if access is None else (access.location, access.function)
                _keep(found, Instant(position, time_s, text, number, at[0], robot, at[1]))
            last = content

        with self._excursion(part):
            note(self._content(robot, watched), run.position)
            marks = StopRequest(watched={} if is_world else {robot: [watched]})
            marks = replace(marks, world=[watched]) if isinstance(watched, WatchedWorld) else marks
            edits = {each.position for each in run.history.changes}
            for event in self._events(marks, part.end) if is_world else self._replayed(marks, part):
                for hit in event.accesses:
                    if hit.access.what != "return":
                        note(hit.access.new, hit.before, hit.access)
                if run.position in edits:
                    note(self._content(robot, watched), run.position)
        return found

    def _content(self, robot: int, watched: Watched) -> Content:
        """Return the watched value at the current position."""
        match watched:
            case WatchedWorld():
                return watched.observe()
            case WatchedExpression():
                return (watched.observe() or UNREADABLE_NOW).content
        stopped = self._run.stopped(robot)
        part = slice(watched.address, watched.address + watched.size)
        return stopped.memory[part].tobytes(), plain_states(stopped.shadow[part].tobytes())

    @contextlib.contextmanager
    def _excursion(self, part: Range) -> Iterator[None]:
        """Move the run to the start of a part of the past, and back after the block."""
        here = self._run.position
        self._run.seek(part.begin)
        try:
            yield
        except InterruptedRunError:
            raise DebugError("interrupted") from None
        finally:
            self._run.seek(here)

    def _events(self, marks: StopRequest, end: Position) -> Iterator[RunEvent]:
        """Replay the programs and the world up to a position."""
        run = self._run
        run.arm(marks)
        while run.position < end and run.can_advance:
            event = run.advance(end)
            if event.kind == "limit":
                return
            yield event

    def _replayed(self, marks: StopRequest, part: Range) -> Iterator[RunEvent]:
        """Replay the programs in a part of the past, and the world only where it must be.

        There is an event at each change of the user's.
        """
        run, edits = self._run, {each.position for each in self._run.history.changes}
        for begin, end in self._pieces(part, edits):
            if begin in edits:
                run.seek(begin)
                yield RunEvent("edit")
            run.arm(marks)
            for event in run.replay(begin, end):
                if run.position > part.begin:
                    yield event
        if part.end in edits:
            run.seek(part.end)
            yield RunEvent("edit")

    def _pieces(self, part: Range, edits: set[Position]) -> Iterator[tuple[Position, Position]]:
        """Return pieces that cover a part of the past, each between two snapshots or at its end."""
        places = self._run.history.snapshots_before(part.end)
        begin = places[max(0, bisect_right(places, part.begin) - 1)] if places else BEGINNING
        for place in places[bisect_right(places, begin) :]:
            if place in edits or place.timestep - begin.timestep >= _PIECE:
                yield begin, place
                begin = place
        yield begin, part.end


def _keep(found: list[Instant], one: Instant) -> None:
    """Append an instant; raise DebugError if there are too many."""
    if len(found) >= MAX_INSTANTS:
        raise DebugError(f"more than {MAX_INSTANTS:,} instants: give a shorter range")
    found.append(one)
