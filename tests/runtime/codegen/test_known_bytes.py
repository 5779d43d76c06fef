"""What a block has checked is known in the blocks that only it leads to."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.runtime.codegen.indices import SHADOW
from crs_cc.session.build import build_executable
from tests.c.execution import Run


def _checks(folder: Path, body: str) -> int:
    """Return the number of looks at the shadow memory in a function `f(int *p, int n)`."""
    source = folder / "known.c"
    source.write_text(
        "void g(void) { for (int i = 0; i < 2; i++); }"
        "int small(int x) { return x + 1; }"
        f"int f(int *p, int n) {{ int i = 0, s = 0; {body} return s + i; }}"
        "int main(void) { int a[2] = {1, 2}; return f(a, 1); }"
    )
    functions = build_executable([source], Diagnostics()).detail().compiled.module.functions
    code = next(each for each in functions if each.name == "f")  # what resumes it comes later
    return sum(each[:2] == ("i32.load", SHADOW) for each in code.body)


@pytest.mark.parametrize(
    ("body", "checks"),
    [
        ("s = *p; if (n) s += *p; else s -= *p;", 1),
        ("s = *p; switch (n) { case 1: s = 2 * *p; break; case 2: s = 3 * *p; }", 1),
        ("if (n) s = *p; s += *p;", 2),
        ("if (*p) g(); s = *p;", 2),
        ("s = *p; g(); s += *p;", 2),
        ("s = *p; n = small(n); s += *p;", 1),
        ("s = *p; p = (int *)small((int)p); s += *p;", 2),
        ("s = *p; do s += *p; while (++i < n);", 2),
    ],
)
def test_a_check_is_repeated_only_where_it_is_needed(
    tmp_path: Path, body: str, checks: int
) -> None:
    assert _checks(tmp_path, body) == checks


def test_what_a_loop_frees_is_checked_in_its_next_turn(tmp_path: Path) -> None:
    source = tmp_path / "frees.c"
    source.write_text("""
        #include <stdlib.h>
        int main(void)
        {
            int *p = calloc(1, 4), i, s = 0;
            for (i = 0; i < 3; i++) {
                if (*p == 0)
                    s += *p;
                if (i == 1)
                    free(p);
            }
            return s;
        }""")
    failure = Run(build_executable([source], Diagnostics())).to_end().failure
    assert failure is not None
    assert (failure.kind, failure.location.line) == ("use after free", 7)
