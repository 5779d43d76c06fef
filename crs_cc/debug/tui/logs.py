"""Two logs: commands with their answers, and the output of the programs."""

from __future__ import annotations

import re
from collections import deque
from typing import Final

from rich.console import Console
from rich.style import Style
from rich.text import Text
from textual import events
from textual.message import Message
from textual.widgets import RichLog

from crs_cc.debug.commands.shell import PROMPT
from crs_cc.debug.tui.printable import printable
from crs_cc.debug.tui.screen_data import OutputLine

_MAX_LINES: Final = 2000
_STALE: Final = -1
_ERROR: Final = Style(color="red")
_WHO: Final = Style(color="cyan")
_ECHO: Final = Style(dim=True)
_HEAD: Final = re.compile(r"(?:@\d+)?[ │├└─]*")
"""The number of an instant and the lines of a tree, or spaces, before the text of a line."""
_PLAIN: Final = Console(width=80, color_system=None)


class ConsoleLog(RichLog):
    """Commands and their answers."""

    def __init__(self, **arguments: str) -> None:
        super().__init__(
            max_lines=_MAX_LINES,
            wrap=True,
            min_width=1,
            **arguments,  # type: ignore[arg-type]
        )
        self.border_title = "console"
        self._texts: deque[Text] = deque(maxlen=_MAX_LINES)
        self._wrapped_at = 0

    def echo(self, line: str, prompt: str = PROMPT) -> None:
        """Show a typed line."""
        self._add(Text(prompt + printable(line), _ECHO))

    def answer(self, text: Text) -> None:
        """Show an answer."""
        if text.plain:
            self._add(text)

    def error(self, line: str) -> None:
        """Show an error."""
        self._add(Text(printable(line), _ERROR))

    def _add(self, text: Text) -> None:
        self._texts.append(text)
        width = self.scrollable_content_region.width
        if width:
            self._wrap(text, width)
        else:  # it is hidden, and its width unknown
            self._wrapped_at = _STALE

    def on_resize(self, _event: events.Resize) -> None:
        """Rewrap the lines."""
        self._rewrap()

    def on_show(self) -> None:
        """Wrap lines written while the pane was hidden."""
        self._rewrap()

    def _rewrap(self) -> None:
        width = self.scrollable_content_region.width
        if width and self._wrapped_at != width:
            self.clear()
            for text in self._texts:
                self._wrap(text, width)
            self._wrapped_at = width

    def _wrap(self, text: Text, width: int) -> None:
        """Write lines so that what continues one is indented as its text."""
        for line in text.split("\n", allow_blank=True):
            for part in wrapped(line, width):
                self.write(part)


def wrapped(line: Text, width: int) -> list[Text]:
    """Return a line in pieces of at most a width, later ones indented as the first one's text.

    >>> [each.plain for each in wrapped(Text("@1    speed = 40 written there"), 18)]
    ['@1    speed = 40 ', '      written ', '      there']
    """
    head = _HEAD.match(line.plain)
    indent = len(head[0]) if head and len(head[0]) <= width // 2 else 0
    first, *rest = [*line.wrap(_PLAIN, width)] if line.cell_len > width else [line]
    if not rest or not indent:
        return [first, *rest]
    left = line[len(first.plain) :]
    left = left[len(left.plain) - len(left.plain.lstrip()) :]
    return [first, *(Text(" " * indent) + each for each in left.wrap(_PLAIN, width - indent))]


class OutputLog(RichLog):
    """The output of the programs up to the current position; a click goes to its origin."""

    class Chosen(Message):
        """The user clicks a line."""

        def __init__(self, number: int) -> None:
            super().__init__()
            self.number = number

    def __init__(self, **arguments: str) -> None:
        super().__init__(
            max_lines=_MAX_LINES,
            min_width=1,
            **arguments,  # type: ignore[arg-type]
        )
        self.border_title = "output"
        self._lines: tuple[OutputLine, ...] = ()

    def show(self, lines: tuple[OutputLine, ...]) -> None:
        """Show the output; less than before if the run has gone back."""
        known = len(self._lines)
        if lines[:known] != self._lines:
            self.clear()
            known = 0
        self.add(lines[known:])
        self._lines = lines

    def on_click(self, event: events.Click) -> None:
        """Post the line that is clicked, unless text is selected."""
        place = event.get_content_offset(self)
        if place is None or self.screen.get_selected_text():
            return
        row = place.y + self.scroll_offset.y
        if row < len(self.lines):
            number = self._lines[len(self._lines) - len(self.lines) + row].number
            self.post_message(self.Chosen(number))

    def add(self, lines: tuple[OutputLine, ...]) -> None:
        """Append new output."""
        for line in lines[-_MAX_LINES:]:
            self.write(_written(line))
        self._lines += lines


def _written(line: OutputLine) -> Text:
    text = Text(no_wrap=True)
    text.append(f"{line.writer}: " if line.writer else "", _WHO)
    return text.append(printable(line.text.expandtabs()), _ERROR if line.is_error else "")
