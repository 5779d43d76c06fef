"""Writes of an object from itself, one after the other, as in a loop: they are one cause."""

from __future__ import annotations

from crs_cc.debug.data.statement_text import is_count, source_of
from crs_cc.debug.last_write import MemoryObject, Write, writes_before
from crs_cc.debug.statement_source import statement_source
from crs_cc.debug.timeline.position import Position
from crs_cc.debug.view import View

MIN_REPEATS, MAX_REPEATS = 3, 10_000
"""So many changes of an object by itself, in a loop, are one node; no more are counted."""


def repeated(
    view: View, name: str, wanted: MemoryObject, before: Position, function: str
) -> tuple[int, Write | None]:
    """Return the number of last self-dependent writes of an object in a function, and the first.

    Args:
        view: shows the run.
        name: the object, as the statements name it.
        wanted: the object.
        before: the position before which it was changed.
        function: the function.
    """
    first, count = None, 0
    for write in writes_before(view.run, wanted, before):
        access = write.access
        if access is None or access.library or access.location is None:
            break
        if access.function != function or count >= MAX_REPEATS:
            break
        text = statement_source(view, wanted.robot, function, access.location).text
        if name not in source_of(text) and not is_count(text):
            break
        first, count = write, count + 1
    return count, first
