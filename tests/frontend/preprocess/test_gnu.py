"""GNU syntax and unusual spellings are rewritten for the parser."""

from __future__ import annotations

from pathlib import Path

import pytest
from pycparser.c_parser import CParser

from crs_cc.core.source import Diagnostics
from crs_cc.frontend.preprocess.options import Options
from crs_cc.frontend.preprocess.preprocessor import preprocess
from tests.frontend.preprocess.preprocessing import (
    cases,
    messages,
    result,
    run,
    tokens,
    without_attributes,
)


@pytest.mark.parametrize(
    ("source", "expected"), cases("gnu.txt", "gives") + cases("spelling.txt", "gives")
)
def test_gnu_syntax_is_rewritten(source: str, expected: str) -> None:
    assert result(source) == tokens(expected)


@pytest.mark.parametrize(
    ("source", "expected"), cases("gnu.txt", "says") + cases("spelling.txt", "says")
)
def test_unsupported_syntax_errors(source: str, expected: str) -> None:
    assert messages(source) == expected.splitlines()


def test_unknown_escape_sequences_are_their_character() -> None:
    program, _ = run(r"""char *s = "100\% \\\%"; char c = '\$';""")
    assert program.text == r"""char *s = "100% \\%"; char c = '$';""" + "\n"


def test_bytes_that_are_not_utf8_are_preserved(tmp_path: Path) -> None:
    path = tmp_path / "old.c"
    path.write_bytes(b'char *s = "gr\xf6\xdfe"; /* \xe9 */\nint x = 1; // \xfc\n')
    diagnostics = Diagnostics()
    program = preprocess(path, Options(), diagnostics)
    assert diagnostics.messages == []
    assert program.text == 'char *s = "gr\\366\\337e";\nint x = 1;\n'
    assert diagnostics.lines[str(path)][0] == 'char *s = "gr��e"; /* � */'


def test_output_can_be_parsed() -> None:
    program, _ = run(
        "typedef char *va_list;\n"
        "static inline int f(int n, ...) __attribute__((unused));\n"
        "static inline int f(int n, ...) {\n"
        "  va_list ap; int a<:2:> = <% __alignof__(int), 0 %>;\n"
        '  puts("100\\%" "\xe9"); größe: __extension__ ({ n; });\n'
        "  return __builtin_va_arg(ap, int *) + a[0];\n"
        "}\n"
    )
    tree = CParser().parse(without_attributes(program.text))
    call = tree.ext[2].body.block_items[-1].expr.left
    assert call.name.name == "__builtin_va_arg"
    assert [type(each).__name__ for each in call.args.exprs] == ["ID", "Typename"]


def test_very_long_numbers_are_fast() -> None:
    source = f"int a = 0x{'f' * 100_000};"
    assert result(source) == tokens(source)
