"""Runs the C programs below this folder: valid ones five ways, wrong ones to their messages.

valid/     must print what is in the `.out` file beside them (made by gcc, see `test_gcc.py`), and
exit with 0 or with what a comment `// exit: N` says
errors/    must be stopped by the error that a comment `// error: kind` names, at its line, with
the report in the `.report` file beside them (see `test_errors_page.py` for what is made of them)
refused/   must not compile; a comment `// error: text` stands at each line to be blamed, and
           the folder's name is that of the stage that must say so
warned/    must compile, with the warnings of the comments `// warning: text` and no others
hostile/   see `test_hostile.py`

A line `//    ^` below such a comment tells the column, too. A file is a case, unless there is a
`main.c` in its folder: then all files of the folder are one.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest

from crs_cc.cli.report import render_report
from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostics
from crs_cc.requests import ERROR_KINDS
from crs_cc.runtime.diagnosis.failure import Failure
from crs_cc.runtime.diagnosis.report import report
from crs_cc.session.build import build_executable
from tests.c.execution import (
    ENDLESS,
    HERE,
    Outcome,
    Run,
    Stepping,
    build,
    cases,
    expected_errors,
    expected_warnings,
    name,
    sources,
)

FUEL_STEPS = 200_000
"""Programs of up to so many instructions get their fuel one by one, longer ones so many times."""

STATEMENT_STEPS = 4000
"""Programs of up to so many statements stop before every one, longer ones so many times."""


def valid_cases() -> list[object]:
    """Gives each valid case once; all but the first of a topic are left out of quick runs."""
    rows, seen = [], set()
    for path in cases("valid"):
        marks = [pytest.mark.slow] if path.parent in seen else []
        seen.add(path.parent)
        rows.append(pytest.param(path, id=name(path), marks=marks))
    return rows


def error_cases() -> list[object]:
    """Gives each wrong case once; all but the first of a kind of error are left out as well."""
    rows, seen = [], set()
    for path in cases("errors"):
        kinds = {each.text for each in expected_errors(path)}
        marks = [pytest.mark.slow] if kinds <= seen else []
        seen |= kinds
        rows.append(pytest.param(path, id=name(path), marks=marks))
    return rows


@pytest.fixture(params=valid_cases(), scope="module")
def case(request: pytest.FixtureRequest) -> Path:
    path: Path = request.param
    return path


@cache
def plain(path: Path) -> Outcome:
    """Gives what the program does when nothing interrupts it."""
    return Run(build(path)).to_end()


def same(left: Outcome, right: Outcome) -> bool:
    """Tells whether two runs did the same, instruction for instruction."""
    return (left.output, left.errors, left.status, left.fuel) == (
        right.output, right.errors, right.status, right.fuel,
    )  # fmt: skip


def test_a_valid_program_does_what_gcc_says(case: Path) -> None:
    outcome = plain(case)
    assert outcome.failure is None
    wanted = case.with_suffix(".out").read_bytes()
    assert outcome.output.decode(errors="replace") == wanted.decode(errors="replace")
    assert outcome.output == wanted
    exit_comment = re.search(r"// exit: (\d+)", case.read_text(encoding="latin-1"))
    assert outcome.status == (int(exit_comment[1]) if exit_comment else 0)


def test_running_out_of_fuel_everywhere_changes_nothing(case: Path) -> None:
    fuel = max(1, plain(case).fuel // FUEL_STEPS)
    outcome = Run(build(case), Stepping(fuel=fuel)).to_end()
    assert same(outcome, plain(case))


@pytest.mark.slow
def test_moving_to_a_fresh_instance_changes_nothing(case: Path) -> None:
    fuel = plain(case).fuel // 20 + 1
    outcome = Run(build(case), Stepping(fuel=fuel, restore_every=3)).to_end()
    assert outcome.rounds > 3
    assert same(outcome, plain(case))


@pytest.mark.slow
def test_stopping_before_statements_changes_nothing(case: Path) -> None:
    whole = Run(build(case, debug=True)).to_end()
    assert same(whole, plain(case))
    every = whole.statements // STATEMENT_STEPS + 1
    stepped = Run(build(case, debug=True), Stepping(statements=every)).to_end()
    assert same(stepped, whole)
    assert stepped.statements == whole.statements
    assert stepped.rounds >= whole.statements // every
    assert stepped.memory == whole.memory


@pytest.mark.slow
@pytest.mark.parametrize("path", error_cases())
def test_stopping_leaves_no_trace_in_a_program_that_fails(path: Path) -> None:
    whole = Run(build(path, debug=True)).to_end()
    every = whole.statements // STATEMENT_STEPS + 1
    stepped = Run(build(path, debug=True), Stepping(statements=every)).to_end()
    assert stepped.statements == whole.statements
    assert stepped.memory == whole.memory


@pytest.mark.slow
def test_leaving_out_the_checks_changes_nothing(case: Path) -> None:
    assert same(Run(build(case, checked=False)).to_end(), plain(case))


def shown(failure: Failure, folder: Path) -> bytes:
    """Gives a report without what a change elsewhere would change: the folder and addresses."""
    text = render_report(report(failure)).replace(f"{folder}/", "")
    return re.sub(r"0x[0-9a-f]{5,}", "0x...", text).encode() + b"\n"


@pytest.mark.parametrize("path", error_cases())
def test_a_run_time_error_is_named_at_its_line(
    path: Path, check_golden: Callable[[Path, bytes], None]
) -> None:
    (wanted,) = expected_errors(path)
    assert wanted.text in ERROR_KINDS
    for fuel in (ENDLESS, 2000):
        failure = Run(build(path), Stepping(fuel)).to_end().failure
        assert failure is not None
        assert failure.kind == wanted.text
        message = report(failure)
        assert message.text.startswith(wanted.text)
        if wanted.line:
            assert Path(message.location.file).name == path.name
            assert message.location.line == wanted.line
            assert message.location.column > 0
        check_golden(path.with_suffix(".report"), shown(failure, path.parent))


@pytest.mark.parametrize("path", cases("refused"), ids=name)
def test_a_wrong_program_is_refused_at_its_line(path: Path) -> None:
    with pytest.raises(CompileError) as caught:
        build(path)
    errors = [each for each in caught.value.diagnostics if each.severity == "error"]
    stage = path.relative_to(HERE / "refused").parts[0]
    for wanted in expected_errors(path):
        assert any(wanted.is_met_by(each) and each.stage == stage for each in errors), errors
    assert all(each.location.file for each in errors)
    assert len(errors) == len(set(errors)), "said twice"


@pytest.mark.parametrize("path", cases("warned"), ids=name)
def test_a_doubtful_program_is_warned_of(path: Path) -> None:
    diagnostics = Diagnostics()
    build_executable(sources(path), diagnostics)
    wanted, found = expected_warnings(path), diagnostics.messages
    assert wanted
    for each in wanted:
        assert any(map(each.is_met_by, found)), found
    for message in found:
        assert any(each.is_met_by(message) for each in wanted), message


def test_every_case_says_what_it_expects() -> None:
    for path in cases("errors") + cases("refused"):
        assert expected_errors(path), name(path)
    for path in cases("valid"):
        assert path.with_suffix(".out").exists(), name(path)
