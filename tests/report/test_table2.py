"""Table 2 of the CRS report runs with only its non-C parts changed.

`table2.txt` is the excerpt as the report prints it, `samples/scout_c/report_table2.c` the sample.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import pytest

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostics
from crs_cc.session.build import build_executable

EXCERPT = (Path(__file__).parent / "table2.txt").read_text().splitlines()
SAMPLE = Path(__file__).parents[2] / "samples" / "scout_c" / "report_table2.c"


@dataclass(frozen=True)
class Change:
    """What is not C in a line of the excerpt.

    Attributes:
        line: the line's number.
        written: what the report writes.
        meant: what C wants instead.
        error: what the compiler says of it.
    """

    line: int
    written: str
    meant: str
    error: str


CHANGES = (
    Change(12, "SERVER_MACHINE_NAME) {", "SERVER_MACHINE_NAME)) {", "expected ')'"),
    Change(33, "State[STATE BUMPER]", "State[STATE_BUMPER]", "expected ']'"),
    Change(39, "}", "", "extraneous closing brace ('}')"),
    Change(42, "}", "", "extraneous closing brace ('}')"),
)
"""All of them."""


def changed(changes: tuple[Change, ...]) -> list[str]:
    """Return the excerpt with changes; empty lines are dropped in the sample."""
    lines = list(EXCERPT)
    for change in changes:
        assert lines[change.line - 1].count(change.written) == 1
        lines[change.line - 1] = lines[change.line - 1].replace(change.written, change.meant)
    return lines


def test_the_sample_is_the_reports_text_with_these_changes_and_no_others() -> None:
    emptied = {change.line for change in CHANGES if not change.meant}
    kept = [line for number, line in enumerate(changed(CHANGES), 1) if number not in emptied]
    assert SAMPLE.read_text() == "\n".join(kept) + "\n"


@pytest.mark.parametrize("change", CHANGES, ids=lambda change: f"line {change.line}")
def test_each_change_is_needed(change: Change, tmp_path: Path) -> None:
    others = tuple(each for each in CHANGES if each is not change)
    path = tmp_path / "table2.c"
    path.write_text("\n".join(changed(others)) + "\n")
    with pytest.raises(CompileError) as caught:
        build_executable([path], Diagnostics(), dialect="report")
    first = caught.value.diagnostics[0]
    assert first.location.line == change.line
    assert change.error in first.text


def test_there_are_no_other_diagnostics() -> None:
    messages = Diagnostics()
    build_executable([SAMPLE], messages, dialect="report")
    assert not messages.messages
