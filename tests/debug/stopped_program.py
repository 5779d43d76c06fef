"""Programs that have stopped before a line, for tests of what looks at them."""

from __future__ import annotations

import contextlib
from pathlib import Path

from crs_cc.core.source import Diagnostics
from crs_cc.debug.data.evaluate import Evaluator
from crs_cc.debug.data.expression_compiler import SourceNames
from crs_cc.debug.program import DebugProgram
from crs_cc.debug.world.state_fields import state_fields
from crs_cc.requests import SUSPENDED
from crs_cc.runtime.fleet import Fleet
from crs_cc.session.build import build_executable
from crs_cc.session.host import Host, HostRequest
from crs_cc.session.library import library_options


class EndError(Exception):
    """The program has ended."""


class Stopping:
    """A program that runs from stop to stop; `STOP` in the source is where it stops."""

    def __init__(self, folder: Path, *sources: str, checked: bool = True) -> None:
        paths = [folder / f"test{number or ''}.c" for number in range(len(sources))]
        for path, source in zip(paths, sources, strict=True):
            path.write_text(source)
        self.executable = build_executable(paths, Diagnostics(), debug=True, checked=checked)
        self.program = DebugProgram(self.executable, paths, library_options())
        self.fleet = Fleet([self.executable])
        self.printed = printed = bytearray()
        self.host = Host([["test"]], lambda *written: printed.extend(written[2]), lambda *_: b"")
        self.status: int | None = None
        self.lines = {str(path): path.read_text().splitlines() for path in paths}

    def run(self, mark: str = "STOP") -> Stopping:
        """Run on to the next statement in a line with a mark."""
        places = self.executable.detail().compiled.statements
        for number, site in enumerate(places):
            lines = self.lines.get(site.location.file, [])
            has_mark = lines and mark in lines[site.location.line - 1]
            self.fleet.marks[0][number] = int(bool(has_mark))
        slot = self.fleet.slots[0]
        while self.status is None:
            slot["run"], slot["fuel"] = 1, 10**9
            self.fleet.run_round()
            assert slot["status"] == SUSPENDED, self.fleet.report(0)
            if slot["stopped"]:
                return self
            self.host.serve(int(slot["code"]), HostRequest(0, slot["message"]))
            self.status = self.host.exit_status[0]
        raise EndError

    def run_to_end(self) -> bytes:
        """Run to the end of the program; return what it has printed."""
        with contextlib.suppress(EndError):
            self.run("no such mark")
        return bytes(self.printed)

    def evaluator(self) -> Evaluator:
        """Return what evaluates expressions."""
        fields = state_fields("nomad")
        return Evaluator(lambda: self.fleet.stopped(0), SourceNames(self.program), fields=fields)

    def state(self) -> tuple[bytes, bytes]:
        """Return all bytes of the program, and of its shadow."""
        return self.fleet.memory(0).tobytes(), self.fleet.stopped(0).shadow.tobytes()
