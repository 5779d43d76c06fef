"""Hints about mistakes that show only in a run, each once: on stderr, and in the JSON."""

from __future__ import annotations

import time
from collections.abc import Iterator
from typing import Final

from crs_cc.core.source import Diagnostic, Location
from crs_cc.session.session import Session

SILENT_S: Final = 5.0
"""Real time without output after which a run on a terminal reports its progress [s]."""

SILENT_SIMULATED_S: Final = 600.0
"""Simulated time after which other runs do, so that what they say depends on no clock [s]."""


class RunHints:
    """The hints of a run.

    Attributes:
        found: those said during the run.
    """

    def __init__(self, session: Session) -> None:
        self.found: list[Diagnostic] = []
        self._session = session
        self._wrote_s, self._wrote_at_s = time.monotonic(), 0.0

    def wrote(self) -> None:
        """Record output of a program."""
        self._wrote_s = time.monotonic()
        self._wrote_at_s = self._session.time_s

    def silence(self, *, on_terminal: bool) -> Diagnostic | None:
        """Return a hint if nothing has been written for long, and the run may have no end."""
        if self.found:
            return None
        silent_s = time.monotonic() - self._wrote_s
        if not on_terminal:
            silent_s = self._session.time_s - self._wrote_at_s
        limit_s, kind = (SILENT_S, "") if on_terminal else (SILENT_SIMULATED_S, "simulated ")
        if silent_s < limit_s:
            return None
        robot = next((each for each, alive in enumerate(self._session.state.alive) if alive), 0)
        call = self._session.state.current_call(robot)
        where = f", in '{call.function}'" if call else ""
        place = call.location if call and call.location else None
        time_s = self._session.time_s
        text = f"no output for {limit_s:.0f} {kind}s and no end at {time_s:.0f} s{where}"
        hint = "Ctrl-C stops the run; --max-time S limits it"
        self.found.append(self._diagnostic(robot, place, text, hint, "silent-run"))
        return self.found[0]

    def at_end(self) -> Iterator[Diagnostic]:
        """Yield the hints at doubtful calls and comparisons, each for the first of its kind."""
        yield from self._unconnected()
        for each in self._session.hints:
            yield self._diagnostic(each.robot, each.location, each.text, each.advice, each.flag)

    def _unconnected(self) -> Iterator[Diagnostic]:
        """Yield a warning for each place that calls the robot without a connection."""
        places = set()
        for robot, call in enumerate(self._session.state.unconnected_calls):
            if call is None or call.location is None or call.location in places:
                continue
            places.add(call.location)
            text = f"'{call.function}' is called without a connection to the robot"
            hint = "call connect_robot first"
            yield self._diagnostic(robot, call.location, text, hint, "unconnected")

    def _diagnostic(
        self, robot: int, place: Location | None, text: str, hint: str, flag: str
    ) -> Diagnostic:
        executable = self._session.fleet.executable(robot)
        if place is None:
            return Diagnostic("warning", Location(executable.name), text, hint=hint, flag=flag)
        lines = executable.detail().lines.get(place.file, ())
        line = lines[place.line - 1] if 0 < place.line <= len(lines) else ""
        return Diagnostic("warning", place, text, line, hint, flag=flag)
