"""What the front end leaves to Python's garbage collector."""

from __future__ import annotations

import gc
from pathlib import Path

import pytest

from crs_cc.core.errors import CompileError
from crs_cc.core.gc_pause import gc_paused
from crs_cc.core.source import Diagnostics
from crs_cc.frontend.unit import compile_file
from crs_cc.session.library import library_options

PROGRAM = """#include <stdio.h>
#include "Nclient.h"
int main(void) { printf("%d at line %d\\n", connect_robot(1), __LINE__); return 0; }
"""
DAMAGED = "int main(void) { return 1 +; } int f(void) { return g; } int a[-1]; }\n" * 30
MAX_GARBAGE = 500
"""Its tokens, macros and places in the source are more than 3,000 objects."""


def test_tokens_and_macros_are_not_in_reference_cycles(tmp_path: Path) -> None:
    path = tmp_path / "cycles.c"
    path.write_text(PROGRAM)
    compile_file(path, library_options(), Diagnostics())  # what is remembered of headers stays
    with gc_paused():
        gc.freeze()  # the collector goes through new objects only
        compile_file(path, library_options(), Diagnostics())
        assert gc.collect() < MAX_GARBAGE


def test_tokens_of_a_damaged_program_are_not_in_reference_cycles(tmp_path: Path) -> None:
    path = tmp_path / "damaged.c"
    path.write_text(PROGRAM + DAMAGED)
    with gc_paused():
        gc.freeze()
        with pytest.raises(CompileError):
            compile_file(path, library_options(), Diagnostics())
        assert gc.collect() < MAX_GARBAGE
