"""Values are written by their types, and unfold into their parts."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.debug.data.evaluate import Evaluator
from tests.debug.stopped_program import Stopping

SOURCE = r"""
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "Nclient.h"
enum mode { IDLE, TURN = 5, BACK = -1 };
enum flags { LEFT = 1, RIGHT = 2, UP = 4 };
struct point { int x, y; };
union word { float number; unsigned bits; };
struct part {
    struct point at; struct part *next; enum mode mode; enum flags flags; union word word;
    unsigned on : 3; signed off : 4; unsigned : 2; _Bool yes : 1; char name[6];
    struct { short inner; };
};
struct part part;
int order[4] = {1, 2, 3, 4}, grid[2][3] = {{1, 2, 3}, {4, 5, 6}}, many[40];
char text[8] = "a\n\"b\"", packed[6] = "\357\374\303\244", unended[4] = {'a', 'b', 'c', 'd'};
const char *words[] = {"one", 0};
static int twice(int n) { return 2 * n; }
int (*op)(int) = twice, (*ops[2])(int) = {twice, 0};
float f = 0.1f; double d = 0.1, huge = 1e300, infinite, number;
unsigned char byte = 200; long long wide = -1; unsigned long long uwide = -1; _Bool yes = 1;
void *any = order; int **twofold; int *p_order;
static int *leaked(void) { int gone = 3; int *p = &gone; return p; }
int main(void)
{
    struct part *heap = malloc(sizeof *heap), *freed = malloc(24), *none = 0;
    int *mid = &order[3], *past = order + 4, *wild = (int *)0x500000, local = 7;
    char *inside = text + 2;
    int *stale = leaked(), half[3], *reg_p = &half[1];
    p_order = order; twofold = &p_order;
    half[1] = 5;
    infinite = 1 / 0.0; number = infinite - infinite;
    part = (struct part) {{1, 2}, &part, TURN, LEFT | UP, {0.5f}, 5, -3, 1, "ab", {9}};
    many[39] = 1;
    free(freed);
    memset(heap, 0, sizeof *heap);
    heap->next = &part;
    State[STATE_SONAR_0] = 48; State[STATE_SONAR_0 + 1] = 255;
    printf("%d", local + *mid + (past != wild) + *inside + *reg_p + (stale != 0)); /* STOP */
    return heap->on + (freed == none) + ops[0](1) + op(2) + twofold[0][0] + unended[0] + words[0][0]
        + byte + (int)wide + (int)uwide + yes + (any != 0) + (int)(f + d + huge) + grid[0][0];
}
"""


@pytest.fixture(scope="module")
def evaluator(tmp_path_factory: pytest.TempPathFactory) -> Evaluator:
    return Stopping(tmp_path_factory.mktemp("values"), SOURCE).run().evaluator()


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("f", "0.1"),
        ("d", "0.1"),
        ("huge", "1e+300"),
        ("infinite", "inf"),
        ("number", "nan"),
        ("byte", "200"),
        ("wide", "-1"),
        ("uwide", "18446744073709551615"),
        ("yes", "true"),
        ("'\\n'", "10"),
        ("(char)10", "10 '\\n'"),
        ("part.mode", "TURN"),
        ("(enum mode)-1", "BACK"),
        ("(enum mode)3", "3"),
        ("part.flags", "LEFT | UP"),
        ("(enum flags)8", "8"),
        ("part.word", "{number = 0.5, bits = 1056964608}"),
        ("order", "{1, 2, 3, 4}"),
        ("grid", "{{1, 2, 3}, {4, 5, 6}}"),
        ("many", "{0 <repeats 39 times>, 1}"),
        ("half", "{?, 5, ?}"),
        ("text", '"a\\n\\"b\\""'),
        ("packed", '"\\357\\374\u00e4"'),
        ("inside", '"\\"b\\""'),
        ("unended", "{97 'a', 98 'b', 99 'c', 100 'd'}"),
        ("words", '{"one", null}'),
        ("op", "twice"),
        ("ops", "{twice, null}"),
        ("mid", "&order[3]"),
        ("any", "order"),
        ("twofold", "&p_order"),
        ("past", "ADDRESS (past the end of 'order')"),
        ("none", "null"),
        ("reg_p", "&half[1]"),
        ("&local", "&local"),
        ("heap->next", "&part"),
        ("State[17]", "48 in = 1.219 m"),
        ("State[STATE_SONAR_0 + 1]", "255 (no echo)"),
        ("State[17] + 0", "48"),
    ],
)
def test_values_as_text(evaluator: Evaluator, text: str, wanted: str) -> None:
    value = evaluator.evaluate(text).value
    address = f"{value.number:#x}" if isinstance(value.number, int) else ""
    assert value.text == wanted.replace("ADDRESS", address)


def test_pointers_describe_dead_objects(evaluator: Evaluator) -> None:
    shown = {
        name: evaluator.evaluate(name).value.text.partition(" ")[2]
        for name in ("heap", "freed", "wild", "stale", "&heap->at.y")
    }
    assert shown["heap"] == "(heap block of 36 bytes from test.c:27)"
    assert shown["&heap->at.y"] == "(4 bytes into heap block of 36 bytes from test.c:27)"
    assert shown["freed"] == "(freed heap block of 24 bytes from test.c:27)"
    assert shown["wild"] == "(no object)"
    assert shown["stale"] == "(ended 'gone')"


def parts(evaluator: Evaluator, text: str) -> dict[str, str]:
    return {name: each.text for name, each in evaluator.evaluate(text).value.children()}


def test_parts(evaluator: Evaluator) -> None:
    assert parts(evaluator, "part") == {
        "at": "{x = 1, y = 2}", "next": "&part", "mode": "TURN", "flags": "LEFT | UP",
        "word": "{number = 0.5, bits = 1056964608}", "on": "5", "off": "-3", "yes": "true",
        "name": '"ab"', "<struct <anonymous>>": "{inner = 9}",
    }  # fmt: skip
    assert parts(evaluator, "grid") == {"[0]": "{1, 2, 3}", "[1]": "{4, 5, 6}"}
    assert parts(evaluator, "mid") == {"*": "4"}
    assert parts(evaluator, "twofold") == {"*": "order"}
    for text in ("none", "freed", "wild", "past", "any", "op", "local"):
        assert parts(evaluator, text) == {}
    many = evaluator.evaluate("many").value
    assert many.child_count == 40
    assert [(name, each.text) for name, each in many.children(38, 5)] == [
        ("[38]", "0"), ("[39]", "1"),
    ]  # fmt: skip


def test_state_elements_have_names(evaluator: Evaluator) -> None:
    value = evaluator.evaluate("State").value
    assert [(name, each.text) for name, each in value.children(17, 2)] == [
        ("[17] STATE_SONAR_0", "48 in = 1.219 m"), ("[18] STATE_SONAR_1", "255 (no echo)"),
    ]  # fmt: skip
    part = evaluator.evaluate("State[18..19]").value
    assert [name for name, _ in part.children()] == ["[18] STATE_SONAR_1", "[19] STATE_SONAR_2"]


def test_numbers_of_values(evaluator: Evaluator) -> None:
    def number(text: str) -> float | None:
        return evaluator.evaluate(text).value.number

    assert [number(each) for each in ("d", "part.off", "part.mode", "none", "part")] == [
        0.1, -3, 5, 0, None,
    ]  # fmt: skip
    assert evaluator.evaluate("half[0]").value.text == "uninitialised"
    assert number("half[0]") is None


def test_full_values_are_written_at_length(evaluator: Evaluator) -> None:
    value = evaluator.evaluate("part").value
    assert value.text.endswith("...")
    assert value.full == (
        "{at = {x = 1, y = 2}, next = &part, mode = TURN, flags = LEFT | UP,"
        " word = {number = 0.5, bits = 1056964608}, on = 5, off = -3, yes = true,"
        ' name = "ab", {inner = 9}}'
    )


def test_an_unchecked_program_can_be_inspected(tmp_path: Path) -> None:
    evaluator = Stopping(tmp_path, SOURCE, checked=False).run().evaluator()
    assert evaluator.evaluate("part.at.y + local").value.text == "9"
    assert evaluator.evaluate("mid").value.text == "&order[3]"
    assert {each.name: each.value.text for each in evaluator.variables()}["local"] == "7"
    assert evaluator.evaluate("local = 8").changed
    assert evaluator.evaluate("local").value.text == "8"
