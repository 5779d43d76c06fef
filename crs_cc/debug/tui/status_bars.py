"""One-line bars: buttons (keys, names of panes), and the status of the run."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

from rich.segment import Segment
from rich.style import Style
from rich.text import Text
from textual import events
from textual.reactive import reactive
from textual.strip import Strip
from textual.widget import Widget

from crs_cc.debug.tui.printable import printable
from crs_cc.debug.tui.screen_data import ScreenData

_WIDE: Final = 110  # columns; below that counts of timesteps are omitted
_KEY: Final = Style(bold=True, color="yellow")
_CHOSEN: Final = Style(reverse=True)
_RUNNING: Final = Style(bold=True, color="black", bgcolor="green")
_BADGES: Final = {
    "stopped": Style(bold=True, color="black", bgcolor="yellow"),
    "over": Style(bold=True, color="white", bgcolor="blue"),
    "error": Style(bold=True, color="white", bgcolor="red"),
}


@dataclass(frozen=True, slots=True)
class Button:
    """A button in a bar.

    Attributes:
        text: its label.
        action: its Textual action.
        key: its key, shown before it.
        is_chosen: whether it is selected.
    """

    text: str
    action: str
    key: str = ""
    is_chosen: bool = False


class ButtonBar(Widget):
    """A line of buttons, as many as fit."""

    buttons: reactive[tuple[Button, ...]] = reactive(())

    def render_line(self, _y: int) -> Strip:
        """Render the bar."""
        strip = Strip([])
        for each in self.buttons:
            longer = Strip([*strip, *_button(each)])
            if longer.cell_length > self.size.width + 1:  # the last cell is a space
                break
            strip = longer
        strip = strip.adjust_cell_length(self.size.width)
        return strip.apply_style(self.rich_style)

    async def on_click(self, event: events.Click) -> None:
        """Run the action of the button under the pointer."""
        left = 0
        for each in self.buttons:
            right = left + Strip(_button(each)).cell_length
            if left <= event.x < right:
                await self.run_action(f"app.{each.action}")
                return
            left = right


def _button(button: Button) -> Sequence[Segment]:
    if button.key:
        return [Segment(button.key, _KEY), Segment(f" {button.text} ")]
    return [Segment(f" {button.text} ", _CHOSEN if button.is_chosen else None), Segment(" ")]


class StatusBar(Widget):
    """Shows what runs, or why it has stopped, and the time."""

    snapshot: reactive[ScreenData] = reactive(ScreenData())
    running: reactive[str] = reactive("")

    def render(self) -> Text:
        """Render the line: the reason, then the time, as far as there is room."""
        text = Text(no_wrap=True, overflow="ellipsis")
        if self.running:
            text.append(" running ", _RUNNING)
            text.append(f" {printable(self.running)}   Ctrl-C stops it")
            return text
        text.append(f" {self.snapshot.badge} ", _BADGES[self.snapshot.badge])
        text.append(f" {printable(self.snapshot.state)}")
        place = f"  {self.snapshot.time_s:.3f} s  "
        if self.size.width >= _WIDE:
            place += f"{self.snapshot.place} "
        room = self.size.width - len(place)
        if room >= len(place):
            text.truncate(room, overflow="ellipsis", pad=True)
            text.append(place, Style(bold=True))
        return text
