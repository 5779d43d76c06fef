"""What workers remember before they are copied serves submissions."""

from __future__ import annotations

import pytest

from crs_cc.cli.grading import compiler_memory
from crs_cc.core.source import Diagnostics
from crs_cc.frontend.unit import compile_text
from crs_cc.ir.names import in_library
from crs_cc.ir.program import Function
from crs_cc.runtime.codegen import library_code
from crs_cc.runtime.codegen.module import compile_program
from crs_cc.runtime.link import link
from crs_cc.session.library import library, library_options
from tests.cli.grading.handed_in import good


def test_no_code_of_the_library_is_generated_for_a_usual_submission(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    generate, generated = library_code.generate, list[str]()

    def noting(function: Function, *others: object) -> object:
        if in_library(function.location):
            generated.append(function.name)
        return generate(function, *others)  # type: ignore[arg-type]

    monkeypatch.setattr(library_code, "generate", noting)
    monkeypatch.setattr(library_code, "_TEMPLATES", {})
    compiler_memory.fill()
    assert "scout_pr" in generated
    generated.clear()
    unit = compile_text(good(), "good.c", library_options(), Diagnostics())
    compile_program(link([unit], library(), Diagnostics()))
    assert generated == []
