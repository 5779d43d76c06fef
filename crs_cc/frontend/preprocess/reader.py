r"""An open file: where reading stands in it, and which of its conditional groups are open.

>>> from crs_cc.frontend.preprocess.source_text import Places
>>> text = Places().add("a.c", "int a;\nint b;")
>>> reader = Reader(text, Path("."))
>>> reader.next_line(), reader.next_line(), reader.next_line()
(('int a;', 0), ('int b;', 7), None)
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from crs_cc.frontend.preprocess.includes import Header
from crs_cc.frontend.preprocess.source_text import Place, SourceText


@dataclass(slots=True)
class Conditional:
    """A group of lines between `#if` and `#endif` (C17 6.10.1).

    Attributes:
        directive: what began it, as `#ifdef`.
        place: where.
        active: whether the lines of its present part are used.
        done: whether no later part can be used: one was, or the whole is skipped.
        else_place: where its `#else` is.
    """

    directive: str
    place: Place
    active: bool
    done: bool
    else_place: Place | None = None


@dataclass(slots=True)
class Reader:
    r"""An open file.

    Attributes:
        text: its text.
        folder: where `#include "..."` looks first.
        header: how the file was found; none for the main file.
        presumed_name: what `__FILE__` gives, which `#line` can change.
        line_offset: what `__LINE__` adds to the line's number, which `#line` can change.
        conditionals: the open groups, the innermost last.
        place: where the next line begins.
    """

    text: SourceText
    folder: Path
    header: Header | None = None
    presumed_name: str = ""
    line_offset: int = 0
    conditionals: list[Conditional] = field(default_factory=list)
    place: Place = 0
    _index: int = 0

    def __post_init__(self) -> None:
        self.presumed_name = self.text.name
        self.place = self.text.start

    @property
    def skipping(self) -> bool:
        """Return whether the lines here are left out."""
        return bool(self.conditionals) and not self.conditionals[-1].active

    def next_line(self) -> tuple[str, Place] | None:
        """Return the next logical line and its place, none at the end of the file."""
        lines = self.text.lines
        if self._index >= len(lines):
            return None
        line = lines[self._index]
        place = self.place
        self._index += 1
        self.place = place + len(line) + 1
        return line, place
