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
Tab moves between panes, the arrow keys within a pane; Enter expands or selects.

Click in the gutter of the source to set a breakpoint. Drag the timeline to go to a time; its \
arrow keys move by timesteps, with Shift by events. Click a line of output to go to the statement \
that printed it.

"/text" on the command line finds the next source line with this text, "/" repeats the search; \
"list" scrolls the source. Type a part of an earlier command, then Ctrl-R, to recall it.

"help" on the command line explains the commands. Escape closes this page.
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
