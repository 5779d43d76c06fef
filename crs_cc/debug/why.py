"""The why-tree: the writes that a value came from, each with the values it was computed from.

The last write of an object is found as by `last_write`. Its statement shows what it was computed
from; each of these operands is an object with a last write of its own, before that statement. So
the tree goes back through assignments, arguments, return values, messages from other robots and
`State[]` to readings of sensors, to what was typed, to the user's changes and to initial values. A
value of the world comes from the motion command of its robot, contacts and changes by hand.

A statement is read as text, with its macros expanded. Of the calls in it only the last one
is followed into its `return`; what the others returned is not.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Final

from crs_cc.core.source import Location
from crs_cc.debug.battery_cause import battery_facts, world_facts
from crs_cc.debug.cause import Cause
from crs_cc.debug.data.notation import RobotName, WorldDistance, WorldName
from crs_cc.debug.data.object_parts import (
    Span,
    bytes_behind,
    bytes_copied,
    bytes_read,
    holds,
    part_assigned,
    part_operands,
    part_read,
)
from crs_cc.debug.data.statement_text import (
    argument,
    arguments,
    calls,
    cut,
    is_count,
    operands,
    source_of,
    value_of,
    without_call,
)
from crs_cc.debug.echo_cause import firing_cause, nearest
from crs_cc.debug.errors import DebugError
from crs_cc.debug.evaluation_point import EvaluationPoint, PassingCall, passing_call
from crs_cc.debug.last_write import MemoryObject, Write, last_write
from crs_cc.debug.message_cause import (
    RECEIVES,
    ReceivedMessage,
    is_sent,
    lost_messages,
    received,
    sending_statements,
    sent_arguments,
)
from crs_cc.debug.motion_cause import CONCERNS, Concern, command_statement, facts, pushing_robots
from crs_cc.debug.navigator import Navigator
from crs_cc.debug.repeated_writes import MIN_REPEATS, repeated
from crs_cc.debug.statement_source import StatementSource, statement_source
from crs_cc.debug.timeline.position import Position
from crs_cc.debug.timeline.recorded_run import InterruptedRunError
from crs_cc.debug.timeline.run_event import StopRequest
from crs_cc.debug.view import View
from crs_cc.debug.watchpoints import owner_of, same_activation
from crs_cc.debug.world.sensor_cause import (
    firing,
    sensor_texts,
)
from crs_cc.debug.world.state_fields import StateField
from crs_cc.debug.world.world_values import object_number
from crs_cc.ir.names import plain_name
from crs_cc.runtime.diagnosis.inspect import StackFrame

MAX_NODES: Final = 40
MAX_DEPTH: Final = 12
"""Limits of the nodes and levels of a tree; `why` at one of its times continues it."""

_COPIES: Final = frozenset({"memcpy", "memmove"})


class Why:
    """Explains values of the recorded run."""

    def __init__(self, view: View, navigator: Navigator) -> None:
        self._view = view
        self._run = view.run
        self._navigator = navigator
        self._left = MAX_NODES
        self._asked_s = 0.0
        self._seen: set[tuple[MemoryObject, Position]] = set()

    def explain(self, text: str) -> Cause:
        """Return where the value of an expression came from; the run is where it was.

        Raises:
            DebugError: the expression is invalid, or the user interrupts.
        """
        robot, here = self._view.robot, self._run.position
        self._asked_s = self._run.time_s(robot)
        frame = self._view.active_frame(robot)
        external = self._view.evaluator(robot).external_name(text, frame)
        if isinstance(external, RobotName):
            robot, text = self._view.names.index(external.robot), external.text
            frame = self._view.active_frame(robot)
        value = self._view.evaluate_pure(text, robot=robot)
        point = EvaluationPoint(here, robot, frame)
        try:
            found = self._value(point, text, 0)
            if found is None:
                causes = self._operands(point, operands(text), 0)
                found = Cause(f"{text} = {value.text}", robot=robot, causes=causes)
        except InterruptedRunError:
            raise DebugError("interrupted") from None
        finally:
            self._run.seek(here)
        return replace(found, expression=text)

    # -- values and their writes ---------------------------------------------------------------

    def _operands(
        self,
        point: EvaluationPoint,
        names: Sequence[str],
        depth: int,
        own: MemoryObject | None = None,
        read: Sequence[Span] = (),
    ) -> tuple[Cause, ...]:
        """Return where the values of some operands came from.

        Args:
            point: where they have their values.
            names: the operands.
            depth: the level of the nodes.
            own: the object that their statement writes.
            read: the bytes that their statement reads, if they are known.
        """
        found: list[Cause] = []
        for each in names:
            self._run.seek(point.position)
            with contextlib.suppress(DebugError):  # a function, a macro's word, a member's name
                name = part_read(self._view.evaluator(point.robot), each, read, point.frame)
                cause = self._value(point, name, depth, own)
                found += [] if cause is None else [replace(cause, expression=name)]
        return tuple(found)

    def _value(
        self, point: EvaluationPoint, name: str, depth: int, own: MemoryObject | None = None
    ) -> Cause | None:
        """Return where the value of an operand came from, of the program or the world."""
        external = self._view.evaluator(point.robot).external_name(name, point.frame)
        if isinstance(external, WorldName | WorldDistance):
            value = self._view.evaluate_pure(name, robot=point.robot)
            causes = tuple(self._of_world(point.position, external, depth))
            how = "" if causes else "a value of the world"
            return Cause(f"{name} = {value.text}", how, causes=causes)
        return self._object(point, name, depth, own)

    def _object(
        self, point: EvaluationPoint, name: str, depth: int, own: MemoryObject | None
    ) -> Cause | None:
        """Return where the value of an operand came from; None if it is not an object in memory.

        The run is at the place, and somewhere else after that.
        """
        robot, evaluator = point.robot, self._view.evaluator(point.robot)
        value = evaluator.evaluate(name, point.frame).value
        evaluator.undo()
        if value.address is None or not value.type.size:
            return None
        stopped = self._run.stopped(robot)
        owner = owner_of(stopped, value.address)
        wanted = MemoryObject(robot, value.address, value.type.size, owner, value.type)
        head = f"{name} = {value.text}"
        if self._left <= 0 or depth >= MAX_DEPTH:
            return Cause(head, "...", robot=robot)
        self._left -= 1
        calling = passing_call(evaluator, stopped.stack, owner, value)
        if own is not None and own.is_same_memory(wanted) and point.frame is not None:
            count, first = repeated(self._view, name, wanted, point.position, point.frame.function)
            if first is not None and count >= MIN_REPEATS:
                return self._written(head, wanted, first, depth, count)
        write = last_write(self._run, wanted, point.position)
        if write is not None:
            return self._written(head, wanted, write, depth)
        if calling is not None:
            return self._argument(head, robot, calling, depth)
        how = "its initial value" if owner is None else "not written since its function was called"
        return Cause(head, how, robot=robot)

    def _written(
        self, head: str, wanted: MemoryObject, write: Write, depth: int, times: int = 1
    ) -> Cause:
        """Return the node of a write, with the written values as its causes.

        It may represent several writes, of which it is the first.
        """
        robot, access = wanted.robot, write.access
        self._run.seek(write.before)
        base = Cause(head, "", write.before, self._run.time_s(robot), robot)
        if access is None:
            return replace(base, how=f"you changed it: {write.edit}")
        if access.location is None:
            return replace(base, how="the C library wrote it")
        base = replace(base, location=access.location, function=access.function)
        frame = self._frame(robot, access.function, access.location)
        source = statement_source(self._view, robot, access.function, access.location)
        shown, text = source.shown, source.text
        if times > 1:
            base = replace(base, times=times)
            shown += f"  ({times:,} times, the first one here)"
        if (wanted, write.before) in self._seen:
            return replace(base, how=f"{shown} (see above)")
        self._seen.add((wanted, write.before))
        point = EvaluationPoint(write.before, robot, frame)
        if access.library:
            causes = self._from_library(point, access.library, text, wanted, depth)
            return replace(base, how=shown, causes=causes)
        if is_count(text):
            return self._counted(replace(base, how=shown), point, wanted, text, depth)
        evaluator = self._view.evaluator(robot)
        part = part_assigned(evaluator, text, (wanted.address, wanted.size), frame)
        returned = self._returned(point, text, depth, part)
        if returned is not None:
            text = without_call(text, returned.text.partition(" ")[0])
            self._run.seek(point.position)
        read = bytes_read(evaluator, text, frame)
        names = source_of(text, part and part_operands(evaluator, value_of(text), part, frame))
        own = self._operands(point, names, depth + 1, wanted, read)
        causes = own if returned is None else (returned, *own)
        return replace(base, how=shown, causes=causes)

    def _counted(
        self, base: Cause, point: EvaluationPoint, wanted: MemoryObject, text: str, depth: int
    ) -> Cause:
        """Return the node of a write such as `i++`: of the first of many in a row."""
        (name,) = operands(cut(text))
        function = "" if point.frame is None else point.frame.function
        count, first = repeated(self._view, name, wanted, point.position, function)
        if base.times == 1 and first is not None and count + 1 >= MIN_REPEATS:
            return self._written(base.text, wanted, first, depth, count + 1)
        return replace(base, causes=self._operands(point, [name], depth + 1, wanted))

    def _returned(
        self, point: EvaluationPoint, text: str, depth: int, part: Span | None = None
    ) -> Cause | None:
        """Return the `return` statement of the call whose value was used last; None for none.

        Args:
            point: where it returns.
            text: the statement that has the call.
            depth: the level of the node.
            part: the bytes of a struct that are asked for; None for all.
        """
        site = self._run.site(point.robot)
        stack = self._run.stopped(point.robot).stack
        if site is None or point.frame is None or same_activation(stack[0], point.frame):
            return None
        if plain_name(site.function) not in calls(text):
            return None
        source = statement_source(self._view, point.robot, site.function, site.location)
        inner = EvaluationPoint(
            point.position, point.robot, replace(stack[0], location=site.location)
        )
        evaluator, value = self._view.evaluator(point.robot), value_of(source.text)
        found = part and part_operands(evaluator, value, part, inner.frame)
        return Cause(
            f"{plain_name(site.function)} returned",
            source.shown,
            point.position,
            self._run.time_s(point.robot),
            point.robot,
            site.location,
            self._operands(inner, source_of(source.text, found), depth + 1),
        )

    # -- arguments -----------------------------------------------------------------------------

    def _argument(self, head: str, robot: int, calling: PassingCall, depth: int) -> Cause:
        """Return the node of a parameter: the call that passed it."""
        caller, begun = calling.caller, calling.callee.entered - 1
        base = Cause(head, robot=robot)
        if begun < 0 or not self._navigator.goto_statement(robot, begun):
            return replace(base, how="an argument of the program")
        point = EvaluationPoint(self._run.position, robot, caller)
        source = statement_source(self._view, robot, caller.function, caller.location)
        passed = argument(source.text, plain_name(calling.callee.function), calling.number)
        returned = None
        if calls(passed):
            inner = self._last_return(point, source.text, begun)
            returned = self._returned(inner, passed, depth, calling.part)
        if returned is not None:
            passed = without_call(passed, returned.text.partition(" ")[0])
        names = operands(passed)
        self._run.seek(point.position)
        if calling.part is not None:
            evaluator = self._view.evaluator(robot)
            names = part_operands(evaluator, passed, calling.part, caller) or names
        return Cause(
            head,
            source.shown,
            point.position,
            self._run.time_s(robot),
            robot,
            caller.location,
            (*(() if returned is None else (returned,)), *self._operands(point, names, depth + 1)),
        )

    def _last_return(self, point: EvaluationPoint, text: str, begun: int) -> EvaluationPoint:
        """Return where the last call returned before another call of the same statement.

        Args:
            point: where the other call is made.
            text: the statement. If it has several calls of that function, the place is returned.
            begun: how many statements had begun before the other call.
        """
        self._navigator.goto_statement(point.robot, begun - 1)
        site = self._run.site(point.robot)
        if site is None or calls(text).count(plain_name(site.function)) != 1:
            self._run.seek(point.position)
        return replace(point, position=self._run.position)

    # -- the library ---------------------------------------------------------------------------

    def _from_library(
        self, point: EvaluationPoint, function: str, text: str, wanted: MemoryObject, depth: int
    ) -> tuple[Cause, ...]:
        """Return the source from which a function of the library wrote an object."""
        robot = point.robot
        for field, value in self._view.vendor_state(robot):
            if value.address == wanted.address:
                return tuple(self._measured(point, field, depth))
        if function == RECEIVES:
            return self._message(point, text, depth, wanted)
        part = None
        if function in _COPIES:
            span = wanted.address, wanted.size
            evaluator, passed = self._view.evaluator(robot), arguments(text)
            part = bytes_copied(evaluator, passed, span, point.frame, wanted.type)
        if part is not None:
            return self._operands(point, [part], depth + 1)
        names = [each.lstrip("& ") for each in arguments(text)]
        found = list(dict.fromkeys(each for name in names for each in operands(name)))
        if not function.endswith("cat"):  # what these write, they have read before (C17 7.24.3)
            evaluator = self._view.evaluator(robot)
            found = [e for e in found if not holds(evaluator, e, wanted.address, point.frame)]
        return self._operands(point, found, depth + 1)

    def _measured(self, point: EvaluationPoint, field: StateField, depth: int) -> Iterator[Cause]:
        """Return the cause of a reading that the robot reports here."""
        run, robot = self._run, point.robot
        environment = run.session.environment
        texts = list(sensor_texts(environment, robot, field))
        ping = firing(environment, robot, field)
        is_pose = "_CONF" in field.name
        if ping is not None:
            yield firing_cause(run, robot, ping, f"{field.name}: ")
        for each in texts:
            yield Cause(f"{field.name}: {each}", position=point.position, robot=robot)
        if is_pose:
            run.seek(point.position)
            driven = self._commanded(robot, depth + 1)
            yield from () if driven is None else (driven,)

    # -- the world -----------------------------------------------------------------------------

    def _of_world(
        self, here: Position, name: WorldName | WorldDistance, depth: int
    ) -> Iterator[Cause]:
        """Return the cause of a value of the world."""
        environment = self._run.session.environment
        if isinstance(name, WorldDistance):
            for each in (name.one, name.other):
                yield from self._moved(here, object_number(environment, each), depth)
        elif name.path and name.path[0] in environment.names:
            number = object_number(environment, name.path[0])
            concern = CONCERNS.get(name.path[1] if name.path[1:] else "")
            if concern == "sonar":
                yield from nearest(self._run, here, number)
            elif concern is not None:
                if concern == "battery":
                    given = battery_facts(environment, number, name.path[1])
                    yield from (Cause(each.text) for each in given)
                yield from self._moved(here, number, depth, concern)
        elif name.path:
            yield from (Cause(each.text) for each in world_facts(environment, name.path[0]))

    def _moved(
        self, here: Position, number: int, depth: int, concern: Concern = "motion"
    ) -> Iterator[Cause]:
        """Return the cause of an object's motion, or else of its value."""
        self._run.seek(here)
        others = pushing_robots(self._run.session.environment, number)
        found = list(facts(self._run, number, concern))
        if concern == "motion" and (cause := self._commanded(number, depth)) is not None:
            yield cause
        for each in found:
            robot = number if number < len(self._run.programs) else -1
            yield Cause(each.text, "", each.position, each.time_s, robot)
        for other in others if concern == "motion" else ():
            self._run.seek(here)
            text = f"{self._run.name(other)} touched it"
            driven = self._commanded(other, depth + 1)
            yield Cause(text, "", here, causes=() if driven is None else (driven,))

    def _commanded(self, number: int, depth: int) -> Cause | None:
        """Return the node of the motion command that a robot follows; None if there is none."""
        if number >= len(self._run.programs) or depth >= MAX_DEPTH:
            return None
        begun = command_statement(self._run, number)
        if begun is None or not self._navigator.goto_statement(number, begun):
            return None
        return self._posted(number, f"{self._run.name(number)} was driven", depth)

    def _message(
        self, point: EvaluationPoint, text: str, depth: int, wanted: MemoryObject
    ) -> tuple[Cause, ...]:
        """Return where a part of a message came from, and which ones were lost since."""
        robot, found = point.robot, list[Cause]()
        received_s = self._run.time_s(robot)
        self._run.arm(StopRequest(all=frozenset({robot})))
        while self._run.advance().kind != "statement" and self._run.can_advance:
            pass
        assert point.frame is not None
        stack = self._run.stopped(robot).stack
        frame = next(each for each in stack if same_activation(each, point.frame))
        evaluator, span = self._view.evaluator(robot), (wanted.address, wanted.size)
        message = received(evaluator, f"({arguments(text)[0]})", frame, span)
        sender = message.sender
        numbers = sending_statements(self._run, sender, message.sent_s)
        begun = next((each for each in numbers if self._has_sent(each, message)), None)
        begun = begun if begun is not None or not numbers else numbers[0]
        if begun is not None and self._navigator.goto_statement(sender, begun):
            head = f"{self._run.name(sender)} sent it"
            found.append(self._posted(sender, head, depth, message.part))
        timestep_s = self._run.session.environment.timestep_s
        for each in lost_messages(self._run, robot, received_s, self._asked_s):
            position = Position(int(each.time_s / timestep_s), 0)
            found.append(
                Cause(
                    f"a later message did not arrive: {each.text}", "", position, each.time_s, robot
                )
            )
        return tuple(found)

    def _has_sent(self, begun: int, message: ReceivedMessage) -> bool:
        """Return whether a statement of a robot has sent a message."""
        robot = message.sender
        if not self._navigator.goto_statement(robot, begun):
            return False
        point, source = self._posting(robot)
        return is_sent(self._view.evaluator(robot), source.text, point.frame, message)

    def _posting(self, robot: int) -> tuple[EvaluationPoint, StatementSource]:
        """Return the statement that posts a request: the run is before it."""
        stack, site = self._run.stopped(robot).stack, self._run.site(robot)
        assert site is not None
        frame = replace(stack[0], location=site.location)
        source = statement_source(self._view, robot, site.function, site.location)
        return EvaluationPoint(self._run.position, robot, frame), source

    def _posted(self, robot: int, head: str, depth: int, part: Span | None = None) -> Cause:
        """Return the node of a message or a command: the run is before its statement.

        Args:
            robot: the robot that posts it.
            head: what it is.
            depth: the level of the node.
            part: the bytes of a message that are asked for; None for all.
        """
        point, source = self._posting(robot)
        sent = sent_arguments(source.text)
        passed = sent[-2:-1] or arguments(source.text)
        names = [each for one in passed for each in operands(one.lstrip("& "))]
        if part is not None and len(sent) > 1:
            named = bytes_behind(self._view.evaluator(robot), sent[-2], part, point.frame)
            names = names if named is None else [named]
        return Cause(
            head,
            source.shown,
            point.position,
            self._run.time_s(robot),
            robot,
            None if point.frame is None else point.frame.location,
            self._operands(point, list(dict.fromkeys(names)), depth + 1),
        )

    # -- the source ----------------------------------------------------------------------------

    def _frame(self, robot: int, function: str, location: Location) -> StackFrame | None:
        """Return the innermost frame of a function, at a location."""
        stack = self._run.stopped(robot).stack
        found = next((each for each in stack if each.function == function), None)
        return None if found is None else replace(found, location=location)
