r"""An open source file: the current line, and the open conditional groups.

>>> from crs_cc.frontend.preprocess.source_text import SourceMap
>>> text = SourceMap().add("a.c", "int a;\nint b;")
>>> reader = Reader(text, "a.c", Path("."))
>>> reader.next_line(), reader.next_line(), reader.next_line()
(('int a;', 0), ('int b;', 7), None)
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from crs_cc.frontend.preprocess.includes import Header
from crs_cc.frontend.preprocess.source_text import Position, SourceText


@dataclass(slots=True)
class Conditional:
    """A group of lines between `#if` and `#endif` (C17 6.10.1).

    Attributes:
        directive: the directive at its start, such as `#ifdef`.
        position: the position of that directive.
        active: whether the lines of its current part are used.
        done: whether no later part can be used: one was, or the whole group is skipped.
        else_position: the position of its `#else`.
    """

    directive: str
    position: Position
    active: bool
    done: bool
    else_position: Position | None = None


@dataclass(slots=True)
class Reader:
    r"""An open file.

    Attributes:
        name: its name, whatever the directory in which the program lies: that of the main file, or
            the way from there to a header, or a header's name in the directories of `-I`.
        folder: the directory that `#include "..."` searches first.
        header: the header that it is; None for the main file.
        presumed_name: the value of `__FILE__`: `name`, which `#line` can change.
        line_offset: the difference of `__LINE__` from the line number, which `#line` can change.
        conditionals: the open groups, the innermost last.
        position: the position of the next line.
    """

    text: SourceText
    name: str
    folder: Path
    header: Header | None = None
    presumed_name: str = ""
    line_offset: int = 0
    conditionals: list[Conditional] = field(default_factory=list)
    position: Position = 0
    _index: int = 0

    def __post_init__(self) -> None:
        self.presumed_name = self.name
        self.position = self.text.start

    @property
    def skipping(self) -> bool:
        """Whether the current lines are skipped."""
        return bool(self.conditionals) and not self.conditionals[-1].active

    def next_line(self) -> tuple[str, Position] | None:
        """Return the next logical line and its position, None at the end of the file."""
        lines = self.text.lines
        if self._index >= len(lines):
            return None
        line = lines[self._index]
        position = self.position
        self._index += 1
        self.position = position + len(line) + 1
        return line, position
