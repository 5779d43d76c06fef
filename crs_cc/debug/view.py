"""The selected robot and stack frame of a stopped run."""

from __future__ import annotations

import contextlib
import functools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from crs_cc.core.source import Location
from crs_cc.core.suggest import unknown
from crs_cc.debug.data.evaluate import Evaluator
from crs_cc.debug.data.expression_compiler import SourceNames
from crs_cc.debug.data.memory_inspection import FULL
from crs_cc.debug.data.scope import Storage
from crs_cc.debug.data.values import Value
from crs_cc.debug.data.variables import Variable
from crs_cc.debug.errors import DebugError
from crs_cc.debug.run_values import RunValues
from crs_cc.debug.timeline.position import Position
from crs_cc.debug.timeline.recorded_run import RecordedRun
from crs_cc.debug.world.state_fields import StateField, state_fields
from crs_cc.frontend.expression import FileNames
from crs_cc.ir.names import in_library, plain_name
from crs_cc.ir.types import CType
from crs_cc.runtime.diagnosis.inspect import StackFrame, StoppedProgram
from crs_cc.session.session import Session


@dataclass(frozen=True, slots=True)
class BacktraceFrame:
    """A stack frame as the user sees it.

    Attributes:
        number: 0 for the innermost.
        function: its name.
        location: its current location.
        is_library: whether it belongs to the C library, whose source is not shown.
        active: the frame of the running program.
    """

    number: int
    function: str
    location: Location
    is_library: bool
    active: StackFrame


