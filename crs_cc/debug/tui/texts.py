"""Two rolls of text: what was typed and answered, and what the programs write."""

from __future__ import annotations

from typing import Final

from rich.style import Style
from rich.text import Text
from textual.widgets import RichLog

from crs_cc.debug.tui.printable import printable

_MOST_LINES: Final = 2000
_ERROR: Final = Style(color="red")
_ECHO: Final = Style(dim=True)


class Console(RichLog):
    """Commands and their answers."""

    def __init__(self, **arguments: str) -> None:
        super().__init__(
            max_lines=_MOST_LINES,
            wrap=True,
            min_width=1,
            **arguments,  # type: ignore[arg-type]
        )
        self.border_title = "console"

    def echo(self, line: str) -> None:
        """Shows a command that is being run."""
        self.write(Text(f"(crs) {printable(line)}", _ECHO))

    def answer(self, text: Text) -> None:
        """Shows what a command says."""
        if text.plain:
            self.write(text)

    def error(self, line: str) -> None:
        """Shows what is wrong with a command."""
        self.write(Text(printable(line), _ERROR))


class Output(RichLog):
    """What the programs have written up to where the run stands."""

    def __init__(self, **arguments: str) -> None:
        super().__init__(
            max_lines=_MOST_LINES,
            min_width=1,
            **arguments,  # type: ignore[arg-type]
        )
        self.border_title = "output"
        self._text = ""

    def show(self, text: str) -> None:
        """Shows all that was written; less than before when the run has gone back."""
        if text == self._text:
            return
        more = text
        if self._text.endswith("\n") and text.startswith(self._text):
            more = text[len(self._text) :]
        else:
            self.clear()
        self._text = text
        for line in more.removesuffix("\n").split("\n")[-_MOST_LINES:]:
            self.write(Text(printable(line.expandtabs()), no_wrap=True))
