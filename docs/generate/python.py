"""Tables of `docs/python.md`: the kinds of events."""

from __future__ import annotations

from crs_cc.api.events import EVENT_KINDS
from docs.generate import Fillers, table


def events() -> str:
    """Return the table of the kinds of events."""
    return table(("kind", "when"), [(f"`{kind}`", text) for kind, text in EVENT_KINDS.items()])


FILLERS: Fillers = {"events": events}
