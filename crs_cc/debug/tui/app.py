"""The application: sends requests to the debugger and shows its replies.

The debugger works in a thread of its own, one request after the other, so that the screen stays
responsive; the only thing done to it meanwhile is to interrupt it.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Final

from textual.app import App, ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Horizontal
from textual.driver import Driver
from textual.message import Message
from textual.screen import Screen
from textual.timer import Timer
from textual.widgets import Label

from crs_cc.debug.commands.shell import PROMPT
from crs_cc.debug.tui.backend import Backend, BackendReply, BackendRequest
from crs_cc.debug.tui.choices import ChoiceList
from crs_cc.debug.tui.command_line import CommandLine
from crs_cc.debug.tui.help_page import HelpPage
from crs_cc.debug.tui.keys import SHORTCUTS
from crs_cc.debug.tui.logs import ConsoleLog, OutputLog
from crs_cc.debug.tui.map_pane import MapPane
from crs_cc.debug.tui.panes import Panes
from crs_cc.debug.tui.screen_data import OPEN, ScreenData
from crs_cc.debug.tui.short_styles import short_driver
from crs_cc.debug.tui.source_pane import SourcePane
from crs_cc.debug.tui.status_bars import Button, ButtonBar, StatusBar
from crs_cc.debug.tui.time_line import TimeLine
from crs_cc.debug.tui.variables_pane import VariablesPane

_WAIT_S: Final = 0.15  # between updates of the running command


@dataclass
class RequestFinished(Message):
    """A request is complete."""

    request: BackendRequest
    done: BackendReply


@dataclass
class InputRequested(Message):
    """A program waits for a line of input."""

    robot: str


class DebugApp(App[int]):
    """The full screen of the debugger."""

    TITLE = "crs debug"
    CSS_PATH = "layout.tcss"
    ENABLE_COMMAND_PALETTE = False
    HORIZONTAL_BREAKPOINTS = [(0, "-narrow"), (110, "-wide")]
    VERTICAL_BREAKPOINTS = [
        (0, "-low"),
        (16, "-middle"),
        (34, "-tall"),
    ]
    BINDINGS: ClassVar[list[BindingType]] = [
        *(
            Binding(each.keys, each.action or f"press({each.command!r})", show=False, priority=True)
            for each in SHORTCUTS
            if each.keys
        ),
        *(
            Binding(each.letter, each.action or f"press({each.command!r})", show=False)
            for each in SHORTCUTS
            if each.letter
        ),
    ]

    def __init__(self, backend: Backend, history: Sequence[str] = ()) -> None:
        """Set the debugger, and the commands of earlier sessions."""
        super().__init__()
        self.typed: list[str] = []  # commands, without input for programs
        self._backend = backend
        self._history = history
        self._requests: deque[BackendRequest] = deque()
        self._current: BackendRequest | None = None
        self._slow: Timer | None = None
        self._unfolded = set(OPEN)
        self._map_size = (0, 0)
        self._file = ""  # to show instead of the current one
        self._goto_s: float | None = None  # the target of the timeline
        self._snapshot = ScreenData()
        self._leaving = False
        self._sought = ""  # in the source
        self._prompted = PROMPT
        self._asks = ""  # the robot whose program waits for input

    def show(self, *, headless: bool = False) -> None:
        """Show the screen until the user quits; without a terminal if `headless`."""
        self.run(headless=headless)
        if self._exception is not None:
            raise self._exception

    def _fatal_error(self) -> None:
        """Exit after an internal error, without Textual's traceback."""
        self._close_messages_no_wait()

    def get_driver_class(self) -> type[Driver]:
        """Return the driver of the terminal."""
        return short_driver(super().get_driver_class())

    def compose(self) -> ComposeResult:
        """Create the widgets."""
        yield StatusBar(id="status")
        yield Panes(id="panes")
        yield TimeLine(id="time")
        with Horizontal(id="prompt"):
            yield Label(PROMPT)
            yield CommandLine(self._backend.complete, self._history, id="command")
        yield ButtonBar(id="keys")

    def on_mount(self) -> None:
        """Request the first data."""
        self.main.query_one("#keys", ButtonBar).buttons = tuple(
            Button(each.label, f"simulate('{each.keys.split(',')[0]}')", each.shown)
            for each in SHORTCUTS
            if each.label
        )
        self.main.query_one(CommandLine).focus()
        self._backend.on_input_request(self._post_input_request)
        self._request(BackendRequest())

    @property
    def main(self) -> Screen[object]:
        """Return the main screen, below the help page."""
        return self.screen_stack[0]

    @property
    def is_idle(self) -> bool:
        """Return whether the debugger is idle."""
        return self._current is None and not self._requests

    # -- orders to the debugger ----------------------------------------------------------------

    def _request(self, request: BackendRequest) -> None:
        """Queue a request."""
        self._requests.append(request)
        self._start_next()

    def _start_next(self) -> None:
        if self._current is not None or not self._requests:
            return
        request = self._current = self._requests.popleft()
        wanted = frozenset(self._unfolded), self._map_size, self._file
        request = BackendRequest(request.line, request.is_typed, *wanted)
        if request.line is not None:
            self._slow = self.set_interval(_WAIT_S, self._show_running)
        self.run_worker(lambda: self._execute(request), thread=True, exit_on_error=False)

    def _execute(self, request: BackendRequest) -> None:
        """Execute a request; in the debugger's thread."""
        self.post_message(RequestFinished(request, self._backend.execute(request)))

    def _post_input_request(self, robot: str) -> None:
        """Post that a program waits for input; in the debugger's thread."""
        self.post_message(InputRequested(robot))

    def on_request_finished(self, message: RequestFinished) -> None:
        """Show a reply."""
        request, done = message.request, message.done
        self._current = None
        if self._slow is not None:
            self._slow.stop()
        self.main.query_one(StatusBar).running = ""
        if self._leaving or done.quits:
            self.exit(0)
            return
        self._show_answer(request, done)
        self._prompt(done.prompt)
        if done.listed is not None:
            self._file = done.snapshot.source.file
        self._show(done.snapshot, moved=done.moved)
        if done.listed is not None:
            self.main.query_one(SourcePane).go_to(sum(done.listed) // 2)
        self._start_next()
        self._start_goto()

    def _show_answer(self, request: BackendRequest, done: BackendReply) -> None:
        console = self.main.query_one("#console", ConsoleLog)
        if request.line is not None and (request.is_typed or done.answer.plain or done.errors):
            console.echo(request.line)
        console.answer(done.answer)
        for line in done.errors:
            console.error(line)
        has_failed = done.moved and done.snapshot.badge == "error"
        if (request.is_typed and done.answer.plain) or done.errors or has_failed:
            self.main.query_one(Panes).pick("console")
            self.main.add_class("-answer")

    def _show(self, snapshot: ScreenData, *, moved: bool) -> None:
        if moved:
            self.main.remove_class("-answer")
        if snapshot.source.file != self._file:
            self._file = ""
        self._snapshot = snapshot
        self.main.query_one(StatusBar).snapshot = snapshot
        self.main.query_one(Panes).show(snapshot, moved=moved)
        line = self.main.query_one(TimeLine)
        line.end_s, line.now_s, line.happened = snapshot.end_s, snapshot.now_s, snapshot.events
        line.timestep_s = snapshot.timestep_s

    def _show_running(self) -> None:
        """Show the running command, its progress and new output; most commands end before."""
        if self._current is not None and self._current.line is not None:
            line = self._current.line or "again"
            self.main.query_one(StatusBar).running = f"{line}: {self._backend.time_s:.2f} s"
            self.main.query_one("#output", OutputLog).add(self._backend.take_output())

    # -- what the user does --------------------------------------------------------------------

    def action_press(self, command: str) -> None:
        """Execute the command of a key, unless one is running: keys held down do not pile up."""
        if self._current is None:
            self._request(BackendRequest(command))

    def action_interrupt(self) -> None:
        """Interrupt the running command, or else copy the selection."""
        if self._current is not None:
            self._requests.clear()
            self._direct_input("")
            self._backend.interrupt()
        elif marked := self.screen.get_selected_text():
            self.copy_to_clipboard(marked)

    async def action_quit(self) -> None:
        """Quit as soon as the running command has stopped."""
        self._leaving = True
        if self._current is None:
            self.exit(0)
        self._backend.interrupt()

    def action_breakpoint(self) -> None:
        """Toggle a breakpoint at the cursor."""
        self._toggle(self.main.query_one(SourcePane).cursor)

    def action_here(self) -> None:
        """Run to the cursor."""
        source = self.main.query_one(SourcePane)
        self.action_press(f"advance {source.file}:{source.cursor}")

    def _toggle(self, line: int) -> None:
        source = self._snapshot.source
        if line in source.breakpoints:
            self.action_press(f"delete {source.breakpoints[line].number}")
        elif source.file:
            self.action_press(f"break {source.file}:{line}")

    def action_file(self) -> None:
        """Show the next source file."""
        files = self._snapshot.source.files
        if files:
            shown = files.index(self.main.query_one(SourcePane).file)
            self._file = files[(shown + 1) % len(files)]
            self._refresh()

    def action_help(self) -> None:
        """Show the help page."""
        if not isinstance(self.screen, HelpPage):
            self.push_screen(HelpPage())

    def action_pane(self, steps: int) -> None:
        """Switch between the lower panes."""
        self.main.query_one(Panes).move(steps)

    def action_pick(self, name: str) -> None:
        """Switch to a lower pane."""
        panes = self.main.query_one(Panes)
        panes.pick(name)
        panes.pane(name).focus()

    def action_zoom(self) -> None:
        """Maximise the focused pane, or restore the layout."""
        panes = self.main.query_one(Panes)
        alone = self.focused if self.focused in panes.children else self.main.query_one(SourcePane)
        for each in panes.children:
            each.set_class(each is alone, "-alone")
        self.main.toggle_class("-zoomed")

    def action_type(self) -> None:
        """Toggle focus between command line and source."""
        if isinstance(self.screen, HelpPage):
            self.pop_screen()
            return
        line = self.main.query_one(CommandLine)
        (self.main.query_one(SourcePane) if line.has_focus else line).focus()

    def action_search(self) -> None:
        """Ask for a text to search the source for."""
        line = self.main.query_one(CommandLine)
        line.value, line.cursor_position = "/", 1
        line.focus()

    def _search(self, text: str) -> None:
        """Go to the next line of the source with a text; the last one if it is empty."""
        self._sought = text or self._sought
        if not self.main.query_one(SourcePane).search(self._sought):
            self.main.query_one("#console", ConsoleLog).error(f"no line has '{self._sought}'")
            self.main.query_one(Panes).pick("console")

    def action_simulate(self, key: str) -> None:
        """Simulate a key press."""
        self.simulate_key(key)

    # -- what the panes say --------------------------------------------------------------------

    def on_command_line_typed(self, message: CommandLine.Typed) -> None:
        """Handle a command, or input for a program."""
        if self._asks:
            self._send_input(message.line)
        elif message.line.startswith("/"):
            self._search(message.line[1:])
        else:
            self.typed += [message.line] if message.line.strip() else []
            self._request(BackendRequest(message.line, is_typed=True))

    async def on_command_line_finished(self) -> None:
        """Quit, or end the input of a waiting program."""
        if self._asks:
            self._send_input(None)
        else:
            await self.action_quit()

    def on_input_requested(self, message: InputRequested) -> None:
        """Prompt for a program's input."""
        self._direct_input(message.robot)
        self.main.query_one(CommandLine).focus()

    def _direct_input(self, robot: str) -> None:
        """Direct typed lines to a robot's program; to the debugger for an empty name."""
        self._asks = robot
        self._prompt(_input_prompt(robot) if robot else PROMPT)

    def _prompt(self, text: str) -> None:
        """Show a prompt; only another one, as that lays out the whole screen."""
        if text != self._prompted:
            self._prompted = text
            self.main.query_one("#prompt Label", Label).update(text)

    def _send_input(self, line: str | None) -> None:
        self.main.query_one("#console", ConsoleLog).echo(line or "", _input_prompt(self._asks))
        self._direct_input("")
        self._backend.send_input(line)

    def on_source_pane_toggle(self, message: SourcePane.Toggle) -> None:
        """Toggle a breakpoint."""
        self._toggle(message.line)

    def on_choice_list_chosen(self, message: ChoiceList.Chosen) -> None:
        """Select a frame or robot."""
        what = {"stack": "frame", "robots": "robot"}[message.pane.id or ""]
        self.action_press(f"{what} {message.number}")

    def on_output_log_chosen(self, message: OutputLog.Chosen) -> None:
        """Go to the statement that printed a line."""
        if message.number:
            self.action_press(f"goto output {message.number}")

    def on_variables_pane_unfolded(self, message: VariablesPane.Unfolded) -> None:
        """Expand or collapse a value."""
        (self._unfolded.add if message.is_open else self._unfolded.discard)(message.key)
        self._refresh()

    def on_map_pane_resized(self, message: MapPane.Resized) -> None:
        """Redraw the map."""
        self._map_size = message.width, message.height
        self._refresh()

    def _refresh(self) -> None:
        if not any(each.line is None for each in self._requests):
            self._request(BackendRequest())

    def on_time_line_press(self, message: TimeLine.Press) -> None:
        """Execute a command of the timeline's keys."""
        self.action_press(message.command)

    def on_time_line_move(self, message: TimeLine.Move) -> None:
        """Go to a time; while a command runs, only the last request counts."""
        self._goto_s = message.time_s
        self._start_goto()

    def _start_goto(self) -> None:
        if self._goto_s is not None and self.is_idle:
            self._request(BackendRequest(f"goto {self._goto_s:.6f}"))
            self._goto_s = None


def _input_prompt(robot: str) -> str:
    """Return the prompt for a program's input."""
    return f"{robot} reads: "
