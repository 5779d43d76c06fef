"""Build a program smaller that shows a difference: leaves out lines while the difference stays.

What is left out is a run of lines whose braces match, so whole functions and blocks go first, then
statements. A program counts as still showing the difference only while gcc finds nothing wrong
with it, and agrees with itself.
"""

from __future__ import annotations

from collections.abc import Callable

Shows = Callable[[str], bool]
"""Tells whether a program's text still shows the difference."""


def reduced(text: str, shows: Shows, most: int = 500) -> str:
    """Return a smaller text that `shows` accepts.

    >>> text = chr(10).join(["a", "f {", "x", "y", "}", "b"])
    >>> reduced(text, lambda shorter: "x" in shorter)
    'x'

    Args:
        text: the program, one statement or declaration in each line.
        shows: the test; `text` itself passes it.
        most: how often to ask it at most.
    """
    lines = text.split("\n")
    asked = 0
    size = max(1, len(lines) // 2)
    while size and asked < most:
        start, changed = 0, False
        while start < len(lines) and asked < most:
            shorter = [*lines[:start], *lines[_end(lines, start, size) :]]
            if len(shorter) < len(lines):
                asked += 1
                if shows("\n".join(shorter)):
                    lines, changed = shorter, True
                    continue
            start += max(1, size // 2)
        if not changed or size > 1:
            size //= 2
    return _without_braces(lines, shows)


def _end(lines: list[str], start: int, size: int) -> int:
    """Return where about `size` lines from `start` end, with as many braces closed as opened."""
    depth = 0
    for place in range(start, len(lines)):
        opened, closed = lines[place].count("{"), lines[place].count("}")
        if depth - closed < 0 and opened < closed:
            return place
        depth += opened - closed
        if depth == 0 and place - start + 1 >= size:
            return place + 1
    return len(lines)


def _without_braces(lines: list[str], shows: Shows) -> str:
    """Leave out lines with a brace that stays open, together with the line that closes it."""
    start = 0
    while start < len(lines):
        end = _end(lines, start, 1)
        inner = [*lines[:start], *lines[start + 1 : end - 1], *lines[end:]]
        if end > start + 1 and shows("\n".join(inner)):
            lines = inner
        else:
            start += 1
    return "\n".join(lines)
