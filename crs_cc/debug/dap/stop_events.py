"""Events for a run that has stopped or ended."""

from __future__ import annotations

from typing import Final

from crs_cc.core.errors import ProgramError
from crs_cc.debug.dap.framing import Message
from crs_cc.debug.dap.session import EditorSession, Execution
from crs_cc.debug.engine import Debugger
from crs_cc.debug.stop import WORDS, Reason, Stop
from crs_cc.debug.world.rows import instant

_REASONS: Final[dict[Reason, str]] = {
    "start": "entry",
    "beginning": "entry",
    "step": "step",
    "tick": "step",
    "breakpoint": "breakpoint",
    "watchpoint": "data breakpoint",
    "catchpoint": "exception",
    "error": "exception",
    "exit": "exited",
    "end": "exited",
    "goto": "goto",
    "interrupt": "pause",
}
"""The protocol's names of our reasons; `exited` is not one of them, which is permitted."""

_SAID: Final[dict[Reason, str]] = {
    **{reason: words.capitalize() for reason, words in WORDS.items()},
    "end": "All programs have ended: step back, or continue to end the session",
    "goto": "Moved",
    "step": "Stepped",
    "breakpoint": "Breakpoint",
    "watchpoint": "Data breakpoint",
}


def thread_of(robot: int) -> int:
    """Return the thread ID of a robot; some clients reserve 0."""
    return robot + 1


def report_stop(session: EditorSession, stop: Stop) -> None:
    """Report that a run has stopped; or that it has ended, if no stop is wanted there."""
    launch, debugger = session.launch, session.require_debugger()
    assert launch is not None
    if stop.reason == "end" and not (launch.stop_at_end and launch.debugs):
        report_end(session)
        return
    if not launch.debugs and stop.reason in {"error", "exit"}:
        session.execution = Execution(debugger.resume, go_on=debugger.resume)
        return
    said = stop.text or _SAID.get(stop.reason, stop.reason)
    robot = stop.robot if stop.robot >= 0 else debugger.view.robot
    body: Message = {
        "reason": _reason(session, stop),
        "description": f"{said.splitlines()[0]} (t = {instant(stop.time_s)})",
        "threadId": thread_of(robot),
        "allThreadsStopped": True,
    }
    if stop.text:
        body["text"] = stop.text
    hit = session.breakpoints.ids(stop.breakpoints)
    if hit:
        body["hitBreakpointIds"] = hit
    session.breakpoints.synchronize(session.require_debugger())  # temporary ones may be gone
    session.connection.event("stopped", body)


def report_moved(session: EditorSession) -> None:
    """Report the continuation of programs that the client believes to be stopped.

    A client that has not asked for it may let a robot run again that stops beside a stopped one.
    """
    body = {"threadId": thread_of(session.require_debugger().view.robot)}
    session.connection.event("continued", {**body, "allThreadsContinued": True})


def _reason(session: EditorSession, stop: Stop) -> str:
    if stop.reason == "breakpoint" and session.breakpoints.are_functions(stop.breakpoints):
        return "function breakpoint"
    return _REASONS[stop.reason]


def report_end(session: EditorSession) -> None:
    """Report that the run is over; the client will end the session."""
    session.output.flush()
    session.connection.event("exited", {"exitCode": exit_code(session.require_debugger())})
    session.connection.event("terminated")


def exit_code(debugger: Debugger) -> int:
    """Return the exit status of a run, as `crs run` has it."""
    statuses = [
        ProgramError.exit_status if robot.outcome == "failed" else (robot.exit_status or 0) & 0xFF
        for robot in debugger.session.result().robots
    ]
    return statuses[0] if len(statuses) == 1 else int(any(statuses))
