"""The debugger without a screen: what its user can do, as plain calls that give plain data.

All that a user can do wrong raises `DebugError`, and changes nothing. Moving gives a `Stop`. What
changes the run (a variable, the world) lets it branch: what had been behind this instant is
forgotten, what was before it stays.
"""

from __future__ import annotations

import contextlib
import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Final

from crs_cc.debug.branches import Branch, Branches, Checkpoint
from crs_cc.debug.comparison import Difference, differences, facts
from crs_cc.debug.data.values import Value
from crs_cc.debug.errors import DebugError
from crs_cc.debug.navigator import Traveller
from crs_cc.debug.step_conditions import Aim, BackAim, Calls, Spot, ToCaller, ToLine, ToStatement
from crs_cc.debug.stop import Stop
from crs_cc.debug.stop_points import Points
from crs_cc.debug.timeline.console import Console
from crs_cc.debug.timeline.history import History
from crs_cc.debug.timeline.position import BEGINNING, Position
from crs_cc.debug.timeline.run import InterruptedRunError, Run
from crs_cc.debug.view import Frame
from crs_cc.debug.world.edits import edit
from crs_cc.debug.world.events import Happening
from crs_cc.session.host import Client, Input, Output, discard, no_input

if TYPE_CHECKING:
    from crs_cc.debug.program import DebugProgram
    from crs_cc.sim.model.world import WorldModel

Move = Callable[[], Stop]

_SLACK_S: Final = 1e-9
_MOST_STEPS: Final = 1_000_000
_MOST_LINES: Final = 10
_RETURN: Final = re.compile(r"return\b\s*([^;]+);")


