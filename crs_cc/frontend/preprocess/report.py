"""Messages of the preprocessor, up to a limit.

>>> source_map = SourceMap()
>>> text = source_map.add("a.c", "int a;")
>>> report = Report(Diagnostics(), source_map)
>>> report.error(text.start + 4, "'a' is wrong")
>>> report.diagnostics.messages[0].render()
"a.c:1:5: error: 'a' is wrong"
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, NoReturn

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.preprocess.source_text import Position, SourceMap

MAX_ERRORS: Final = 100
MAX_WARNINGS: Final = 100


class StopError(Exception):
    """Preprocessing cannot continue; the reason is in the diagnostics. It is caught internally."""


@dataclass(slots=True)
class Report:
    """Records the messages of one run.

    Attributes:
        diagnostics: receives the messages.
        source_map: maps a position to a location.
        is_complete: whether all text was read.
    """

    diagnostics: Diagnostics
    source_map: SourceMap
    is_complete: bool = True
    _errors: int = 0
    _warnings: int = 0

    def error(self, position: Position, text: str, hint: str = "") -> None:
        """Record an error; raise StopError if there are too many."""
        self.diagnostics.error(self.source_map.location(position), text, hint)
        self._errors += 1
        if self._errors >= MAX_ERRORS:
            self.fatal(position, f"too many errors ({MAX_ERRORS}), stopping now")

    def warning(self, position: Position, text: str, hint: str = "", *, flag: str) -> None:
        """Record a warning, unless there are too many; `flag` is its name."""
        self._warnings += 1
        if self._warnings <= MAX_WARNINGS:
            self.diagnostics.warning(self.source_map.location(position), text, hint, flag=flag)

    def note(self, position: Position, text: str) -> None:
        """Record a note to the preceding warning, if that was recorded."""
        if self._warnings <= MAX_WARNINGS:
            self.diagnostics.add("note", self.source_map.location(position), text)

    def fatal(self, position: Position, text: str, hint: str = "") -> NoReturn:
        """Record an error after which preprocessing cannot continue; raise StopError."""
        self.diagnostics.error(self.source_map.location(position), text, hint)
        raise StopError
