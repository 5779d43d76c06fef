"""The debugger without a user interface: its operations as methods that return plain data.

Invalid requests raise `DebugError` and leave the run unchanged. Moving returns a `Stop`. A change
of the run (of a variable, of the world) starts a new history: the recorded future is discarded, the
past is kept.
"""

from __future__ import annotations

import contextlib
import math
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Final

from crs_cc.debug.branch_comparison import Difference, differences, facts
from crs_cc.debug.branches import Branch, Branches, Checkpoint
from crs_cc.debug.breakpoints import Breakpoint
from crs_cc.debug.data.interpret import Printed
from crs_cc.debug.data.values import Value
from crs_cc.debug.errors import DebugError
from crs_cc.debug.navigator import Navigator
from crs_cc.debug.program import DebugProgram
from crs_cc.debug.returned_value import returned_value
from crs_cc.debug.step_conditions import (
    ActiveCalls,
    ProgramPoint,
    ReverseStepCondition,
    StepCondition,
    StepToLine,
    StepToStatement,
)
from crs_cc.debug.stop import Stop
from crs_cc.debug.stop_points import StopPoints
from crs_cc.debug.timeline.change import Change, MemoryPatch
from crs_cc.debug.timeline.console import ReplayConsole, WaitingAfter
from crs_cc.debug.timeline.history import History
from crs_cc.debug.timeline.note import Note
from crs_cc.debug.timeline.position import BEGINNING, Position
from crs_cc.debug.timeline.recorded_run import InterruptedRunError, RecordedRun
from crs_cc.debug.view import View
from crs_cc.debug.world.events import WorldEvent
from crs_cc.debug.world.run_edits import edit_run
from crs_cc.session.host import Client, Input, Output, discard, never_waits, no_input
from crs_cc.session.session import Listener, Session
from crs_cc.sim.model.world import WorldModel

Move = Callable[[], Stop]

_SLACK_S: Final = 1e-9
_MAX_STEPS: Final = 1_000_000


