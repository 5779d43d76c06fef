"""An error in the expansion of a macro has a note with the macro's definition."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostics
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.unit import compile_file
from crs_cc.session.library import library_options
from tests.frontend.compiling import messages

UNDECLARED = "error: use of undeclared identifier 'sped'"


@pytest.mark.parametrize(
    ("source", "told"),
    {
        "#define FAST sped\nint f(void) { return FAST; }":
            [f"2:22 {UNDECLARED}", "1:9 note: macro 'FAST' is defined here"],
        "#define TWICE(x) (2 * (x)\nint f(int a) { return TWICE(a); }":
            [
                "2:31 error: expected ')' before ';' [to close the '(' at a.c:2:23]",
                "1:9 note: macro 'TWICE' is defined here",
            ],
        "#define LIMIT 5\nint f(void) { LIMIT = 6; return 0; }": [
            "2:15 error: expression is not assignable",
            "1:9 note: macro 'LIMIT' is defined here",
        ],
        # Of macros in macros the one that says it
        "#define HALF (sped / 2)\n#define SLOW HALF\nint f(void) { return SLOW; }": [
            f"3:22 {UNDECLARED}",
            "1:9 note: macro 'HALF', which 'SLOW' uses, is defined here",
        ],
        # An argument is the user's own
        "#define TWICE(x) (2 * (x))\nint f(void) { return TWICE(sped); }": [f"2:28 {UNDECLARED}"],
        # Once for each macro
        "#define A 1\nint f(void) { A = 2; A = 3; return 0; }": [
            "2:15 error: expression is not assignable",
            "1:9 note: macro 'A' is defined here",
            "2:22 error: expression is not assignable",
        ],
        # What was there before counts
        "#define A 1\nint f(void) { A = 2; return 0; }\n#undef A\n#define A 2\n": [
            "2:15 error: expression is not assignable",
            "1:9 note: macro 'A' is defined here",
        ],
        "int f(void) { __LINE__ = 2; return 0; }": ["1:15 error: expression is not assignable"],
    }.items(),
)  # fmt: skip
def test_note_names_the_macro(source: str, told: list[str]) -> None:
    assert messages(source) == told


def test_note_for_macros_of_user_headers_only(tmp_path: Path) -> None:
    (tmp_path / "speeds.h").write_text("#define FAST 5\n")
    program = tmp_path / "main.c"
    program.write_text(
        '#include <stdio.h>\n#include "speeds.h"\nvoid f(void) { FAST = 1; EOF = 1; }\n'
    )
    diagnostics = Diagnostics()
    with pytest.raises(CompileError):
        compile_file(program, library_options(), diagnostics)
    (note,) = [each for each in diagnostics.messages if each.severity == "note"]
    assert str(note.location) == f"{tmp_path / 'speeds.h'}:1:9"
    assert note.source_line == "#define FAST 5"


def test_note_for_a_macro_of_the_command_line(tmp_path: Path) -> None:
    program = tmp_path / "main.c"
    program.write_text("void f(void) { FAST = 1; }\n")
    diagnostics = Diagnostics()
    with pytest.raises(CompileError):
        compile_file(program, Options(defines=("FAST=5",)), diagnostics)
    assert [str(each.location) for each in diagnostics.messages][1] == "<command line>:1:9"
