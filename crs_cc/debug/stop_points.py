"""Breakpoints, watchpoints and catchpoints of a run, with their conditions."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from typing import Any

from crs_cc.core.source import Location
from crs_cc.core.suggest import unknown
from crs_cc.debug.breakpoints import Breakpoint, BreakpointHit, BreakpointKind, Breakpoints
from crs_cc.debug.condition_tests import ConditionTests
from crs_cc.debug.data.evaluate import Evaluator
from crs_cc.debug.data.expression_compiler import NOWHERE
from crs_cc.debug.data.notation import RobotName, slice_in
from crs_cc.debug.data.scope import is_own
from crs_cc.debug.errors import DebugError
from crs_cc.debug.locations import BreakpointLocation, find_location
from crs_cc.debug.log_message import expressions_in, message
from crs_cc.debug.view import View
from crs_cc.debug.watch import KINDS, MAX, AccessKind, WatchedWorld
from crs_cc.debug.watchpoints import (
    Watchpoint,
    change_text,
    same_activation,
    watched_expression,
    watched_object,
    watched_world,
)
from crs_cc.debug.world.events import check_event_kind
from crs_cc.runtime.diagnosis.inspect import StackFrame
from crs_cc.runtime.sites import StatementSite


class StopPoints:
    """The breakpoints, watchpoints and catchpoints of a run.

    Attributes:
        breakpoints: all breakpoints, watchpoints and catchpoints.
        print_log: receives the messages of log points.
        set_tests: has programs test conditions themselves.
    """

    def __init__(self, view: View) -> None:
        self._view = view
        self._run = view.run
        self.breakpoints = Breakpoints()
        self.print_log: Callable[[str], None] = _discard_message
        self.set_tests = ConditionTests(view).set

    def add_breakpoint(self, place: str, *, internal: bool = False, **options: Any) -> Breakpoint:
        """Add a breakpoint.

        Args:
            place: see `locations.find_location`.
            internal: whether it belongs to a command, not to the user.
            options: further attributes of the `Breakpoint`: `condition`, `ignore`, `temporary`,
                `robot`, `log`.

        Raises:
            DebugError: there is no such location, or the condition is invalid there.
        """
        found = self.location(place, options.get("robot"))
        return self._add("breakpoint", place, found, options, internal=internal)

    def location(self, place: str, robot: int | None = None) -> BreakpointLocation:
        """Return a location in the program of a robot, or of all; raise DebugError for none."""
        here = self._view.current_file(robot)
        robots = range(len(self._run.programs)) if robot is None else [robot]
        return find_location(place, self._run.programs, robots, here)

    def add_joined_robots(self) -> None:
        """Resolve the breakpoints of all robots in the programs of robots that have joined."""
        robots = range(len(self._run.programs))
        for each in self.breakpoints:
            if each.location is None or each.robot is not None:
                continue
            where = each.location.location
            text = f"{where.file}:{where.line}" if where and each.text.isdecimal() else each.text
            with contextlib.suppress(DebugError):
                place = find_location(text, self._run.programs, robots, "")
                self._check(each.condition, place)
                known = {**each.location.statements, **place.statements}
                each.location = replace(each.location, statements=known)

    def add_catchpoint(self, what: str, **options: Any) -> Breakpoint:
        """Add a catchpoint for an event kind, or for the `exit` of a program.

        Raises:
            DebugError: there is no such kind.
        """
        if what == "error":
            raise DebugError("runtime errors always stop; no catchpoint is needed")
        kind = what if what == "exit" else check_event_kind(what)
        return self._add("catchpoint", kind, None, options)

    def add_watchpoint(
        self,
        expression: str,
        kind: AccessKind = "change",
        *,
        location: bool = False,
        **options: Any,
    ) -> Breakpoint:
        """Add a watchpoint for an expression, or an object in the memory of a robot.

        Forward, the run stops before the next statement after an access; backward, before the
        statement that made it.

        Args:
            expression: the expression, in the scope of the selected frame.
            kind: which accesses count: `write`, `read`, both (`access`), or those that `change` it.
            location: whether to watch the object that it names now; otherwise it is evaluated
                again whenever its value may have changed. A slice is an object.
            options: further attributes of the `Breakpoint`.

        Raises:
            DebugError: it cannot be watched, or too many are watched.
        """
        robot = self._view.robot if options.get("robot") is None else options["robot"]
        if kind not in KINDS:
            raise DebugError(unknown("access kind", kind, list(KINDS)))
        number = self.breakpoints.next_number
        robot, made = self.resolve(number, expression, robot, kind, location=location)
        self._check(options.get("condition", ""), None, robot, made.watched.frame)
        if not isinstance(made.watched, WatchedWorld):
            self._make_room(robot)
        return self.breakpoints.add(
            lambda number: Breakpoint(
                number, "watchpoint", made.text, watch=made, **{**options, "robot": robot}
            )
        )

    def resolve(
        self,
        number: int,
        expression: str,
        robot: int,
        kind: AccessKind = "change",
        *,
        location: bool = False,
    ) -> tuple[int, Watchpoint]:
        """Return the watched object of an expression, and the robot of its program.

        Args:
            number: the number that identifies it.
            expression: the expression, in the scope of the selected frame.
            robot: the robot in whose program it is evaluated.
            kind: which accesses count.
            location: whether to watch the object that it names now.

        Raises:
            DebugError: it cannot be watched.
        """
        active, evaluator = self._view.active_frame(robot), self._view.evaluator(robot)
        again = partial(self._view.evaluator, robot)
        alone = evaluator.external_name(expression, active)
        if isinstance(alone, RobotName):
            other = self._view.names.index(alone.robot)
            return self.resolve(number, alone.text, other, kind, location=location)
        if not slice_in(expression) and evaluator.uses_external_values(expression, active):
            if location or kind != "change":
                raise DebugError(f"'{expression}' is a value, not an object in memory")
            return robot, watched_world(number, expression, robot, again)
        is_fixed = location and not evaluator.is_unused(expression, active)
        if is_fixed or slice_in(expression):
            return robot, watched_object(number, expression, kind, evaluator, active)
        return robot, watched_expression(number, expression, kind, again, active)

    def add_world_breakpoint(
        self, condition: str, robot: int, *, internal: bool = False, **options: Any
    ) -> Breakpoint:
        """Add a breakpoint at the start of any timestep at which a condition becomes true.

        Args:
            condition: the condition, in the scope of the robot's program; it uses the world.
            robot: the robot.
            internal: whether it belongs to a command, not to the user.
            options: further attributes of the `Breakpoint`.

        Raises:
            DebugError: it cannot be evaluated everywhere.
        """
        again = partial(self._view.evaluator, robot)
        points = self.breakpoints
        number = points.next_internal if internal else points.next_number
        made = watched_world(number, condition, robot, again, rises=True)
        return self.breakpoints.add(
            lambda number: Breakpoint(
                number, "breakpoint", condition, watch=made, robot=robot, **options
            ),
            internal=internal,
        )

    def _make_room(self, robot: int) -> None:
        """Check that one more object can be watched."""
        if len(self.breakpoints.watched(robot)) >= MAX:
            name = self._view.names[robot]
            raise DebugError(
                f"at most {MAX} objects of {name} can be watched at once: delete a"
                " watchpoint, or watch a whole struct or array"
            )

    def _add(
        self,
        kind: BreakpointKind,
        text: str,
        place: BreakpointLocation | None,
        options: Mapping[str, Any],
        *,
        internal: bool = False,
    ) -> Breakpoint:
        self._check(options.get("condition", ""), place, options.get("robot"))
        for each in expressions_in(options.get("log", "")):
            self._check(each, place, options.get("robot"))
        return self.breakpoints.add(
            lambda number: Breakpoint(number, kind, text, place, **options), internal=internal
        )

    def remove(self, number: int) -> None:
        """Remove a breakpoint; raise DebugError if it does not exist."""
        self.breakpoints.remove(number)

    def enable(self, number: int, *, on: bool = True) -> None:
        """Enable or disable a breakpoint; raise DebugError if it does not exist."""
        own = self.breakpoints.get(number)
        if on and own.watch and not own.enabled and own.robot is not None:
            self._make_room(own.robot)
        if on and own.stops_left == 0:
            own.stops_left = 1
        own.enabled = on

    def enable_for(self, number: int, stops: int | None) -> None:
        """Enable a breakpoint for some stops.

        Args:
            number: its number.
            stops: after how many stops it is disabled; None to delete it after the first.

        Raises:
            DebugError: it does not exist.
        """
        self.enable(number)
        own = self.breakpoints.get(number)
        own.temporary, own.stops_left = stops is None, stops

    def count_stops(self, numbers: Iterable[int]) -> None:
        """Disable or delete the breakpoints that have stopped the run for the last time."""
        for own in map(self.breakpoints.get, numbers):
            own.count_stop()
            if own.temporary:
                self.breakpoints.remove(own.number)

    def ignore(self, number: int, count: int) -> None:
        """Ignore the next hits of a breakpoint; raise DebugError if it does not exist."""
        self.breakpoints.get(number).ignore = max(0, count)

    def set_condition(self, number: int, condition: str) -> None:
        """Set the condition of a breakpoint; an empty one removes it.

        Raises:
            DebugError: there is no such breakpoint, or the condition is invalid there.
        """
        own = self.breakpoints.get(number)
        frame = own.watch.watched.frame if own.watch else None
        self._check(condition, own.location, own.robot, frame)
        own.condition = condition

    def _check(
        self,
        condition: str,
        place: BreakpointLocation | None = None,
        robot: int | None = None,
        frame: StackFrame | None = None,
    ) -> None:
        """Check that a condition is valid where it will be evaluated.

        Args:
            condition: the condition; empty for none.
            place: the location of a breakpoint.
            robot: the only robot concerned; None for all of them.
            frame: the frame in whose scope a watchpoint lasts.
        """
        if not condition:
            return
        if frame is not None and robot is not None:
            self._view.evaluator(robot).check(condition, frame.function, frame.location)
        elif place is not None and not place.codes:
            for evaluator, site in self._sites(place):
                evaluator.check(condition, site.function, site.location)
        else:
            self._check_anywhere(condition, robot)

    def _check_anywhere(self, condition: str, robot: int | None) -> None:
        """Check that a condition is valid at any statement, as events may happen at each."""
        wrong: DebugError | None = None
        for evaluator, function, location in self._all_scopes(robot):
            try:
                evaluator.check(condition, function, location)
            except DebugError as error:
                wrong = wrong or error
            else:
                return
        if wrong is not None:
            raise wrong

    def _all_scopes(self, robot: int | None) -> Iterator[tuple[Evaluator, str, Location]]:
        """Return the scopes of a robot's program, or of all programs: that of the file first."""
        robots = range(len(self._run.programs)) if robot is None else [robot]
        by_program = {id(self._run.programs[each]): each for each in reversed(robots)}
        for each in by_program.values():
            evaluator = self._view.evaluator(each)
            yield evaluator, "", NOWHERE
            for _, site in self._run.programs[each].executable.detail().compiled.breakable():
                if is_own(site.location):
                    yield evaluator, site.function, site.location

    def _sites(self, place: BreakpointLocation) -> Iterator[tuple[Evaluator, StatementSite]]:
        for robot, numbers in place.statements.items():
            if robot >= len(self._run.programs):  # it has joined after now
                continue
            sites = self._run.programs[robot].executable.detail().compiled.statements
            for number in numbers:
                yield self._view.evaluator(robot), sites[number]

    def assigns(self, one: Breakpoint) -> bool:
        """Return whether a condition is an assignment, where a comparison is likely to be meant."""
        if not one.condition:
            return False
        if one.location is not None and not one.location.codes:
            return any(
                evaluator.assigns(one.condition, site.function, site.location)
                for evaluator, site in self._sites(one.location)
            )
        for evaluator, function, location in self._all_scopes(one.robot):
            with contextlib.suppress(DebugError):
                return evaluator.assigns(one.condition, function, location)
        return False

    def accepts(self, hit: BreakpointHit, counts: bool) -> tuple[bool, str]:
        """Return whether a hit stops the run, and a remark."""
        own = hit.breakpoint
        if hit.watch_hit and hit.watch_hit.access.what == "return":
            return True, ""
        if own.condition:
            try:
                if not self._holds(own, self._evaluation_robot(hit)):
                    return False, ""
            except DebugError as error:
                return True, f"error in the condition of breakpoint {own.number}: {error}"
        if counts:
            own.hits += 1
            if own.ignore:
                own.ignore -= 1
                return False, ""
            if own.hits % own.every:
                return False, ""
            if own.log:
                self.print_log(self.log_message(own.log, self._evaluation_robot(hit)))
        return not own.log, ""

    def _evaluation_robot(self, hit: BreakpointHit) -> int:
        """Return the robot in whose program a breakpoint's expressions are evaluated."""
        if hit.robot >= 0:
            return hit.robot
        own = hit.breakpoint.robot  # the event belongs to no robot
        return self._view.robot if own is None else own

    def _holds(self, own: Breakpoint, robot: int) -> bool:
        """Return whether a condition is true; for a local variable's watchpoint, in its frame."""
        frame = own.watch.watched.frame if own.watch else None
        stack = self._run.stopped(robot).stack if frame else ()
        same = next((each for each in stack if frame and same_activation(each, frame)), None)
        return self._view.evaluator(robot).holds(own.condition, same)

    def describe_hit(self, hit: BreakpointHit) -> str:
        """Return a description of an access."""
        assert hit.watch_hit is not None
        assert hit.breakpoint.watch is not None
        return change_text(
            hit.breakpoint.watch, hit.watch_hit.access, self._view.evaluator(hit.robot).inspector()
        )

    def log_message(self, text: str, robot: int) -> str:
        """Return the message of a log point, see `log_message`."""
        frame = self._view.first_own_frame(robot)
        return message(text, partial(self._view.evaluate_pure, robot=robot, frame=frame))


def _discard_message(_text: str) -> None:
    """Discard a message."""
