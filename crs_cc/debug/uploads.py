"""Programs that a user adds to a running run, as text, for robots that join.

Their text is part of the change that uses them, so a recording has all that it needs.
"""

from __future__ import annotations

import re
import tempfile
from pathlib import Path
from typing import Final

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostics
from crs_cc.debug.errors import DebugError
from crs_cc.debug.program import DebugProgram
from crs_cc.runtime.executable import Executable
from crs_cc.session.build import build_executable
from crs_cc.session.library import library_options

MAX_TEXT: Final = 60_000
MAX_PROGRAMS: Final = 50
"""Programs of a run, chosen by us."""

_NAME: Final = re.compile(r"[A-Za-z0-9_][\w.-]{0,58}\.c")


class Uploads:
    """The programs that were brought to a run.

    Attributes:
        programs: by name.
        texts: by name, their source.
    """

    def __init__(self, *, debug: bool = True) -> None:
        """Start without programs.

        Args:
            debug: whether they are built for the debugger.
        """
        self._debug = debug
        self.programs: dict[str, DebugProgram] = {}
        self.texts: dict[str, str] = {}
        self._folder: tempfile.TemporaryDirectory[str] | None = None

    def add(self, name: str, text: str) -> None:
        """Compile a program; it may include headers of the library only.

        Args:
            name: of its file: `dance.c`.
            text: its source.

        Raises:
            DebugError: it is invalid; nothing has changed.
        """
        if self.texts.get(name) == text:
            return
        if not _NAME.fullmatch(name):
            raise DebugError(f"{name[:60]!r} is not a name for a C file (such as dance.c)")
        if name in self.texts:
            raise DebugError(f"a different '{name}' has been added to this run: rename it")
        if len(text) > MAX_TEXT or len(self.texts) >= MAX_PROGRAMS:
            raise DebugError(f"at most {MAX_PROGRAMS} programs of {MAX_TEXT:,} characters each")
        if self._folder is None:
            self._folder = tempfile.TemporaryDirectory(prefix="crs-upload-")
        path = Path(self._folder.name, name)
        path.write_text(text, "utf-8")
        try:
            executable = build_executable(
                [path], Diagnostics(), root=path.parent, debug=self._debug
            )
        except CompileError as error:
            first = error.diagnostics[0]
            raise DebugError(f"{name}:{first.location.line}: {first.text}") from None
        options = library_options((), (), (), "gnu17", path.parent)
        self.programs[name] = DebugProgram(executable, [path], options)
        self.texts[name] = text

    def executables(self) -> list[Executable]:
        """Return the builds of all programs."""
        return [each.executable for each in self.programs.values()]

    def used_in(self, change: str) -> tuple[str, str] | None:
        """Return name and text of the program that a change names; None if it names none."""
        name = change.rpartition(" running ")[2].strip()
        return (
            (name, self.texts[name]) if change.startswith("join ") and name in self.texts else None
        )
