r"""The preprocessed program, with a map back to the user's files.

>>> source_map = SourceMap()
>>> text = source_map.add("a.c", "  int speed = FAST;")
>>> writer = Writer()
>>> writer.line("  int x;", text.start)
>>> writer.tokens([Token("name", "speed", 6, False), Token("number", "200", 14, True)])
>>> program = writer.finish(source_map)
>>> program.text, str(program.location(1, 3)), str(program.location(2, 7))
('  int x;\nspeed 200\n', 'a.c:1:3', 'a.c:1:15')
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Hashable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Final

from crs_cc.core.source import Location
from crs_cc.frontend.preprocess.macros import Macro
from crs_cc.frontend.preprocess.source_text import Position, SourceMap, SourceText
from crs_cc.frontend.preprocess.tokens import NAME, NUMBER, PUNCTUATOR, Token


@dataclass(frozen=True, slots=True)
class _TokenLine:
    """The columns of the tokens in a line of output, and the positions that they come from."""

    columns: list[int]
    positions: list[Position]


def _position(mapped: Position | _TokenLine, row: str, column: int) -> Position:
    """Return where a column of a line of output comes from."""
    if isinstance(mapped, _TokenLine):
        return mapped.positions[bisect_right(mapped.columns, max(column, 1)) - 1]
    return mapped + min(max(column, 1) - 1, len(row))


@dataclass(frozen=True, slots=True)
class HeaderLines:
    """Consecutive lines of output that come from one of our headers.

    Attributes:
        first: the line of `Preprocessed.text` that is the first one here, counted from 1.
        text: the lines.
    """

    first: int
    text: str
    _rows: list[str]
    _lines: list[Position | _TokenLine]
    _source: SourceText

    def location(self, line: int, column: int) -> Location:
        """Return what `Preprocessed.location` does, without a reference to the whole program."""
        row = line - self.first
        return self._source.location(_position(self._lines[row], self._rows[row], column))

    def content(self) -> Hashable:
        """Return all that these lines are: equal for lines whose tokens and locations are equal.

        The positions in our headers are those of no other text. None if some tokens come from
        another file.
        """
        start, end = self._source.start, self._source.start + self._source.size
        places: list[object] = []
        for each in self._lines:
            if isinstance(each, _TokenLine):
                if min(each.positions) < start or max(each.positions) > end:
                    return None
                places.append((tuple(each.columns), tuple(each.positions)))
            else:
                places.append(each)
        return self.text, tuple(places)


@dataclass(frozen=True, slots=True)
class WeakName:
    """A name of `#pragma weak`; `alias` is the name that it stands for, "" if there is none."""

    location: Location
    alias: str


@dataclass(frozen=True, slots=True)
class Preprocessed:
    """C without directives, comments and macros.

    Attributes:
        text: the program, for the parser.
        macros: the macros at its end, by name.
        uses: the macros that were replaced, by position.
        weak: the names of `#pragma weak`, wherever in the program it is.
        more: preprocesses another text, given its name and content, after the last line.
        is_complete: whether all files were read to their ends. If not, what follows in the program
            can depend on what is missing.
    """

    text: str
    _rows: list[str]
    _lines: list[Position | _TokenLine]
    _source_map: SourceMap
    macros: Mapping[str, Macro] = field(default_factory=dict)
    uses: Mapping[Position, Sequence[Macro]] = field(default_factory=dict)
    weak: Mapping[str, WeakName] = field(default_factory=dict)
    more: Callable[[str, str], Preprocessed] | None = None
    is_complete: bool = True

    @property
    def files(self) -> tuple[str, ...]:
        """The names of the files that were read, as in messages."""
        return tuple(text.name for text in self._source_map.texts)

    def location(self, line: int, column: int) -> Location:
        """Return the location in the user's files of a position in `text`.

        Args:
            line: the line in `text`, counted from 1.
            column: the column in the line, counted from 1; 0 means its first token.

        Returns:
            The location of the token there, or of the macro call that it comes from. A position
            outside the text is moved to the nearest one inside.
        """
        if not self._lines:
            return Location(self._source_map.texts[-1].name)
        if line > len(self._lines):
            line, column = len(self._lines), 1 << 30
        row = max(line, 1) - 1
        position = _position(self._lines[row], self._rows[row], column)
        return self._source_map.location(position)

    def pieces(self) -> Iterator[str | HeaderLines]:
        """Yield the program's lines, those of one of our headers together."""
        start, source = 0, None
        low = high = -1
        for row, mapped in enumerate(self._lines):
            position = mapped.positions[0] if isinstance(mapped, _TokenLine) else mapped
            if low <= position <= high:
                continue
            if row > start:
                yield self._piece(start, row, source)
            start, source = row, self._source_map.text(position)
            low, high = source.start, source.start + source.size
        if self._lines:
            yield self._piece(start, len(self._lines), source)

    def _piece(self, start: int, stop: int, source: SourceText | None) -> str | HeaderLines:
        rows = self._rows[start:stop]
        text = "\n".join(rows)
        if source is None or not source.is_ours:
            return text
        return HeaderLines(start + 1, text, rows, self._lines[start:stop], source)

    def macro_uses(self) -> dict[Location, Sequence[Macro]]:
        """Return the macros that were replaced, by the location of the call."""
        return {
            self._source_map.location(position): macros for position, macros in self.uses.items()
        }

    def definition(self, macro: Macro) -> Location:
        """Return the location of a macro's definition."""
        return self._source_map.location(macro.position)


