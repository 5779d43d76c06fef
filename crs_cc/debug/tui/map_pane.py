"""The map: the world from above, as large as there is room."""

from __future__ import annotations

from rich.text import Text
from textual.message import Message
from textual.reactive import reactive
from textual.widget import Widget


class MapPane(Widget, can_focus=True):
    """Shows a map; posts `Resized` when another size of it is needed."""

    chart: reactive[Text] = reactive(Text)

    class Resized(Message):
        """There is another amount of room, in cells."""

        def __init__(self, width: int, height: int) -> None:
            super().__init__()
            self.width = width
            self.height = height

    def __init__(self, **arguments: str) -> None:
        super().__init__(**arguments)  # type: ignore[arg-type]
        self.border_title = "map"

    def render(self) -> Text:
        """Return the map."""
        return self.chart

    def on_resize(self) -> None:
        """Ask for a map of the new size."""
        self.post_message(self.Resized(*self.content_size))
