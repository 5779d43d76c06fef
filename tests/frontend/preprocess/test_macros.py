"""Macro replacement: the examples of C17 6.10.3, and gcc's behaviour where it is unspecified."""

from __future__ import annotations

import pytest

from crs_cc.frontend.preprocess.options import Options
from tests.frontend.preprocess.preprocessing import cases, messages, result, run, tokens


@pytest.mark.parametrize(("source", "expected"), cases("macros.txt", "gives"))
def test_macro_expansion(source: str, expected: str) -> None:
    assert result(source) == tokens(expected)


@pytest.mark.parametrize(("source", "expected"), cases("macros.txt", "says"))
def test_macro_errors(source: str, expected: str) -> None:
    assert messages(source) == expected.splitlines()


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("OBJ (1-1)", "OBJ /* space */ (1-1) /* other */"),
        ("F(a) ( a )", "F( a )( /* the space */ \\\n a /* other\n */ )"),
    ],
)
def test_the_same_definition_may_be_repeated(first: str, second: str) -> None:
    assert messages(f"#define {first}\n#define {second}\n") == []


@pytest.mark.parametrize(
    ("name", "first", "second"),
    [
        ("OBJ", "OBJ (1-1)", "OBJ (0)"),
        ("OBJ", "OBJ (1-1)", "OBJ (1 - 1)"),
        ("F", "F(a) ( a )", "F(a) (a)"),
        ("F", "F(a) ( a )", "F(b) ( b )"),
        ("F", "F(a) a", "F a"),
        ("F", "F(a) a", "F(a...) a"),
    ],
)
def test_redefinition_is_a_warning_and_takes_effect(name: str, first: str, second: str) -> None:
    both = f"#define {first}\n#define {second}\n"
    assert messages(both) == [
        f"2:9: warning: '{name}' macro redefined [-Wmacro-redefined]",
        "1:9: note: previous definition is here",
    ]
    assert run(f"{both}{name}(7)")[0].text == run(f"#define {second}\n{name}(7)")[0].text


def test_options_define_and_undefine() -> None:
    options = Options(
        defines=("ONE", "TWO=2", "F(x)=<x>", "EMPTY=", "GONE=1"), undefines=("GONE", "linux")
    )
    text = "ONE TWO F(3) EMPTY GONE linux"
    assert result(text, options) == tokens("1 2 <3> GONE linux")


def test_invalid_macro_option_is_an_error() -> None:
    assert messages("int a;", Options(defines=("1x=2",))) == [
        "<command line>:1:9: error: macro name must be an identifier, not '1x'"
    ]