_AS_SPACE: Final = str.maketrans("\v\f", "  ")


@dataclass(slots=True)
class Writer:
    """Collects the output."""

    _rows: list[str] = field(default_factory=list)
    _lines: list[Position | _TokenLine] = field(default_factory=list)

    def line(self, text: str, position: Position) -> None:
        """Write a line of the source unchanged."""
        is_literal = '"' in text or "'" in text  # which may contain such characters
        self._rows.append(text.rstrip() if is_literal else text.rstrip().translate(_AS_SPACE))
        self._lines.append(position)

    def tokens(self, tokens: Sequence[Token]) -> None:
        """Write a line of tokens."""
        if not tokens:
            return
        parts: list[str] = []
        columns: list[int] = []
        column = 1
        before = tokens[0]
        for token in tokens:
            if column > 1 and (token.spaced or would_merge(before, token)):
                parts.append(" ")
                column += 1
            columns.append(column)
            parts.append(token.text)
            column += len(token.text)
            before = token
        self._rows.append("".join(parts))
        self._lines.append(_TokenLine(columns, [token.position for token in tokens]))

    def tail(self, size: int) -> str:
        """Return about the last characters that were written."""
        parts: list[str] = []
        for line in reversed(self._rows):
            parts.append(line[-size:])
            size -= len(line) + 1
            if size <= 0:
                break
        return "\n".join(reversed(parts))

    def finish(self, source_map: SourceMap) -> Preprocessed:
        """Return the program."""
        text = "\n".join([*self._rows, ""]) if self._rows else ""
        return Preprocessed(text, self._rows, self._lines, source_map)


_LONGER: Final = (
    "++ -- && || << >> == -> += -= *= /= %= &= |= ^= != <= >= ## .. // /* <: <% :> %> %: ::"
)
"""Pairs of characters that form or start one token, or a comment."""


def would_merge(left: Token, right: Token) -> bool:
    """Return whether two adjacent tokens would be read as other tokens."""
    if left.kind in (NAME, NUMBER):
        return right.kind != PUNCTUATOR or (left.kind == NUMBER and right.text[0] in "+-.")
    if right.kind == NUMBER:
        return left.text == "."
    return left.text[-1] + right.text[0] in _LONGER
