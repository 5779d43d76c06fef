"""Reduces a program that shows a difference by removing lines.

It removes sequences of lines with balanced braces: first whole functions and blocks, then
statements. A reduced program must be free of warnings, and gcc must agree with itself about it.
"""

from __future__ import annotations

from collections.abc import Callable

Shows = Callable[[str], bool]
"""Returns whether a program's text still shows the difference."""


def reduced(text: str, shows: Shows, most: int = 500) -> str:
    """Return a smaller text that `shows` accepts.

    >>> text = chr(10).join(["a", "f {", "x", "y", "}", "b"])
    >>> reduced(text, lambda shorter: "x" in shorter)
    'x'

    Args:
        text: the program, with one statement or declaration per line.
        shows: the test, which `text` itself passes.
        most: the maximum number of tests.
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
    """Return the end of about `size` lines from `start` with balanced braces."""
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
    """Remove lines that open a brace together with the lines that close it."""
    start = 0
    while start < len(lines):
        end = _end(lines, start, 1)
        inner = [*lines[:start], *lines[start + 1 : end - 1], *lines[end:]]
        if end > start + 1 and shows("\n".join(inner)):
            lines = inner
        else:
            start += 1
    return "\n".join(lines)
