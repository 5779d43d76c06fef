"""Programs with one planted error each, and the same programs without it.

In each file of `planted/`, `PLANT(wrong, right)` is the error or its remedy. A comment
`// error: kind` stands at the line where a run must stop, `// warning: text` at a line that the
compiler or the run must warn of, and `// leak: N` says how many blocks nothing points to at the
end; `// origin` stands where the report must say that a value that was never set comes from, or
where the object is declared that an access is outside of. The programs of `first/` and
`third/` were written before the checks that they test, those of `second/` and `fourth/` after.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Final

from crs_cc.core.source import Diagnostics
from crs_cc.runtime.diagnosis.report import report
from crs_cc.runtime.executable import Executable
from crs_cc.session.build import build_executable
from tests.c.execution import Run

FOLDER: Final = Path(__file__).parent / "planted"
WRONG: Final = "PLANT(wrong, right)=wrong"
RIGHT: Final = "PLANT(wrong, right)=right"
_COMMENT: Final = re.compile(r"// (error|warning|leak): (.+)$", re.MULTILINE)


@dataclass(frozen=True)
class Planted:
    """A program with a planted error.

    Attributes:
        path: its file.
        severity: "error" at run time, "warning", or "leak".
        text: the kind of the error, a part of the warning, the number of lost blocks.
        line: the line of the error.
        origin: the line of the declaration or allocation that the report must name; 0 if none.
    """

    path: Path
    severity: str
    text: str
    line: int
    origin: int = 0

    @property
    def name(self) -> str:
        """The name of the folder and the file."""
        return f"{self.path.parent.name}/{self.path.stem}"


@dataclass(frozen=True)
class Found:
    """What was found in a program.

    Attributes:
        severity: as in `Planted`; empty if nothing was found.
        text: the message.
        line: its line; 0 if unknown.
        notes: what is said of the object.
    """

    severity: str = ""
    text: str = ""
    line: int = 0
    notes: tuple[str, ...] = ()


def planted(names: str = "*/*") -> Iterator[Planted]:
    """Return the planted programs whose names match a pattern, in a fixed order."""
    for path in sorted(FOLDER.glob(f"{names}.c")):
        text = path.read_text()
        (found,) = _COMMENT.finditer(text)
        before, has_origin, _ = text.partition("// origin\n")
        origin = before.count("\n") + 1 if has_origin else 0
        yield Planted(path, found[1], found[2], text[: found.start()].count("\n") + 1, origin)


def look(path: Path, definition: str, *, trap_overflow: bool = False) -> Found:
    """Compile and run a program; return the error, the warning or the lost blocks found."""
    diagnostics = Diagnostics()
    program = build_executable(
        [path], diagnostics, defines=[definition], trap_overflow=trap_overflow
    )
    found = _run(program)
    if found.severity:
        return found
    for each in diagnostics.messages:
        if each.flag == "sequence-point":
            return Found("warning", each.text, each.location.line)
    return Found()


def _run(program: Executable) -> Found:
    run = Run(program)
    outcome = run.to_end()
    assert run.fleet is not None
    compared = run.fleet.compared_pointers(0)
    if compared is not None:
        return Found("warning", compared.text, compared.location.line)
    if outcome.failure is not None:
        made = report(outcome.failure)
        return Found("error", made.text, made.location.line, made.notes)
    lost = run.fleet.lost_blocks(0)
    if lost:
        number = sum(len(each.sizes) for each in lost)
        return Found("leak", str(number), lost[0].allocated[0].location.line)
    return Found()
