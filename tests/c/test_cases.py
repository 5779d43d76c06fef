"""Run the C programs below this folder: valid ones five ways, wrong ones to their messages.

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
from pathlib import Path

import pytest

from crs_cc.cli.report import render_report
from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostics
from crs_cc.requests import ERROR_KINDS
from crs_cc.runtime.diagnosis.failure import Failure
from crs_cc.runtime.diagnosis.report import report
from crs_cc.runtime.executable import Executable
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
    standard,
)

FUEL_STEPS = 200_000
"""Programs of up to so many instructions get their fuel one by one, longer ones so many times."""

STATEMENT_STEPS = 4000
"""Programs of up to so many statements stop before every one, longer ones so many times."""

DEEP_STEPS = 400
"""Longer ones that overflow the stack stop about so many times, for a stop unwinds all calls."""


def same(left: Outcome, right: Outcome) -> bool:
    """Return whether two runs did the same, instruction for instruction."""
    return (left.output, left.errors, left.status, left.fuel) == (
        right.output, right.errors, right.status, right.fuel,
    )  # fmt: skip


@pytest.mark.parametrize("path", cases("valid"), ids=name)
def test_a_valid_program_does_what_gcc_says_however_it_is_run(
    path: Path, subtests: pytest.Subtests
) -> None:
    executable = build(path)
    plain = does_what_gcc_says(path, executable)
    with subtests.test("running out of fuel everywhere changes nothing"):
        running_out_of_fuel_everywhere_changes_nothing(executable, plain)
    with subtests.test("moving to a fresh instance changes nothing"):
        moving_to_a_fresh_instance_changes_nothing(executable, plain)
    with subtests.test("stopping before statements changes nothing"):
        stopping_before_statements_changes_nothing(build(path, debug=True), plain)
    with subtests.test("leaving out the checks changes nothing"):
        leaving_out_the_checks_changes_nothing(build(path, checked=False), plain)


def does_what_gcc_says(path: Path, executable: Executable) -> Outcome:
    outcome = Run(executable).to_end()
    assert outcome.failure is None
    wanted = path.with_suffix(".out").read_bytes()
    assert outcome.output.decode(errors="replace") == wanted.decode(errors="replace")
    assert outcome.output == wanted
    exit_comment = re.search(r"// exit: (\d+)", path.read_text(encoding="latin-1"))
    assert outcome.status == (int(exit_comment[1]) if exit_comment else 0)
    return outcome


def running_out_of_fuel_everywhere_changes_nothing(executable: Executable, plain: Outcome) -> None:
    fuel = -(-plain.fuel // FUEL_STEPS)
    assert same(Run(executable, Stepping(fuel=fuel)).to_end(), plain)


def moving_to_a_fresh_instance_changes_nothing(executable: Executable, plain: Outcome) -> None:
    stepping = Stepping(fuel=plain.fuel // 10 + 1, restore_every=3)
    outcome = Run(executable, stepping).to_end()
    assert outcome.rounds > 3
    assert same(outcome, plain)


def stopping_before_statements_changes_nothing(executable: Executable, plain: Outcome) -> None:
    whole, stepped, every = with_stops(executable)
    assert same(whole, plain)
    assert same(stepped, whole)
    assert stepped.rounds >= whole.statements // every


def leaving_out_the_checks_changes_nothing(executable: Executable, plain: Outcome) -> None:
    assert same(Run(executable).to_end(), plain)


def with_stops(executable: Executable, *, is_deep: bool = False) -> tuple[Outcome, Outcome, int]:
    """Run a debug build whole, and stopping before every so many statements; both must agree.

    So must a run in which it tests before each statement whether to stop.
    """
    whole = Run(executable).to_end()
    every = whole.statements // STATEMENT_STEPS + 1
    if is_deep and every > 1:  # the last stop is before the last statement, where it is deepest
        fewest = whole.statements // DEEP_STEPS
        every = min(range(fewest, 2 * fewest), key=lambda each: (whole.statements - 1) % each)
    stepped = Run(executable, Stepping(statements=every)).to_end()
    assert stepped.statements == whole.statements
    assert stepped.memory == whole.memory
    tested = Run(executable, Stepping(tests=bool(whole.statements))).to_end()
    assert same(tested, whole)
    assert (tested.memory, tested.statements) == (whole.memory, whole.statements)
    assert tested.rounds == whole.rounds
    return whole, stepped, every


def shown(failure: Failure, folder: Path) -> bytes:
    """Return a report without what a change elsewhere would change: the folder and addresses."""
    text = render_report(report(failure)).replace(f"{folder}/", "")
    return re.sub(r"0x[0-9a-f]{5,}", "0x...", text).encode() + b"\n"


@pytest.mark.parametrize("path", cases("errors"), ids=name)
def test_a_run_time_error_is_named_at_its_line_and_leaves_no_trace_when_stopped_before(
    path: Path,
    check_golden: Callable[[Path, bytes], None],
    subtests: pytest.Subtests,
    request: pytest.FixtureRequest,
) -> None:
    overflows = expected_errors(path)[0].text == "stack overflow"
    if overflows:
        request.getfixturevalue("users_settings")
    executable = build(path)
    for fuel in (ENDLESS, 2000):
        failure = Run(executable, Stepping(fuel)).to_end().failure
        assert failure is not None
        is_named_at_its_line(path, failure)
        check_golden(path.with_suffix(".report"), shown(failure, path.parent))
    with subtests.test("stopping before statements leaves no trace"):
        with_stops(build(path, debug=True), is_deep=overflows)


def is_named_at_its_line(path: Path, failure: Failure) -> None:
    (wanted,) = expected_errors(path)
    assert wanted.text in ERROR_KINDS
    assert failure.kind == wanted.text
    message = report(failure)
    assert message.text.startswith(wanted.text)
    if wanted.line:
        assert Path(message.location.file).name == path.name
        assert message.location.line == wanted.line
        assert message.location.column > 0


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
    build_executable(sources(path), diagnostics, standard=standard(path))
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
