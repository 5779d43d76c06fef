"""The full screen at 80x24, where most panes are hidden, over a real debugger."""

from __future__ import annotations

from pathlib import Path

import pytest
from rich.console import RenderableType
from textual._compositor import CompositorUpdate
from textual.pilot import Pilot
from textual.screen import Screen

from crs_cc.debug.tui.app import DebugApp
from crs_cc.debug.tui.controller import Controller
from crs_cc.debug.tui.panes import Panes
from crs_cc.debug.tui.program_streams import ProgramStreams
from crs_cc.debug.tui.source_pane import SourcePane
from tests.debug.debuggers import ROOT, debugger_at
from tests.debug.tui.screen import SMALL, drive, enter, settle, text_of

SOURCE = (
    "int count;\n"
    + "/* a line of a long file */\n" * 60
    + "static int far(void)\n{\n    return ++count;\n}\n"
    + "int main(void)\n{\n    int n = far();\n    return n;\n}\n"
)


@pytest.fixture
def controller(tmp_path: Path) -> Controller:
    path = tmp_path / "a.c"
    path.write_text(SOURCE)
    streams = ProgramStreams()
    return Controller(debugger_at([path], output=streams.write), streams)


def test_text_written_while_the_console_is_hidden_has_the_width_of_the_pane(
    controller: Controller,
) -> None:
    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        app.query_one(Panes).pick("console")
        await settle(pilot)
        app.query_one(Panes).pick("variables")
        await settle(pilot)
        await pilot.press("escape", "b")  # sets a breakpoint, and says so in the hidden console
        await settle(pilot)
        app.query_one(Panes).pick("console")
        await settle(pilot)
        assert "\nBreakpoint 1: main at\n" in text_of(app)  # the path is longer than a line

    drive(controller, session, SMALL)


def test_list_scrolls_the_source(controller: Controller) -> None:
    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        source = app.query_one(SourcePane)
        assert source.cursor == 68
        await enter(pilot, "list 5")
        await settle(pilot)
        assert source.cursor in range(4, 7)
        assert source.scroll_offset.y < 5
        await enter(pilot, "list far")
        await settle(pilot)
        assert source.scroll_offset.y < 62 <= source.scroll_offset.y + source.size.height
        await enter(pilot, "next")
        await settle(pilot)
        assert source.cursor == 69

    drive(controller, session, SMALL)


def test_a_slash_searches_the_source(controller: Controller) -> None:
    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        source = app.query_one(SourcePane)
        found = []
        await pilot.press("escape", "slash", *"FAR", "enter")
        await settle(pilot)
        found.append(source.cursor)
        for text in ("/", "/return", "/count", "/nowhere"):
            await enter(pilot, text)
            await settle(pilot)
            found.append(source.cursor)
        assert found == [62, 68, 69, 1, 1]
        await settle(pilot)
        assert "no line has 'nowhere'" in text_of(app)
        assert app.typed == []

    drive(controller, session, SMALL)


def test_a_step_sends_at_most_5_kb_to_the_terminal() -> None:
    """It scrolls the source by a line; before, all panes were drawn, the source twice."""
    streams, sent = ProgramStreams(), list[str]()
    wander = ROOT / "samples" / "scout_c" / "wander.c"
    controller = Controller(debugger_at([wander], "room.xml", output=streams.write), streams)

    def display(screen: Screen[object], update: RenderableType | None) -> None:
        assert isinstance(update, CompositorUpdate)
        sent.append(update.render_segments(screen.app.console))

    async def session(pilot: Pilot[int], app: DebugApp) -> None:
        app._display = display  # type: ignore[method-assign]
        await pilot.press("escape")
        await settle(pilot)
        for key in "snnnsN":
            sent.clear()
            await pilot.press(key)
            await settle(pilot)
            size = sum(len(each.encode()) for each in sent)
            assert 200 < size <= 5120, (key, size)

    drive(controller, session, SMALL)
