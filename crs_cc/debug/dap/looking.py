"""Requests that look: robots as threads, active functions, scopes, and what stands in these."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from crs_cc.debug.dap.arguments import RefusalError
from crs_cc.debug.dap.listing import address_of
from crs_cc.debug.dap.places import NO_PLACE
from crs_cc.debug.dap.stops import thread_of
from crs_cc.debug.robot_rows import activity, robot_rows
from crs_cc.debug.world_rows import world_rows

if TYPE_CHECKING:
    from crs_cc.debug.dap.arguments import Arguments
    from crs_cc.debug.dap.framing import Message
    from crs_cc.debug.dap.session import EditorSession
    from crs_cc.debug.rows import Row
    from crs_cc.debug.view import Frame


@dataclass(frozen=True, slots=True)
class FrameHandle:
    """An active function of a robot's program.

    Attributes:
        robot: the robot's number.
        frame: the function's; None for a program without one.
        function: its name; empty without one.
    """

    robot: int
    frame: int | None = None
    function: str = ""


@dataclass(frozen=True, slots=True)
class Rows:
    """Rows of text."""

    rows: Sequence[Row]


def threads(session: EditorSession, _arguments: Arguments) -> Message:
    """Gives the robots."""
    names = session.debugger.names if session.debugger else ()
    return {"threads": [{"id": thread_of(robot), "name": name} for robot, name in enumerate(names)]}


def stack_trace(session: EditorSession, arguments: Arguments) -> Message:
    """Gives the active functions of a robot's program; without one, what it does instead."""
    debugger, robot = session.opened(), session.robot(arguments)
    frames = debugger.frames(robot)
    if not frames:
        label = {
            "id": session.handles.give(FrameHandle(robot)),
            "name": activity(debugger.session, robot),
            "presentationHint": "label",
        }
        return {"stackFrames": [label | NO_PLACE], "totalFrames": 1}
    start, levels = arguments.natural("startFrame", 0), arguments.natural("levels", 0)
    shown = frames[start : start + levels] if levels else frames[start:]
    return {
        "stackFrames": [_frame(session, robot, frame) for frame in shown],
        "totalFrames": len(frames),
    }


def _frame(session: EditorSession, robot: int, frame: Frame) -> Message:
    handle = FrameHandle(robot, frame.number, frame.function)
    program = session.opened().run.programs[robot]
    address = address_of(program, robot, frame.active.function, frame.location)
    return {
        "id": session.handles.give(handle),
        "name": frame.function,
        "instructionPointerReference": f"{address:#x}",
        "presentationHint": "subtle" if frame.is_library else "normal",
        "canRestart": False,
        **session.places.place(frame.location),
    }


def scopes(session: EditorSession, arguments: Arguments) -> Message:
    """Gives what can be looked at from an active function."""
    frame = frame_handle(session, arguments)
    environment = session.opened().session.environment
    made: list[tuple[str, Any]] = [
        ("Robot", Rows(robot_rows(session.opened().session, frame.robot))),
        ("World", Rows(world_rows(environment))),
    ]
    return {
        "scopes": [
            {"name": name, "variablesReference": session.handles.give(of), "expensive": False}
            for name, of in made
        ]
    }


def variables(session: EditorSession, arguments: Arguments) -> Message:
    """Gives what stands in a scope, or the parts of something that stands there."""
    thing = session.handles.take(arguments.integer("variablesReference"))
    if isinstance(thing, Rows):
        return {"variables": [_row(session, row) for row in thing.rows]}
    raise RefusalError("'variablesReference' is that of nothing with parts")


def _row(session: EditorSession, row: Row) -> Message:
    parts = session.handles.give(Rows(row.children)) if row.children else 0
    return {
        "name": row.name,
        "value": row.text,
        "variablesReference": parts,
        "presentationHint": {"attributes": ["readOnly"]},
    }


def frame_handle(session: EditorSession, arguments: Arguments) -> FrameHandle:
    """Gives the active function that a request means.

    Raises:
        RefusalError: it is gone.
    """
    found = session.handles.take(arguments.integer("frameId"))
    if not isinstance(found, FrameHandle):
        raise RefusalError("'frameId' is that of no frame")
    return found
