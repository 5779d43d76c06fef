"""Instructions that can fail have the location of their expression, from first to last token."""

from __future__ import annotations

import pytest

from crs_cc.core.source import underline
from crs_cc.ir.instruction import Binary, Call, Load, Store
from crs_cc.ir.liveness import all_instructions
from tests.frontend.compiling import function

START = """
#define HALF(x) ((x) / 2)
#define VALUE value
struct node { int value, list[4]; struct node *next; } *global;
int g(int a);
int f(struct node *n, int *p, int i, int (*h)(int)) { return %s; }
"""

BLAMED = {
    "n->next->next->value": ["n->next", "n->next->next", "n->next->next->value"],
    "i / 3 / (i + 1)": ["i / 3", "i / 3 / (i + 1)"],
    "p[p[i]]": ["p[i]", "p[p[i]]"],
    "-*p + !*++p": ["*p", "*++p"],
    "(*n).list[i]": ["(*n).list[i]"],
    "n->list[2] %= 3": ["n->list[2]", "n->list[2] %= 3", "n->list[2]"],
    "(n)->next[i].value": ["(n)->next", "(n)->next[i].value"],
    "(p[0] = *p++)": ["*p++", "p[0]"],
    "n -> VALUE": ["n -> VALUE"],
    "(HALF(i + p[1]))": ["p[1]", "HALF(i + p[1])"],
    "1 + HALF(p[i]) / HALF(i)": ["p[i]", "HALF(p[i])", "HALF(i)", "HALF(p[i]) / HALF(i)"],
    "h(p[0]) % i": ["p[0]", "h(p[0])", "h(p[0]) % i"],
    "(short)p[1] / (char)i": ["p[1]", "(short)p[1] / (char)i"],
    "(i ? n : global)->value": ["global", "(i ? n : global)->value"],
    'p["a;)"[i]]': ['"a;)"[i]', 'p["a;)"[i]]'],
}


@pytest.mark.parametrize("expression", BLAMED)
def test_instructions_have_the_span_of_their_expression(expression: str) -> None:
    source = START % expression
    found = []
    for block in function(source).blocks:
        for each in all_instructions(block):
            is_division = isinstance(each, Binary) and ("div" in each.op or "rem" in each.op)
            if isinstance(each, Load | Store | Call) or is_division:
                place = each.location
                line = source.split("\n")[place.line - 1]
                start = place.column - 1
                found.append(line[start : start + len(underline(line, place))])
    a_caret_for_a_name = [each[0] if each.isidentifier() else each for each in BLAMED[expression]]
    assert found == a_caret_for_a_name
