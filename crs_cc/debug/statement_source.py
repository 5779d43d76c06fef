"""The source text of a statement, from its location on."""

from __future__ import annotations

import contextlib
import re
from dataclasses import dataclass
from typing import Final

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Location
from crs_cc.debug.data.statement_text import cut
from crs_cc.debug.errors import DebugError
from crs_cc.debug.view import View

_LINES: Final = 20
_HEAD: Final = re.compile(r"(?:(?:->|[\w.\[\]*-])+\s*(?:[-+*/%&|^]|<<|>>)?=\s*)?(?:!\s*)*$")
"""What belongs to an expression before its location: an assignment's target, negations."""
_COMMENT: Final = re.compile(
    r'("(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)*\')|/\*.*?\*/|//[^\n]*', re.DOTALL
)


@dataclass(frozen=True, slots=True)
class StatementSource:
    """The text of a statement: as it is written, in one line, and with macros expanded."""

    shown: str
    text: str


def statement_source(view: View, robot: int, function: str, location: Location) -> StatementSource:
    """Return the source of what was done at a location in a function of a robot's program."""
    lines = view.source(location.file)[location.line - 1 :][:_LINES]
    before = lines[0][: location.column - 1] if lines else ""
    head = _HEAD.search(before)
    start = location.column - 1 if head is None else head.start()
    text = _COMMENT.sub(lambda found: found[1] or " ", "\n".join(lines)[start:])
    shown = cut(text)
    with contextlib.suppress(DebugError, CompileError):
        text = view.names_in(robot, function, location.file).expanded(shown)
    return StatementSource(" ".join(shown.split()), text)
