"""Run one compiled program to its end, in small steps of several kinds.

A program may be stopped by lack of fuel at any loop, before any statement, and may be saved and
loaded into another instance; none of that may change what it does.
"""

from __future__ import annotations

import hashlib
import re
from dataclasses import dataclass, field
from pathlib import Path

import wasmtime

from crs_cc.core.source import Diagnostic, Diagnostics
from crs_cc.requests import FAILED
from crs_cc.runtime.codegen import shadow
from crs_cc.runtime.diagnosis.failure import Failure
from crs_cc.runtime.executable import Executable, engine
from crs_cc.runtime.fleet import Fleet
from crs_cc.runtime.layout import MEMORY_BYTES
from crs_cc.runtime.site_tests import SiteTests
from crs_cc.runtime.wasm import PAGE, TYPE_I32_I32, Code, Module
from crs_cc.session.build import build_executable
from crs_cc.session.host import Host, HostRequest
from tests.c.rounds import Rounds

HERE = Path(__file__).parent
ENDLESS = 10**9  # fuel that no case needs


@dataclass
class Outcome:
    """What a program did.

    Attributes:
        output: what it wrote to the standard output.
        errors: what it wrote to the standard error stream.
        status: its exit status; None when it failed or still runs.
        failure: why it failed; None when it exited.
        fuel: instructions that it ran.
        rounds: how often it was resumed.
        statements: statements that it began (debug builds).
        memory: a digest of its memory, and of the states of its bytes, at the end.
    """

    output: bytes = b""
    errors: bytes = b""
    status: int | None = None
    failure: Failure | None = None
    fuel: int = 0
    rounds: int = 0
    statements: int = 0
    memory: str = ""


@dataclass
class Stepping:
    """How a program is run.

    Attributes:
        fuel: fuel for each resume.
        statements: statements to run in each resume, 0 for no limit (debug builds).
        restore_every: number of resumes after which the program moves to a fresh instance; 0 never.
        tests: whether it tests at each site whether to stop, which it need not (debug builds).
    """

    fuel: int = ENDLESS
    statements: int = 0
    restore_every: int = 0
    tests: bool = False


@dataclass
class Run:
    """A program on its way."""

    executable: Executable
    stepping: Stepping = field(default_factory=Stepping)
    outcome: Outcome = field(default_factory=Outcome)
    fleet: Fleet | None = None

    def to_end(self) -> Outcome:
        """Resumes the program until it exits or fails."""
        outcome = self.up_to(ENDLESS, ENDLESS)
        assert outcome.failure or outcome.status is not None, "the program does not end"
        return outcome

    def up_to(self, fuel: int, rounds: int) -> Outcome:
        """Resumes the program until it exits or fails, or has used up so much."""
        outcome = self.outcome
        host = Host([["case"]], self._write, lambda _robot, _wanted: b"")
        fleet = Fleet([self.executable])
        if self.stepping.tests:
            fleet.set_tests(0, _false_everywhere(self.executable))
        driven = Rounds(fleet)
        while outcome.fuel < fuel and outcome.rounds < rounds and outcome.status is None:
            self._resume(driven, fuel, rounds)
            slot = fleet.slots[0]
            outcome.statements = int(slot["statements"])
            if slot["status"] == FAILED:
                outcome.failure = fleet.failure(0)
                break
            if slot["code"]:
                host.serve(int(slot["code"]), HostRequest(0, slot["message"]))
            outcome.status = host.exit_status[0]
            if self.stepping.restore_every and outcome.rounds % self.stepping.restore_every == 0:
                fleet = _moved(fleet, self.executable)
                driven = Rounds(fleet)
        outcome.memory, self.fleet = _digest(fleet), fleet
        return outcome

    def _resume(self, driven: Rounds, fuel: int, rounds: int) -> None:
        """Resume the program until it has to be served or moved, or has used up so much."""
        stepping, outcome = self.stepping, self.outcome
        most_rounds = rounds - outcome.rounds
        if stepping.restore_every:
            due = stepping.restore_every - outcome.rounds % stepping.restore_every
            most_rounds = min(most_rounds, due)
        used, done = driven.run(
            stepping.fuel, stepping.statements, fuel - outcome.fuel, most_rounds
        )
        outcome.fuel += used
        outcome.rounds += done

    def _write(self, _robot: int, stream: int, content: bytes) -> None:
        if stream == 1:
            self.outcome.output += content
        else:
            self.outcome.errors += content


