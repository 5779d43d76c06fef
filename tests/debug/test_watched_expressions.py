"""Watched expressions are evaluated anew: what they name may change, as it does in gdb."""

from __future__ import annotations

import pytest

from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from tests.debug.debuggers import debugger_of
from tests.debug.test_watchpoints import go, texts

LIST = """\
#include <stdlib.h>
struct node { int v; struct node *next; };
struct node *cur, *head;
int tab[4], a, b, i;
struct { unsigned low : 3, high : 5; } bits;
static int sum(int n)
{
    int s;
    s = n;
    if (n > 0)
        s += sum(n - 1);
    return s;
}
int main(void)
{
    int k, local;
    for (i = 0; i < 4; i++) {
        cur = malloc(sizeof *cur);
        cur->v = 10 * i;
        cur->next = head;
        head = cur;
    }
    for (i = 3; i > 0; i--)
        tab[i] = i + 4;
    for (cur = head; cur; cur = cur->next)
        a += cur->v;
    b = a;
    a = 1;
    bits.high = 3;
    bits.low = 2;
    local = sum(2);
    for (k = 0; k < 3; k++)
        b += tab[k];
    return local;
}
"""
WATCHED = {
    "cur->v": ("25", 4),
    "tab[i]": ("24", 6),
    "a + b": ("25", 7),
    "head->next->v": ("17", 3),
    "tab[1] > 2 ? a : b": ("17", 4),
    "bits.low * 10": ("17", 1),
    "tab": ("17", 3),
}
"""Expressions, where they are set, and how often they change from there on, as gdb 13 counts."""


def debugger_at_line(place: str) -> Debugger:
    debugger = debugger_of(LIST)
    go(debugger, place)
    return debugger


@pytest.mark.parametrize("expression", WATCHED)
def test_both_directions_stop_wherever_the_value_changes(expression: str) -> None:
    place, count = WATCHED[expression]
    debugger = debugger_at_line(place)
    debugger.stop_points.add_watchpoint(expression)
    forward = texts(debugger)
    assert len(forward) == count, forward
    back = texts(debugger, backward=True)
    assert back[:count] == forward[::-1]
    assert texts(debugger) == back[::-1]


def test_a_watched_member_follows_the_pointer() -> None:
    """It was watched in the first object for ever."""
    debugger = debugger_at_line("25")
    debugger.stop_points.add_watchpoint("cur->v")
    assert texts(debugger) == [
        "cur->v: 30 -> 20, changed at a.c:25",
        "cur->v: 20 -> 10, changed at a.c:25",
        "cur->v: 10 -> 0, changed at a.c:25",
        "cur->v: 0 -> unreadable, changed at a.c:25",
    ]


def test_a_location_is_watched_for_ever() -> None:
    debugger = debugger_at_line("25")
    point = debugger.stop_points.add_watchpoint("cur->v", location=True)
    assert point.watch
    assert point.watch.is_location
    assert texts(debugger) == []


def test_an_element_is_written_wherever_the_index_is_by_then() -> None:
    debugger = debugger_at_line("24")
    debugger.stop_points.add_watchpoint("tab[i]", "write")
    assert texts(debugger) == [f"tab[i]: 0 -> {value}, written at a.c:24" for value in (7, 6, 5)]


def test_a_local_expression_lasts_as_long_as_its_function() -> None:
    debugger = debugger_at_line("9")
    point = debugger.stop_points.add_watchpoint("s * 2 + n")
    assert point.watch
    assert point.watch.note == "lasts until 'sum' returns"
    forward = texts(debugger)
    assert forward == [
        "s * 2 + n: uninitialised -> 6, changed at a.c:9",
        "s * 2 + n: 6 -> 8, changed at a.c:11",
        "s * 2 + n went out of scope: 'sum' has returned at a.c:12",
    ]
    assert texts(debugger, backward=True)[:3] == forward[::-1]
    assert texts(debugger) == forward


def test_a_read_in_the_last_statement_of_a_function_is_reported() -> None:
    """It was reported only as the end of the function."""
    debugger = debugger_at_line("9")
    debugger.stop_points.add_watchpoint("s", "read")
    forward = texts(debugger)
    assert (
        forward
        == [
            "s = 2, read at a.c:11",
            "s = 3, read at a.c:12; s went out of scope: 'sum' has returned at a.c:12",
        ]
        or forward
    )


def test_variables_of_two_calls() -> None:
    debugger = debugger_at_line("9")
    debugger.stop_points.add_watchpoint("main::local + s")
    assert "went out of scope: 'sum'" in texts(debugger)[-1]
    debugger = debugger_at_line("9")
    debugger.view.select_frame(1)
    debugger.stop_points.add_watchpoint("sum::s")
    assert "went out of scope: 'sum'" in texts(debugger)[-1]
    with pytest.raises(DebugError):
        debugger.stop_points.add_watchpoint("sum::s")


@pytest.mark.parametrize("text", ["a + 1.5", "1e3", "-1"])
def test_a_value_that_is_no_address_has_no_writes(text: str) -> None:
    debugger = debugger_of(LIST)
    debugger.start()
    with pytest.raises(DebugError, match="not an object in memory"):
        debugger.stop_points.add_watchpoint(text, "write", location=True)


NAMED_ALIKE = """\
struct node { int v; } pool[3];
static void put(int at, int v)
{
    pool[at].v = v;
}
int main(void)
{
    put(1, 7);
    put(1, 8);
    return 0;
}
"""


def test_the_name_of_a_member_is_no_variable() -> None:
    debugger = debugger_of(NAMED_ALIKE)
    debugger.stop_points.add_breakpoint("4")
    debugger.resume()
    debugger.stop_points.remove(1)
    debugger.stop_points.add_watchpoint("pool[1].v")
    assert texts(debugger) == [
        "pool[1].v: 0 -> 7, written at a.c:4",
        "pool[1].v: 7 -> 8, written at a.c:4",
    ]
