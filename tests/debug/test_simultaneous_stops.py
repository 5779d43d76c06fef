"""What happens to several robots at the same time is told of all of them."""

from __future__ import annotations

from crs_cc.debug.timeline.history import History
from tests.debug.debuggers import debugger_of

NULL = """\
int main(void)
{
    int *nothing = 0;
    return *nothing;
}
"""

DRIVE = """\
#include "Nclient.h"
int main(void)
{
    int i;
    connect_robot(1, MODEL_SCOUT, "", 38400);
    for (i = 0; i < 400; i++)
        scout_vm(150, 0);
    return 0;
}
"""


def test_all_failures_of_a_round_are_reported() -> None:
    debugger = debugger_of(NULL, world="pair.xml")
    stop = debugger.resume()
    assert stop.reason == "error"
    for name in debugger.names:
        assert f"{name}: null pointer" in stop.text
    assert debugger.resume().reason == "end"


def test_leaving_triggers_the_exit_catchpoint() -> None:
    debugger = debugger_of(DRIVE, world="pair.xml")
    second = debugger.names[1]
    debugger.goto_time(0.5)
    debugger.edit_world(f"remove {second}")
    point = debugger.stop_points.add_catchpoint("exit")
    stop = debugger.resume()
    assert (stop.breakpoints, stop.robot) == ((point.number,), 1)
    assert stop.text == f"the program of {second} ended"
    debugger.stop_points.remove(point.number)
    debugger.tick(3)
    debugger.stop_points.add_breakpoint("vm", robot=0)
    debugger.stop_points.add_catchpoint("exit")
    while (back := debugger.resume(backward=True)).robot == 0:
        pass
    assert back.text == stop.text
    assert back.position == stop.position


def test_reverse_continue_to_a_catchpoint_with_little_memory() -> None:
    debugger = debugger_of(DRIVE)
    run = debugger.run
    run.history, first = History(most_bytes=300_000), run.history.at(run.position)
    run.history.keep(run.position, first)
    debugger.stop_points.add_catchpoint("tick", ignore=300)
    debugger.resume()
    for point in list(debugger.stop_points.breakpoints):
        debugger.stop_points.remove(point.number)
    debugger.stop_points.add_catchpoint("collision")
    assert debugger.resume(backward=True).reason == "beginning"
