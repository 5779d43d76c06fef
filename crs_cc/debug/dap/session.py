"""The state of a session with an editor."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Any, Final

from crs_cc.debug.commands.shell import Shell
from crs_cc.debug.dap.arguments import Arguments, RefusalError
from crs_cc.debug.dap.breakpoints import EditorBreakpoints
from crs_cc.debug.dap.connection import Connection
from crs_cc.debug.dap.inbox import ClientRequest, Inbox
from crs_cc.debug.dap.launch import Launch
from crs_cc.debug.dap.locations import ClientLocations
from crs_cc.debug.dap.output_events import OutputEvents
from crs_cc.debug.dap.progress import Progress
from crs_cc.debug.engine import Debugger
from crs_cc.debug.stop import Stop
from crs_cc.session.host import Output

MAX_HANDLES: Final = 100_000  # per stop; chosen by us


class Handles:
    """Objects by the numbers by which a client refers to them until the run moves.

    Numbers are never reused, so stale ones are detected.
    """

    def __init__(self) -> None:
        self._first = 1
        self._objects: list[Any] = []

    def clear(self) -> None:
        """Invalidate all handles."""
        self._first += len(self._objects)
        self._objects.clear()

    def add(self, value: Any) -> int:
        """Assign a number to an object; raise RefusalError if there are too many."""
        if len(self._objects) >= MAX_HANDLES:
            raise RefusalError("too many variables are expanded: collapse some, or resume")
        self._objects.append(value)
        return self._first + len(self._objects) - 1

    def get(self, number: int) -> Any:
        """Return the object with a number; raise RefusalError if it is unknown or stale."""
        if not self._first <= number < self._first + len(self._objects):
            raise RefusalError("the reference is no longer valid: the programs have moved on")
        return self._objects[number - self._first]


ENDING: Final = frozenset({"pause", "cancel", "terminate", "disconnect", "restart"})
"""Requests that want the programs to stop."""

OpenRun = Callable[[Sequence[str], "Output", Callable[[str], None]], Debugger]
"""Makes a debugger from a command line of `crs debug`: its programs' output goes to the output,
compiler messages are passed on line by line. Raises `CrsError`, or `DebugError` if the
command line is invalid."""


@dataclass(frozen=True, slots=True)
class Execution:
    """A pending execution, forward or backward.

    Attributes:
        go: starts it.
        go_on: continues it after an interruption by an unrelated request; None if it
            cannot be continued, so that such requests wait.
    """

    go: Callable[[], Stop]
    go_on: Callable[[], Stop] | None = None


class EditorSession:
    """The state that request handlers share.

    Attributes:
        connection: sends messages to the client.
        client: the client's capabilities.
        locations: its conventions for source locations.
        launch: what it has launched; None for nothing.
        handles: objects that it can refer to until the run moves.
        output: the programs' output.
        progress: reports long moves to the client.
        execution: the execution to start after the response; None for none.
        after_response: sends events after the response; None for none.
        has_started: whether the run has started.
        is_running: whether the programs run as far as the client knows.
        paused: whether it has requested a pause.
        shell: executes commands; None if nothing is launched.
        over: whether the session should end.
    """

    def __init__(
        self,
        connection: Connection,
        inbox: Inbox,
        open_run: OpenRun,
        folder: str | None = None,
    ) -> None:
        self.connection = connection
        self.client = Arguments({})
        self.locations = ClientLocations()
        self.launch: Launch | None = None
        self.breakpoints = EditorBreakpoints(connection, self.locations)
        self.handles = Handles()
        self.output = OutputEvents(connection)
        self.progress = Progress(connection, wanted=False)
        self.execution: Execution | None = None
        self.after_response: Callable[[], None] | None = None
        self.has_started = False
        self.is_running = False
        self.paused = False
        self.over = False
        self.shell: Shell | None = None
        self._inbox = inbox
        self._open_run = open_run
        self._debugger: Debugger | None = None
        self._folder = folder or os.getcwd()  # noqa: PTH109

    def configure_client(self, client: Arguments) -> None:
        """Store the client's capabilities; raise RefusalError if they are not supported."""
        self.locations.configure(client)
        self.client = client
        wanted = client.flag("supportsProgressReporting", default=False)
        self.progress = Progress(self.connection, wanted=wanted)

    @property
    def debugger(self) -> Debugger | None:
        """The debugger; None if nothing is launched."""
        return self._debugger

    def require_debugger(self) -> Debugger:
        """Return the debugger; raise RefusalError if nothing is launched."""
        if self._debugger is None:
            raise RefusalError("no program is launched")
        return self._debugger

    def require_stopped(self) -> Debugger:
        """Return the debugger of stopped programs.

        Raises:
            RefusalError: they are running, or nothing is launched.
        """
        debugger = self.require_debugger()
        if self.is_running:
            raise RefusalError("the programs are running: pause them first", "notStopped")
        return debugger

    def robot(self, arguments: Arguments) -> int:
        """Return the robot of a request's `threadId`.

        Raises:
            RefusalError: there is no such robot.
        """
        robot = arguments.integer("threadId") - 1
        if not 0 <= robot < len(self.require_debugger().names):
            raise RefusalError("unknown 'threadId'")
        return robot

    def open(self, launch: Launch) -> None:
        """Start a new run, which replaces the previous one.

        Raises:
            RefusalError: its working directory is invalid.
            DebugError: the command line is invalid.
            CrsError: a program or the world is invalid.
        """
        try:
            os.chdir(os.path.join(self._folder, launch.folder))  # noqa: PTH118
        except OSError as error:
            raise RefusalError(f"'cwd' cannot be used: {error.strerror}") from None
        for name in launch.unknown:
            self.output.send_message(f"unknown attribute '{name}' of launch: ignored", "important")
        debugger = self._open_run(launch.command_line, self.output.write, self.output.send_message)
        self.launch, self._debugger, self.has_started = launch, debugger, False
        self.breakpoints.debugger = debugger
        self.shell = Shell(debugger)
        debugger.stop_points.print_log = self.output.send_message
        self.output.begin(debugger.names)
        self.handles.clear()
        for program in debugger.run.programs:
            self.locations.add_sources(program.executable.detail().lines)

    def begin(self) -> None:
        """Start the run: go to its first statement, or its first breakpoint."""
        launch, debugger = self.launch, self.require_debugger()
        assert launch is not None
        self.has_started = True
        if launch.stop_on_entry and launch.debugs:
            self.execution = Execution(lambda: replace(debugger.start(), reason="start"))
        else:
            self.execution = Execution(debugger.resume, go_on=debugger.resume)

    def close(self) -> None:
        """Close the run."""
        self._debugger = self.shell = self.breakpoints.debugger = None
        self.handles.clear()

    @contextmanager
    def interruptible(self, *, by_all: bool) -> Iterator[None]:
        """Interrupt the run when a request arrives during the block.

        Args:
            by_all: whether every request does; else only those that stop the programs.
        """
        debugger = self.require_debugger()

        def interrupt(request: ClientRequest | None) -> None:
            if request is None or by_all or request.command in ENDING:
                debugger.interrupt()

        with self._inbox.watched(interrupt):
            yield
        debugger.forget_interrupt()  # an interrupt that arrived after the stop

    def report_invalidated(self) -> None:
        """Report that the client's view of the programs is outdated."""
        if self.client.flag("supportsInvalidatedEvent", default=False):
            self.connection.event("invalidated", {"areas": ["all"]})

    def report_memory_written(self, reference: str, count: int) -> None:
        """Report that bytes of a program's memory have changed."""
        if self.client.flag("supportsMemoryEvent", default=False):
            where = {"memoryReference": reference, "offset": 0, "count": count}
            self.connection.event("memory", where)
        self.report_invalidated()
