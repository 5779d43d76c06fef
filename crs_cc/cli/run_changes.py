"""Changes of a run at simulated times, from a file: `12.5s: move robot0 to 1 2 90`.

The changes are those of the debugger (`debug.world.run_edits`). Each is made at the start of the
first timestep that begins at its time or later, so the same file gives the same run bit for bit.
"""

from __future__ import annotations

import math
from collections import deque
from pathlib import PurePath
from typing import TYPE_CHECKING, Final

import click

from crs_cc.cli.messages import say
from crs_cc.cli.typed_input import TIMED_LINE
from crs_cc.debug.errors import DebugError
from crs_cc.debug.timeline.change import Change
from crs_cc.debug.timeline.position import Position
from crs_cc.debug.uploads import Uploads
from crs_cc.debug.world.run_edits import edit_run

if TYPE_CHECKING:
    from collections.abc import Callable, Collection
    from pathlib import Path

    from crs_cc.session.session import Session

_SLACK: Final = 1e-6  # timesteps
_UNLIMITED: Final = 2**30


class RunChanges:
    """The changes of a file, which are made when a run reaches their times."""

    def __init__(self, path: Path, timestep_s: float) -> None:
        """Read a file.

        Raises:
            click.UsageError: a line is invalid.
            OSError: it cannot be read.
        """
        self._path = path
        self._uploads = Uploads(debug=False)
        self._left: deque[tuple[int, int, str]] = deque()  # timestep, line, change
        lines = path.read_text("utf-8", "replace").splitlines()
        for number, line in enumerate(lines, start=1):
            if not line.strip() or line.lstrip().startswith("#"):
                continue
            match = TIMED_LINE.match(line)
            if match is None or not match[2].strip():
                raise self._wrong(
                    number, "expected a time and a change, as in '2.5s: move robot0 to 1 2'"
                )
            timestep = math.ceil(float(match[1]) / timestep_s - _SLACK)
            if self._left and timestep < self._left[-1][0]:
                raise self._wrong(number, "the time is before that of the previous line")
            self._left.append((timestep, number, match[2].strip()))

    def apply_due(self, session: Session, made: Callable[[Change], None]) -> None:
        """Make the changes that are due at the start of the current timestep.

        Args:
            session: the run.
            made: is called with each.

        Raises:
            click.UsageError: one is invalid or impossible.
        """
        while self._left and self._left[0][0] <= session.timesteps:
            _, number, text = self._left.popleft()
            programs = [session.fleet.executable(robot) for robot in range(len(session.fleet))]
            beside = self._beside(text, {PurePath(each.name).name for each in programs})
            try:
                if beside is not None:
                    self._uploads.add(beside.name, beside.read_text("utf-8", "replace"))
                edit_run(session, text, [*programs, *self._uploads.executables()])
            except DebugError as error:
                raise self._wrong(number, str(error)) from None
            program = self._uploads.used_in(text)
            made(Change(Position(session.timesteps, 0), text, program=program))

    def _beside(self, text: str, known: Collection[str]) -> Path | None:
        """Return the C file beside this one that a change names, unless its name is known."""
        name = text.rpartition(" running ")[2].strip()
        path = self._path.parent / name
        is_named = text.startswith("join ") and path.name == name and name not in known
        return path if is_named and path.is_file() else None

    def timesteps_left(self, session: Session) -> int:
        """Return the number of timesteps until the next change, at least 1."""
        return max(1, self._left[0][0] - session.timesteps) if self._left else _UNLIMITED

    def report(self) -> None:
        """Report how many changes were not made because the run ended earlier."""
        if self._left:
            many = f"{len(self._left)} change{'s' * (len(self._left) > 1)}"
            say(f"crs: {self._path}: the run ended before {many}")

    def _wrong(self, line: int, text: str) -> click.UsageError:
        return click.UsageError(f"{self._path}:{line}: {text}")
