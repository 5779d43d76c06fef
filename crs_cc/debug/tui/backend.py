"""What the screen wants of the debugger, and what it gets."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Protocol

from rich.text import Text

from crs_cc.debug.commands.shell import PROMPT
from crs_cc.debug.tui.screen_data import Key, OutputLine, ScreenData


@dataclass(frozen=True, slots=True)
class BackendRequest:
    """Something to be done.

    Attributes:
        line: a command; None just to look.
        is_typed: the user has typed it, and did not press a key.
        unfolded: the values whose parts are wanted.
        chart_size: columns and lines of the map.
        file: the C file to show; empty for the one where the run stands.
    """

    line: str | None = None
    is_typed: bool = False
    unfolded: frozenset[Key] = frozenset()
    chart_size: tuple[int, int] = (0, 0)
    file: str = ""


@dataclass(frozen=True, slots=True)
class BackendReply:
    """What came of it.

    Attributes:
        look: how the run looks now.
        answer: what the command says.
        errors: what is wrong with it, a line each.
        moved: the run stands elsewhere.
        leaves: the user wants to leave.
        prompt: what asks for the next line.
    """

    look: ScreenData
    answer: Text = field(default_factory=Text)
    errors: tuple[str, ...] = ()
    moved: bool = False
    leaves: bool = False
    prompt: str = PROMPT


class Backend(Protocol):
    """The debugger's side of the screen; `do` is called in a thread of its own."""

    def do(self, order: BackendRequest) -> BackendReply:
        """Execute an order; raises nothing."""

    def interrupt(self) -> None:
        """Make what is being done come to an end; from any thread."""

    @property
    def time_s(self) -> float:
        """How far the run is [s], also while it goes on; from any thread."""

    def listen(self, asked: Callable[[str], None]) -> None:
        """Return whom to tell that a robot's program, by its name, waits for a line of input."""

    def give(self, line: str | None) -> None:
        """Return the program that waits a line; None for the end of its input."""

    def take_output(self) -> tuple[OutputLine, ...]:
        """Return what programs have written since this was last asked for."""

    def complete(self, line: str) -> Sequence[str]:
        """Return what a line that has been begun may become; does not touch the run."""