class Debugger:
    """A debugging session: a recorded run, and its inspection, stop points and changes.

    Attributes:
        run: the run; to be moved by the methods of this class only.
        view: the robot and stack frame that the user has selected.
        stop_points: breakpoints, watchpoints and catchpoints.
        navigator: what moves the run to its next or previous stop.
        branches: the alternative histories of the run.
        stop: the last stop.
        notes: the user's notes on instants of the run.
        save: saves the run of a debugger up to here as a recording; None if that is not possible.
    """

    def __init__(
        self,
        world: WorldModel,
        programs: Sequence[DebugProgram],
        seed: int = 0,
        *,
        arguments: Sequence[Sequence[str]] = (),
        output: Output = discard,
        read: Input = no_input,
        files: Mapping[str, bytes] | None = None,
        client: Client = "nclient",
        observer: Listener | None = None,
        waiting: WaitingAfter = never_waits,
    ) -> None:
        """Load the programs into the robots; for the arguments see `Session`."""
        self.run = RecordedRun(
            world,
            programs,
            seed,
            ReplayConsole(output, read, waiting),
            History(robots=len(programs)),
            arguments=arguments,
            files=files,
            client=client,
            observer=observer,
        )
        self.view = View(self.run)
        self.stop_points = StopPoints(self.view)
        self.navigator = Navigator(self.run, self.stop_points)
        self.branches = Branches(self.run)
        self.stop = self.navigator.stop("start")
        self.notes: list[Note] = []
        self.save: Callable[[Debugger, Path], None] | None = None

    @property
    def session(self) -> Session:
        """The session; read only."""
        return self.run.session

    @property
    def names(self) -> tuple[str, ...]:
        """The robots' names, by number."""
        return self.view.names

    @property
    def position(self) -> Position:
        """The position of the run."""
        return self.run.position

    # -- moving --------------------------------------------------------------------------------

    def interrupt(self) -> None:
        """Request an interrupt; thread-safe."""
        self.run.interrupted = True

    def forget_interrupt(self) -> None:
        """Discard an interrupt that arrived too late."""
        self.run.interrupted = False

    def start(self) -> Stop:
        """Go to the first statement of the program that starts first."""
        return self.step_statement()

    def resume(self, *, backward: bool = False) -> Stop:
        """Continue to the next stop, or back to the previous one."""
        if backward:
            return self._record_stop(self.navigator.backward())
        return self.run_to(None)

    def step(self, count: int = 1, *, backward: bool = False) -> Stop:
        """Step to the next line, entering calls; or to the start of the previous line."""
        robot, back = self.view.robot, self.navigator.backward_to
        if backward:
            return self._repeat(count, lambda: back(ReverseStepCondition(robot)))
        return self._repeat(count, lambda: self._forward(StepToLine(robot, self._program_point())))

    def next(self, count: int = 1, *, backward: bool = False) -> Stop:
        """Step to the next line, over calls; or to the start of the previous line."""
        move = self._next_back if backward else self._next
        return self._repeat(count, move)

    def step_statement(
        self, count: int = 1, *, backward: bool = False, over_calls: bool = False
    ) -> Stop:
        """Step to the next statement, or to the previous one; by default into calls."""
        robot, navigator = self.view.robot, self.navigator

        def move() -> Stop:
            calls = self._own_calls() if over_calls else None
            if backward:
                return navigator.backward_to(ReverseStepCondition(robot, calls, whole_line=False))
            return self._forward(StepToStatement(robot, calls))

        return self._repeat(count, move)

    def finish(self, *, backward: bool = False) -> Stop:
        """Run until the selected function returns, and report its value; or go back to its call.

        Forward, it stops right behind the call, in the middle of the caller's statement.

        Raises:
            DebugError: it has no caller.
        """
        robot = self.view.robot
        frame = self.view.current_frame()
        callers = None if frame is None else self.navigator.calls(robot, frame.active)
        if frame is None or callers is None or not callers.functions:
            which = "reverse-" * backward + "finish"
            raise DebugError(f"'{which}' is not meaningful in the outermost frame")
        if backward:
            aim = ReverseStepCondition(robot, callers, whole_line=False, after_calls=True)
            return self._record_stop(self.navigator.backward_to(aim))
        stop = self.run_to(StepToStatement(robot, callers, after_calls=True))
        site = self.run.site(robot)
        if stop.reason != "step" or site is None or not site.after_call:
            return stop
        reader = self.view.evaluator(robot).inspector()
        value = returned_value(self.run.stopped(robot), reader, frame.active)
        if value is not None:
            text = f"{frame.function} returned {value.text}"
            self.stop = replace(stop, text=text, returned=value)
        return self.stop

    def until(self) -> Stop:
        """Step like `next`, but only to a line after the current one, so out of loops."""
        return self._record_stop(self._next(onward=True))

    def advance(self, added: Breakpoint) -> Stop:
        """Continue to a temporary breakpoint, which is removed, or until the function returns.

        Raises:
            DebugError: the selected program has ended.
        """
        robot = self.view.robot
        try:
            frame = self.view.current_frame() if added.robot == robot else None
            if frame is None:
                return self.run_to(None)
            callers = self.navigator.calls(robot, frame.active)
            return self.run_to(StepToStatement(robot, callers, after_calls=True))
        finally:
            if added in list(self.stop_points.breakpoints):
                self.stop_points.breakpoints.remove(added.number)

    def tick(self, count: int = 1, *, backward: bool = False) -> Stop:
        """Go to the end of the timestep, or back to its start."""
        position = self.position
        inside = position != Position(position.timestep, 0)
        if backward:
            return self.goto_timestep(max(0, position.timestep + inside - count))
        return self.run_to(None, Position(position.timestep + count, 0))

    def goto(self, target: Position) -> Stop:
        """Go to a recorded position."""
        self.run.seek(target)
        return self._record_stop(
            self.navigator.stop("beginning" if target == BEGINNING else "goto")
        )

    def goto_timestep(self, timestep: int) -> Stop:
        """Go to the start of a timestep, ignoring breakpoints on the way.

        Raises:
            DebugError: it is negative.
        """
        if timestep < 0:
            raise DebugError("time starts at 0")
        with self._showing_new():
            return self._to_timestep(timestep)

    def goto_end(self) -> Stop:
        """Go to where all programs have ended, ignoring breakpoints on the way."""
        with self._showing_new():
            self.run.seek(max(self.position, self.run.history.latest()))
            return self._record_stop(self.navigator.goto_timestep(sys.maxsize))

    def goto_time(self, time_s: float) -> Stop:
        """Go to the start of the timestep that contains a time.

        Raises:
            DebugError: it is negative.
        """
        if not math.isfinite(time_s):
            raise DebugError(f"invalid time {time_s}")
        timestep_s = self.session.environment.world.timestep_s
        return self.goto_timestep(math.floor(time_s / timestep_s + _SLACK_S))

    def goto_statement(self, number: int) -> Stop:
        """Go to the point just before statement `number` of the selected program, from 1.

        Raises:
            DebugError: the program has no such statement.
        """
        if number < 1:
            raise DebugError("statement numbers start at 1")
        start = self.position
        try:
            with self._showing_new():
                is_there = self.navigator.goto_statement(self.view.robot, number - 1)
        except InterruptedRunError:
            return self._record_stop(self.navigator.stop("interrupt"))
        if not is_there:
            self.run.seek(start)
            raise DebugError(
                f"{self.names[self.view.robot]}'s program ends before statement {number}"
            )
        return self._record_stop(self.navigator.stop("goto", self.view.robot))

    def _to_timestep(self, timestep: int) -> Stop:
        target = Position(timestep, 0)
        if target <= max(self.position, self.run.history.latest()):
            return self.goto(target)
        return self._record_stop(self.navigator.goto_timestep(timestep))

    @contextlib.contextmanager
    def _showing_new(self) -> Iterator[None]:
        """Show new output of the programs while the run is moved."""
        self.run.console.shows_new = True
        try:
            yield
        finally:
            self.run.console.shows_new = False

    def _program_point(self) -> ProgramPoint | None:
        return self.navigator.program_point(self.view.robot)

    def _next(self, *, onward: bool = False) -> Stop:
        calls = self._own_calls()
        program_point = None if calls is None else self._program_point()
        return self._forward(StepToLine(self.view.robot, program_point, calls, onward))

    def _next_back(self) -> Stop:
        return self.navigator.backward_to(ReverseStepCondition(self.view.robot, self._own_calls()))

    def _own_calls(self) -> ActiveCalls | None:
        """Return the active calls of the user's functions; None if there are none."""
        if all(each.is_library for each in self.view.frames()):
            return None
        return self.navigator.calls(self.view.robot)

    def run_to(self, aim: StepCondition | None, until: Position | None = None) -> Stop:
        """Run forward to where a step ends, or to the start of a timestep."""
        return self._record_stop(self._forward(aim, until))

    def _forward(self, aim: StepCondition | None, until: Position | None = None) -> Stop:
        if aim is not None and self.run.is_over(aim.robot) and self.run.can_advance:
            raise DebugError(f"{self.names[aim.robot]}'s program has ended; others still run")
        self.run.console.is_live = True
        try:
            return self.navigator.forward(aim, until)
        finally:
            self.run.console.is_live = False

    def _repeat(self, count: int, move: Move) -> Stop:
        if not 1 <= count <= _MAX_STEPS:
            raise DebugError(f"invalid count {count} (expected 1 to {_MAX_STEPS:,})")
        for left in reversed(range(count)):
            stop = move()
            if stop.reason != "step":
                break
            if left and self.run.interrupted:  # nothing else would notice it between two moves
                stop = self.navigator.stop("interrupt", self.view.robot)
                break
        return self._record_stop(stop)

    def _record_stop(self, stop: Stop) -> Stop:
        """Complete a move: record the stop and select the robot and frame that it is about."""
        self.stop = stop
        self.forget_interrupt()
        self._note(stop)
        if stop.robot >= 0:
            self.view.robot = stop.robot
        elif self.view.robot >= len(self.names):  # a robot that has been added, and is no more
            self.view.robot = 0
        self.stop_points.count_stops(stop.breakpoints)
        frames = (each for each in self.view.frames() if each.active.function == stop.function)
        about = next(frames, None)
        self.view.frame = self.view.first_own_frame() if about is None else about.number
        return stop

    def _note(self, stop: Stop) -> None:
        """Record a stop in the event history, for timelines."""
        if stop.breakpoints or stop.reason == "error":
            kind = "error" if stop.reason == "error" else "stop"
            event = WorldEvent(stop.time_s, kind, stop.robot, stop.why)
            self.run.event_history.note(stop.position.timestep, event)

    # -- changing ------------------------------------------------------------------------------

    def evaluate(self, text: str, *, robot: int | None = None, frame: int | None = None) -> Value:
        """Evaluate a C expression, which may change the program.

        Args:
            text: the expression.
            robot: the robot; by default the selected one.
            frame: the number of the frame whose scope applies; by default the selected
                one.

        Raises:
            DebugError: it is invalid or cannot be evaluated; nothing has changed.
        """
        robot = self.view.robot if robot is None else robot
        found = self.view.evaluator(robot).evaluate(text, self.view.active_frame(robot, frame))
        if found.changed:
            self._record_change(text, robot, found.patches, found.printed)
        return found.value

    def edit_world(self, text: str) -> str:
        """Change the run or its world; return a description of the change.

        Args:
            text: the change, see `run_edits.ALL_EDITS`.

        Raises:
            DebugError: it is invalid or impossible; nothing has changed.
        """
        done = edit_run(self.session, text, self.run.executables())
        self._record_change(text)
        return done

    def revert(self, number: int) -> Stop:
        """Undo a change and all later ones, and go to the position before it.

        Raises:
            DebugError: there is no such change.
        """
        changes = self.run.history.changes
        if not 0 <= number < len(changes):
            raise DebugError(f"no change {number}")
        return self.rewind_to(changes[number].position, range(number))

    def rewind_to(self, place: Position, kept: Iterable[int]) -> Stop:
        """Go to a recorded position, and forget the changes there and later, but for some."""
        changes = self.run.history.changes
        same = [changes[number] for number in kept if changes[number].position == place]
        if self.branches.keeps_past:
            self.run.seek(place)
            self.branches.leave_past()
        self.run.revert(place)
        self.branches.discard_checkpoints()
        for each in same:
            self.repeat(each)
        return self._record_stop(self.navigator.stop("goto"))

    def repeat(self, change: Change) -> None:
        """Go to the position of a change of the same run, and make it again.

        Raises:
            DebugError: the run does not get there, or the change is not possible there.
        """
        self.run.seek(change.position)
        if self.position != change.position:
            raise DebugError(
                f"the run does not reach the position of the change {change.text[:40]!r}"
            )
        if change.robot < 0:
            if change.program is not None:
                self.run.uploads.add(*change.program)
            edit_run(self.session, change.text, self.run.executables())
        else:
            try:
                self.run.patch(change.robot, change.patches)
            except ValueError as wrong:
                raise DebugError(str(wrong)) from None
        self._record_change(change.text, change.robot, change.patches, change.printed)

    def _record_change(
        self,
        text: str,
        robot: int = -1,
        patches: tuple[MemoryPatch, ...] = (),
        printed: tuple[Printed, ...] = (),
    ) -> None:
        """Record a change, and discard the future."""
        program = self.run.uploads.used_in(text) if robot < 0 else None
        self.branches.leave_past()
        with self._showing_new():
            self.run.record_change(Change(self.position, text, robot, patches, program, printed))
        self.branches.discard_checkpoints()
        if robot < 0:  # only changes of the world add robots
            self.stop_points.add_joined_robots()

    # -- branches ------------------------------------------------------------------------------

    def checkpoint(self, name: str = "") -> Checkpoint:
        """Save the current position as a checkpoint."""
        return self.branches.add_checkpoint(name, self.view.time_s)

    def restart(self, number: int) -> Stop:
        """Return to a checkpoint; raise DebugError if it does not exist."""
        return self.goto(self.branches.checkpoint(number).position)

    def branch(self, name: str) -> Branch:
        """Create a branch here and switch to it; raise DebugError if one has that name."""
        return self.branches.add(name)

    def switch(self, name: str) -> Stop:
        """Switch to another branch, where the user left it.

        Raises:
            DebugError: it does not exist.
        """
        self.branches.switch(name)
        self.stop_points.add_joined_robots()
        return self._record_stop(self.navigator.stop("goto"))

    def compare(self, name: str) -> list[Difference]:
        """Compare this branch with another one at the start of the current timestep.

        The other one is run that far if necessary.

        Raises:
            DebugError: it does not exist, or ends before.
        """
        own, here = self.branches.current.name, self.position
        looked_at = self.view.robot, self.view.frame, self.stop
        self.goto_timestep(here.timestep)
        facts_here = facts(self.view)
        try:
            self.branches.switch(name)
            there = self.position
            self._to_timestep(here.timestep)  # without output: it is undone
            reached, facts_there = self.position.timestep, facts(self.view)
            self.run.seek(there)
        finally:
            self.branches.switch(own)
            self.run.seek(here)
            self.view.robot, self.view.frame, self.stop = looked_at
        if reached != here.timestep:
            raise DebugError(f"branch '{name}' has ended, or was interrupted, before this timestep")
        return differences(facts_here, facts_there)
