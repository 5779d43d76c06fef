"""Errors of one stage do not hide those of another."""

from crs_cc.core.errors import CompileError
from crs_cc.core.source import Diagnostics
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.unit import compile_text


def errors(text: str) -> list[str]:
    """Return the location and text of each error."""
    diagnostics = Diagnostics()
    try:
        compile_text(text, "a.c", Options(), diagnostics)
    except CompileError as error:
        return [f"{each.location.line}: {each.text}" for each in error.diagnostics]
    return []


def test_a_mistake_of_the_preprocessor_hides_no_wrong_types() -> None:
    assert errors("#els\nint f(void) { return x; }\n") == [
        "1: unknown directive '#els'", "2: use of undeclared identifier 'x'",
    ]  # fmt: skip


def test_a_rejected_line_is_not_reported_twice() -> None:
    text = "#define ONE(x) x\nint f(void) { return ONE(1, 2); }\n"
    assert errors(text) == ["2: macro 'ONE' requires 1 argument, but has 2"]


def test_nothing_is_checked_without_a_header_that_is_missing() -> None:
    (only,) = errors('#include "none.h"\npoint p = ORIGIN;\n')
    assert "none.h" in only
