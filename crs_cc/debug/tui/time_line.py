"""The timeline: progress and events of the run; dragged, or moved by keys.

The bar extends from the start to the latest time that the run has reached. Its cursor is at the
start of the current timestep, whichever robot is selected: the clocks of programs may be ahead.
"""

from __future__ import annotations

import math
from typing import ClassVar, Final

from rich.segment import Segment
from rich.style import Style
from textual import events
from textual.binding import Binding, BindingType
from textual.message import Message
from textual.reactive import reactive
from textual.strip import Strip
from textual.widget import Widget

from crs_cc.debug.world.events import WorldEvent

_MARKS: Final = {
    "error": ("✖", Style(color="red", bold=True)),
    "collision": ("\N{MULTIPLICATION SIGN}", Style(color="red")),
    "bumper": ("\N{MULTIPLICATION SIGN}", Style(color="red")),
    "degradation": ("!", Style(color="magenta")),
    "message": ("~", Style(color="cyan")),
    "stop": ("●", Style(color="yellow")),
}
"""By kind of event its mark; the first ones win where several fall into one cell."""
_OTHER: Final = ("·", Style(dim=True))
_RANKS: Final = {kind: rank for rank, kind in enumerate(_MARKS)}

_PAST: Final = Style(color="green", bold=True)
_FUTURE: Final = Style(dim=True)
_HERE: Final = Style(color="black", bgcolor="yellow", bold=True)
_SLACK: Final = 1e-9  # of a timestep
_LABEL: Final = 11  # cells for the time at either end


class TimeLine(Widget, can_focus=True):
    """Shows the position of the run between start and end, and marks of events above."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("left", "press('reverse-tick')", show=False),
        Binding("right", "press('tick')", show=False),
        Binding("pageup", "press('reverse-tick 10')", show=False),
        Binding("pagedown", "press('tick 10')", show=False),
        Binding("shift+left,ctrl+left", "event(-1)", show=False),
        Binding("shift+right,ctrl+right", "event(1)", show=False),
        Binding("home", "ends(False)", show=False),
        Binding("end", "ends(True)", show=False),
    ]

    class Move(Message):
        """The user has requested to go to a time [s]."""

        def __init__(self, time_s: float) -> None:
            super().__init__()
            self.time_s = time_s

    class Press(Message):
        """The user has requested a command."""

        def __init__(self, command: str) -> None:
            super().__init__()
            self.command = command

    now_s: reactive[float] = reactive(0.0)
    timestep_s: reactive[float] = reactive(0.1)
    end_s: reactive[float] = reactive(0.0)
    happened: reactive[tuple[WorldEvent, ...]] = reactive(())
    held_s: reactive[float | None] = reactive(None)
    hint: reactive[str] = reactive("")

    @property
    def _cells(self) -> int:
        return max(1, self.size.width - 2 * _LABEL)

    def _cell(self, time_s: float) -> int:
        if self.end_s <= 0.0:
            return 0
        return min(self._cells - 1, max(0, round(time_s / self.end_s * (self._cells - 1))))

    def _time_at(self, x: int) -> float:
        share = (x - _LABEL) / max(1, self._cells - 1)
        return min(1.0, max(0.0, share)) * self.end_s

    def render_line(self, y: int) -> Strip:
        """Render the marks, or the bar below them."""
        width = self.size.width
        segments = self._bar() if y == self.size.height - 1 else self._marks()
        strip = Strip(segments).adjust_cell_length(width, self.rich_style)
        return strip.apply_style(self.rich_style).simplify()

    def _marks(self) -> list[Segment]:
        cells: dict[int, WorldEvent] = {}
        for each in self.happened:
            cell = self._cell(each.time_s)
            there = cells.get(cell)
            if there is None or _rank(each) < _rank(there):
                cells[cell] = each
        row = [Segment(" " * _LABEL)]
        for cell in range(self._cells):
            if cell in cells:
                row.append(Segment(*_MARKS.get(_family(cells[cell]), _OTHER)))
            else:
                row.append(Segment(" "))
        if self.hint:
            return _lay_over(row, self.hint, self.size.width)
        return row

    def _bar(self) -> list[Segment]:
        shown_s = self.now_s if self.held_s is None else self.held_s
        here = self._cell(shown_s)
        return [
            Segment(f"{_seconds(shown_s):>{_LABEL - 1}} ", _PAST),
            Segment("━" * here, _PAST),
            Segment("┃", _HERE),
            Segment("─" * (self._cells - here - 1), _FUTURE),
            Segment(f" {_seconds(self.end_s):<{_LABEL - 1}}", _FUTURE),
        ]

    def on_mouse_down(self, event: events.MouseDown) -> None:
        """Start dragging."""
        self.capture_mouse()
        self._hold(event.x)

    def on_mouse_move(self, event: events.MouseMove) -> None:
        """Drag the bar, or show the event under the pointer."""
        if self.held_s is not None:
            self._hold(event.x)
        else:
            self.hint = self._event_at(event.x)

    def on_mouse_up(self, _event: events.MouseUp) -> None:
        """End dragging."""
        self.release_mouse()
        self.held_s = None

    def on_leave(self) -> None:
        """Hide the event under the pointer."""
        self.hint = ""

    def _hold(self, x: int) -> None:
        held_s = self._time_at(x)
        if held_s != self.held_s:
            self.held_s = held_s
            self.post_message(self.Move(held_s))
        self.hint = self._event_at(x)

    def _event_at(self, x: int) -> str:
        here = [each for each in self.happened if self._cell(each.time_s) == x - _LABEL]
        if not here:
            return ""
        first = min(here, key=_rank)
        return f"{_seconds(first.time_s)} {first.text or first.kind}"

    def action_press(self, command: str) -> None:
        """Post a command."""
        self.post_message(self.Press(command))

    def action_event(self, direction: int) -> None:
        """Go to the previous or next event."""
        now, times = self._timestep(self.now_s), sorted({each.time_s for each in self.happened})
        if direction < 0:
            times = [each for each in times if self._timestep(each) < now]
        else:
            times = [each for each in times if self._timestep(each) > now]
        if times:
            self.post_message(self.Move(times[-1 if direction < 0 else 0]))

    def _timestep(self, time_s: float) -> int:
        """Return the timestep that contains a time, to which the run goes for it."""
        return math.floor(time_s / self.timestep_s + _SLACK)

    def action_ends(self, last: bool) -> None:
        """Go to the start or to the latest time."""
        self.post_message(self.Move(self.end_s if last else 0.0))


def _rank(event: WorldEvent) -> int:
    return _RANKS.get(_family(event), len(_RANKS))


def _family(event: WorldEvent) -> str:
    """Return the general kind: `message` for `message-lost`."""
    return event.kind.partition("-")[0]


def _seconds(time_s: float) -> str:
    """Return a formatted time.

    >>> _seconds(12.3456), _seconds(1234.5)
    ('12.346 s', '1234.5 s')
    """
    return f"{time_s:.3f} s" if time_s < 1000 else f"{time_s:.1f} s"


def _lay_over(row: list[Segment], text: str, width: int) -> list[Segment]:
    """Return a row with a text laid over its right end."""
    text = f" {text} "[:width]
    before = Strip(row).adjust_cell_length(width).crop(0, width - len(text))
    return [*before, Segment(text, Style(reverse=True))]
