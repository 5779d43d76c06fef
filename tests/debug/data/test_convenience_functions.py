"""Convenience functions return what gdb's do."""

from __future__ import annotations

import pytest

from crs_cc.debug.commands.shell import Shell
from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from tests.debug.debuggers import debugger_of

SOURCE = """\
enum mode { IDLE, DRIVE = 4 } mode = DRIVE;
char name[8] = "robot7";
static int inner(int n)
{
    return n + mode + name[0];
}
static int outer(int n)
{
    return inner(n) + 1;
}
int main(void)
{
    return outer(1) + inner(2) > 0;
}
"""


@pytest.fixture
def debugger() -> Debugger:
    """Stands in `inner`, called by `outer`."""
    made = debugger_of(SOURCE)
    made.stop_points.add_breakpoint("inner")
    made.resume()
    return made


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        ('$_regex(name, "t[0-9]$")', "1"),
        ('$_regex(name, "^7")', "0"),
        ('$_regex(&name[5], "^7")', "1"),
        ("$_as_string(mode)", '"DRIVE"'),
        ('$_streq($_as_string(mode), "DRIVE")', "1"),
        ("$_isvoid($nothing)", "1"),
        ("$_isvoid(mode + 1)", "0"),
        ('$_caller_is("outer")', "1"),
        ('$_caller_is("main", 2) + $_caller_is("inner", 0)', "2"),
        ('$_caller_is("main", 7)', "0"),
        ('$_caller_matches("ou") && !$_caller_matches("ter")', "1"),
        ('$_any_caller_is("main")', "0"),
        ('$_any_caller_is("main", 2)', "1"),
        ('$_any_caller_matches("^m", 5)', "1"),
        ("$_thread", "0"),
        ("$_inferior + $_thread", "1"),
        ('"$_thread"', '"$_thread"'),
        ("$nothing", "void"),
    ],
)
def test_values(debugger: Debugger, expression: str, expected: str) -> None:
    assert debugger.evaluate(expression).text == expected


def test_settings_are_known(debugger: Debugger) -> None:
    shell = Shell(debugger)
    list(shell.execute("set listsize 7"))
    assert debugger.evaluate('$_gdb_setting("listsize")').text == "7"


def test_conditions_use_them(debugger: Debugger) -> None:
    debugger.stop_points.remove(1)
    debugger.stop_points.add_breakpoint("inner", condition='$_caller_is("main")')
    debugger.resume()
    assert debugger.evaluate("n").text == "2"


@pytest.mark.parametrize(
    ("expression", "message"),
    [
        ("$_regex(name)", "2 arguments, not 1"),
        ('$_regex(name, "(")', "invalid regular expression"),
        ("$_regex(name", "missing"),
        ('$_regex(1, "x")', "not a string"),
        ("$_as_string(1)", "enumeration"),
        ('$_caller_is("main", -1)', "number of frames"),
        ('$_gdb_setting("nothing")', "unknown setting"),
    ],
)
def test_errors(debugger: Debugger, expression: str, message: str) -> None:
    with pytest.raises(DebugError, match=message):
        debugger.evaluate(expression)
