"""The interface between the screen and the debugger's thread."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Protocol

from rich.text import Text

from crs_cc.debug.commands.shell import PROMPT
from crs_cc.debug.tui.screen_data import Key, OutputLine, ScreenData


@dataclass(frozen=True, slots=True)
class BackendRequest:
    """A request to the debugger.

    Attributes:
        line: a command; None only to refresh.
        is_typed: whether the user has typed it, and not pressed a key.
        unfolded: the expanded values.
        map_size: columns and lines of the map.
        file: the C file to show; empty for the current one.
    """

    line: str | None = None
    is_typed: bool = False
    unfolded: frozenset[Key] = frozenset()
    map_size: tuple[int, int] = (0, 0)
    file: str = ""


@dataclass(frozen=True, slots=True)
class BackendReply:
    """The reply to a request.

    Attributes:
        snapshot: the data to show.
        answer: the answer of the command.
        errors: its errors, a line each.
        moved: whether the run has moved.
        quits: whether the user has quit.
        prompt: the prompt for the next line.
        listed: the first and last line that the command has listed, of the file shown; None if it
            has listed nothing.
    """

    snapshot: ScreenData
    answer: Text = field(default_factory=Text)
    errors: tuple[str, ...] = ()
    moved: bool = False
    quits: bool = False
    prompt: str = PROMPT
    listed: tuple[int, int] | None = None


class Backend(Protocol):
    """The debugger as seen by the screen; `execute` is called in a worker thread."""

    def execute(self, request: BackendRequest) -> BackendReply:
        """Execute a request; raises nothing."""

    def interrupt(self) -> None:
        """Interrupt the current request; thread-safe."""

    @property
    def time_s(self) -> float:
        """The simulated time [s], also while the run advances; thread-safe."""

    def on_input_request(self, asked: Callable[[str], None]) -> None:
        """Set the callback for programs that wait for input; it receives the robot's name."""

    def send_input(self, line: str | None) -> None:
        """Pass a line to the waiting program; None for the end of its input."""

    def take_output(self) -> tuple[OutputLine, ...]:
        """Return the output since the last call."""

    def complete(self, line: str) -> Sequence[str]:
        """Return the completions of a line, without access to the run."""
