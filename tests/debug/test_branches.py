"""Courses of events beside each other, each with its own past and output."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from tests.debug.debuggee import debugger_of

COUNT = """\
#include <stdio.h>
int main(void)
{
    int i;
    for (i = 0; i < 5; i++)
        printf("%d\\n", i);
    return 0;
}
"""


@pytest.fixture
def counting(tmp_path: Path) -> Debugger:
    debugger = debugger_of(COUNT, folder=tmp_path)
    debugger.start()
    debugger.add_breakpoint("6")
    debugger.resume()
    debugger.resume()
    return debugger


def text(debugger: Debugger) -> bytes:
    return debugger.run.console.text()


def test_a_change_makes_another_future_and_the_past_stays(counting: Debugger) -> None:
    counting.add_breakpoint("7")
    here = counting.position
    counting.evaluate("i = 4")
    counting.enable(1, on=False)
    counting.resume()
    assert text(counting) == b"0\n4\n"
    counting.goto_statement(1)
    assert text(counting) == b""
    counting.resume()  # through the change again
    assert text(counting) == b"0\n4\n"
    counting.goto(here)
    counting.step(backward=True)
    counting.resume()
    assert text(counting) == b"0\n4\n"


def test_a_branch_leaves_the_other_as_it_was(counting: Debugger) -> None:
    counting.add_breakpoint("7")
    counting.branch("short")
    counting.evaluate("i = 4")
    counting.enable(1, on=False)
    counting.resume()
    assert text(counting) == b"0\n4\n"
    counting.switch("main")
    assert text(counting) == b"0\n"
    counting.resume()
    assert text(counting) == b"0\n1\n2\n3\n4\n"
    counting.switch("short")
    assert text(counting) == b"0\n4\n"
    for name in ("main", "", "short"):
        with pytest.raises(DebugError):
            counting.branch(name)
    with pytest.raises(DebugError):
        counting.switch("long")


def test_checkpoints_are_gone_back_to_unless_a_change_has_undone_them(counting: Debugger) -> None:
    first = counting.checkpoint("first")
    counting.resume()
    second = counting.checkpoint()
    assert (first.number, second.number) == (1, 2)
    counting.restart(1)
    assert counting.position == first.position
    counting.restart(2)
    assert text(counting) == b"0\n1\n"
    counting.restart(1)
    counting.evaluate("i = 4")
    with pytest.raises(DebugError):
        counting.restart(2)
