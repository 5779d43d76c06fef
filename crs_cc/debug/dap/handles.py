"""Handles: numbers by which a client refers to objects until the run moves.

>>> handles = Handles()
>>> handles.give("a scope"), handles.give("a struct")
(1, 2)
>>> handles.take(2)
'a struct'
"""

from __future__ import annotations

from typing import Any, Final

from crs_cc.debug.dap.arguments import RefusalError

MAX: Final = 100_000  # handles per stop; chosen by us


class Handles:
    """Objects by number. Numbers are never reused, so stale ones are detected."""

    def __init__(self) -> None:
        self._first = 1
        self._things: list[Any] = []

    def clear(self) -> None:
        """Invalidate all handles."""
        self._first += len(self._things)
        self._things.clear()

    def give(self, thing: Any) -> int:
        """Assign a number to an object; raise RefusalError if there are too many."""
        if len(self._things) >= MAX:
            raise RefusalError("too many variables are expanded: collapse some, or resume")
        self._things.append(thing)
        return self._first + len(self._things) - 1

    def take(self, number: int) -> Any:
        """Return the object with a number; raise RefusalError if it is unknown or stale."""
        if not self._first <= number < self._first + len(self._things):
            raise RefusalError("the reference is no longer valid: the programs have moved on")
        return self._things[number - self._first]
