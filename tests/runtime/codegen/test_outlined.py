"""Functions without loops are resumed by functions of their own, so that their code stays short."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.runtime.codegen.module import compile_program
from crs_cc.session.build import build_executable

DEEP = "static int deep(int n) { return n < 2 ? n : deep(n - 1) + deep(n - 2); }"
LOOP = "static int deep(int n) { int s = n; while (n > 1) s += deep(--n); return s; }"
LEAF = "static int deep(int n) { while (n > 9) n -= n / 2; return n * n; }"
MANY = f"static int deep(int n) {{ return n < 2 ? n : {' + '.join(['deep(n / 2)'] * 9)}; }}"


@pytest.mark.parametrize("checked", [True, False])
@pytest.mark.parametrize(
    ("function", "others"),
    [(DEEP, 1), (LOOP, 0), (LEAF, 0), (MANY, 0)],
    ids=["deep", "loop", "leaf", "many"],
)
def test_a_function_that_only_calls_is_resumed_by_another(
    tmp_path: Path, function: str, others: int, *, checked: bool
) -> None:
    assert _functions(tmp_path, function, checked=checked) == others


@pytest.mark.parametrize("checked", [True, False])
def test_debug_builds_resume_each_function_by_itself(tmp_path: Path, *, checked: bool) -> None:
    assert _functions(tmp_path, DEEP, checked=checked, debug=True) == 0


def _functions(folder: Path, function: str, *, checked: bool, debug: bool = False) -> int:
    """Return how many functions more than with a loop in it a program has."""
    found = []
    for number, text in enumerate((function, LOOP)):
        source = folder / f"{number}.c"
        source.write_text(f"{text}\nint main(int n, char **v) {{ return deep(n); }}")
        program = build_executable([source], Diagnostics()).program
        module = compile_program(program, checked=checked, debug=debug).module
        found.append(len(module.functions))
    return found[0] - found[1]
