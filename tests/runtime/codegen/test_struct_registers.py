"""Structs in registers: the program does the same, and what must be in memory stays there."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.unit import compile_text
from crs_cc.runtime.codegen.small_functions import Bodies, small_functions
from crs_cc.runtime.codegen.struct_registers import with_structs_in_registers
from tests.c.execution import Run, Stepping, build
from tests.c.test_cases import shown

TYPES = """
#include <stdio.h>
struct point { int x, y; };
struct box { struct point low, high; double weight; };
static const int table[4] = { 7, 5, 3, 1 };
static struct point make(int x, int y) { struct point p; p.x = x; p.y = y; return p; }
static struct point sum(struct point a, struct point b) { return make(a.x + b.x, a.y + b.y); }
static struct point picked(int i) { return make(table[i & 3], i); }
static struct point divided(struct point a, int by) { return make(a.x / by, a.y % by); }
static struct point swapped(struct point a) { struct point r = { a.y, a.x }; return r; }
static void add(struct point *to, struct point a) { to->x += a.x; to->y += a.y; }
static int area(const struct box *b)
{ return (b->high.x - b->low.x) * (b->high.y - b->low.y); }
"""
PROGRAM = (
    TYPES
    + """
static struct point stored[3] = { { 1, 2 }, { 3, 4 }, { 5, 6 } };
static int far(struct point a) { int i, n = 0; for (i = a.x; i < a.y; i++) n += i; return n; }
static struct point *escaped;
int main(void)
{
    struct point at = { 1, 1 }, step = { 2, 3 }, kept, passed = { 2, 5 };
    struct box room = { { 0, 0 }, { 4, 5 }, 1.5 }, other;
    union { float f; int i; } bits;
    int i;

    escaped = &kept;
    kept = at;
    for (i = 0; i < 20; i++) {
        struct point next = sum(at, step);
        if (i % 3)
            at = next;
        else
            step = swapped(divided(step, 1));
        at = sum(at, stored[i % 3]);
        stored[i % 3] = swapped(at);
        add(&at, picked(i));
        escaped->x += at.x;
        other = room;
        other.high = sum(other.high, make(i, kept.x & 15));
        other.weight *= i;
        room.weight += other.weight / 64;
    }
    bits.f = 1.5f;
    printf("%d %d %d %d %d %d\\n", at.x, at.y, step.x, step.y, kept.x, kept.y);
    printf("%d %g %g %x %d\\n", area(&other), room.weight, other.weight, bits.i, far(passed));
    return 0;
}
"""
)
PRINTED = b"14098 14122 0 0 44233 1\n322 22.4574 329.014 3fc00000 9\n"


@pytest.mark.parametrize("checked", [True, False])
def test_structs_in_registers_do_what_structs_in_memory_do(tmp_path: Path, checked: bool) -> None:
    path = tmp_path / "structs.c"
    path.write_text(PROGRAM)
    executable = build(path, checked=checked)
    plain = Run(executable).to_end()
    assert plain.output == PRINTED
    for stepping in (Stepping(3), Stepping(40, 0, 2)):
        outcome = Run(executable, stepping).to_end()
        assert (outcome.output, outcome.fuel) == (plain.output, plain.fuel)


def replaced(body: str, *, checked: bool = False) -> set[str]:
    """Return the names of the variables of a function that are in registers."""
    text = TYPES.replace("#include <stdio.h>", "int use(void *p);")
    program = compile_text(f"{text} int f(int n) {{ {body} }}", "f.c", Options(), Diagnostics())
    bodies = Bodies(small_functions(program.functions), checked=checked, traps_overflow=False)
    homes = with_structs_in_registers(program.functions["f"], bodies).homes
    return {slot.name for slot, _ in homes.values()}


def test_structs_passed_to_small_functions_are_in_registers() -> None:
    body = "struct point a = { 1, n }, b = sum(a, a); add(&b, swapped(a)); return b.x;"
    assert replaced(body) >= {"a", "b"}
    assert replaced(body.replace("add(&b, swapped(a));", ""), checked=True) >= {"a", "b"}


@pytest.mark.parametrize(
    "body",
    [
        "struct point b; b.x = n; n = b.x; b.y = 2; return b.y + n;",
        "struct point b; if (n) b.x = 1; b.y = n; return b.y + b.x;",
        "while (n--) { struct point b; if (n > 2) b.x = b.y = n; else n -= b.x + b.y; } return 0;",
        "struct point *p = use(0) ? 0 : 0, b = *p; return b.x + b.y;",
        "int v[2]; struct point b; use(v); b.x = v[0]; b.y = v[1]; return b.x + b.y;",
        "struct point b, c; b.x = n; c = b; c.y = 1; return c.x + c.y;",
    ],
    ids=["half", "on_one_path", "of_last_pass", "from_memory", "of_deferred_values", "copied_half"],
)
def test_what_may_have_no_value_stays_in_memory_in_checked_builds(body: str) -> None:
    body = f"struct point a = {{ 3, 1 }}; int m = a.x + a.y; {body}"
    assert replaced(body) >= {"a", "b"}
    assert replaced(body, checked=True) == {"a"}


def test_what_has_its_values_is_in_registers_in_checked_builds() -> None:
    assert replaced("struct point b; b.x = n; b.y = 2; return b.x + b.y;", checked=True) == {"b"}


@pytest.mark.parametrize(
    "body",
    [
        "struct point b = { n, 2 }; return use(&b);",
        "struct point b = { n, 2 }, *p = n ? &b : 0; return p->x;",
        "struct point b = { n, 2 }; return divided(b, n).x + use(&b);",
        "struct { int x[2]; } b = { { 1, 2 } }; return b.x[n];",
        "struct { char x, y; } b = { 1, 2 }; return b.x + b.y;",
        "union { int i; float f; } b; b.f = n; return b.i;",
    ],
    ids=["escapes", "chosen", "passed_and_escapes", "indexed", "narrow", "union"],
)
def test_others_stay_in_memory_and_do_not_keep_those_beside_them(body: str) -> None:
    assert replaced(f"struct point a = {{ n, 1 }}; n = a.y; {body}") == {"a"}


def test_a_failure_in_a_function_that_is_passed_a_struct_is_reported_as_ever(
    tmp_path: Path,
) -> None:
    path = tmp_path / "fails.c"
    path.write_text(
        TYPES
        + "int main(void) { struct point a = make(4, 2), b = sum(a, a);\n"
        + "    while (a.y >= 0) { b = divided(b, a.y); a.y--; } return b.x; }\n"
    )
    failures = [Run(build(path, checked=checked)).to_end().failure for checked in (True, False)]
    reports = [shown(failure, tmp_path) for failure in failures if failure is not None]
    assert len(reports) == 2
    assert reports[0] == reports[1]
    assert b"by=0)" in reports[0]


def test_a_report_shows_structs_in_registers(tmp_path: Path) -> None:
    path = tmp_path / "fails.c"
    path.write_text(
        TYPES
        + "int main(void) { int cells[9] = { 0 }; struct point at = { 3, 4 }, step = { 2, 5 };\n"
        + "    while (at.x) { struct point next = sum(at, step);\n"
        + "        cells[next.x]++; at = next; } return 0; }\n"
    )
    failures = [Run(build(path, debug=debug)).to_end().failure for debug in (False, True)]
    reports = [shown(failure, tmp_path) for failure in failures if failure is not None]
    assert len(reports) == 2
    assert reports[0] == reports[1]
    assert b"next = {x = 9, y = 19}" in reports[0]
