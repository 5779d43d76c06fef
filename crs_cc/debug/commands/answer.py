"""The answer of a command: lines of text and of source."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

LineKind = Literal["text", "stop", "place", "log", "error"]
"""The kind of a line: an answer, the reason of a stop, a location, the message of a log
point, an error."""


@dataclass(frozen=True, slots=True)
class Line:
    """A line of an answer.

    Attributes:
        text: its text, without colours.
        indent: the column in which it continues if it is longer than a line of the screen.
    """

    text: str
    kind: LineKind = "text"
    indent: int = 0


@dataclass(frozen=True, slots=True)
class SourceLine:
    """A source line.

    Attributes:
        number: its number in its file.
        code: the line.
        is_current: whether it is the current line.
        has_breakpoint: whether it has a breakpoint.
    """

    number: int
    code: str
    is_current: bool = False
    has_breakpoint: bool = False

    @property
    def head(self) -> str:
        """Return the prefix of the line: marks and number."""
        mark = "=>" if self.is_current else "  "
        return f"{mark}{'*' if self.has_breakpoint else ' '}{self.number:4}  "

    @property
    def text(self) -> str:
        """Return the line as plain text.

        >>> SourceLine(12, "x = 3;", is_current=True).text
        '=>   12  x = 3;'
        """
        return (self.head + self.code.expandtabs()).rstrip()


@dataclass(frozen=True, slots=True)
class NestedCommand:
    """Another command that is executed here, and answers here.

    Attributes:
        text: the command with its arguments.
    """

    text: str


Answer = Iterator[str | Line | SourceLine | NestedCommand]
"""The answer of a command, line by line while it runs; a `str` is a `Line` of text."""
