"""Large functions do what small ones do, and compile in time that grows with their size.

The second is the doing of `large_functions`: with its limits switched off the last tests fail.
"""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable

import pytest
import wasmtime

from crs_cc.core.gc_pause import gc_paused
from crs_cc.core.source import Diagnostics
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.unit import compile_text
from crs_cc.runtime.codegen import large_functions, library_code
from crs_cc.runtime.codegen.module import compile_program
from crs_cc.runtime.diagnosis.report import report
from crs_cc.runtime.executable import Executable, engine, make_executable
from crs_cc.runtime.link import link
from crs_cc.runtime.wasm import Module
from crs_cc.session.library import library
from tests.c.execution import HERE as CASES
from tests.c.execution import Run, Stepping, build


def again(executable: Executable, *, debug: bool = False) -> Executable:
    """Return a program with its code generated again."""
    detail = executable.detail()
    return make_executable(detail.program, executable.name, lines=detail.lines, debug=debug)


def make_all_large(patch: pytest.MonkeyPatch) -> None:
    """Compile every function as if it were large, and keep the code of none for other programs."""
    patch.setattr(large_functions, "MAX_BLOCKS", 0)
    patch.setattr(library_code, "_TEMPLATES", {})


def test_a_program_of_large_functions_does_the_same_wherever_it_is_suspended(
    monkeypatch: pytest.MonkeyPatch, subtests: pytest.Subtests
) -> None:
    for path in sorted((CASES / "valid").glob("*.c"))[::6]:
        small = build(path)
        small.detail()
        plain = Run(small).to_end()
        with monkeypatch.context() as patch, subtests.test(path.stem):
            make_all_large(patch)
            large, stepped = again(small), again(small, debug=True)
            fuel = plain.fuel // 5000 + 1
            ways = Stepping(), Stepping(fuel), Stepping(fuel * 300, restore_every=3)
            for outcome in (*(Run(large, way).to_end() for way in ways), Run(stepped).to_end()):
                assert (outcome.output, outcome.status) == (plain.output, plain.status)
                assert outcome.fuel == plain.fuel
            statements = Run(stepped, Stepping(statements=50)).to_end()
            assert statements.memory == Run(stepped).to_end().memory


@pytest.mark.parametrize(
    "name", ["divide_int", "null_member", "wild_last_bytes", "calls/mismatched_fewer"]
)
def test_a_large_function_is_reported_like_a_small_one(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = CASES / f"errors/{name}.c"
    small = build(path)  # before the limits change: it is kept in the cache
    small.detail()
    with monkeypatch.context() as patch:
        make_all_large(patch)
        large = again(small)
    failures = [Run(each).to_end().failure for each in (small, large)]
    first, second = (report(each) for each in failures if each)
    assert first == second


def switch(size: int) -> str:
    """Return a program with a `switch` of so many cases."""
    cases = "".join(f"case {3 * i}: x += {i}; break;\n" for i in range(size))
    return (
        f"int f(int x) {{ switch (x) {{\n{cases}}} return x; }}\nint main(void) {{ return f(3); }}"
    )


def branches(size: int) -> str:
    """Return a program with a function of so many branches."""
    rows = "".join(f"if (a > {i}) b += a; else b -= {i};\n" for i in range(size))
    return f"int f(int a, int b) {{\n{rows} return b; }}\nint main(void) {{ return f(3, 4); }}"


def sums(size: int) -> str:
    """Return a program with a function that adds so many numbers through pointers."""
    rows = "a = a->next; b += a->number;\n" * size
    text = "struct list { struct list *next; int number; };\nint f(struct list *a, int b) {\n"
    return f"{text}{rows} return b; }}\nint main(void) {{ return f(0, 4); }}"


def calls(size: int) -> str:
    """Return a program with a function of so many calls of another."""
    rows = "".join(f"if (a > {i}) b += g(a); else a = g(b) - {i};\n" for i in range(size))
    text = f"int g(int x) {{ while (x > 9) x /= 2; return x; }}\nint f(int a, int b) {{\n{rows}"
    return f"{text} return b; }}\nint main(void) {{ return f(3, 4); }}"


@pytest.mark.parametrize(
    ("text", "size"), [(switch, 1000), (branches, 400), (sums, 200), (calls, 200)]
)
def test_a_large_function_keeps_its_values_in_the_frame(
    text: Callable[[int], str], size: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each local with a value at a meeting of control flow has a part in the quadratic time."""
    assert len(joined(text(size))) <= 1  # a check may use one that was set just before
    switch_limits_off(monkeypatch)
    assert len(joined(text(size))) > 1


def switch_limits_off(patch: pytest.MonkeyPatch) -> None:
    """Make no function a large one."""
    for limit in ("MAX_BLOCKS", "MAX_CHECKED", "MAX_IN_BLOCK", "MAX_WAYS"):
        patch.setattr(large_functions, limit, 10**9)


def joined(text: str) -> set[int]:
    """Return the locals of the function `f` whose values the host joins where control flow meets.

    They are written in several places, and read where a block has not written them before.
    """
    (code,) = (each for each in webassembly(text).functions if each.name == "f")
    places = Counter(instr[1] for instr in code.body if instr[0] in {"local.set", "local.tee"})
    found, written = set(), set[int]()
    for name, *operands in code.body:
        if name in {"block", "loop", "if", "else", "end", "br", "br_if", "br_table"}:
            written.clear()
        elif name in {"local.set", "local.tee"}:
            written.add(operands[0])
        elif name == "local.get" and operands[0] not in written and places[operands[0]] > 1:
            found.add(operands[0])
    return found


@pytest.mark.usefixtures("users_settings")
def test_a_large_function_is_compiled_sooner_than_a_smaller_one_without_the_limits(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """It takes a quarter of the time of one of three eighths of its size."""
    with gc_paused():
        large_s = least_s(sums(400))
        switch_limits_off(monkeypatch)
        assert 2 * large_s < least_s(sums(150))


def webassembly(text: str) -> Module:
    """Return a program's code."""
    unit = compile_text(text, "large.c", Options(), Diagnostics())
    return compile_program(link([unit], library(), Diagnostics())).module


def least_s(text: str) -> float:
    """Return the least of two processor times of compiling WebAssembly [s]."""
    binary = webassembly(text).to_binary()
    times = []
    for _ in range(2):
        start = time.process_time()
        wasmtime.Module(engine(), binary)
        times.append(time.process_time() - start)
    return min(times)
