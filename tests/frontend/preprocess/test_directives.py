"""Directives: C17 6.10."""

from __future__ import annotations

import pytest

from tests.frontend.preprocess.preprocessing import cases, messages, result, run, tokens


@pytest.mark.parametrize(("source", "expected"), cases("directives.txt", "gives"))
def test_directives(source: str, expected: str) -> None:
    assert result(source) == tokens(expected)


@pytest.mark.parametrize(("source", "expected"), cases("directives.txt", "says"))
def test_directive_errors(source: str, expected: str) -> None:
    assert messages(source) == expected.splitlines()


def test_similar_directive_is_suggested() -> None:
    _, diagnostics = run("#inclde <stdio.h>\n")
    assert diagnostics.messages[0].hint == "did you mean '#include'?"


@pytest.mark.parametrize("ending", ["\n", "\r\n", "\r"])
def test_line_ends(ending: str) -> None:
    source = ending.join(["#define A \\", " 1", "int a = A; // x", "/* a", "b */ int b;", ""])
    program, diagnostics = run(source)
    assert program.text == "int a = 1;\n          int b;\n"
    assert diagnostics.lines["a.c"][2] == "int a = A; // x"


def test_byte_order_and_end_marks_are_ignored() -> None:
    assert result("\ufeffint a;\n\x1a") == ["int", "a", ";"]


def test_a_form_feed_is_white_space() -> None:
    assert result("\fint\va;\n\f#define X 1\nX") == ["int", "a", ";", "1"]
