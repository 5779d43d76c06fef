"""The grid of panes, and its layout by screen size.

A large screen shows all of them. On smaller ones only one of the lower panes is
shown at a time, selected in a bar of their names; on the smallest only source and console.
"""

from __future__ import annotations

from typing import Final

from textual.app import ComposeResult
from textual.containers import Container
from textual.widget import Widget

from crs_cc.debug.tui.choices import ChoiceList
from crs_cc.debug.tui.logs import ConsoleLog, OutputLog
from crs_cc.debug.tui.map_pane import MapPane
from crs_cc.debug.tui.screen_data import ScreenData
from crs_cc.debug.tui.source_pane import SourcePane
from crs_cc.debug.tui.status_bars import Button, ButtonBar
from crs_cc.debug.tui.variables_pane import VariablesPane

LOWER: Final = ("variables", "stack", "robots", "chart", "output", "console")
"""The lower panes, in the order of their names in the bar."""

_NAMES: Final = {"chart": "map"}


class Panes(Container):
    """The grid."""

    def compose(self) -> ComposeResult:
        """Create the panes, in the order of the grid's cells."""
        yield SourcePane(id="source", classes="pane")
        yield ButtonBar(id="tabs")
        yield MapPane(id="chart", classes="pane lower")
        yield VariablesPane(id="variables", classes="pane lower")
        yield ConsoleLog(id="console", classes="pane lower")
        yield OutputLog(id="output", classes="pane lower")
        yield ChoiceList("stack", id="stack", classes="pane lower")
        yield ChoiceList("robots", id="robots", classes="pane lower")

    def on_mount(self) -> None:
        """Select the first of the lower panes."""
        self.pick(LOWER[0])

    @property
    def picked(self) -> str:
        """Return the selected lower pane."""
        return next(name for name in LOWER if self.pane(name).has_class("-shown"))

    def pane(self, name: str) -> Widget:
        """Return a pane."""
        return self.query_one(f"#{name}")

    def pick(self, name: str) -> None:
        """Select a lower pane."""
        buttons = []
        for each in LOWER:
            self.pane(each).set_class(each == name, "-shown")
            buttons.append(Button(_NAMES.get(each, each), f"pick('{each}')", "", each == name))
        self.query_one("#tabs", ButtonBar).buttons = tuple(buttons)

    def move(self, steps: int) -> None:
        """Select the lower pane some steps further on."""
        self.pick(LOWER[(LOWER.index(self.picked) + steps) % len(LOWER)])

    def show(self, snapshot: ScreenData, *, moved: bool) -> None:
        """Show a stopped run."""
        self.query_one(SourcePane).show(snapshot.source)
        self.query_one(MapPane).world_map = snapshot.world_map
        self.query_one(VariablesPane).show(snapshot.variables, moved=moved)
        self.query_one("#output", OutputLog).show(snapshot.output)
        self.query_one("#stack", ChoiceList).show(snapshot.frames)
        self.query_one("#robots", ChoiceList).show(snapshot.robots)