def _digest(fleet: Fleet) -> str:
    state = fleet.snapshot(0)
    parts = state.chunks, state.content, state.shadow_chunks, state.shadow_content
    return hashlib.sha256(b"".join(part.tobytes() for part in parts)).hexdigest()


def _moved(fleet: Fleet, executable: Executable) -> Fleet:
    """Return a fresh fleet whose program goes on where the old one's stopped."""
    saved = fleet.snapshot(0)
    fresh = Fleet([executable])
    fresh.restore(0, saved)
    return fresh


def _false_everywhere(executable: Executable) -> SiteTests:
    """Return tests for all sites of a program, by which it stops at none.

    All are one function: to compile one for each would take longer than to run most programs.
    """
    compiled = executable.detail().compiled
    sites = range(len(compiled.statements))
    memories = [("crs", "memory", MEMORY_BYTES // PAGE), ("crs", "shadow", shadow.PAGES)]
    module = Module(
        functions=[Code("false", TYPE_I32_I32, [], [("i32.const", 0)])],
        own_imports=memories if compiled.checked else memories[:1],
        exports=[(str(site), "func", 0) for site in sites],
    )
    return SiteTests(tuple(sites), wasmtime.Module(engine(), module.to_binary()))


def build(path: Path, *, debug: bool = False, checked: bool = True) -> Executable:
    """Return the program of a case, without asking for its warnings."""
    how = {"standard": standard(path), "debug": debug, "checked": checked}
    return build_executable(sources(path), Diagnostics(), **how)


def mark(path: Path, title: str) -> str:
    """Return what a comment of a case says, `// title: ...`; nothing if there is none."""
    match = re.search(rf"// {title}: *(.*)", path.read_text(encoding="latin-1"))
    return match[1] if match else ""


def standard(path: Path) -> str:
    """Return the C standard of a case, from its options for gcc."""
    match = re.search(r"-std=(\w+)", mark(path, "gcc options"))
    return match[1] if match else "gnu17"


def cases(folder: str) -> list[Path]:
    """Return the cases of a folder in a fixed order, each by its C file or its `main.c`."""
    found = sorted((HERE / folder).rglob("*.c"))
    return [path for path in found if sources(path)[0] == path]


def sources(path: Path) -> list[Path]:
    """Return the C files of a case: a `main.c` and all others of its folder are one program."""
    main = path.with_name("main.c")
    if not main.exists():
        return [path]
    return [main, *sorted(each for each in path.parent.glob("*.c") if each != main)]


def name(path: Path) -> str:
    """Return a case's name: its path without the folder of all cases."""
    return path.relative_to(HERE).with_suffix("").as_posix()


@dataclass(frozen=True)
class Expected:
    """What a comment `// error: text` or `// warning: text` asks for.

    Attributes:
        file: in which file.
        line: at which line; 0 for anywhere, also in no file.
        text: what the message says, or a part of it.
        column: at which column, told by a `^` in the next line; 0 for any.
    """

    file: str
    line: int
    text: str
    column: int = 0

    def is_met_by(self, message: Diagnostic) -> bool:
        """Return whether a message is the one that is asked for."""
        place = message.location
        return (
            self.text in message.text + message.hint
            and (not self.line or (Path(place.file).name, place.line) == (self.file, self.line))
            and self.column in (0, place.column)
        )


def expected_errors(path: Path) -> list[Expected]:
    """Return the errors that the comments of a case ask for."""
    return _expected(path, "error")


def expected_warnings(path: Path) -> list[Expected]:
    """Return the warnings that the comments of a case ask for."""
    return _expected(path, "warning")


def _expected(case: Path, severity: str) -> list[Expected]:
    found = []
    for path in sources(case):
        lines = path.read_text(encoding="latin-1").split("\n")
        for number, line in enumerate(lines, start=1):
            match = re.search(rf"// {severity}:\s*(.*?)\s*(\(anywhere\))?$", line)
            if match:
                caret = re.fullmatch(r"//( *)\^", lines[number]) if number < len(lines) else None
                column = len(caret[0]) if caret else 0
                found.append(Expected(path.name, 0 if match[2] else number, match[1], column))
    return found
