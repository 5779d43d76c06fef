"""Programs of a world that is edited, compiled in the background, with the messages of `crs check`.

Each program is checked by a process of its own, one at a time, for a limited time; what it says is
kept until the file changes.
"""

from __future__ import annotations

import json
import subprocess
import sys
import threading
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, Final, NamedTuple

from crs_cc.sim.model.world import WorldModel

MAX_PROGRAMS: Final = 50
"""Programs of one world that are checked."""

MAX_KEPT: Final = 500
MAX_MESSAGES: Final = 5
TIMEOUT_S: Final = 30.0


class Version(NamedTuple):
    """A program as it was at a time."""

    path: str
    dialect: str
    size: int
    changed_ns: int


class ProgramChecks:
    """Checks programs in the background."""

    def __init__(self, notify: Callable[[], None]) -> None:
        """Begin without any.

        Args:
            notify: called in a thread of its own when something new is known.
        """
        self._notify = notify
        self._known: dict[Version, list[dict[str, Any]]] = {}
        self._wanted: list[Version] = []
        self._lock = threading.Lock()
        self._process: subprocess.Popen[str] | None = None
        self._thread: threading.Thread | None = None

    def messages(self, world: WorldModel) -> dict[str, list[dict[str, Any]]]:
        """Return the known errors of the robots' programs, and start checking the others.

        Returns:
            for each robot whose program has errors, these as `crs check --json` writes them.
        """
        versions = {robot.id: _version(str(robot.program), robot.dialect or "")
                    for robot in world.robots if robot.program}  # fmt: skip
        known: dict[str, list[dict[str, Any]]] = {}
        with self._lock:
            there = [each for each in dict.fromkeys(versions.values()) if each is not None]
            self._wanted = [each for each in there[:MAX_PROGRAMS] if each not in self._known]
            if self._wanted and self._thread is None:
                self._thread = threading.Thread(target=self._work, daemon=True)
                self._thread.start()
            for name, version in versions.items():
                if version is not None and self._known.get(version):
                    known[name] = self._known[version]
        return known

    def end(self) -> None:
        """Cancel the current check."""
        with self._lock:
            self._wanted = []
            if self._process is not None:
                self._process.kill()

    def _work(self) -> None:
        while True:
            with self._lock:
                if not self._wanted:
                    self._thread = None
                    break
                version = self._wanted.pop(0)
                self._process = _start(version)
            found = _errors(self._process)
            with self._lock:
                self._process = None
                while len(self._known) >= MAX_KEPT:
                    self._known.pop(next(iter(self._known)))
                self._known[version] = found
        self._notify()


def _version(path: str, dialect: str) -> Version | None:
    try:
        stat = Path(path).stat()
    except OSError:
        return None  # the loader reports the error
    return Version(path, dialect, stat.st_size, stat.st_mtime_ns)


def _start(version: Version) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "crs_cc", "check", "--json", "-q", version.path]
    if version.dialect:
        command += ["--dialect", version.dialect]
    return subprocess.Popen(  # noqa: S603 - ourselves
        command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
        text=True, errors="replace",
    )  # fmt: skip


def _errors(process: subprocess.Popen[str]) -> list[dict[str, Any]]:
    """Return the errors that a check finds; none if it is ended."""
    try:
        text, _ = process.communicate(timeout=TIMEOUT_S)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        return []
    try:
        found: Sequence[dict[str, Any]] = json.loads(text)
    except ValueError:
        return []
    return [each for each in found if each["severity"] == "error"][:MAX_MESSAGES]
