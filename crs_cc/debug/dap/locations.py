"""Places in the words of the client: its paths, or ours; lines from 0 or from 1; sources by number.

Files of the user have paths. Those of the C library are told by a number, under which the client
asks for their text.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Final
from urllib.parse import unquote, urlsplit

from crs_cc.core.source import Location
from crs_cc.core.suggest import unknown
from crs_cc.debug.dap.arguments import Arguments, RefusalError
from crs_cc.debug.dap.framing import Message
from crs_cc.ir.names import LIBRARY
from crs_cc.session.library import SOURCES


class ClientLocations:
    """How this client counts and names, and which files the programs are made of."""

    def __init__(self) -> None:
        self._first_line = 1
        self._first_column = 1
        self._has_uris = False
        self._files: list[str] = []

    def configure(self, client: Arguments) -> None:
        """Adopt the conventions that a client announces.

        Raises:
            RefusalError: it wants an unknown format of paths.
        """
        first_line = int(client.flag("linesStartAt1", default=True))
        first_column = int(client.flag("columnsStartAt1", default=True))
        form = client.text("pathFormat", "path")
        if form not in {"path", "uri"}:
            raise RefusalError(unknown("path format", form, ("path", "uri")))
        self._first_line, self._first_column = first_line, first_column
        self._has_uris = form == "uri"

    def know(self, files: Iterable[str]) -> None:
        """Take the names of the files that the programs are made of; a file keeps its number."""
        known = set(self._files)
        self._files += [file for file in dict.fromkeys(files) if file not in known]

    def sources(self) -> list[Message]:
        """Return all files that are known."""
        return [self.source(file) for file in self._files]

    def source(self, file: str) -> Message:
        """Return a file as the client calls it."""
        name = file.rpartition("/")[2]
        if file.startswith(LIBRARY):
            self.know([file])
            number = self._files.index(file) + 1
            return {
                "name": name, "sourceReference": number, "origin": "library",
                "presentationHint": "deemphasize",
            }  # fmt: skip
        path = Path(os.path.abspath(file))  # noqa: PTH100 - links are kept as the user sees them
        return {"name": name, "path": path.as_uri() if self._has_uris else str(path)}

    def key(self, source: Arguments) -> str:
        """Return what tells a client's source from all others, whether programs have it or not.

        Raises:
            RefusalError: it says neither a path nor a number.
        """
        number = source.natural("sourceReference", 0)
        if number:
            return self._files[number - 1] if number <= len(self._files) else ""
        path = source.text("path", "") or source.text("name")
        if path.startswith("file:"):
            path = unquote(urlsplit(path).path)
        return "" if "\0" in path else os.path.realpath(path)

    def file_at(self, key: str) -> str | None:
        """Return the name that the programs have for the source with a key; None if they have none.

        Known are the names with which the user has called them, and the library's own.
        """
        if key in self._files:
            return key
        return next((file for file in self._files if os.path.realpath(file) == key), None)

    def text(self, file: str, lines: Sequence[str]) -> str:
        """Return the text of a file.

        Args:
            file: its name.
            lines: what the programs know of it; of the C library they know nothing.
        """
        if not file.startswith(LIBRARY):
            return "\n".join(lines)
        return (SOURCES / file.removeprefix(LIBRARY)).read_text("utf-8")

    def line(self, line: int) -> int:
        """Return a line as the client counts."""
        return line - 1 + self._first_line

    def column(self, column: int) -> int:
        """Return a column as the client counts; unknown ones are at the beginning."""
        return max(column, 1) - 1 + self._first_column

    def to_line(self, line: int) -> int:
        """Return a client's line as we count."""
        return line + 1 - self._first_line

    def to_column(self, column: int) -> int:
        """Return a client's column as we count."""
        return column + 1 - self._first_column

    def place(self, location: Location) -> Message:
        """Return a place: source, line and column."""
        return {
            "source": self.source(location.file),
            "line": self.line(location.line),
            "column": self.column(location.column),
        }


NO_PLACE: Final[Message] = {"line": 0, "column": 0}
"""Where a robot stands whose program does not: the protocol wants numbers."""
