"""Requests for breakpoints."""

from __future__ import annotations

from typing import Final

from crs_cc.debug.dap.arguments import Arguments, RefusalError
from crs_cc.debug.dap.breakpoints import ACCESS, RequestedBreakpoint, data_id
from crs_cc.debug.dap.framing import Message
from crs_cc.debug.dap.session import EditorSession
from crs_cc.debug.dap.value_messages import FrameHandle, requested_frame
from crs_cc.debug.dap.variables import expression_of
from crs_cc.debug.errors import DebugError
from crs_cc.debug.world.events import KINDS

_TOO_FINE: Final = frozenset({"tick", "bumper-pressed", "bumper-released"})

FILTERS: Final[list[Message]] = [
    {
        "filter": kind,
        "label": kind.replace("-", " ").capitalize(),
        "description": f"Stop when {meaning}.",
        "default": False,
        "supportsCondition": True,
        "conditionDescription": "a C expression in the robot's program",
    }
    for kind, meaning in {"exit": "a program has ended", **KINDS}.items()
    if kind not in _TOO_FINE
]
"""What else can stop a run, as a client offers it. Run-time errors always do."""


def set_breakpoints(session: EditorSession, arguments: Arguments) -> Message:
    """Set the line breakpoints of a file."""
    file = session.locations.key(arguments.object("source"))
    requests = [
        RequestedBreakpoint(
            "line",
            file,
            session.locations.to_line(each.natural("line")),
            condition=each.text("condition", ""),
            hits=each.text("hitCondition", ""),
            log=each.text("logMessage", ""),
        )
        for each in arguments.objects("breakpoints")
    ]
    return {"breakpoints": session.breakpoints.replace(("line", file), requests)}


def set_function_breakpoints(session: EditorSession, arguments: Arguments) -> Message:
    """Set the function breakpoints: functions of the program or of the robot."""
    requests = [
        RequestedBreakpoint(
            "function",
            each.text("name"),
            condition=each.text("condition", ""),
            hits=each.text("hitCondition", ""),
        )
        for each in arguments.objects("breakpoints")
    ]
    return {"breakpoints": session.breakpoints.replace(("function", ""), requests)}


def set_exception_breakpoints(session: EditorSession, arguments: Arguments) -> Message:
    """Set the catchpoints."""
    requests = [RequestedBreakpoint("exception", kind) for kind in arguments.texts("filters")]
    requests += [
        RequestedBreakpoint(
            "exception", each.text("filterId"), condition=each.text("condition", "")
        )
        for each in arguments.objects("filterOptions")
    ]
    return {"breakpoints": session.breakpoints.replace(("exception", ""), requests)}


def data_breakpoint_info(session: EditorSession, arguments: Arguments) -> Message:
    """Return whether an object can be watched, and its data ID."""
    try:
        at, expression = _watch_target(session, arguments)
        _require_object(session, at, expression)
    except (RefusalError, DebugError) as error:
        return {"dataId": None, "description": str(error)}
    return {
        "dataId": data_id(at.robot, at.function, expression),
        "description": expression,
        "accessTypes": list(ACCESS),
        "canPersist": False,
    }


def set_data_breakpoints(session: EditorSession, arguments: Arguments) -> Message:
    """Set the watchpoints."""
    requests = [
        RequestedBreakpoint(
            "data",
            each.text("dataId"),
            access=each.text("accessType", "write"),
            condition=each.text("condition", ""),
            hits=each.text("hitCondition", ""),
        )
        for each in arguments.objects("breakpoints")
    ]
    if any(each.access not in ACCESS for each in requests):
        raise RefusalError(f"'accessType' must be {', '.join(ACCESS)}")
    return {"breakpoints": session.breakpoints.replace(("data", ""), requests)}


def _watch_target(session: EditorSession, arguments: Arguments) -> tuple[FrameHandle, str]:
    """Return the C expression to watch, and its scope; raise RefusalError if it is invalid."""
    if "variablesReference" in arguments and arguments.integer("variablesReference"):
        return expression_of(session, arguments)
    return requested_frame(session, arguments), arguments.text("name")


def _require_object(session: EditorSession, at: FrameHandle, expression: str) -> None:
    """Check that an expression names an object in memory; raise DebugError if it does not."""
    debugger = session.require_stopped()
    active = None if at.frame is None else debugger.view.frames(at.robot)[at.frame].active
    debugger.view.evaluator(at.robot).place(expression, active)