class Debugger(Points):
    """A run under the eyes of a user, who moves it.

    What he looks at is told by `View`, what the run stops at by `Points`.

    Attributes:
        branches: the courses of events that the user has tried.
        stop: the last stop.
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
    ) -> None:
        """Put the programs into the robots; nothing has run yet. See `Session`."""
        super().__init__(
            Run(
                world,
                programs,
                seed,
                Console(output, read),
                History(robots=len(programs)),
                arguments=arguments,
                files=files,
                client=client,
            )
        )
        self._traveller = Traveller(self.run, self.breakpoints, self.accepts, self.told_of)
        self.branches = Branches(self.run)
        self.stop = self._traveller.stop("start")

    # -- moving --------------------------------------------------------------------------------

    def interrupt(self) -> None:
        """Lets what is running stop soon; may be called from anywhere."""
        self.run.interrupted = True

    def forget_interrupt(self) -> None:
        """Forgets an interrupt that came when what it was meant for had ended."""
        self.run.interrupted = False

    def start(self) -> Stop:
        """Goes to the first statement of the first program that begins."""
        return self.step_statement()

    def resume(self, *, backward: bool = False) -> Stop:
        """Goes on to the next breakpoint, or back to the last one."""
        if backward:
            return self._arrive(self._traveller.backward())
        return self._go(None)

    def step(self, count: int = 1, *, backward: bool = False) -> Stop:
        """Goes to the next line, into calls; or to the start of the line before."""
        robot = self.robot
        if backward:
            return self._repeat(count, lambda: self._traveller.backward_to(BackAim(robot)))
        return self._repeat(count, lambda: self._forward(ToLine(robot, self._spot())))

    def next(self, count: int = 1, *, backward: bool = False) -> Stop:
        """Goes to the next line, past calls; or to the start of the one before."""
        move = self._next_back if backward else self._next
        return self._repeat(count, move)

    def step_statement(self, count: int = 1, *, backward: bool = False) -> Stop:
        """Goes to the next statement, into calls; or to the one before."""
        robot = self.robot
        if backward:
            aim = partial(BackAim, robot, whole_line=False)
            return self._repeat(count, lambda: self._traveller.backward_to(aim()))
        return self._repeat(count, lambda: self._forward(ToStatement(robot)))

    def finish(self, *, backward: bool = False) -> Stop:
        """Goes to where the function has returned, and tells what; or back to where it was called.

        Raises:
            DebugError: nobody has called it.
        """
        robot = self.robot
        frame = self.current_frame()
        callers = None if frame is None else self._traveller.calls(robot, frame.active)
        if frame is None or callers is None or not callers.functions:
            raise DebugError("the outermost function has no caller to go to")
        if backward:
            aim = BackAim(robot, callers, whole_line=False)
            return self._arrive(self._traveller.backward_to(aim))
        stop = self._go(ToCaller(robot, callers))
        if stop.reason != "step":
            return stop
        value = self._returned(frame)
        text = f"{frame.function} returned {value}" if value else ""
        self.stop = replace(stop, text=text)
        return self.stop

    def _returned(self, frame: Frame) -> str:
        """Gives what a call that has ended returned, if its last statement tells; else nothing."""
        here, robot = self.position, self.robot
        call = Calls.of([frame.active])
        spots = self._traveller.spots_back(robot, call.functions)
        value = ""
        with contextlib.suppress(DebugError, InterruptedRunError):
            last = next(filter(call.include, spots), None)
            if last is not None:
                lines = self.source(last.location.file)[last.location.line - 1 :][:_MOST_LINES]
                match = _RETURN.match(" ".join(lines)[last.location.column - 1 :])
                if match and self._traveller.to_statement(robot, last.statements):
                    value = self.evaluator(robot).evaluate(match[1]).value.text
                    self.evaluator(robot).undo()
        self.run.seek(here)
        return value

    def until(self) -> Stop:
        """Goes to the next line past calls that stands further down, so out of loops."""
        return self._arrive(self._next(onward=True))

    def advance(self, place: str) -> Stop:
        """Goes to a place, or to where the function has returned.

        Raises:
            DebugError: there is no such place.
        """
        robot = self.robot
        added = self.add_breakpoint(place, temporary=True, robot=robot)
        try:
            frame = self.current_frame()
            if frame is None:
                return self._go(None)
            return self._go(ToCaller(robot, self._traveller.calls(robot, frame.active)))
        finally:
            if added in list(self.breakpoints):
                self.breakpoints.remove(added.number)

    def tick(self, count: int = 1, *, backward: bool = False) -> Stop:
        """Goes to the end of the timestep, or back to its start."""
        position = self.position
        inside = position != Position(position.timestep, 0)
        if backward:
            return self.goto_timestep(max(0, position.timestep + inside - count))
        return self._go(None, Position(position.timestep + count, 0))

    def goto(self, target: Position) -> Stop:
        """Goes to an instant that the run has been at."""
        self.run.seek(target)
        return self._arrive(self._traveller.stop("beginning" if target == BEGINNING else "goto"))

    def goto_timestep(self, timestep: int) -> Stop:
        """Goes to the start of a timestep; breakpoints on the way do not count.

        Raises:
            DebugError: there is none before 0.
        """
        if timestep < 0:
            raise DebugError("time begins at 0")
        with self._showing_new():
            return self._to_timestep(timestep)

    def goto_time(self, time_s: float) -> Stop:
        """Goes to the start of the timestep that an instant lies in.

        Raises:
            DebugError: there is none before 0.
        """
        if not math.isfinite(time_s):
            raise DebugError(f"{time_s} is no time")
        timestep_s = self.session.environment.world.timestep_s
        return self.goto_timestep(math.floor(time_s / timestep_s + _SLACK_S))

    def goto_statement(self, number: int) -> Stop:
        """Goes to before a statement of the current robot's program, counted from 1.

        Raises:
            DebugError: the program has no such statement.
        """
        if number < 1:
            raise DebugError("statements are counted from 1")
        start = self.position
        try:
            with self._showing_new():
                is_there = self._traveller.to_statement(self.robot, number - 1)
        except InterruptedRunError:
            return self._arrive(self._traveller.stop("interrupt"))
        if not is_there:
            self.run.seek(start)
            raise DebugError(f"{self.names[self.robot]}'s program ends before statement {number}")
        return self._arrive(self._traveller.stop("goto", self.robot))

    def _to_timestep(self, timestep: int) -> Stop:
        target = Position(timestep, 0)
        if target <= max(self.position, self.run.history.latest()):
            return self.goto(target)
        return self._arrive(self._traveller.to_timestep(timestep))

    @contextlib.contextmanager
    def _showing_new(self) -> Iterator[None]:
        """Shows what programs write for the first time while the run goes where the user wants."""
        self.run.console.shows_new = True
        try:
            yield
        finally:
            self.run.console.shows_new = False

    def _spot(self) -> Spot | None:
        return self._traveller.spot(self.robot)

    def _next(self, *, onward: bool = False) -> Stop:
        calls = self._own_calls()
        spot = None if calls is None else self._spot()
        return self._forward(ToLine(self.robot, spot, calls, onward))

    def _next_back(self) -> Stop:
        return self._traveller.backward_to(BackAim(self.robot, self._own_calls()))

    def _own_calls(self) -> Calls | None:
        """Gives the active calls of the user's functions; None when there are none."""
        if all(each.is_library for each in self.frames()):
            return None
        return self._traveller.calls(self.robot)

    def _go(self, aim: Aim | None, until: Position | None = None) -> Stop:
        return self._arrive(self._forward(aim, until))

    def _forward(self, aim: Aim | None, until: Position | None = None) -> Stop:
        if aim is not None and self.run.is_over(aim.robot) and self.run.goes_on:
            raise DebugError(f"{self.names[aim.robot]}'s program has ended; others go on")
        self.run.console.is_live = True
        try:
            return self._traveller.forward(aim, until)
        finally:
            self.run.console.is_live = False

    def _repeat(self, count: int, move: Move) -> Stop:
        if not 1 <= count <= _MOST_STEPS:
            raise DebugError(f"a count is from 1 to {_MOST_STEPS:,}")
        for left in reversed(range(count)):
            stop = move()
            if stop.reason != "step":
                break
            if left and self.run.interrupted:  # between two moves nothing else would hear of it
                stop = self._traveller.stop("interrupt", self.robot)
                break
        return self._arrive(stop)

    def _arrive(self, stop: Stop) -> Stop:
        """Ends what the user asked for: lets him look at where the run has stopped."""
        self.stop = stop
        self.forget_interrupt()
        self._note(stop)
        if stop.robot >= 0:
            self.robot = stop.robot
        for number in stop.breakpoints:
            if self.breakpoints.get(number).temporary:
                self.breakpoints.remove(number)
        frames = (each for each in self.frames() if each.active.function == stop.function)
        about = next(frames, None)
        self.frame = self.first_own_frame() if about is None else about.number
        return stop

    def _note(self, stop: Stop) -> None:
        """Lets time lines show where the run stopped by itself."""
        if stop.breakpoints or stop.reason == "error":
            kind = "error" if stop.reason == "error" else "stop"
            happening = Happening(stop.time_s, kind, stop.robot, stop.why)
            self.run.chronicle.note(stop.position.timestep, happening)

    # -- changing ------------------------------------------------------------------------------

    def evaluate(self, text: str, *, robot: int | None = None, frame: int | None = None) -> Value:
        """Evaluates a C expression, which may change the program: then the run is another.

        Args:
            text: the expression.
            robot: whose program; by default that of the robot that the user looks at.
            frame: the number of the active function that it is looked at from; by default the one
                that the user looks at.

        Raises:
            DebugError: it means nothing there, or cannot be evaluated; then nothing has changed.
        """
        robot = self.robot if robot is None else robot
        found = self.evaluator(robot).evaluate(text, self._active(robot, frame))
        if found.changed:
            self._changed()
        return found.value

    def edit_world(self, text: str) -> str:
        """Changes the world, so that the run is another from here; gives what was done, in words.

        Args:
            text: what to do, see `edits.EDITS`.

        Raises:
            DebugError: it means nothing, or cannot be done; then nothing has changed.
        """
        done = edit(self.session.environment, text)
        self._changed()
        return done

    def _changed(self) -> None:
        """Lets the run go on from here as another one."""
        self.run.changed()
        self.branches.changed()

    # -- branches ------------------------------------------------------------------------------

    def checkpoint(self, name: str = "") -> Checkpoint:
        """Makes a checkpoint here."""
        return self.branches.keep(name, self.time_s)

    def restart(self, number: int) -> Stop:
        """Goes to a checkpoint.

        Raises:
            DebugError: there is no such one.
        """
        return self.goto(self.branches.checkpoint(number).position)

    def branch(self, name: str) -> Branch:
        """Goes on in a new branch that begins here; the one that was left stays as it is.

        Raises:
            DebugError: there is one of that name.
        """
        return self.branches.add(name)

    def switch(self, name: str) -> Stop:
        """Goes to where the user was in another branch.

        Raises:
            DebugError: there is no such one.
        """
        self.branches.switch(name)
        return self._arrive(self._traveller.stop("goto"))

    def compare(self, name: str) -> list[Difference]:
        """Compares this branch with another one, at the start of this timestep in both.

        The other one runs on if it has not come so far.

        Raises:
            DebugError: there is no such one, or it ends before.
        """
        own, here = self.branches.current.name, self.position
        looked_at = self.robot, self.frame, self.stop
        self.goto_timestep(here.timestep)
        facts_here = facts(self)
        try:
            self.branches.switch(name)
            there = self.position
            self._to_timestep(here.timestep)  # showing nothing: it is taken back again
            reached, facts_there = self.position.timestep, facts(self)
            self.run.seek(there)
        finally:
            self.branches.switch(own)
            self.run.seek(here)
            self.robot, self.frame, self.stop = looked_at
        if reached != here.timestep:
            raise DebugError(f"branch '{name}' has ended, or was interrupted, before this timestep")
        return differences(facts_here, facts_there)
