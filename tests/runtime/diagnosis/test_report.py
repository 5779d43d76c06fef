"""Reports of stopped programs: locations in the user's files, values and call stack."""

from __future__ import annotations

import weakref
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from crs_cc.cli.report import render_report
from crs_cc.core.gc_pause import gc_paused
from crs_cc.core.source import underline
from crs_cc.runtime.diagnosis.failure import Failure
from crs_cc.runtime.diagnosis.inspect import call_stack
from crs_cc.runtime.diagnosis.report import ErrorReport, report
from crs_cc.runtime.layout import STACK_TOP
from tests.c.execution import Run, build

SOURCE = """\
#include <stdlib.h>
#include <string.h>
enum mode { IDLE, TURN };
struct node { int value; struct node *next; char name[8]; };
static struct node last = { 7, 0, "last" }, first = { 3, &last, "first" };
static int table[4] = { 1, 2, 3, 4 };
static int zero;
static void copy(char *to, const char *text) { strcpy(to, text); }
static int value_of(struct node *n, enum mode mode, double x) { return n->next->next->value; }
int old(f, c, n) float f; char c; { return n / zero; }
static int down(int n)
{
    int k = n;
    return n ? down(n - 1) + 1 : abs(k / n);
}
static int even(int n);
static int odd(int n) { return n ? even(n - 1) : 1 / n; }
static int even(int n) { return n ? odd(n - 1) : 1 / n; }
static int order(const void *a, const void *b) { return *(int *)a / zero + *(const int *)b; }
static int many(const char *format, ...) { return format[0] / zero; }
static int shadow(int n) { int i = 1; { int i = n; return 8 / (i - i); } }
int main(void)
{
    %s;
    return 0;
}
"""


def failure_of(folder: Path, source: str) -> Failure:
    path = folder / "program.c"
    path.write_text(source)
    failure = Run(build(path)).to_end().failure
    assert failure is not None
    return failure


def report_of(folder: Path, statement: str) -> ErrorReport:
    return report(failure_of(folder, SOURCE % statement))


def stack(error: ErrorReport) -> list[str]:
    return [str(call) for call in error.stack]


def blamed(error: ErrorReport) -> str:
    start = error.location.column - 1
    return error.source_line[start : start + len(underline(error.source_line, error.location))]


def test_a_failure_in_the_library_is_reported_at_the_call(tmp_path: Path) -> None:
    error = report_of(tmp_path, 'copy(0, "x")')
    assert error.text == "null pointer: strcpy is passed a null pointer as 'to'"
    assert blamed(error) == "strcpy(to, text)"
    assert stack(error) == [
        'strcpy(to=null, from="x")', 'copy(to=null, text="x")', "main()",
    ]  # fmt: skip


def test_a_stopped_program_is_freed_at_once_when_it_has_been_reported(tmp_path: Path) -> None:
    failure = failure_of(tmp_path, SOURCE % 'copy(0, "x")')
    assert failure.stopped is not None
    memory = weakref.ref(failure.stopped.memory)
    with gc_paused():
        report(failure)
        del failure
        assert memory() is None


def test_abort_is_reported_at_the_call(tmp_path: Path) -> None:
    error = report_of(tmp_path, "abort()")
    assert error.text == "abort called"
    assert blamed(error) == "abort()"
    assert stack(error) == ["main()"]


def test_the_pointer_that_is_null_is_named(tmp_path: Path) -> None:
    error = report_of(tmp_path, "value_of(&first, TURN, 0.5)")
    assert error.text == "null pointer: 'n->next->next' is null"
    assert error.values[1] == ("*n", '{value = 3, next = &last, name = "first"}')
    assert stack(error) == ["value_of(n=&first, mode=TURN, x=0.5)", "main()"]


def test_arguments_of_the_old_style_are_shown_as_passed(tmp_path: Path) -> None:
    error = report_of(tmp_path, "old(2.5, 'a', 7)")
    assert error.values == (("n", "7"), ("zero", "0"))
    assert stack(error)[0] == "old(f=2.5, c=97, n=7)"


def test_a_long_chain_of_calls_is_cut(tmp_path: Path) -> None:
    error = report_of(tmp_path, "down(50)")
    assert error.text == "division by zero"
    assert error.values == (("k", "0"), ("n", "0"))
    assert stack(error) == [
        "down(n=0)", "down(n=1)", "down(n=2)", "47 more calls to down", "down(n=50)", "main()",
    ]  # fmt: skip


def test_a_chain_of_two_functions_is_cut(tmp_path: Path) -> None:
    error = report_of(tmp_path, "even(50)")
    assert "47 more calls to odd and even" in stack(error)


def test_the_library_between_the_users_functions_is_one_call(tmp_path: Path) -> None:
    error = report_of(tmp_path, "qsort(table, 4, sizeof table[0], order)")
    assert stack(error) == [
        "order(a=table, b=&table[1])",
        "qsort(items=table, count=4, size=4, compare=order)",
        "main()",
    ]  # fmt: skip


def test_a_variadic_function_has_dots(tmp_path: Path) -> None:
    assert stack(report_of(tmp_path, 'many("x", 1, 2)'))[0] == 'many(format="x", ...)'


def test_a_name_refers_to_the_innermost_variable(tmp_path: Path) -> None:
    assert report_of(tmp_path, "shadow(5)").values == (("i", "5"),)


@pytest.mark.usefixtures("users_settings")
def test_infinite_recursion_shows_its_cycle(tmp_path: Path) -> None:
    error = report_of(tmp_path, "down(-1)")
    assert error.kind == "stack overflow"
    assert stack(error)[-2:] == ["down(n=-1)", "main()"]
    assert stack(error)[0].startswith("down(n=-")


def test_a_report_does_not_change_when_the_file_does(tmp_path: Path) -> None:
    path = tmp_path / "program.c"
    path.write_text(SOURCE % "down(3)")
    program = build(path)
    path.write_text("/* edited meanwhile */\n")
    failure = Run(program).to_end().failure
    assert failure is not None
    assert blamed(report(failure)) == "k / n"


@pytest.mark.parametrize("statement", ["down(9)", "copy(0, first.name)", "value_of(&first, 1, 2)"])
def test_corrupt_memory_still_gives_a_report(tmp_path: Path, statement: str) -> None:
    stopped = failure_of(tmp_path, SOURCE % statement)
    assert stopped.stopped is not None
    random = np.random.default_rng(1)
    memory = stopped.stopped.memory
    for _ in range(30):
        places = random.integers(STACK_TOP - 1500, STACK_TOP + 3000, 200)
        memory[places] = random.integers(0, 256, 200)
        stack = tuple(call_stack(memory, stopped.stopped.compiled, stopped.location))
        failure = replace(stopped, stack=stack, stopped=replace(stopped.stopped, stack=stack))
        assert render_report(report(failure))
