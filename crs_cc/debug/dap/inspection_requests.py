"""Requests about the state: robots as threads, stack frames, scopes, exceptions."""

from __future__ import annotations

from typing import TYPE_CHECKING

from crs_cc.debug.dap.arguments import Arguments, RefusalError
from crs_cc.debug.dap.disassembly import address_of
from crs_cc.debug.dap.framing import Message
from crs_cc.debug.dap.locations import NO_PLACE
from crs_cc.debug.dap.session import EditorSession
from crs_cc.debug.dap.stop_events import thread_of
from crs_cc.debug.dap.value_messages import FrameHandle, requested_frame
from crs_cc.debug.dap.variables import scopes_at
from crs_cc.debug.view import BacktraceFrame
from crs_cc.debug.world.robot_rows import activity

if TYPE_CHECKING:
    from crs_cc.runtime.diagnosis.report import ErrorReport


def threads(session: EditorSession, _arguments: Arguments) -> Message:
    """Return the robots."""
    names = session.debugger.names if session.debugger else ()
    return {"threads": [{"id": thread_of(robot), "name": name} for robot, name in enumerate(names)]}


def stack_trace(session: EditorSession, arguments: Arguments) -> Message:
    """Return the stack frames of a robot's program; without one, its activity."""
    debugger, robot = session.require_debugger(), session.robot(arguments)
    frames = debugger.view.frames(robot)
    if not frames:
        label = {
            "id": session.handles.add(FrameHandle(robot)),
            "name": activity(debugger.session, robot),
            "presentationHint": "label",
        }
        return {"stackFrames": [label | NO_PLACE], "totalFrames": 1}
    start, levels = arguments.natural("startFrame", 0), arguments.natural("levels", 0)
    shown = frames[start : start + levels] if levels else frames[start:]
    places = {(each.active.function, each.location) for each in shown}  # few, in a recursion
    program = debugger.run.programs[robot]
    addresses = {place: address_of(program, robot, *place) for place in places}
    return {
        "stackFrames": [
            _frame(session, robot, each, addresses[each.active.function, each.location])
            for each in shown
        ],
        "totalFrames": len(frames),
    }


def _frame(session: EditorSession, robot: int, frame: BacktraceFrame, address: int) -> Message:
    handle = FrameHandle(robot, frame.number, frame.function)
    return {
        "id": session.handles.add(handle),
        "name": frame.function,
        "instructionPointerReference": f"{address:#x}",
        "presentationHint": "subtle" if frame.is_library else "normal",
        "canRestart": False,
        **session.locations.location(frame.location),
    }


def scopes(session: EditorSession, arguments: Arguments) -> Message:
    """Return the scopes of a stack frame."""
    session.require_stopped()
    arguments.integer("frameId")
    return {"scopes": list(scopes_at(session, requested_frame(session, arguments)))}


def exception_info(session: EditorSession, arguments: Arguments) -> Message:
    """Return details of the error or event at which a program has stopped."""
    debugger, robot = session.require_stopped(), session.robot(arguments)
    stop = debugger.stop
    if debugger.run.has_failed(robot):
        return _failure(debugger.session.fleet.report(robot))
    if stop.reason != "catchpoint" or robot != max(stop.robot, 0):
        raise RefusalError("no exception to report for this robot")
    kind = session.breakpoints.event_kind(stop.breakpoints)
    return {"exceptionId": kind, "description": stop.text, "breakMode": "always"}


def _failure(report: ErrorReport) -> Message:
    values = ", ".join(f"{name} = {value}" for name, value in report.values)
    description = "\n".join(row for row in (report.text, values, *report.notes) if row)
    return {"exceptionId": report.kind, "description": description, "breakMode": "always"}
