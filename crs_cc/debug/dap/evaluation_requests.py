"""Requests with C expressions, and with commands of the debugger."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import partial
from typing import Final

from crs_cc.debug.commands.completion import complete
from crs_cc.debug.dap.arguments import Arguments
from crs_cc.debug.dap.framing import Message
from crs_cc.debug.dap.session import EditorSession
from crs_cc.debug.dap.stop_events import report_moved, report_stop
from crs_cc.debug.dap.value_messages import FrameHandle, requested_frame, value_message
from crs_cc.debug.dap.variables import expression_of
from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.debug.stop import Stop

_MAX_COMPLETIONS: Final = 1000  # chosen by us
_WORD: Final = re.compile(r"(?<![\w.>])[A-Za-z_]\w*$")
"""A name that is being written, and none of a member."""


def evaluate(session: EditorSession, arguments: Arguments) -> Message:
    """Evaluate an expression, or in the console execute a command.

    Watch and hover expressions must have no side effects; in the console they may. There a
    line is an expression if it is valid as one, else a command: with a variable `n`
    `n` is its value, and the command must be written `next`.
    """
    debugger, at = session.require_stopped(), requested_frame(session, arguments)
    text, context = arguments.text("expression"), arguments.text("context", "watch")
    if context != "repl":
        value = debugger.view.evaluate_pure(text, robot=at.robot, frame=at.frame)
        line = value.full if context == "clipboard" else value.text
        return value_message(session, value, text, at, text=line, key="result")
    _select_frame(debugger, at)
    assert session.shell is not None
    if session.shell.is_collecting or not _is_expression(debugger, at, text):
        return _command(session, text)
    value = debugger.evaluate(text, robot=at.robot, frame=at.frame)
    session.after_response = session.report_invalidated
    return value_message(session, value, text, at, text=value.full, key="result")


def _select_frame(debugger: Debugger, at: FrameHandle) -> None:
    debugger.view.select_robot(at.robot)
    if at.frame is not None:
        debugger.view.select_frame(at.frame)


def _is_expression(debugger: Debugger, at: FrameHandle, text: str) -> bool:
    """Return whether a text is a valid expression."""
    frame = debugger.view.current_frame()
    if frame is None:
        return False
    try:
        debugger.view.evaluator(at.robot).check(text, frame.active.function, frame.location)
    except DebugError:
        return False
    return True


def _command(session: EditorSession, text: str) -> Message:
    """Execute commands; report a stop if the run has moved."""
    debugger, shell = session.require_debugger(), session.shell
    assert shell is not None
    before = debugger.stop
    with session.interruptible(by_all=False):
        said = "\n".join(each.text for line in text.splitlines() for each in shell.execute(line))
    if shell.has_ended:
        session.close()
        session.after_response = partial(session.connection.event, "terminated")
    elif debugger.stop is not before:
        session.handles.clear()
        session.output.flush()
        session.after_response = partial(_report_move, session, debugger.stop)
    else:
        session.breakpoints.synchronize(session.require_debugger())
        session.after_response = session.report_invalidated
    return {"result": said, "variablesReference": 0}


def _report_move(session: EditorSession, stop: Stop) -> None:
    report_moved(session)
    report_stop(session, stop)


def set_variable(session: EditorSession, arguments: Arguments) -> Message:
    """Set a variable of a scope, or a part of a value."""
    session.require_stopped()
    at, expression = expression_of(session, arguments)
    return _assign(session, at, expression, arguments.text("value"))


def set_expression(session: EditorSession, arguments: Arguments) -> Message:
    """Set the object that an expression names."""
    session.require_stopped()
    at = requested_frame(session, arguments)
    return _assign(session, at, arguments.text("expression"), arguments.text("value"))


def _assign(session: EditorSession, at: FrameHandle, expression: str, value: str) -> Message:
    debugger = session.require_debugger()
    debugger.evaluate(f"({expression}) = ({value})", robot=at.robot, frame=at.frame)
    now = debugger.view.evaluate_pure(expression, robot=at.robot, frame=at.frame)
    session.after_response = session.report_invalidated
    body = value_message(session, now, expression, at)
    del body["evaluateName"]
    return body


def completions(session: EditorSession, arguments: Arguments) -> Message:
    """Return the completions of a line in the console."""
    debugger, at = session.require_stopped(), requested_frame(session, arguments)
    assert session.shell is not None
    _select_frame(debugger, at)
    end = session.locations.to_column(arguments.natural("column")) - 1
    text = arguments.text("text")[: max(end, 0)]
    found = complete(session.shell.context, text)
    words = dict.fromkeys((word, found.start) for word in found.words)
    words |= dict.fromkeys(_names(debugger, at, text))
    items = [
        {
            "label": word,
            "start": session.locations.column(start + 1),
            "length": len(text) - start,
        }
        for word, start in list(words)[:_MAX_COMPLETIONS]
    ]
    return {"targets": items}


def _names(debugger: Debugger, at: FrameHandle, text: str) -> Iterator[tuple[str, int]]:
    """Return the variables that complete an expression, and where its last word starts."""
    word = _WORD.search(text)
    if word is None:
        return
    known = debugger.view.variables(robot=at.robot, frame=at.frame) if at.frame is not None else []
    for each in [*known, *debugger.view.globals_(robot=at.robot)]:
        if each.name.startswith(word[0]):
            yield each.name, word.start()
