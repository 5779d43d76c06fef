r"""The text of a file after translation phases 1 to 3, with a map back to the original.

Lines with a continuation are joined, and comments become white space of the same length (C17
5.1.1.2). The result is split into logical lines. A *position* is a single number: the offset of a
character in the concatenated texts of a run. It is cheap to store, and `SourceMap` maps it to a
file, line and column on demand.

Each of our own headers has positions that no other text has, the same in every run of a process, so
that what was made of it can be used again.

>>> positions = SourceMap()
>>> text = positions.add("a.c", "int a; /* two\nlines */ int \\\n  b;\n")
>>> text.lines
['int a;       \x0b         int   b;', '']
>>> str(positions.location(text.lines[0].index("b")))
'a.c:3:3'
"""

from __future__ import annotations

import re
from bisect import bisect_right
from dataclasses import dataclass, field
from functools import lru_cache
from itertools import count
from typing import Final

from crs_cc.core.source import Location

Position = int

OUR_HEADERS: Final = 1 << 40
"""The first position in our own headers; there is not that much source in a program."""

_REGION: Final = 1 << 24
"""The distance of the starts of our headers, more than the size of any file."""

_regions: Final = count(OUR_HEADERS, _REGION)

_COMMENT_OR_QUOTE: Final = re.compile(
    r"""//[^\n]*
      | /\*[^*]*+\*/
      | /\*(?s:.)*?(?:\*/|\Z)
      | (?<![\w'])[0-9]\w*(?:'\w+)+
      | "[^"\\\n]*+(?:\\.[^"\\\n]*+)*"?
      | '[^'\\\n]*+(?:\\.[^'\\\n]*+)*'?""",
    re.VERBOSE,
)
_CONTROLS: Final = bytes({*range(32), 127} - set(b"\b\t\n\v\f\r\x1a\x1b"))
_TRIGRAPHS: Final = dict(zip("=(/)'<!>-", "#[\\]^{|}~", strict=True))
_TRIGRAPH: Final = re.compile(r"\?\?([=(/)'<!>-])")
_UNDECODABLE: Final = re.compile("[\udc80-\udcff]")


def decode(content: bytes) -> str:
    """Return the text of a UTF-8 file, with or without a byte order mark; lines end in newlines.

    Bytes that are not UTF-8 (old sources have Latin-1 in their comments) become surrogates, as
    Python's `surrogateescape` makes them.
    """
    text = content.removeprefix(b"\xef\xbb\xbf").decode("utf-8", "surrogateescape")
    text = text.replace("\r\n", "\n").replace("\r", "\n")
    return text.rstrip("\x1a")  # the end mark of DOS editors


def without_trigraphs(text: str) -> str:
    r"""Replace the nine trigraphs (C17 5.2.1.1); what follows in a line moves by two columns.

    >>> without_trigraphs("??=define A(x) x??(0??) ?????/")
    '#define A(x) x[0] ???\\'
    """
    return _TRIGRAPH.sub(lambda found: _TRIGRAPHS[found[1]], text)


def is_binary(content: bytes) -> bool:
    """Return whether bytes are not text in any encoding, but a program, a picture or an archive."""
    odd = len(content) - len(content.translate(None, _CONTROLS))
    return odd > 4 + len(content) // 100


def printable(text: str) -> str:
    """Return a printable text, with bytes that are not UTF-8 replaced."""
    return text if text.isascii() else _UNDECODABLE.sub("\N{REPLACEMENT CHARACTER}", text)


@dataclass(frozen=True, slots=True)
class SourceText:
    """The text of a file.

    Attributes:
        name: the file name, for messages.
        start: the position of its first character.
        size: the number of its positions.
        lines: its logical lines, without comments. A newline inside a comment is a vertical tab.
        line_starts: the offset of each line of the file in the logical text.
        unclosed_comment: the position of a comment without end.
    """

    name: str
    start: Position
    size: int
    lines: list[str]
    line_starts: list[int]
    unclosed_comment: Position | None

    @property
    def is_ours(self) -> bool:
        """Whether it is one of our headers."""
        return self.start >= OUR_HEADERS

    def location(self, position: Position) -> Location:
        """Return the line and column of a position in this file."""
        offset = min(position - self.start, self.size)
        line = bisect_right(self.line_starts, offset)
        return Location(self.name, line, offset - self.line_starts[line - 1] + 1)


@dataclass(slots=True)
class SourceMap:
    """All texts of a run, concatenated; our headers follow all others."""

    texts: list[SourceText] = field(default_factory=list)
    _by_start: list[SourceText] = field(default_factory=list)
    _starts: list[Position] = field(default_factory=list)
    _end: Position = 0

    def add(self, name: str, content: str, *, is_ours: bool = False) -> SourceText:
        """Append the content of a file with newlines as line ends."""
        if is_ours:
            text = _our_header(name, content)
        else:
            text = _logical(name, content, self._end)
            self._end += text.size + 1
        self.texts.append(text)
        index = bisect_right(self._starts, text.start)
        self._starts.insert(index, text.start)
        self._by_start.insert(index, text)
        return text

    def location(self, position: Position) -> Location:
        """Return the file, line and column of a position."""
        return self.text(position).location(position)

    def text(self, position: Position) -> SourceText:
        """Return the file of a position."""
        return self._by_start[bisect_right(self._starts, position) - 1]


@lru_cache(maxsize=256)
def _our_header(name: str, content: str) -> SourceText:
    """Return the text of one of our headers, at positions that no other text has."""
    return _logical(name, content, next(_regions))


def forget_headers() -> None:
    """Give our headers new positions, so that nothing that was made of them is used again."""
    _our_header.cache_clear()


def _logical(name: str, content: str, start: Position) -> SourceText:
    """Return the text of a file that starts at a position."""
    joined, line_starts = _join_lines(content)
    blanked, unclosed = _blank_comments(joined)
    return SourceText(
        name,
        start,
        len(joined),
        blanked.split("\n"),
        line_starts,
        None if unclosed is None else start + unclosed,
    )


def _join_lines(content: str) -> tuple[str, list[int]]:
    """Remove each backslash that ends a line, and the newline (C17 5.1.1.2, phase 2).

    White space after the backslash, which is invisible, is removed, too, as in gcc.

    Returns:
        The text, and the offset in it of each line of `content`.
    """
    parts: list[str] = []
    starts: list[int] = []
    offset = 0
    for line in content.split("\n"):
        starts.append(offset)
        if line[-1:] in "\\ \t" and (bare := line.rstrip(" \t")).endswith("\\"):
            part = bare[:-1]
        else:
            part = line + "\n"
        parts.append(part)
        offset += len(part)
    return "".join(parts).removesuffix("\n"), starts


def _blank_comments(text: str) -> tuple[str, int | None]:
    """Replace comments by white space of the same length (C17 5.1.1.2, phase 3).

    Returns:
        The text, and the offset of an unclosed comment.
    """
    unclosed = None

    def blank(match: re.Match[str]) -> str:
        nonlocal unclosed
        found = match.group()
        if found[0] != "/":
            return found
        if found[1] == "*" and (len(found) < 4 or not found.endswith("*/")):
            unclosed = match.start()
        return "\v".join(" " * len(part) for part in found.split("\n"))

    return _COMMENT_OR_QUOTE.sub(blank, text), unclosed
