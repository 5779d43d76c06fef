"""Inlined calls change no result, no fuel and no report."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.unit import compile_text
from crs_cc.ir.instruction import Call
from crs_cc.ir.program import Program
from crs_cc.runtime.codegen import inlined_calls
from crs_cc.runtime.codegen.module import compile_program
from crs_cc.runtime.codegen.scalar_replacement import replace_slots
from crs_cc.runtime.codegen.small_functions import MAX_WORK, Bodies, small_functions
from crs_cc.runtime.executable import Executable, make_executable
from crs_cc.runtime.link import link
from crs_cc.session.library import library
from tests.c.execution import HERE as CASES
from tests.c.execution import Run, Stepping, build, cases
from tests.c.test_cases import shown

VECTOR = "typedef struct { double x, y; } vector;\n"


def compiled(text: str) -> Program:
    """Return a file's program."""
    return compile_text(text, "small.c", Options(), Diagnostics())


def inlined(text: str, *, checked: bool = True) -> list[str]:
    """Return which functions of a file can be inlined."""
    program = compiled(text)
    small = small_functions(program.functions)
    bodies = Bodies(small, checked=checked, traps_overflow=False)
    calls = [
        call
        for function in program.functions.values()
        for block in function.blocks
        if isinstance(call := block.terminator, Call)
    ]
    found = {str(call.callee) for call in calls if bodies.of(call) is not None}
    return sorted(name.rpartition(":")[2] for name in found)


def again(executable: Executable) -> Executable:
    """Return a program with its code generated again."""
    detail = executable.detail()
    return make_executable(detail.program, executable.name, lines=detail.lines)


def test_a_program_does_the_same_with_calls_instead(monkeypatch: pytest.MonkeyPatch) -> None:
    executable = build(CASES / "valid/functions/small.c")
    plain = Run(executable).to_end()
    with monkeypatch.context() as patch:
        patch.setattr(inlined_calls, "MAX_INLINED", 0)
        calling = again(executable)
    assert calling.machine_code != executable.machine_code
    for each, step in ((calling, 10**9), (executable, 1), (calling, 1)):
        outcome = Run(each, Stepping(step)).to_end()
        assert (outcome.output, outcome.fuel) == (plain.output, plain.fuel)


def test_both_are_suspended_at_the_same_places(monkeypatch: pytest.MonkeyPatch) -> None:
    executable = build(CASES / "valid/functions/small.c")
    with monkeypatch.context() as patch:
        patch.setattr(inlined_calls, "MAX_INLINED", 0)
        calling = again(executable)
    first, second = (Run(each, Stepping(7)).to_end() for each in (executable, calling))
    assert (first.rounds, first.fuel) == (second.rounds, second.fuel)


