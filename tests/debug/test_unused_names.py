"""What a program declares but does not use, or only in a block, has its meaning in the debugger.

And its functions can be called there, those that print, too.
"""

from __future__ import annotations

import pytest

from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.debug.timeline.change import Change
from tests.debug.debuggers import advance, debugger_of, line

SOURCE = """\
#include <stdio.h>
static double unused_gain = 2.5;
static const char *names[2] = { "left", "right" };
int table[3] = { 1, 2, 3 };
static int helper(int n)
{
    int twice = 2 * n;
    return twice + table[1];
}
static int report(int n)
{
    printf("n is %d\\n", n);
    return n + 1;
}
enum { OUTER = 1 };
int main(void)
{
    int n = OUTER;
    report(n);
    {
        enum { NEAR = 40, FAR, OUTER = 7 };
        typedef struct pair { int a, b; } pair;
        pair p = { NEAR, FAR };
        n += p.a + OUTER;
    }
    {
        int OUTER = 99;
        n += OUTER;
    }
    return n;
}
"""


@pytest.fixture
def printed() -> list[bytes]:
    """Receives what the program prints."""
    return []


@pytest.fixture
def debugger(printed: list[bytes]) -> Debugger:
    """Stands before `report` is called."""
    made = debugger_of(SOURCE, output=lambda robot, stream, content: printed.append(content))
    made.stop_points.add_breakpoint("19")
    made.resume()
    return made


def text(debugger: Debugger, expression: str) -> str:
    """Return the value of an expression."""
    return debugger.evaluate(expression).text


def test_unused_globals_and_functions_have_values(debugger: Debugger) -> None:
    assert text(debugger, "unused_gain * 2") == "5.0"
    assert '"right"' in text(debugger, "names[1]")
    assert text(debugger, "helper(3)") == "8"  # 2 * 3 + table[1], which is unused but by helper
    assert text(debugger, "*&table[2]") == "3"
    assert text(debugger, "&table[2]") == "&table[2]"
    assert text(debugger, "table[1..2]") == "{2, 3}"
    assert [each.name for each in debugger.view.globals_()] == ["names", "table", "unused_gain"]
    assert not debugger.run.history.changes


def test_unused_globals_can_be_changed_and_follow_the_run(debugger: Debugger) -> None:
    before = debugger.position
    debugger.evaluate("unused_gain = 3")
    debugger.evaluate("table[1] = 20")
    debugger.next()
    debugger.evaluate("unused_gain += 1")
    after = debugger.position
    assert (text(debugger, "unused_gain"), text(debugger, "helper(3)")) == ("4.0", "26")
    assert not debugger.view.holds("(unused_gain = 9) == 0", 0)  # a condition changes nothing
    assert text(debugger, "unused_gain") == "4.0"
    debugger.goto(before)
    assert text(debugger, "unused_gain") == "3.0"
    debugger.goto(after)
    assert text(debugger, "unused_gain") == "4.0"
    assert [Change.of(each.as_data()) for each in debugger.run.history.changes] == list(
        debugger.run.history.changes
    )
    debugger.revert(1)
    assert (text(debugger, "unused_gain"), text(debugger, "table[1]")) == ("3.0", "2")


def test_unused_globals_can_be_watched(debugger: Debugger) -> None:
    for location in (False, True):
        debugger.stop_points.add_watchpoint("table[1]", location=location)
    with pytest.raises(DebugError, match="constant"):
        debugger.stop_points.add_watchpoint("1 + 1")
    debugger.evaluate("unused_gain = 3")
    assert debugger.resume().reason == "end"


def test_functions_that_are_only_called_have_addresses_for_expressions(debugger: Debugger) -> None:
    assert text(debugger, "report") == "report"
    assert text(debugger, "(&helper)(3)") == "8"
    debugger.next()
    with pytest.raises(DebugError, match="cannot be assigned"):
        debugger.evaluate("*(int (**)(int)) &n = report")


def test_breakpoints_can_be_set_in_functions_that_are_never_called(debugger: Debugger) -> None:
    for place in ("helper", "7"):
        made = debugger.stop_points.add_breakpoint(place)
        assert made.location is not None
        assert made.location.location is not None
        assert (made.location.location.line, made.location.note) == (7, "'helper' is never called")
    assert debugger.resume().reason == "end"


def test_enumerators_and_types_of_blocks_are_known_there_and_nowhere_else(
    debugger: Debugger,
) -> None:
    assert (text(debugger, "OUTER"), text(debugger, "(int) OUTER")) == ("OUTER", "1")
    with pytest.raises(DebugError, match="NEAR"):
        debugger.evaluate("NEAR")
    advance(debugger, "23")
    assert text(debugger, "FAR + OUTER") == "48"
    assert text(debugger, "sizeof(pair) + sizeof(struct pair)") == "16"
    advance(debugger, "28")
    assert (line(debugger), text(debugger, "OUTER")) == (28, "99")


def test_convenience_functions_need_no_header_and_no_function_of_the_program(
    debugger: Debugger,
) -> None:
    assert text(debugger, '$_streq(names[0], "left") + $_strlen(names[1])') == "6"
    assert text(debugger, '$_memeq("abc", "abd", 2) && !$_memeq("abc", "abd", 3)') == "1"


def test_a_function_that_prints_can_be_called(debugger: Debugger, printed: list[bytes]) -> None:
    before = debugger.position
    assert text(debugger, "report(41)") == "42"
    assert printed == [b"n is 41\n"]
    debugger.next()
    assert debugger.run.console.text() == b"n is 41\nn is 1\n"
    debugger.goto(before)
    assert debugger.run.console.text() == b"n is 41\n"
    (change,) = debugger.run.history.changes
    assert Change.of(change.as_data()) == change
    assert not debugger.view.holds("report(1) == 0", 0)  # a condition prints nothing
    assert printed == [b"n is 41\n", b"n is 1\n"]
    debugger.revert(0)
    assert debugger.run.console.text() == b""
