"""`--live`: a map in the upper part of the terminal while programs run.

The terminal scrolls in its lower part only (DECSTBM), so what programs print is shown below the map
as it is. The map is drawn ten times a second of real time at most, and stays when the run ends.
"""

from __future__ import annotations

import io
import os
import shutil
import time
from typing import TYPE_CHECKING, Final, TextIO

import numpy as np

from crs_cc.cli.messages import is_coloured, is_terminal
from crs_cc.plot.tracks import Tracks

if TYPE_CHECKING:
    from crs_cc.session.session import Session
    from crs_cc.sim.engine.step import Step

INTERVAL_S: Final = 0.1
"""Real time between two maps; a map takes a tenth of it at most for a few robots."""

MIN_COLUMNS, MIN_LINES = 30, 12
_SHARE: Final = 0.65  # of the lines
_PATHS: Final = 30  # more are unreadable
_SAMPLES: Final = 20_000

_SAVE, _RESTORE = "\x1b7", "\x1b8"
_CLEAR: Final = "\x1b[2J"
_ERASE_REST: Final = "\x1b[K"
_WHOLE: Final = "\x1b[r"


def reason_against(stream: TextIO | None) -> str:
    """Return why there can be no live map on a stream; empty if there can."""
    if not is_terminal(stream):
        return "standard error is not a terminal"
    if os.environ.get("TERM", "dumb") == "dumb":
        return "the terminal does not support it"
    columns, lines = shutil.get_terminal_size()
    if columns < MIN_COLUMNS or lines < MIN_LINES:
        return f"it needs {MIN_COLUMNS} columns and {MIN_LINES} lines, there are {columns}, {lines}"
    return ""


class LiveMap:
    """The map of a running session."""

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self._size = (0, 0)
        self._tracks = Tracks(_SAMPLES)
        self._drawn_s = -INTERVAL_S

    def add_contacts(self, step: Step) -> None:
        """Add the contacts that began in a timestep."""
        contacts = step.contacts
        for robot, x_m, y_m in zip(contacts.robot, contacts.x_m, contacts.y_m, strict=True):
            self._tracks.add_contact(int(robot), float(x_m), float(y_m))

    def sample(self, session: Session) -> None:
        """Add where the robots are."""
        state = session.environment.state
        present = state.presence.present[:_PATHS]
        x_m, y_m = state.x_m[:_PATHS], state.y_m[:_PATHS]
        self._tracks.add(np.where(present, x_m, np.nan), np.where(present, y_m, np.nan))

    def is_due(self) -> bool:
        """Return whether it is time for the next map."""
        return time.monotonic() - self._drawn_s >= INTERVAL_S

    def draw(self, session: Session, status: str) -> None:
        """Draw the map, and a line below it."""
        self._drawn_s = time.monotonic()
        columns, lines = shutil.get_terminal_size()
        high = max(1, int(lines * _SHARE))
        parts = []
        if (columns, lines) != self._size:  # at the start, or the window has another size now
            parts.append(f"{_CLEAR}\x1b[{high + 2};{lines}r\x1b[{high + 2};1H")
            self._size = columns, lines
        rows = [*self._rows(session, columns, high), f"\x1b[7m{status[:columns]:{columns}}\x1b[m"]
        parts.append(_SAVE)
        parts += [f"\x1b[{row};1H{text}{_ERASE_REST}" for row, text in enumerate(rows, 1)]
        parts.append(_RESTORE)
        self._stream.write("".join(parts))
        self._stream.flush()

    def close(self) -> None:
        """Reset the scroll region of the terminal; the map stays."""
        if self._size != (0, 0):
            self._stream.write(f"{_SAVE}{_WHOLE}{_RESTORE}")
            self._stream.flush()

    def _rows(self, session: Session, columns: int, rows: int) -> list[str]:
        from rich.console import Console

        from crs_cc.debug.world.world_map import MapWindow, WorldMap

        environment = session.environment
        robots = min(len(environment.world.robots), _PATHS)
        paths = [self._tracks.path(robot) for robot in range(robots)]
        window = MapWindow.whole(environment, columns, rows, paths)
        shown = 0 if robots == 1 else -1
        world_map = WorldMap(
            environment, window, robot=shown, paths=paths, contacts=self._tracks.contacts
        )
        console = Console(
            file=io.StringIO(),
            width=columns,
            force_terminal=True,
            no_color=not is_coloured(self._stream),
            legacy_windows=False,
        )
        with console.capture() as captured:
            console.print(world_map.text, overflow="crop", no_wrap=True)
        return captured.get().rstrip("\n").split("\n")[:rows]
