"""Requests that say where to stop."""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

from crs_cc.debug.dap.breakpoints import Wish
from crs_cc.debug.happenings import KINDS

if TYPE_CHECKING:
    from crs_cc.debug.dap.arguments import Arguments
    from crs_cc.debug.dap.framing import Message
    from crs_cc.debug.dap.session import EditorSession

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
    """Stops at lines of a file."""
    file = session.places.key(arguments.object("source"))
    wishes = [
        Wish(
            "line",
            file,
            session.places.our_line(each.natural("line")),
            condition=each.text("condition", ""),
            hits=each.text("hitCondition", ""),
            log=each.text("logMessage", ""),
        )
        for each in arguments.objects("breakpoints")
    ]
    return {"breakpoints": session.breakpoints.replace(session, ("line", file), wishes)}


def set_function_breakpoints(session: EditorSession, arguments: Arguments) -> Message:
    """Stops at functions: the program's, or the robot's."""
    wishes = [
        Wish(
            "function",
            each.text("name"),
            condition=each.text("condition", ""),
            hits=each.text("hitCondition", ""),
        )
        for each in arguments.objects("breakpoints")
    ]
    return {"breakpoints": session.breakpoints.replace(session, ("function", ""), wishes)}


def set_exception_breakpoints(session: EditorSession, arguments: Arguments) -> Message:
    """Stops at kinds of happenings."""
    wishes = [Wish("exception", kind) for kind in arguments.texts("filters")]
    wishes += [
        Wish("exception", each.text("filterId"), condition=each.text("condition", ""))
        for each in arguments.objects("filterOptions")
    ]
    return {"breakpoints": session.breakpoints.replace(session, ("exception", ""), wishes)}
