"""Where programs of robots that join stop."""

from __future__ import annotations

import pytest

from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from tests.debug.debuggers import advance, debugger_of

LOOP = """\
#include "Nclient.h"
int main(void)
{
    int i;
    connect_robot(1, MODEL_SCOUT, "", 38400);
    for (i = 0; i < 100; i++)
        get_rc();
    return 0;
}
"""


@pytest.fixture
def debugger() -> Debugger:
    return debugger_of(LOOP)


@pytest.mark.parametrize("place", ["7", "get_rc"])
def test_a_breakpoint_stops_a_robot_that_joins_later(debugger: Debugger, place: str) -> None:
    debugger.stop_points.add_breakpoint(place, condition="i == 30")
    debugger.goto_timestep(2)
    debugger.edit_world("join two like robot0 to 2 2")
    stops = [debugger.resume() for _ in range(2)]
    assert {stop.robot for stop in stops} == {0, 1}
    assert [stop.breakpoints for stop in stops] == [(1,), (1,)]
    debugger.goto_timestep(1)  # before it joined
    debugger.stop_points.set_condition(1, "i == 40")
    assert {debugger.resume().robot for _ in range(2)} == {0, 1}


def test_a_breakpoint_of_one_robot_stops_no_other(debugger: Debugger) -> None:
    debugger.stop_points.add_breakpoint("7", robot=0, condition="i == 30")
    debugger.goto_timestep(2)
    debugger.edit_world("join two like robot0 to 2 2")
    assert debugger.resume().robot == 0
    assert debugger.resume().reason == "end"


def test_conditions_of_requests_events_and_watchpoints_are_checked_when_given(
    debugger: Debugger,
) -> None:
    """They were refused only at the first hit, and stopped the run there."""
    points = debugger.stop_points
    for wrong in ("nothing > 3", "i ==", "i == 3)"):
        with pytest.raises(DebugError):
            points.add_breakpoint("get_rc", condition=wrong)
        with pytest.raises(DebugError):
            points.add_catchpoint("collision", condition=wrong)
        with pytest.raises(DebugError):
            points.add_watchpoint("State[0]", condition=wrong)
    assert not list(points.breakpoints)
    made = [
        points.add_breakpoint("get_rc", condition="i == 3"),
        points.add_catchpoint("collision", condition="State[0] > 1"),
        points.add_watchpoint("State[0]", condition="i == 3 || State[1]"),
    ]
    for each in made:
        with pytest.raises(DebugError):
            points.set_condition(each.number, "nothing")
        assert each.condition
    points.remove(made[2].number)
    assert debugger.resume().breakpoints == (made[0].number,)
    assert debugger.evaluate("i").text == "3"


def test_the_condition_of_a_local_watchpoint_belongs_to_its_function(debugger: Debugger) -> None:
    debugger.start()
    debugger.stop_points.add_watchpoint("i", condition="i == 5")
    with pytest.raises(DebugError):
        debugger.stop_points.add_watchpoint("i", condition="other == 5")
    assert debugger.resume().text == "i: 4 -> 5, written at a.c:6"


def test_advance_takes_no_number(debugger: Debugger) -> None:
    """The user's breakpoints had gaps in their numbers."""
    debugger.start()
    assert advance(debugger, "7").reason == "breakpoint"
    assert advance(debugger, "8").reason == "breakpoint"
    assert not list(debugger.stop_points.breakpoints)
    assert debugger.stop_points.add_breakpoint("7").number == 1
