"""The backend of the screen: executes commands and returns the data to show.

Commands are those of the command table; the screen has none of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Final

from rich.style import Style
from rich.text import Text

from crs_cc.debug.commands.answer import Line, SourceLine
from crs_cc.debug.commands.completion import complete
from crs_cc.debug.commands.shell import Shell
from crs_cc.debug.commands.table import matching
from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.debug.timeline.position import Position
from crs_cc.debug.tui.backend import BackendReply, BackendRequest
from crs_cc.debug.tui.printable import printable
from crs_cc.debug.tui.program_streams import ProgramStreams
from crs_cc.debug.tui.screen_data import OutputLine, ScreenData
from crs_cc.debug.tui.snapshot_builder import build_snapshot, written

_STYLES: Final = {
    "stop": Style(bold=True),
    "place": Style(color="cyan"),
    "log": Style(color="magenta"),
}
"""By kind of line; others are plain."""

_MAX_LINES: Final = 1000
"""Lines of an answer that are shown; chosen by us: more than anybody reads."""


class Controller:
    """Executes requests of the screen.

    Attributes:
        shell: the command line.
    """

    def __init__(
        self, debugger: Debugger, streams: ProgramStreams, scripts: Iterable[str] = ()
    ) -> None:
        """Store the debugger and start with its scripts."""
        self.shell = Shell(debugger)
        self._streams = streams
        self._scripts = scripts
        self._has_begun = False
        self._works = False
        self._is_interrupted = False
        self._snapshot = ScreenData()

    def interrupt(self) -> None:
        """Interrupt the current request; thread-safe."""
        self._is_interrupted = True
        self.shell.debugger.interrupt()
        self._streams.end()

    @property
    def time_s(self) -> float:
        """The simulated time [s], also while the run advances; thread-safe."""
        return self.shell.debugger.session.time_s

    def on_input_request(self, asked: Callable[[str], None]) -> None:
        """Set the callback for programs that wait for input; it receives the robot's name."""
        self._streams.on_input_request = lambda robot: asked(self.shell.debugger.names[robot])

    def send_input(self, line: str | None) -> None:
        """Pass a line to the waiting program; None for the end of its input."""
        self._streams.send_input(b"" if line is None else f"{line}\n".encode())

    def take_output(self) -> tuple[OutputLine, ...]:
        """Return the output since the last call."""
        return tuple(written(self.shell.debugger.names, self._streams.take_output()))

    def complete(self, line: str) -> Sequence[str]:
        """Return the completions of a line; while a command runs, only command names."""
        if self._works:
            return list(matching(line))
        completion = complete(self.shell.context, line)
        return [line[: completion.start] + word for word in completion.words]

    def execute(self, request: BackendRequest) -> BackendReply:
        """Execute a request; errors become lines of the reply."""
        self._works = True
        self._streams.take_output()  # the previous snapshot has shown it
        debugger = self.shell.debugger
        # An interrupt that arrived too late for the previous request does not concern this one.
        self._is_interrupted = False
        debugger.forget_interrupt()
        before, looked_at = debugger.position, (debugger.view.robot, debugger.view.frame)
        listing, listed = self.shell.context.listing, None
        answer, errors = Text(), list[str]()
        try:
            self._answer(request, before, answer, errors)
            if (debugger.position, (debugger.view.robot, debugger.view.frame)) != (
                before,
                looked_at,
            ):
                request = replace(request, file="")
            found = self.shell.context.listing
            if found is not None and found is not listing:
                request, listed = replace(request, file=found.file), (found.first, found.last)
            self._snapshot = build_snapshot(self.shell, request)
        except DebugError as error:  # the source files have changed
            errors.append(str(error))
        except Exception as error:
            errors.append(f"internal error: {type(error).__name__}: {error}; please report it")
        finally:
            self._works = False
        has_moved = debugger.position != before
        leaves, prompt = self.shell.has_ended, self.shell.prompt
        return BackendReply(
            self._snapshot, answer, tuple(errors), has_moved, leaves, prompt, listed
        )

    def _answer(
        self, request: BackendRequest, before: Position, answer: Text, errors: list[str]
    ) -> None:
        count = 0
        for line in self._lines(request):
            count += 1
            if isinstance(line, Line) and line.kind == "error":
                errors.append(line.text)
            elif (
                isinstance(line, SourceLine)
                and line.is_current
                and self.shell.debugger.position != before
            ):
                continue  # the source is on the screen
            elif count <= _MAX_LINES:
                answer.append("\n" if answer.plain else "")
                answer.append(_text(line))
        if count > _MAX_LINES:
            answer.append(f"\n... and {count - _MAX_LINES} lines more")

    def _begin(self) -> Iterator[Line | SourceLine]:
        try:
            for line in self._scripts:
                if self.shell.has_ended:
                    return
                if self._is_interrupted:
                    yield Line("script interrupted", "error")
                    return
                yield from self.shell.execute(line or "#")
        except DebugError as error:  # a script that cannot be read
            yield Line(str(error), "error")

    def _lines(self, request: BackendRequest) -> Iterator[Line | SourceLine]:
        if not self._has_begun:
            self._has_begun = True
            yield from self.shell.greet()
            yield from self._begin()
        if request.line is not None:
            yield from self.shell.execute(request.line)


def _text(line: Line | SourceLine) -> Text:
    if isinstance(line, SourceLine):
        return Text(printable(line.text))
    return Text(printable(line.text.expandtabs()), _STYLES.get(line.kind, Style()))
