"""To look for something in the past, only the programs run again in which it may be."""

from __future__ import annotations

import pytest

from crs_cc.debug.breakpoints import Breakpoints
from crs_cc.debug.engine import Debugger
from crs_cc.debug.timeline.passed_sites import PassedSites
from crs_cc.debug.timeline.position import Position
from tests.debug.debuggers import ROOT, debugger_at, debugger_of

PLATOON = ROOT / "samples" / "scout_c" / "platoon.c"
DRIVE = """\
#include "Nclient.h"
static int turns;
int main(void)
{
    connect_robot(1, MODEL_SCOUT, "", 38400);
    for (;;) {
        scout_vm(150, 0);
        turns++;
    }
}
"""
FAIL = """\
#include "Nclient.h"
int main(void)
{
    int i, zero = 0;
    connect_robot(1, MODEL_SCOUT, "", 38400);
    for (i = 0; i < 4; i++)
        scout_vm(150, 0);
    return 1 / zero;
}
"""


def stops_back(debugger: Debugger) -> list[tuple[Position, int, tuple[int, ...]]]:
    """Go back to the start; return where it stopped."""
    found = []
    while (stop := debugger.resume(backward=True)).reason != "beginning":
        found.append((stop.position, stop.robot, stop.breakpoints))
    return found


@pytest.mark.parametrize("robots", [[0], [2], [0, 1]])
def test_stops_are_those_of_a_replay_of_all(
    robots: list[int], monkeypatch: pytest.MonkeyPatch
) -> None:
    debugger = debugger_at([PLATOON], "platoon.xml")
    for robot in robots:
        debugger.stop_points.add_breakpoint("follow" if robot else "lead", robot=robot)
        debugger.stop_points.add_breakpoint("crs_receive" if robot else "crs_send", robot=robot)
        debugger.stop_points.add_watchpoint("State[0]", robot=robot)
    debugger.goto_timestep(12)
    end = debugger.position
    some = stops_back(debugger)
    debugger.goto(end)
    monkeypatch.setattr(Breakpoints, "may_stop", lambda *_: True)
    monkeypatch.setattr(PassedSites, "passed", lambda *_: None)
    assert stops_back(debugger) == some
    assert len(some) > 1


def test_a_program_that_is_not_concerned_stays_where_it_is() -> None:
    debugger = debugger_of(DRIVE, world="pair.xml")
    debugger.goto_timestep(30)
    run, begin = debugger.run, debugger.run.history.snapshots_before(debugger.position)[0]
    before = run.sites_passed(1)
    for _ in run.replay(begin, Position(25, 0), robots=[0]):
        assert run.sites_passed(1) == before
    assert 0 < run.sites_passed(0) < before
    run.seek(Position(25, 0))
    assert 0 < run.sites_passed(1) < before


def test_an_error_of_another_robot_stops_reverse_execution() -> None:
    debugger = debugger_of(DRIVE, FAIL, world="pair.xml")
    stop = debugger.resume()
    assert (stop.reason, stop.robot) == ("error", 1)
    debugger.tick(20)
    debugger.stop_points.add_breakpoint("main", robot=0)
    back = debugger.resume(backward=True)
    assert (back.reason, back.robot, back.position) == ("error", 1, stop.position)
