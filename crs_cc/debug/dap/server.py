"""The loop that answers requests one after the other, and moves the run between them.

The reading thread puts requests into the inbox; this one, the engine's, takes them out. While
programs run it is busy. Then a request interrupts the run and is answered, and the run continues,
so that a breakpoint can be set at any time; steps are too short for that, and
are interrupted only by requests to stop.
"""

from __future__ import annotations

import os
import traceback
from collections.abc import Callable, Mapping

from crs_cc.core.errors import CrsError
from crs_cc.debug.dap.arguments import Arguments, RefusalError
from crs_cc.debug.dap.connection import ClientDisconnectedError
from crs_cc.debug.dap.framing import Message
from crs_cc.debug.dap.inbox import ClientRequest, Inbox
from crs_cc.debug.dap.session import EditorSession, Execution
from crs_cc.debug.dap.stop_events import report_stop
from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.debug.stop import Stop

Handler = Callable[["EditorSession", Arguments], "Message | None"]
"""Fulfils a request: gives the body of the response; raises `RefusalError` or `DebugError`."""


class Server:
    """Answers the requests of one session."""

    def __init__(
        self, session: EditorSession, inbox: Inbox, handlers: Mapping[str, Handler]
    ) -> None:
        self._session = session
        self._inbox = inbox
        self._handlers = handlers

    def serve(self) -> None:
        """Answer requests until the session is over, or no more can come.

        Raises:
            ClientDisconnectedError: the client has closed the connection.
        """
        session = self._session
        while not session.over and (request := self._inbox.get()) is not None:
            self._answer(request)
            while session.execution is not None and not session.over:
                motion, session.execution = session.execution, None
                self._move(motion)

    def _answer(self, request: ClientRequest) -> None:
        """Answer a request, or refuse it."""
        connection = self._session.connection
        handler = self._handlers.get(request.command)
        if handler is None:
            connection.refuse(request, f"unknown request '{request.command}'")
            return
        try:
            body = handler(self._session, Arguments.of(request.arguments))
        except ClientDisconnectedError:
            raise
        except RefusalError as error:
            connection.refuse(request, str(error), error.word)
        except Exception as error:
            connection.refuse(request, explain(error))
        else:
            connection.respond(request, body)
            self._report_effects()

    def _report_effects(self) -> None:
        """Report the effects of a request."""
        session = self._session
        after_response, session.after_response = session.after_response, None
        if after_response is not None:
            after_response()

    def _move(self, motion: Execution) -> None:
        """Run the programs and report where they stop."""
        session = self._session
        debugger = session.require_debugger()
        session.handles.clear()
        session.is_running, session.paused = True, False
        try:
            with session.progress.of(
                "programs run", lambda: f"t = {debugger.session.time_s:.1f} s"
            ):
                stop = self._run(motion, debugger)
        except ClientDisconnectedError:
            raise
        except Exception as error:
            session.output.send_message(explain(error), "stderr")
            stop = debugger.stop
        session.is_running = False
        session.handles.clear()  # of what was asked for on the way
        if session.debugger is debugger:
            session.output.flush()
            report_stop(session, stop)

    def _run(self, motion: Execution, debugger: Debugger) -> Stop:
        """Run the programs until they stop or a request interrupts them."""
        session = self._session
        go = motion.go
        while True:
            with session.interruptible(by_all=motion.go_on is not None):
                stop = go()
            if stop.reason != "interrupt" or motion.go_on is None:
                return stop
            while not self._wants_end(debugger):
                request = self._inbox.get(wait=False)
                if request is None:
                    break
                self._answer(request)
            if self._wants_end(debugger):
                return stop
            go = motion.go_on

    def _wants_end(self, debugger: Debugger) -> bool:
        session = self._session
        return session.paused or session.debugger is not debugger or self._inbox.closed


def explain(error: Exception) -> str:
    """Return the user's message for an error."""
    if isinstance(error, DebugError | CrsError | OSError):
        return str(error)
    if os.environ.get("CRS_DEBUG"):
        traceback.print_exception(error)
    return (
        f"internal error: {type(error).__name__}: {error}. This is a mistake in crs, not in your "
        "program. Please report it; CRS_DEBUG=1 in the environment shows where it happened."
    )