class View:
    """A stopped run, seen from a selected robot and frame.

    Attributes:
        robot: the selected robot.
        frame: the number of the selected frame.
        convenience_values: the values of `$name` by name; that of `$` has an empty name.
        full_style: how values are written at length.
        settings: the values of the settings of the debugger by name, for expressions.
    """

    def __init__(self, run: RecordedRun) -> None:
        """Select the first robot."""
        self.run = run
        self.robot = 0
        self.frame = 0
        self.convenience_values: dict[str, Value] = {}
        self.full_style = FULL
        self.settings: Mapping[str, int] = {}
        self._seen: tuple[StoppedProgram, list[BacktraceFrame]] | None = None
        self._names: dict[int, SourceNames] = {}
        self._evaluators: dict[tuple[int, int], Evaluator] = {}

    @property
    def session(self) -> Session:
        """The session; read only."""
        return self.run.session

    @property
    def names(self) -> tuple[str, ...]:
        """The robots' names, by number."""
        return tuple(robot.id for robot in self.session.environment.world.robots)

    @property
    def position(self) -> Position:
        """The position of the run."""
        return self.run.position

    @property
    def time_s(self) -> float:
        """The clock of the selected robot's program, or the world's if that does not run [s]."""
        return self.run.time_s(self.robot)

    @property
    def is_over(self) -> bool:
        """Whether no program is left."""
        return not self.run.can_advance

    def frames(self, robot: int | None = None) -> list[BacktraceFrame]:
        """Return the stack frames of a program, innermost first."""
        robot = self.robot if robot is None else robot
        if not self.session.state.alive[robot] and not self.run.has_failed(robot):
            return []
        stopped = self.run.stopped(robot)
        if self._seen is None or self._seen[0] is not stopped:
            self._seen = stopped, self._frames(robot, stopped)
        return self._seen[1]

    def _frames(self, robot: int, stopped: StoppedProgram) -> list[BacktraceFrame]:
        site = self.run.site(robot)
        frames: list[BacktraceFrame] = []
        for active in stopped.stack:
            location, is_library = active.location, in_library(active.location)
            if site is not None and not frames:
                location = site.location
            name = plain_name(active.function)
            frames.append(BacktraceFrame(len(frames), name, location, is_library, active))
        while frames and frames[-1].is_library:
            frames.pop()
        return frames

    def current_frame(self) -> BacktraceFrame | None:
        """Return the selected frame; None if there is none."""
        frames = self.frames()
        return frames[self.frame] if self.frame < len(frames) else None

    def location(self) -> Location | None:
        """Return the location of the selected frame; None without source."""
        frame = self.current_frame()
        return None if frame is None or frame.is_library else frame.location

    def current_file(self, robot: int | None = None) -> str:
        """Return the current file, or the first one of a robot's program."""
        here = self.location()
        robot = self.robot if robot is None else robot
        return here.file if here else next(iter(self.run.programs[robot].files))

    def source(self, file: str) -> Sequence[str]:
        """Return the lines of a C file; none if it is not the user's."""
        for program in self.run.programs:
            lines = program.executable.detail().lines
            if file in lines:
                return lines[file]
        return ()

    def select_robot(self, robot: int | str) -> None:
        """Select a robot by number or name; raise DebugError if it does not exist."""
        names = self.names
        number = names.index(robot) if robot in names else robot
        if not isinstance(number, int) or not 0 <= number < len(names):
            raise DebugError(unknown("robot", str(robot), names))
        self.robot = number
        self.frame = self.first_own_frame()

    def select_frame(self, number: int) -> None:
        """Select a frame by number; raise DebugError if it does not exist."""
        if not 0 <= number < len(self.frames()):
            raise DebugError(f"no frame {number}")
        self.frame = number

    def select_function(self, function: str) -> None:
        """Select the innermost frame of a function, if it is active.

        Args:
            function: the function, by the linker's name.
        """
        frames = (each for each in self.frames() if each.active.function == function)
        self.frame = next((each.number for each in frames), self.frame)

    def active_frame(self, robot: int, frame: int | None = None) -> StackFrame | None:
        """Return a frame by number; by default the selected one."""
        frames = self.frames(robot)
        if frame is None:
            frame = self.frame if robot == self.robot else self.first_own_frame(robot)
        if not frames:
            return None
        if not 0 <= frame < len(frames):
            raise DebugError(f"no frame {frame}")
        return frames[frame].active

    def first_own_frame(self, robot: int | None = None) -> int:
        """Return the number of the innermost frame of the user's own code."""
        frames = self.frames(robot)
        return next((each.number for each in frames if not each.is_library), 0)

    def evaluate_pure(
        self, text: str, *, robot: int | None = None, frame: int | None = None
    ) -> Value:
        """Evaluate a C expression without side effects.

        Raises:
            DebugError: it is invalid here, cannot be evaluated, or has side effects.
        """
        robot = self.robot if robot is None else robot
        evaluator = self.evaluator(robot)
        found = evaluator.evaluate(text, self.active_frame(robot, frame))
        if found.changed:
            evaluator.undo()
            raise DebugError(f"'{text}' would change the program")
        return found.value

    def variables(self, *, robot: int | None = None, frame: int | None = None) -> list[Variable]:
        """Return the variables of a frame, those of the innermost block first."""
        robot = self.robot if robot is None else robot
        active = self.active_frame(robot, frame)
        return [] if active is None else self.evaluator(robot).variables(active)

    def globals_(self, *, robot: int | None = None) -> list[Variable]:
        """Return the global variables of a program, sorted by name."""
        return self.evaluator(self.robot if robot is None else robot).globals_()

    def vendor_state(self, robot: int | None = None) -> list[tuple[StateField, Value]]:
        """Return the vendor's `State[]` as the program has it; empty if it has none."""
        return self.evaluator(self.robot if robot is None else robot).inspector().vendor_state()

    def type_of(self, text: str) -> CType:
        """Return the type of an expression, or the type that it names.

        Raises:
            DebugError: it is neither an expression nor a type here.
        """
        evaluator, frame = self.evaluator(self.robot), self.active_frame(self.robot, None)
        try:
            return evaluator.type_of(text, frame)
        except DebugError:
            with contextlib.suppress(DebugError):
                return evaluator.type_of(f"*(__typeof__({text}) *)0", frame)
            raise

    def file_names(self) -> FileNames:
        """Return the names of the selected frame's file.

        Raises:
            DebugError: the file has changed since the program was built.
        """
        program, frame = self.run.programs[self.robot], self.active_frame(self.robot)
        names = self._names.setdefault(id(program), SourceNames(program))
        return names.of("" if frame is None else frame.function, self.current_file())

    def names_in(self, robot: int, function: str, file: str) -> FileNames:
        """Return the names of the file of a function of a robot's program.

        Raises:
            DebugError: the file has changed since the program was built.
        """
        program = self.run.programs[robot]
        return self._names.setdefault(id(program), SourceNames(program)).of(function, file)

    def declared_at(self, function: str, place: Location) -> list[Storage]:
        """Return the variables of a function that are visible at a place, the innermost first."""
        return self.evaluator(self.robot).declared_at(function, place)

    def holds(self, condition: str, robot: int) -> bool:
        """Return whether a condition is true in the innermost frame of a program.

        Raises:
            DebugError: it is invalid there or cannot be evaluated.
        """
        return self.evaluator(robot).holds(condition)

    def evaluator(self, robot: int) -> Evaluator:
        """Return the evaluator of a robot's program."""
        program = self.run.programs[robot]
        build = id(self.session.fleet.executable(robot))
        if (robot, build) not in self._evaluators:
            names = self._names.setdefault(id(program), SourceNames(program))
            run = self.run
            stopped = functools.partial(run.stopped, robot)
            drive = self.session.environment.world.robots[robot].model.drive
            fields = state_fields(program.options.dialect, synchro=drive.steering is not None)
            made = Evaluator(
                stopped,
                names,
                self.convenience_values,
                fields,
                edits=lambda: run.history.unused_edits(robot, run.position),
                robot=robot,
            )
            self._evaluators[robot, build] = made
        found = self._evaluators[robot, build]
        found.full_style = self.full_style
        found.settings = self.settings
        return found.seeing(RunValues(self, robot))
