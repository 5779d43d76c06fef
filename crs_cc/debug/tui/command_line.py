"""The command line, with history and completion; also for input of programs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import ClassVar, Final

from textual import events
from textual.binding import Binding, BindingType
from textual.message import Message
from textual.suggester import Suggester
from textual.widgets import Input

from crs_cc.debug.commands.completion import ended

_HINT: Final = "a command; Enter repeats the last one, F1 shows help"

Complete = Callable[[str], Sequence[str]]
"""Returns the completions of a line."""


class CommandLine(Input):
    """Input for commands; posts `Typed`."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up", "remember(-1)", show=False),
        Binding("down", "remember(1)", show=False),
        Binding("ctrl+r", "search", show=False),
        Binding("tab", "complete", show=False),
        Binding("ctrl+d", "finish", show=False),
    ]

    class Typed(Message):
        """The user has typed a line."""

        def __init__(self, line: str) -> None:
            super().__init__()
            self.line = line

    class Finished(Message):
        """The user has ended the input: Ctrl-D in an empty line."""

    def __init__(self, complete: Complete, history: Sequence[str] = (), **arguments: str) -> None:
        """Set the completer of lines, and the history."""
        super().__init__(
            placeholder=_HINT,
            suggester=_Completions(complete),
            compact=True,
            select_on_focus=False,  # what is typed next is added
            **arguments,  # type: ignore[arg-type]
        )
        self._complete = complete
        self._history = list(history)
        self._at = len(self._history)
        self._sought: str | None = None

    def on_input_submitted(self, event: Input.Submitted) -> None:
        """Post a line and add it to the history."""
        event.stop()
        line = event.value
        if line.strip() and self._history[-1:] != [line]:
            self._history.append(line)
        self._at = len(self._history)
        self.value = ""
        self.post_message(self.Typed(line))

    def action_remember(self, direction: int) -> None:
        """Recall an earlier or later line."""
        self._at = min(max(0, self._at + direction), len(self._history))
        self.value = self._history[self._at] if self._at < len(self._history) else ""
        self.cursor_position = len(self.value)

    def on_key(self, event: events.Key) -> None:
        """End a search with any other key."""
        if event.key != "ctrl+r":
            self._sought = None

    def action_search(self) -> None:
        """Recall the last line that contains the typed text; when repeated, an earlier one."""
        if self._sought is None:
            self._sought, self._at = self.value, len(self._history)
        for number in reversed(range(self._at)):
            if self._sought in self._history[number]:
                self._at, self.value = number, self._history[number]
                self.cursor_position = len(self.value)
                return

    def action_complete(self) -> None:
        """Complete the common prefix; in an empty line focus the next pane."""
        if not self.value:
            self.screen.focus_next()
            return
        found = self._complete(self.value)
        common = _common(found)
        if len(common) > len(self.value):
            self.value = ended(common) if len(found) == 1 else common
            self.cursor_position = len(self.value)

    def action_finish(self) -> None:
        """Post the end of input; in a non-empty line delete to the right."""
        if self.value:
            self.action_delete_right()
        else:
            self.post_message(self.Finished())


class _Completions(Suggester):
    """Suggests the first completion of a line whose last word has begun."""

    def __init__(self, complete: Complete) -> None:
        super().__init__(use_cache=False, case_sensitive=True)
        self._complete = complete

    async def get_suggestion(self, value: str) -> str | None:
        found: Sequence[str] = () if value[-1:] in {"", " "} else self._complete(value)
        return found[0] if found else None


def _common(texts: Sequence[str]) -> str:
    """Return the common prefix of some words.

    >>> _common(["reverse-next", "reverse-step"])
    'reverse-'
    """
    if not texts:
        return ""
    first, last = min(texts), max(texts)
    for index, letter in enumerate(first):
        if letter != last[index]:
            return first[:index]
    return first
