"""Courses of events beside each other, each with its own past and output."""

from __future__ import annotations

import re

import pytest

from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from tests.debug.debuggers import debugger_of

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
def counting() -> Debugger:
    debugger = debugger_of(COUNT)
    debugger.start()
    debugger.stop_points.add_breakpoint("6")
    debugger.resume()
    debugger.resume()
    return debugger


def text(debugger: Debugger) -> bytes:
    return debugger.run.console.text()


def test_a_change_replaces_the_future_and_keeps_the_past(counting: Debugger) -> None:
    counting.stop_points.add_breakpoint("7")
    here = counting.position
    counting.evaluate("i = 4")
    counting.stop_points.enable(1, on=False)
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


def test_a_branch_does_not_affect_the_other(counting: Debugger) -> None:
    counting.stop_points.add_breakpoint("7")
    counting.branch("short")
    counting.evaluate("i = 4")
    counting.stop_points.enable(1, on=False)
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


def test_checkpoints_are_valid_until_an_earlier_change(counting: Debugger) -> None:
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


DRIVE = """\
#include "Nclient.h"
int speed = 50;
int main(void)
{
    int i;
    connect_robot(1, MODEL_SCOUT, "", 38400);
    for (i = 0; i < 100; i++)
        scout_vm(speed, 0);
    return 0;
}
"""


def test_branches_are_compared_at_the_same_timestep() -> None:
    debugger = debugger_of(DRIVE)
    debugger.stop_points.add_breakpoint("8")
    debugger.resume()
    debugger.stop_points.enable(1, on=False)
    debugger.branch("fast")
    assert debugger.compare("main") == []
    debugger.evaluate("speed = 100")
    debugger.goto_time(1.0)
    here = debugger.position
    found = {each.name: (each.here, each.there) for each in debugger.compare("main")}
    assert found["speed"] == ("100", "50")
    poses = [tuple(map(float, re.findall(r"-?[\d.]+", text))) for text in found["pose"]]
    assert [pose[1:] for pose in poses] == [(0.0, 0.0)] * 2
    assert 0.0 < poses[1][0] < poses[0][0]
    assert [text.split(",")[0] for text in found["command left"]] == ["0.254 m/s", "0.127 m/s"]
    assert debugger.position == here
    assert debugger.branches.current.name == "fast"
    with pytest.raises(DebugError):
        debugger.compare("slow")
    assert debugger.position == here


def east_m(debugger: Debugger) -> float:
    return float(debugger.session.environment.state.x_m[0])


def test_an_edit_of_the_world_is_part_of_the_run() -> None:
    debugger = debugger_of(DRIVE)
    debugger.goto_time(1.0)
    assert "robot0 is now at 1.000, 2.000 m" in debugger.edit_world("move robot0 to 1 2")
    debugger.tick(5)
    x_m = east_m(debugger)
    assert 1.0 < x_m < 2.0
    debugger.goto_time(0.75)
    assert 0.0 < east_m(debugger) < 0.5
    debugger.goto_time(1.25)
    assert east_m(debugger) == x_m
    with pytest.raises(DebugError):
        debugger.edit_world("move robot9 to 1 2")


def test_going_back_to_the_statement_of_a_change(counting: Debugger) -> None:
    counting.next()
    changed = counting.evaluate("i = 1") and counting.position
    counting.resume()
    here = counting.position
    for back in (counting.step, counting.next):
        back(backward=True)
        assert counting.position == changed
        counting.goto(here)
    counting.goto_statement(changed.statements + 1)
    assert counting.position == changed


def test_compare_keeps_the_selection() -> None:
    debugger = debugger_of(DRIVE, world="pair.xml")
    debugger.stop_points.add_breakpoint("8", robot=1)
    stop = debugger.resume()
    debugger.branch("other")
    debugger.compare("main")
    assert (debugger.view.robot, debugger.stop) == (1, stop)
