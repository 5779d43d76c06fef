"""Locations in the conventions of the client: form of paths, first line, source references.

Files of the user have paths. Those of the C library have numbers, by which the client
requests their text.
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
    """The client's conventions, and the source files of the programs."""

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

    def add_sources(self, files: Iterable[str]) -> None:
        """Add the names of source files; a file keeps its number."""
        known = set(self._files)
        self._files += [file for file in dict.fromkeys(files) if file not in known]

    def sources(self) -> list[Message]:
        """Return all source files."""
        return [self.source(file) for file in self._files]

    def source(self, file: str) -> Message:
        """Return the protocol's `Source` of a file."""
        name = file.rpartition("/")[2]
        if file.startswith(LIBRARY):
            self.add_sources([file])
            number = self._files.index(file) + 1
            return {
                "name": name, "sourceReference": number, "origin": "library",
                "presentationHint": "deemphasize",
            }  # fmt: skip
        path = Path(os.path.abspath(file))  # noqa: PTH100 - links are kept as the user sees them
        return {"name": name, "path": path.as_uri() if self._has_uris else str(path)}

    def key(self, source: Arguments) -> str:
        """Return a unique key of a client's source, whether or not a program has it.

        Raises:
            RefusalError: it has neither a path nor a number.
        """
        number = source.natural("sourceReference", 0)
        if number:
            return self._files[number - 1] if number <= len(self._files) else ""
        path = source.text("path", "") or source.text("name")
        if path.startswith("file:"):
            path = unquote(urlsplit(path).path)
        return "" if "\0" in path else os.path.realpath(path)

    def file_at(self, key: str) -> str | None:
        """Return the programs' file name for a key; None if there is none.

        These are the names as the user wrote them, and the library's own.
        """
        if key in self._files:
            return key
        return next((file for file in self._files if os.path.realpath(file) == key), None)

    def text(self, file: str, lines: Sequence[str]) -> str:
        """Return the text of a file."""
        if not file.startswith(LIBRARY):
            return "\n".join(lines)
        return (SOURCES / file.removeprefix(LIBRARY)).read_text("utf-8")

    def line(self, line: int) -> int:
        """Return the client's number for a line."""
        return line - 1 + self._first_line

    def column(self, column: int) -> int:
        """Return the client's number for a column; unknown ones become the first."""
        return max(column, 1) - 1 + self._first_column

    def to_line(self, line: int) -> int:
        """Return the line for a client's number."""
        return line + 1 - self._first_line

    def to_column(self, column: int) -> int:
        """Return the column for a client's number."""
        return column + 1 - self._first_column

    def location(self, location: Location) -> Message:
        """Return a location: source, line and column."""
        return {
            "source": self.source(location.file),
            "line": self.line(location.line),
            "column": self.column(location.column),
        }


NO_PLACE: Final[Message] = {"line": 0, "column": 0}
"""The location of a robot whose program has none: the protocol requires numbers."""
