"""Arguments and results in registers, in every build and however often the program is suspended."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.unit import compile_text
from crs_cc.runtime.codegen.convention import MAX_WORDS, convention_of
from tests.c.execution import Run, Stepping, build
from tests.c.test_cases import shown

PROGRAM = """
#include <stdarg.h>
#include <stdio.h>
struct pair { int x, y; };
static double mix(float a, char b, long long c, double d, unsigned char e, struct pair f, int g)
{ return a + b + c + d + e + f.x * 10 + f.y + g; }
static int many(int a, int b, int c, int d, int e, int f)
{ a += b; while (b-- > 0) c += d; return a * c + e - f; }
static int fib(int n) { return n < 2 ? n : fib(n - 1) + fib(n - 2); }
static int bytes(int first, int second) { int *all = &first; return all[0] + second; }
static int sum(int n, ...)
{ va_list all; int s = 0; va_start(all, n); while (n--) s += va_arg(all, int); va_end(all);
  return s; }
static int fewer(a) int a; { return a + fib(3); }
static struct pair turned(struct pair p, int n)
{ struct pair q; if (n) return turned(p, n - 1); q.x = p.y; q.y = p.x; return q; }
int main(void)
{
    struct pair p = { 1, 2 }, q = turned(p, 5);
    int (*through)(int, int) = bytes;
    double (*mixing)(float, char, long long, double, unsigned char, struct pair, int) = mix;
    printf("%g %g\\n", mix(0.5f, 300, 1LL << 33, 0.25, 511, p, -1),
           mixing(0.5f, 300, 7, 0.25, 511, q, 3));
    printf("%d %d %d\\n", many(1, 2, 3, 4, 5, 6), fib(12), through(3, 4));
    printf("%d %d %d %d\\n", sum(3, 1, 2, 3), fewer(1, 2), q.x, q.y);
    return 0;
}
"""
PRINTED = b"8.58993e+09 330.75\n32 144 7\n6 3 2 1\n"
STEPPINGS = [Stepping(), Stepping(1), Stepping(7, 0, 2)]


@pytest.fixture(scope="module")
def source(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("convention") / "passing.c"
    path.write_text(PROGRAM)
    return path


@pytest.mark.parametrize("checked", [True, False])
@pytest.mark.parametrize("debug", [False, True])
def test_all_kinds_of_calls_do_the_same_in_every_build_and_suspended_anywhere(
    source: Path, checked: bool, debug: bool
) -> None:
    executable = build(source, checked=checked, debug=debug)
    outcomes = [Run(executable, stepping).to_end() for stepping in STEPPINGS]
    assert [each.output for each in outcomes] == [PRINTED] * len(STEPPINGS)
    assert len({each.fuel for each in outcomes}) == 1


@pytest.mark.parametrize("checked", [True, False])
def test_a_report_shows_what_was_passed_though_the_parameter_has_changed(
    tmp_path: Path, checked: bool
) -> None:
    path = tmp_path / "fails.c"
    path.write_text(
        "static int f(int kept, int changed) {\n"
        "    while (changed > 2) changed--;\n"
        "    return kept == 2 ? 1 / (changed - 2) : f(kept + 1, 9) + 1;\n"
        "}\n"
        "int main(void) { return f(0, 7); }\n"
    )
    executable = build(path, checked=checked)
    for stepping in STEPPINGS:
        failure = Run(executable, stepping).to_end().failure
        assert failure is not None
        report = shown(failure, tmp_path).decode()
        assert "f(kept=2, changed=9)" in report
        assert "f(kept=0, changed=7)" in report


def test_parameters_whose_address_is_taken_and_all_beside_them_are_in_memory() -> None:
    text = "int f(int a, int b) { return *&b + a; } int g(int a, double b) { return a + (int)b; }"
    functions = compile_text(text, "f.c", Options(), Diagnostics()).functions
    assert convention_of(functions["f"]).registers == (None, None)
    assert convention_of(functions["g"]).registers == ("i32", "f64")


def test_no_more_is_passed_in_registers_than_there_are() -> None:
    parameters = ", ".join(f"int p{number}" for number in range(9))
    text = f"int f({parameters}) {{ return p0; }}"
    function = compile_text(text, "f.c", Options(), Diagnostics()).functions["f"]
    passed = [each for each in convention_of(function).registers if each is not None]
    assert len(passed) == MAX_WORDS
