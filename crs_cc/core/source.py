"""Source locations and diagnostics.

Everything that a message can be about has a `Location`: tokens, IR instructions, world
elements. A `Diagnostic` is one message at one location; `Diagnostics` collects them so that
several errors are reported in one run.

>>> place = Location("wander.c", 3, 9)
>>> print(Diagnostic("error", place, "unknown identifier 'sped'", "    vm(sped, 0, 0);").render())
wander.c:3:9: error: unknown identifier 'sped'
        vm(sped, 0, 0);
            ^
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import Final, Literal

Severity = Literal["error", "warning", "note"]

Stage = Literal["", "preprocessing", "parsing", "types", "linking"]
"""The part of the compiler that reports, if any."""

_TOKEN: Final = re.compile(
    r""" \w+ | "(?:[^"\\]|\\.)*" | '(?:[^'\\]|\\.)*' | \+\+ | -- | . """, re.VERBOSE
)


@dataclass(frozen=True, slots=True, order=True)
class Location:
    """A location in a source file.

    Attributes:
        file: the path as the user gave it.
        line: line number, counted from 1; 0 when the message is about the whole file.
        column: column number in characters, counted from 1; 0 when only the line is known.
        last: column where the last token of an expression starts, if that is on the same line;
            0 when unknown. It is ignored when locations are compared.
    """

    file: str
    line: int = 0
    column: int = 0
    last: int = field(default=0, compare=False)

    def __reduce__(self) -> tuple[type[Location], tuple[str, int, int, int]]:
        # Cached programs hold thousands of locations; the default of `dataclass` is slow.
        return Location, (self.file, self.line, self.column, self.last)

    def __str__(self) -> str:
        parts = [self.file, *(str(number) for number in (self.line, self.column) if number)]
        return ":".join(parts)


def underline(line: str, location: Location) -> str:
    """Return the underline of an expression: `^~~~`, or `^` if its end is unknown.

    A final name followed by a parenthesis is a macro, which is underlined with its arguments.

    >>> line = "x = a / HALF(b) + 1;"
    >>> print(line); print("    " + underline(line, Location("a.c", 1, 5, last=9)))
    x = a / HALF(b) + 1;
        ^~~~~~~~~~~
    """
    token = _TOKEN.match(line, location.last - 1) if 0 < location.column <= location.last else None
    if token is None:
        return "^"
    end = token.end()
    if token[0].isidentifier() and line.startswith("(", end):
        end = _closing_index(line, end)
    return "^" + "~" * (end - location.column)


def _closing_index(line: str, start: int) -> int:
    """Return the index after the parenthesis matching the one at `start`, or the line's end."""
    depth = 0
    for token in _TOKEN.finditer(line, start):
        depth += {"(": 1, ")": -1}.get(token[0], 0)
        if depth == 0:
            return token.end()
    return len(line)


@dataclass(frozen=True, slots=True)
class Diagnostic:
    """One message about one location.

    Attributes:
        severity: error, warning or note.
        text: the message, without location and severity.
        source_line: the source line at the location, empty when unknown.
        hint: what the user can do about it; may be empty.
        stage: the part of the compiler that reports it.
        flag: the name of a warning, by which `-W` options select it; empty if it has none.
    """

    severity: Severity
    location: Location
    text: str
    source_line: str = ""
    hint: str = ""
    stage: Stage = ""
    flag: str = ""

    @property
    def named_text(self) -> str:
        """The message with the name of its warning: `text [-Wunused-value]`."""
        return f"{self.text} [-W{self.flag}]" if self.flag else self.text

    def render(self) -> str:
        """Return the message as `file:line:col: severity: text`, the line, a caret and the hint."""
        rows = [f"{self.location}: {self.severity}: {self.named_text}"]
        if self.source_line.strip():
            rows.append("    " + self.source_line.replace("\t", " ").rstrip())
            if self.location.column:
                indent = " " * (4 + self.location.column - 1)
                rows.append(indent + underline(self.source_line, self.location))
        if self.hint:
            rows.append(f"    hint: {self.hint}")
        return "\n".join(rows)


@dataclass(slots=True)
class Diagnostics:
    """The messages of one run, in the order in which they were found.

    Attributes:
        messages: every message so far.
        lines: the lines of each known file, for messages.
        digests: a hash of each file that was looked for, found or not, when it was first read; the
            result is valid while these are.
        stage: the part of the compiler that is running.
    """

    messages: list[Diagnostic] = field(default_factory=list)
    lines: dict[str, list[str]] = field(default_factory=dict)
    digests: dict[str, str] = field(default_factory=dict)
    stage: Stage = ""
    _known: set[Diagnostic] = field(default_factory=set, repr=False)

    def add(
        self, severity: Severity, location: Location, text: str, hint: str = "", flag: str = ""
    ) -> None:
        """Record a message, unless it is a duplicate."""
        line = self._line(location)
        message = Diagnostic(severity, location, text, line, hint, self.stage, flag)
        if message not in self._known:
            self._known.add(message)
            self.messages.append(message)

    def error(self, location: Location, text: str, hint: str = "") -> None:
        """Record an error."""
        self.add("error", location, text, hint)

    def warning(self, location: Location, text: str, hint: str = "", *, flag: str) -> None:
        """Record a warning; `flag` is its name, see `frontend.warn.flags`."""
        self.add("warning", location, text, hint, flag)

    def sort(self) -> None:
        """Sort the messages by location: headers first, notes after their messages."""
        files = {name: number for number, name in enumerate(self.lines)}
        groups: list[list[Diagnostic]] = []
        for message in self.messages:
            if message.severity == "note" and groups:
                groups[-1].append(message)
            else:
                groups.append([message])

        def key(group: list[Diagnostic]) -> tuple[int, int, int]:
            place = group[0].location
            return files.get(place.file, 0) or len(files), place.line, place.column

        groups.sort(key=key)
        self.messages[:] = [message for group in groups for message in group]

    def shorten(self, most: int) -> None:
        """Drop all but the first errors, and report how many were dropped."""
        errors = self.errors
        if len(errors) <= most:
            return
        left_out = {id(each) for each in errors[most:]}
        self.messages[:] = [each for each in self.messages if id(each) not in left_out]
        place = Location(errors[most].location.file, errors[most].location.line)
        self.error(place, f"and {len(left_out)} more errors from here on")

    @property
    def errors(self) -> list[Diagnostic]:
        """The errors alone."""
        return [message for message in self.messages if message.severity == "error"]

    def text_at(self, location: Location) -> str:
        """Return the source line from a location on; "" when it is unknown."""
        return self._line(location)[max(0, location.column - 1) :]

    def _line(self, location: Location) -> str:
        lines = self.lines.get(location.file, [])
        return lines[location.line - 1] if 0 < location.line <= len(lines) else ""
