"""Requests about the session itself: from `initialize` to `disconnect`."""

from __future__ import annotations

from functools import partial
from typing import Final

from crs_cc.debug.dap.arguments import Arguments, RefusalError
from crs_cc.debug.dap.breakpoint_requests import FILTERS
from crs_cc.debug.dap.framing import Message
from crs_cc.debug.dap.launch import read_launch
from crs_cc.debug.dap.session import EditorSession
from crs_cc.debug.dap.stop_events import report_moved

CAPABILITIES: Final[Message] = {
    "supportsConfigurationDoneRequest": True,
    "supportsFunctionBreakpoints": True,
    "supportsConditionalBreakpoints": True,
    "supportsHitConditionalBreakpoints": True,
    "supportsLogPoints": True,
    "supportsDataBreakpoints": True,
    "exceptionBreakpointFilters": FILTERS,
    "supportsExceptionFilterOptions": True,
    "supportsStepBack": True,
    "supportsSteppingGranularity": True,
    "supportsGotoTargetsRequest": True,
    "supportsStepInTargetsRequest": True,
    "supportsRestartRequest": True,
    "supportsTerminateRequest": True,
    "supportsCancelRequest": True,
    "supportsExceptionInfoRequest": True,
    "supportsSetVariable": True,
    "supportsSetExpression": True,
    "supportsEvaluateForHovers": True,
    "supportsClipboardContext": True,
    "supportsCompletionsRequest": True,
    "completionTriggerCharacters": [" ", "."],
    "supportsReadMemoryRequest": True,
    "supportsWriteMemoryRequest": True,
    "supportsLoadedSourcesRequest": True,
    "supportsDisassembleRequest": True,
}


def initialize(session: EditorSession, arguments: Arguments) -> Message:
    """Exchange capabilities with the client."""
    if session.launch is not None:
        raise RefusalError("'initialize' must be the first request, and the only one of its kind")
    session.configure_client(arguments)
    return CAPABILITIES


def launch(session: EditorSession, arguments: Arguments) -> None:
    """Create a run; it starts with `configurationDone`."""
    if session.launch is not None:
        raise RefusalError("a program is already launched")
    wanted = read_launch(arguments)
    session.open(wanted)
    if wanted.debugs:
        session.breakpoints.set_again(session.require_debugger())
    session.after_response = partial(session.connection.event, "initialized")


def attach(_session: EditorSession, _arguments: Arguments) -> None:
    """Refuse: programs run in this process only."""
    raise RefusalError("'attach' is not supported: use 'launch'")


def configuration_done(session: EditorSession, _arguments: Arguments) -> None:
    """Start the run."""
    session.require_stopped()
    if session.has_started:
        raise RefusalError("the run has already started")
    session.begin()


def restart(session: EditorSession, arguments: Arguments) -> None:
    """Compile the programs again and restart."""
    if session.launch is None:
        raise RefusalError("no program is launched")
    has_news = "arguments" in arguments
    session.open(read_launch(arguments.object("arguments")) if has_news else session.launch)
    session.breakpoints.set_again(session.require_debugger())
    session.begin()
    session.after_response = partial(report_moved, session)


def terminate(session: EditorSession, _arguments: Arguments) -> None:
    """End the run."""
    session.close()
    session.after_response = partial(session.connection.event, "terminated")


def disconnect(session: EditorSession, _arguments: Arguments) -> None:
    """End the session."""
    session.close()
    session.over = True
