"""The lexer returns the tokens of pycparser's own lexer, with their locations."""

from __future__ import annotations

import pytest
from pycparser.c_lexer import CLexer

from crs_cc.core.source import Diagnostics, Location
from crs_cc.frontend.parse.lexer import lex

SOURCE = r"""
typedef unsigned long size_t; struct s { int a : 3; } *p, q[4];
int f(const char *restrict s, ...) { static _Bool b; return s->x.y += (b ? 1 : -2) << 3; }
if (a && b || c != d) goto end; else while (i-- >= 0x1FuL) x ^= y %= ~z | 'a';
double d = 1.5e-3f + .5 + 0x1.8p3; char *t = "a\"b\\" "c"; for (;;) { break; continue; }
switch (n) { case 1: default: ; } do ; while (!x); x = sizeof(int) * offsetof(struct s, a);
"""


def test_the_tokens_are_those_of_pycparser() -> None:
    def fail(*problem: object) -> None:
        raise AssertionError(problem)

    theirs = CLexer(fail)
    theirs.input(SOURCE)
    wanted = [
        (each.type, each.value, each.lineno, each.column) for each in iter(theirs.token, None)
    ]
    ours = lex(SOURCE, lambda line, column: Location("a.c", line, column), Diagnostics())
    assert [(each.value, each.lineno, each.column) for each in ours] == [
        each[1:] for each in wanted
    ]
    kinds = {"INT_CONST_HEX": "INT_CONST_DEC", "HEX_FLOAT_CONST": "FLOAT_CONST"}
    assert [each.type for each in ours] == [kinds.get(each[0], each[0]) for each in wanted]


COMPLAINTS = {
    "x = 12abc;": "1:5 invalid suffix 'abc' on number '12abc'",
    "x = 1.5q;": "1:5 invalid suffix 'q' on number '1.5q'",
    "x = 0x1G;": "1:5 invalid suffix 'G' on number '0x1G'",
    "x = 089;": "1:5 invalid digit in octal constant '089'",
    "x = @;": "1:5 unexpected character '@'",
    "x = 'a;": "1:5 missing terminating ' character",
    'x = "a;': '1:5 missing terminating " character',
}


@pytest.mark.parametrize("text", COMPLAINTS)
def test_invalid_tokens_are_reported(text: str) -> None:
    diagnostics = Diagnostics()
    lex(text, lambda line, column: Location("a.c", line, column), diagnostics)
    (message,) = diagnostics.messages[:1]
    place = message.location
    assert f"{place.line}:{place.column} {message.text}" == COMPLAINTS[text]
