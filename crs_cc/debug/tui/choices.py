"""A list with a selected entry: stack frames, robots."""

from __future__ import annotations

from rich.style import Style
from rich.text import Text
from textual.message import Message
from textual.widgets import OptionList
from textual.widgets.option_list import Option

from crs_cc.debug.tui.printable import printable
from crs_cc.debug.tui.screen_data import ListEntry

_CURRENT = "▶ "


class ChoiceList(OptionList):
    """Shows entries, one a line; posts `Chosen` with the number of the selected one."""

    class Chosen(Message):
        """The user has selected an entry."""

        def __init__(self, control: ChoiceList, number: int) -> None:
            super().__init__()
            self.pane = control
            self.number = number

        @property
        def control(self) -> ChoiceList:
            """Return the list of the entry."""
            return self.pane

    def __init__(self, title: str, **arguments: str) -> None:
        super().__init__(**arguments)  # type: ignore[arg-type]
        self.border_title = title
        self._choices: tuple[ListEntry, ...] = ()

    def show(self, choices: tuple[ListEntry, ...]) -> None:
        """Show these entries."""
        if choices == self._choices:
            return
        self._choices = choices
        self.set_options([Option(_line(each)) for each in choices])
        current = [row for row, each in enumerate(choices) if each.is_current]
        self.highlighted = current[0] if current else None

    def on_option_list_option_selected(self, event: OptionList.OptionSelected) -> None:
        """Post the selected entry."""
        event.stop()
        self.post_message(self.Chosen(self, self._choices[event.option_index].number))


def _line(choice: ListEntry) -> Text:
    text = Text(no_wrap=True, overflow="ellipsis")
    text.append(_CURRENT if choice.is_current else "  ", Style(color="yellow", bold=True))
    text.append(f"{choice.number} ", Style(dim=True))
    text.append(printable(choice.text), Style(bold=choice.is_current))
    text.append(f"  {printable(choice.place)}", Style(dim=True))
    return text