@pytest.mark.parametrize("path", cases("errors/small_functions"), ids=lambda path: path.stem)
def test_reports_are_those_of_calls(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    executable = build(path)
    executable.detail()  # of a cached program it is made when first asked for
    with monkeypatch.context() as patch:
        patch.setattr(inlined_calls, "MAX_INLINED", 0)
        calling = again(executable)
    first, second = (Run(each).to_end() for each in (executable, calling))
    assert first.failure is not None
    assert second.failure is not None
    one, other = (shown(each.failure, path.parent) for each in (first, second))
    assert one == other
    assert first.fuel == second.fuel


def test_large_structs_cost_what_it_costs_to_copy_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source = tmp_path / "large.c"
    source.write_text(
        "struct large { int x; char rest[1000]; int y; };\n"
        "static int sum(struct large s) { return s.x + s.y; }\n"
        "static int cleared(int x) { struct large s = {0}; s.x = x; return s.x; }\n"
        "int main(void) { struct large s = {1, {0}, 2}; return sum(s) - cleared(3); }\n"
    )
    executable = build(source)
    with monkeypatch.context() as patch:
        patch.setattr(inlined_calls, "MAX_INLINED", 0)
        calling = again(executable)
    assert calling.machine_code != executable.machine_code
    debug = build(source, debug=True)
    first, second, third = (Run(each).to_end() for each in (executable, calling, debug))
    assert first.status == second.status == third.status == 0
    assert first.fuel == second.fuel == third.fuel


def test_structs_by_value_are_inlined() -> None:
    text = VECTOR + (
        "vector add(vector a, vector b) { vector r = { a.x + b.x, a.y + b.y }; return r; }\n"
        "vector twice(vector a) { return (vector){ 2 * a.x, 2 * a.y }; }\n"
        "double test(vector a) { return add(a, twice(a)).x; }\n"
    )
    assert inlined(text) == ["add", "twice"]


def test_a_struct_that_is_passed_on_or_returned_through_is_inlined() -> None:
    text = (
        "struct point { int x, y; };\n"
        "struct point make(int x, char y) { struct point p; p.x = x; p.y = y; return p; }\n"
        "struct point sum(struct point a, struct point b)\n"
        "{ return make(a.x + b.x, a.y + b.y); }\n"
        "int norm(struct point a) { return a.x * a.x + a.y * a.y; }\n"
        "int far(struct point a, struct point b) { return norm(sum(a, b)) > 100; }\n"
        "int test(struct point a) { return far(a, a); }\n"
    )
    for checked in (True, False):
        assert inlined(text, checked=checked) == ["far", "make", "norm", "sum"]


def test_a_function_that_may_fail_after_a_change_is_not_inlined() -> None:
    push = "int n, a[9]; void push(int *to, int x) { to[n++] = x; } void f(void) { push(a, 1); }"
    assert inlined(push) == []
    assert inlined(push, checked=False) == ["push"]
    divide = "int n; int f(int x) { n++; return 6 / x; } int g(void) { return f(2); }"
    assert inlined(divide, checked=False) == []


def test_a_known_address_cannot_fail_again() -> None:
    text = "void swap(int *a, int *b) { int t = *a; *a = *b; *b = t; }"
    assert inlined(f"{text} void f(int *a) {{ swap(a, a + 1); }}") == ["swap"]


def test_a_use_of_a_variable_that_has_ended_is_not_replaced_by_a_register() -> None:
    body = "int *p; { int inner = 3; p = &inner; } return *p;"
    assert inlined(f"int f(void) {{ {body} }} int g(void) {{ return f(); }}") == []


@pytest.mark.parametrize(
    "body",
    [
        "while (x) x /= 2; return x;",
        "int a[3]; a[x & 1] = x; return a[0];",
        "int y; if (x) y = 1; return y;",
        "if (x) return 1;",
        "return x ? f(x - 1) : 0;",
        "int y = x, *p = &y; if (x) p = 0; return *p;",
        "static int (*p)(int) = f; return p(x);",
    ],
    ids=["loop", "array", "no_value", "no_result", "recursive", "address", "pointer"],
)
def test_others_are_not_inlined(body: str) -> None:
    text = f"int f(int x); int f(int x) {{ {body} }} int g(void) {{ return f(3); }}"
    assert inlined(text) == []


def test_the_work_of_a_small_function_includes_its_callees() -> None:
    """A chain in which each function calls the one before twice would double with each."""
    rows = ["int f0(int x) { return x + 1; }"]
    rows += [f"int f{i}(int x) {{ return f{i - 1}(x) + f{i - 1}(x); }}" for i in range(1, 40)]
    small = small_functions(compiled("\n".join(rows)).functions)
    assert 1 < len(small) < 6
    assert sum(block.fuel for each in small.values() for block in each.blocks) < 2 * MAX_WORK


def test_slots_become_registers() -> None:
    text = VECTOR + "vector f(vector a) { vector b = a, c; c = b; c.x += 1; return c; }"
    function = compiled(text).functions["f"]
    replaced = replace_slots(function, {each: each.fuel for each in function.blocks})
    assert replaced is not None
    assert not replaced.function.slots
    assert list(replaced.fuel.values()) == [block.fuel for block in function.blocks]
    (members,) = replaced.members.values()
    assert [(each.offset, each.memory) for each in members] == [(0, "f64"), (8, "i64")]


@pytest.mark.parametrize(
    "body",
    [
        "vector b = a; *(char *)&b.x = 1; return b;",
        "vector b = a; b.x += 1; b.y = *(unsigned long long *)&b.x; return b;",
        "vector b = a, *p = a.x > 0 ? &a : &b; return *p;",
        "union { vector v; float f[4]; } u; u.v = a; u.v.x = u.f[1]; return u.v;",
    ],
    ids=["byte", "other_type", "address", "overlapping"],
)
def test_slots_used_otherwise_stay_in_memory(body: str) -> None:
    function = compiled(f"{VECTOR} vector f(vector a) {{ {body} }}").functions["f"]
    assert replace_slots(function, {each: each.fuel for each in function.blocks}) is None


def test_the_growth_by_inlining_is_limited() -> None:
    """Each function is inlined in a caller only up to a limit, so that code grows linearly."""
    rows = "".join(f"x = f(x) + {i};\n" for i in range(1000))
    text = (
        f"int f(int x) {{ return x * x + 1; }}\nint main(void) {{ int x = 0;\n{rows} return x; }}"
    )
    whole = link([compiled(text)], library(), Diagnostics())
    main = whole.functions["main"]
    bodies = Bodies(small_functions(whole.functions), checked=True, traps_overflow=False)
    found = inlined_calls.inlined_calls(main.blocks, bodies)
    assert sum(sum(body.fuel.values()) for body in found.values()) > 0
    assert sum(sum(body.fuel.values()) for body in found.values()) <= inlined_calls.MAX_INLINED
    compile_program(whole)
