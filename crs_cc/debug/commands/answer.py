"""The lines in which a command answers."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

LineKind = Literal["text", "stop", "place", "log", "error"]
"""What a line is about: an answer, why a program stopped, where it stands, what a breakpoint
logs, what the user did wrong."""


@dataclass(frozen=True, slots=True)
class Line:
    """A line of an answer.

    Attributes:
        text: what it says, without colours.
        kind: what it is about.
    """

    text: str
    kind: LineKind = "text"


@dataclass(frozen=True, slots=True)
class SourceLine:
    """A line of C.

    Attributes:
        number: its number in its file.
        code: the line.
        is_current: whether the program stands there.
        has_breakpoint: whether a breakpoint is there.
    """

    number: int
    code: str
    is_current: bool = False
    has_breakpoint: bool = False

    @property
    def head(self) -> str:
        """Return what stands before the code: marks and the number."""
        mark = "=>" if self.is_current else "  "
        return f"{mark}{'*' if self.has_breakpoint else ' '}{self.number:4}  "

    @property
    def text(self) -> str:
        """Return the line as plain text.

        >>> SourceLine(12, "x = 3;", is_current=True).text
        '=>   12  x = 3;'
        """
        return (self.head + self.code.expandtabs()).rstrip()


Answer = Iterator[str | Line | SourceLine]
"""What a command answers, line by line, while it is at work; a `str` is a `Line` of text."""
