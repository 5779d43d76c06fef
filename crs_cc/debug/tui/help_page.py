"""The help page: the keyboard shortcuts."""

from __future__ import annotations

from typing import ClassVar

from rich.table import Table
from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import VerticalScroll
from textual.screen import ModalScreen
from textual.widgets import Static

from crs_cc.debug.tui.keys import help_rows

_MORE = """
Letters work outside the command line: Escape leaves it, ":" returns to it. \
Tab goes from pane to pane, the arrow keys move in it, Enter unfolds or picks.

In the gutter of the source a click sets a breakpoint. The time line is dragged; its arrow keys go \
by timesteps, with Shift from event to event.

"/text" in the command line goes to the next line of the source with this text, "/" to the one \
after it; "list" scrolls the source. Ctrl-R searches the commands typed before.

"help" in the command line explains the commands. Escape closes this page.
"""


class HelpPage(ModalScreen[None]):
    """Shows the shortcuts until a key is pressed."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape,enter,q,f1,question_mark", "dismiss", show=False),
    ]

    def compose(self) -> ComposeResult:
        """Create the widgets."""
        table = Table.grid(padding=(0, 2))
        for row in help_rows():
            table.add_row(*row)
        with VerticalScroll():
            yield Static(table)
            yield Static(_MORE)
