"""The map pane."""

from __future__ import annotations

from rich.text import Text
from textual.message import Message
from textual.reactive import reactive
from textual.widget import Widget


class MapPane(Widget, can_focus=True):
    """Shows a map; posts `Resized` when its size changes."""

    world_map: reactive[Text] = reactive(Text)

    class Resized(Message):
        """The size has changed [cells]."""

        def __init__(self, width: int, height: int) -> None:
            super().__init__()
            self.width = width
            self.height = height

    def __init__(self, **arguments: str) -> None:
        super().__init__(**arguments)  # type: ignore[arg-type]
        self.border_title = "map"

    def render(self) -> Text:
        """Return the map."""
        return self.world_map

    def on_resize(self) -> None:
        """Request a map of the new size."""
        self.post_message(self.Resized(*self.content_size))
