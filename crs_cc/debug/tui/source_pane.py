"""The source pane: highlighted lines with numbers, the current line, and a gutter of breakpoints.

A click in the gutter toggles a breakpoint; elsewhere it moves the cursor, as the arrow keys do.
"""

from __future__ import annotations

from functools import lru_cache
from typing import ClassVar, Final

from rich.segment import Segment
from rich.style import Style
from rich.syntax import Syntax
from rich.text import Span, Text
from textual import events
from textual.binding import Binding, BindingType
from textual.geometry import Region, Size
from textual.message import Message
from textual.scroll_view import ScrollView
from textual.strip import Strip

from crs_cc.debug.tui.printable import printable
from crs_cc.debug.tui.screen_data import SourceData

_MARKS: Final = 3  # cells before the line number: breakpoint, arrow, space
_CONTEXT: Final = 4  # lines to keep in sight around the current one
_MAX_COLOURED: Final = 20_000  # lines; beyond, colours would take seconds
_TAB: Final = 8

_BREAKPOINT: Final = Style(color="red", bold=True)
_OFF: Final = Style(color="red", dim=True)
_ARROW: Final = Style(color="yellow", bold=True)
_NUMBER: Final = Style(dim=True)


class SourcePane(ScrollView, can_focus=True):
    """Shows a file; posts `Toggle` to set or remove a breakpoint.

    Attributes:
        cursor: the line of the cursor, from 1.
    """

    COMPONENT_CLASSES: ClassVar[set[str]] = {"source--current", "source--cursor"}
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up,k", "move(-1)", show=False),
        Binding("down,j", "move(1)", show=False),
        Binding("pageup", "page(-1)", show=False),
        Binding("pagedown,space", "page(1)", show=False),
        Binding("home,g", "move(-10_000_000)", show=False),
        Binding("end,G", "move(10_000_000)", show=False),
        Binding("enter", "breakpoint", show=False),
    ]

    class Toggle(Message):
        """The user toggles the breakpoint at a line."""

        def __init__(self, line: int) -> None:
            super().__init__()
            self.line = line

    def __init__(self, **arguments: str) -> None:
        super().__init__(**arguments)  # type: ignore[arg-type]
        self._snapshot = SourceData()
        self._coloured: list[Text] = []
        self.cursor = 1

    @property
    def file(self) -> str:
        """Return the name of the file that is shown."""
        return self._snapshot.file

    def show(self, snapshot: SourceData) -> None:
        """Show a file; scroll to the current line if it has changed."""
        before, self._snapshot = self._snapshot, snapshot
        altered = {before.line, self.cursor, snapshot.line}
        altered |= {
            line
            for line in before.breakpoints.keys() | snapshot.breakpoints.keys()
            if before.breakpoints.get(line) != snapshot.breakpoints.get(line)
        }
        if (snapshot.file, snapshot.lines) != (before.file, before.lines):
            self._coloured = _colour(snapshot.file, tuple(snapshot.lines))
            width = max((each.cell_len for each in self._coloured), default=0)
            self.virtual_size = Size(width + self._gutter, len(self._coloured))
            self.cursor = 1
        if snapshot.line and (snapshot.file, snapshot.line) != (before.file, before.line):
            self.cursor = snapshot.line
        if self.border_title != (snapshot.file or "no source"):  # it draws all of the pane
            self.border_title = snapshot.file or "no source"
        if (snapshot.file, snapshot.line) != (before.file, before.line):
            self.reveal(self.cursor)  # at once: else the lines would be drawn twice
            self.call_after_refresh(self.reveal, self.cursor)
        if snapshot.file != before.file or snapshot.lines != before.lines:
            self.refresh()
        for line in altered | {self.cursor}:  # a line is a twentieth of what a terminal gets
            self.refresh_lines(line - 1)

    def reveal(self, line: int) -> None:
        """Scroll a line into view, with some context."""
        height = self.scrollable_content_region.height
        if not height:
            return
        around = min(_CONTEXT, (height - 1) // 2)
        top, first = line - 1, round(self.scroll_y)
        if top < first + around or top >= first + height - around:
            near = first - height < top < first + 2 * height
            last = top - around if top < first + around else top - height + 1 + around
            to = max(0, last if near else top - height // 3)
            self.scroll_to(y=to, animate=False, immediate=True)

    def on_resize(self) -> None:
        """Keep the cursor in view."""
        self.reveal(self.cursor)

    @property
    def _gutter(self) -> int:
        return _MARKS + len(str(max(1, len(self._coloured)))) + 2

    def render_line(self, y: int) -> Strip:
        """Render a line of the screen."""
        scroll_x, scroll_y = self.scroll_offset
        number = scroll_y + y + 1
        width = self.scrollable_content_region.width
        if number > len(self._coloured):
            return Strip.blank(width, self.rich_style)
        gutter = Strip(self._marks(number))
        text = Strip(self._coloured[number - 1].render(self.app.console))
        text = text.crop(scroll_x, scroll_x + max(0, width - gutter.cell_length))
        line = Strip.join([gutter, text]).crop(0, width).extend_cell_length(width)
        return line.apply_style(self._background(number)).simplify()

    def _marks(self, number: int) -> list[Segment]:
        snapshot = self._snapshot
        mark = snapshot.breakpoints.get(number)
        dot = " " if mark is None else "●" if mark.enabled else "○"
        arrow = " " if number != snapshot.line else "▶" if snapshot.innermost else "▷"
        digits = len(str(len(self._coloured)))
        return [
            Segment(dot, _BREAKPOINT if mark and mark.enabled else _OFF),
            Segment(arrow, _ARROW),
            Segment(f" {number:>{digits}}  ", _NUMBER),
        ]

    def _background(self, number: int) -> Style:
        if number == self._snapshot.line:
            return self.get_component_rich_style("source--current")
        if number == self.cursor and self.has_focus:
            return self.get_component_rich_style("source--cursor")
        return self.rich_style

    def on_click(self, event: events.Click) -> None:
        """Move the cursor, or toggle a breakpoint in the gutter."""
        place = event.get_content_offset(self)
        if place is None:
            return
        line = place.y + self.scroll_offset.y + 1
        if line > len(self._coloured):
            return
        self._mark(line)
        if place.x < self._gutter - 1:
            self.post_message(self.Toggle(line))

    def go_to(self, line: int) -> None:
        """Move the cursor to a line, and scroll it into view."""
        self._mark(min(max(1, line), max(1, len(self._coloured))))
        self.call_after_refresh(self.reveal, self.cursor)

    def search(self, text: str) -> bool:
        """Go to the next line with a text, from the cursor on and then from the start."""
        count, wanted = len(self._coloured), text.lower()
        for step in range(1, count + 1):
            number = (self.cursor - 1 + step) % count
            if wanted in self._coloured[number].plain.lower():
                self.go_to(number + 1)
                return True
        return False

    def action_move(self, lines: int) -> None:
        """Move the cursor."""
        self._mark(min(max(1, self.cursor + lines), max(1, len(self._coloured))))
        self.reveal(self.cursor)

    def action_page(self, pages: int) -> None:
        """Move the cursor by a page."""
        self.action_move(pages * max(1, self.scrollable_content_region.height - 1))

    def action_breakpoint(self) -> None:
        """Toggle a breakpoint at the cursor."""
        self.post_message(self.Toggle(self.cursor))

    def _mark(self, line: int) -> None:
        self.cursor = line
        self.refresh(Region(0, 0, *self.size))


@lru_cache(maxsize=64)
def _colour(file: str, lines: tuple[str, ...]) -> list[Text]:
    """Return the lines with syntax highlighting, tabs as spaces."""
    plain = [printable(line.expandtabs(_TAB)) for line in lines]
    if not file.endswith((".c", ".h")) or len(plain) > _MAX_COLOURED:
        return [Text(line) for line in plain]
    syntax = Syntax("", "c", theme="monokai", background_color="default")
    text = syntax.highlight("\n".join(plain))
    text.style = ""  # the background is that of the line
    text.spans = [Span(each.start, each.end, _foreground(each.style)) for each in text.spans]
    return list(text.split("\n", allow_blank=True)[: len(plain)])


def _foreground(style: Style | str) -> Style:
    """Return a style without its background."""
    if isinstance(style, str):
        return Style()
    return Style(color=style.color, bold=style.bold, italic=style.italic)
