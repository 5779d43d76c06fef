"""The calls of a line that a step can enter."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from crs_cc.core.source import Location
from crs_cc.debug.engine import Debugger
from crs_cc.debug.step_conditions import ActiveCalls, ProgramPoint, StepToLine
from crs_cc.debug.stop import Stop
from crs_cc.ir.instruction import Call
from crs_cc.ir.names import in_library
from crs_cc.runtime.diagnosis.inspect import StackFrame


@dataclass(frozen=True, slots=True)
class CallSite:
    """A call in the source of a program.

    Attributes:
        function: the function that is called.
        location: the location of the call.
    """

    function: str
    location: Location


def call_sites(debugger: Debugger) -> list[CallSite]:
    """Return the calls of the user's functions in the current line, from left to right.

    Calls through pointers are left out: what they call is known only when they are made.
    """
    view = debugger.view
    frame = next(iter(view.frames()), None)
    if frame is None or frame.is_library or debugger.run.has_failed(view.robot):
        return []
    functions = debugger.run.programs[view.robot].executable.program.functions
    here = frame.location.file, frame.location.line
    found = {
        CallSite(each.callee, each.location)
        for each in (block.terminator for block in functions[frame.active.function].blocks)
        if isinstance(each, Call) and isinstance(each.callee, str) and each.callee in functions
        if (each.location.file, each.location.line) == here
        if not in_library(functions[each.callee].location)
    }
    return sorted(found, key=lambda each: (each.location.column, each.function))


def step_into(debugger: Debugger, call: CallSite) -> Stop:
    """Step into one of the `call_sites`; like `next` if the line ends without that call."""
    robot, run, navigator = debugger.view.robot, debugger.run, debugger.navigator
    frame = debugger.view.frames()[0].active
    line = StepToLine(robot, navigator.program_point(robot), navigator.calls(robot))
    caller, stack = (frame.fp, frame.entered), lambda: run.stopped(robot).stack
    return debugger.run_to(StepIntoCall(robot, call, caller, stack, line))


@dataclass(slots=True)
class StepIntoCall:
    """The first statement of one call of a line; if the call is not made, the line after it.

    Attributes:
        call: the call.
        caller: address of the caller's frame, and how many sites had been passed at its call.
        stack: returns the calls of the program, the innermost first.
        otherwise: where `next` would end.
    """

    robot: int
    call: CallSite
    caller: tuple[int, int]
    stack: Callable[[], Sequence[StackFrame]]
    otherwise: StepToLine
    calls: ActiveCalls | None = None
    after_calls: bool = False
    by_lines: bool = False

    def reached(self, program_point: ProgramPoint) -> bool:
        """Return whether a statement is the first of the call, or starts a line after it."""
        if program_point.function == self.call.function:
            _, *callers = self.stack()
            for caller in callers[:1]:
                if (caller.fp, caller.entered) == self.caller:
                    return caller.location == self.call.location
        return self.otherwise.reached(program_point)
