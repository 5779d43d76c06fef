"""Loops that are tested at the top are rotated; others are left as they are."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.ir.loops import loop_headers
from crs_cc.ir.program import Function
from crs_cc.runtime.codegen import rotation
from crs_cc.runtime.codegen.rotation import rotated_loops
from crs_cc.session.build import build_executable

ROTATED = {
    "while (i < n) i += 3;": 1,
    "for (i = 0; i < n; i++) if (i % 5 == 2) n--;": 1,
    "while (i < n) { if (i % 7 == 1) { i += 2; continue; } i++; }": 1,
    "for (i = 0; i < n; i++) for (j = 0; j < i; j++) s += j;": 2,
    "while (i < n && s < 100) s += i++;": 1,
    "do i += 2; while (i < n);": 0,
    "do { if (i & 1) s++; i += 3; } while (i < n);": 0,
    "if (n & 1) goto inside; while (i < n) { s++; inside: i++; }": 0,
    "for (;;) { if (i & 1) s++; else s += 2; if (i++ > n) break; }": 0,
}


@pytest.mark.parametrize("statement", ROTATED)
def test_a_loop_is_rotated_if_its_header_is_its_test(tmp_path: Path, statement: str) -> None:
    function = _main(tmp_path, statement)
    rotated = rotated_loops(function, loop_headers(function))
    assert len(rotated) == ROTATED[statement]
    for header, latches in rotated.items():
        assert latches
        assert all(header in latch.successors() for latch in latches)


def test_a_huge_loop_is_not_examined(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    function = _main(tmp_path, "while (i < n) { if (s & 1) s++; i++; }")
    monkeypatch.setattr(rotation, "MAX_BLOCKS", 2)
    assert rotated_loops(function, loop_headers(function)) == {}


def _main(folder: Path, statement: str) -> Function:
    source = folder / "loops.c"
    source.write_text(
        f"int main(int n, char **v) {{ int i = 0, j = 0, s = 0; {statement} return i + j + s; }}"
    )
    return build_executable([source], Diagnostics()).program.functions["main"]
