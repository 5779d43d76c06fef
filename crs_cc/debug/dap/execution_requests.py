"""Requests that move the run: forward, backward, and to a line."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Final

from crs_cc.debug.call_sites import CallSite, call_sites, step_into
from crs_cc.debug.dap.arguments import Arguments, RefusalError
from crs_cc.debug.dap.framing import Message
from crs_cc.debug.dap.session import EditorSession, Execution
from crs_cc.debug.dap.stop_events import report_end
from crs_cc.debug.dap.value_messages import requested_frame
from crs_cc.debug.engine import Debugger
from crs_cc.debug.locations import find_location
from crs_cc.debug.stop import Stop
from crs_cc.ir.names import plain_name

_GRANULARITIES: Final = ("statement", "line", "instruction")


def continue_(session: EditorSession, _arguments: Arguments) -> Message:
    """Continue to the next stop; at the end of the run, end the session."""
    debugger = session.require_stopped()
    if debugger.view.is_over:
        session.after_response = partial(report_end, session)
    else:
        session.execution = Execution(debugger.resume, go_on=debugger.resume)
    return {"allThreadsContinued": True}


def reverse_continue(session: EditorSession, _arguments: Arguments) -> None:
    """Continue backward to the previous stop."""
    session.execution = Execution(partial(session.require_stopped().resume, backward=True))


def next_(session: EditorSession, arguments: Arguments) -> None:
    """Step to the next line, over calls."""
    _step(session, arguments, Debugger.next)


def step_in(session: EditorSession, arguments: Arguments) -> None:
    """Step to the next line, entering calls; or into one of the calls of the line."""
    number = arguments.integer("targetId", 0)
    if not number:
        _step(session, arguments, Debugger.step)
        return
    call = session.handles.get(number)
    if not isinstance(call, CallSite):
        raise RefusalError("unknown 'targetId'")
    session.execution = Execution(partial(step_into, _select_robot(session, arguments), call))


def step_in_targets(session: EditorSession, arguments: Arguments) -> Message:
    """Return the calls of the current line that can be entered; none for frames of callers."""
    debugger = session.require_stopped()
    frame = requested_frame(session, arguments)
    debugger.view.select_robot(frame.robot)
    if frame.frame:
        return {"targets": []}
    targets = []
    for call in call_sites(debugger):
        place, line = call.location, debugger.view.source(call.location.file)
        text = line[place.line - 1][place.column - 1 : place.last] if place.last else ""
        targets.append(
            {
                "id": session.handles.add(call),
                "label": text or f"{plain_name(call.function)}()",
                "line": session.locations.line(place.line),
            }
        )
    return {"targets": targets}


def step_back(session: EditorSession, arguments: Arguments) -> None:
    """Step back to the previous line, over calls."""
    _step(session, arguments, Debugger.next, backward=True)


def _step(
    session: EditorSession,
    arguments: Arguments,
    by_line: Callable[..., Stop],
    *,
    backward: bool = False,
) -> None:
    """Take a step. The finest granularity is a statement; it is used for instructions."""
    granularity = arguments.text("granularity", "statement")
    if granularity not in _GRANULARITIES:
        raise RefusalError(f"'granularity' must be {', '.join(_GRANULARITIES)}")
    debugger = _select_robot(session, arguments)
    move = Debugger.step_statement if granularity == "instruction" else by_line
    session.execution = Execution(partial(move, debugger, backward=backward))


def step_out(session: EditorSession, arguments: Arguments) -> None:
    """Run until the function returns."""
    session.execution = Execution(_select_robot(session, arguments).finish)


def _select_robot(session: EditorSession, arguments: Arguments) -> Debugger:
    """Select the robot of a request."""
    debugger = session.require_stopped()
    debugger.view.select_robot(session.robot(arguments))
    return debugger


def pause(session: EditorSession, _arguments: Arguments) -> None:
    """Interrupt the programs if they run."""
    session.require_debugger()
    session.paused = session.is_running


def cancel(session: EditorSession, _arguments: Arguments) -> None:
    """Interrupt the programs: the client has cancelled the move that is in progress."""
    session.paused = session.is_running


@dataclass(frozen=True, slots=True)
class _GotoTarget:
    """A visit of a line: the next one, or the previous one."""

    place: str
    backward: bool


def goto_targets(session: EditorSession, arguments: Arguments) -> Message:
    """Return the visits that a line can mean; no statement is ever skipped to get there."""
    debugger = session.require_stopped()
    key = session.locations.key(arguments.object("source"))
    file = session.locations.file_at(key)
    if file is None:
        raise RefusalError("no program of this run was built from this file")
    line = session.locations.to_line(arguments.natural("line"))
    robots = range(len(debugger.names))
    place = find_location(f"{file}:{line}", debugger.run.programs, robots, file)
    assert place.location is not None
    targets = []
    for backward, label in ((False, "the next time it gets here"), (True, "the last time it did")):
        number = session.handles.add(_GotoTarget(f"{file}:{line}", backward))
        at = session.locations.line(place.location.line)
        targets.append({"id": number, "label": label, "line": at})
    return {"targets": targets}


def goto(session: EditorSession, arguments: Arguments) -> None:
    """Run to a visit of a line."""
    debugger = _select_robot(session, arguments)
    visit = session.handles.get(arguments.integer("targetId"))
    if not isinstance(visit, _GotoTarget):
        raise RefusalError("unknown 'targetId'")
    session.execution = Execution(partial(_visit, debugger, debugger.view.robot, visit))


def _visit(debugger: Debugger, robot: int, visit: _GotoTarget) -> Stop:
    made = debugger.stop_points.add_breakpoint(visit.place, temporary=True, robot=robot)
    try:
        stop = debugger.resume(backward=visit.backward)
    finally:
        if made in list(debugger.stop_points.breakpoints):  # it was not what stopped the run
            debugger.stop_points.remove(made.number)
    return replace(stop, reason="goto") if made.number in stop.breakpoints else stop


def restart_frame(_session: EditorSession, _arguments: Arguments) -> None:
    """Refuse: restarting a frame would leave its side effects; going back undoes them."""
    raise RefusalError("'restartFrame' is not supported: step back to the call instead")
