"""Signed overflow stops a program only on request."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.session.build import build_executable
from tests.c.execution import Run

OVERFLOWS = (
    "int n = 2147483647; n = n + one;",
    "int n = -2147483647; n -= one + 1;",
    "int n = 65536; n *= n * one;",
    "int n = 2147483647; n++;",
    "int n = -2147483647 - one; n = -n;",
    "long long n = 9223372036854775807ll; n += one;",
    "long long n = -9223372036854775807ll; n = n - 2;",
    "long long n = 4294967296ll; n = n * (n / 2) * one;",
    "long long n = -9223372036854775807ll - 1; n = -one * n;",
)
FINE = (
    "int n = 2147483646; n = n + one;",
    "int n = -2147483647; n -= one;",
    "int n = 46340; n = n * n * one;",
    "unsigned n = 4294967295u; n = n + one; n *= n; n = -n;",
    "signed char n = 127; n++; n = n + one;",
    "long long n = 9223372036854775806ll; n += one; n = -n;",
    "long long n = 4294967296ll; n = n * (n / 2 - 1) * one; n = -one * n;",
    "int a[4], *p = a; p += 2; p -= one; n = p - a;",
    "unsigned a = -one; n = __builtin_mul_overflow(a, a, &a);",
)


def run(folder: Path, body: str, *, trap_overflow: bool) -> str:
    path = folder / "sum.c"
    path.write_text(f"int n;\nint main(void) {{ volatile int one = 1; {body} return 0; }}\n")
    outcome = Run(build_executable([path], Diagnostics(), trap_overflow=trap_overflow)).to_end()
    return outcome.failure.kind if outcome.failure else ""


@pytest.mark.parametrize("body", OVERFLOWS)
def test_overflow_wraps_or_traps_by_option(tmp_path: Path, body: str) -> None:
    assert run(tmp_path, body, trap_overflow=False) == ""
    assert run(tmp_path, body, trap_overflow=True) == "signed overflow"


def test_results_in_range_do_not_overflow(tmp_path: Path) -> None:
    for body in FINE:
        assert run(tmp_path, body, trap_overflow=True) == "", body
