"""Expressions use the world and the programs of other robots."""

from __future__ import annotations

import math

import pytest

from crs_cc.debug.commands.shell import Shell
from crs_cc.debug.engine import Debugger
from crs_cc.debug.errors import DebugError
from crs_cc.debug.world.world_values import OBJECT_VALUES, ROBOT_VALUES, WORLD_VALUES
from tests.debug.debuggers import debugger_of
from tests.debug.test_watchpoints import go

DRIVES = """\
#include "Nclient.h"
struct node { int v; struct node *next; } first = { 3 }, *list = &first;
double x = 1.5;
int main(void)
{
    int i;
    connect_robot(1, MODEL_SCOUT, "/dev/ttyS0", 38400);
    for (i = 0; i < 8; i++) {
        scout_vm(100, 0);
        ws(1, 1, 0, 1);
    }
    return x > 2 || !list;
}
"""


@pytest.fixture
def debugger() -> Debugger:
    """Return a debugger of two robots that run one program, in its loop."""
    debugger = debugger_of(DRIVES, world="pair.xml")
    go(debugger, "10")
    return debugger


def number(debugger: Debugger, text: str) -> float:
    found = debugger.view.evaluate_pure(text).number
    assert found is not None
    return found


def test_values_of_the_world_are_those_of_the_environment(debugger: Debugger) -> None:
    debugger.goto_time(2.0)
    state, (one, other) = debugger.session.environment.state, debugger.names
    assert number(debugger, f"{one}.x") == state.x_m[0]
    assert number(debugger, f"$world.{other}.y * 2") == 2 * state.y_m[1]
    away_m = math.dist(*state.bodies.position_m[:2].tolist())
    assert number(debugger, f"distance({one}, '{other}')") == pytest.approx(away_m)
    assert number(debugger, "$world.time") == 2.0
    assert 0 < number(debugger, f"{one}.speed") < 1
    assert number(debugger, f"{one}.odometry_x") == state.odometry.x_m[0]


def test_every_row_can_be_read(debugger: Debugger) -> None:
    robot, obj = debugger.names[0], debugger.session.environment.names[-1]
    for path, rows in ("$world", WORLD_VALUES), (robot, ROBOT_VALUES), (obj, OBJECT_VALUES):
        for row in rows:
            name = path if path.startswith("$") else f"$world.'{path}'"
            assert not math.isnan(number(debugger, f"{name}.{row.name}")), row.name


def test_operands_of_another_program_are_evaluated_there(debugger: Debugger) -> None:
    other = debugger.names[1]
    assert number(debugger, f"{other}::list->v") == 3
    assert number(debugger, f"{other}::(i + list->v) - {other}::i + 1") == 4
    assert debugger.view.evaluate_pure(f"{other}::first").text.startswith("{v = 3")


def test_ambiguous_names_are_rejected(debugger: Debugger) -> None:
    other = debugger.names[1]
    assert debugger.evaluate(f"*{other}::list").text == "void"
    for text in (f"({other}::first).next->v", f"{other}::x = 2"):
        with pytest.raises(DebugError):
            debugger.evaluate(text)
    assert number(debugger, f"{other}::x") == 1.5


def test_the_address_of_a_value_from_outside_is_refused(debugger: Debugger) -> None:
    one, other = debugger.names[:2]
    for text in (f"&{other}::i", f"&{other}::(i + 1)", f"&$world.{one}.x", f"{other}::i, &{one}.x"):
        with pytest.raises(DebugError, match="not in the program's memory"):
            debugger.evaluate(text)
    assert debugger.evaluate(f"*&{other}::i").text == debugger.evaluate(f"{other}::i").text
    assert debugger.evaluate("(int *)-1").text.startswith("0xffffffff")
    with pytest.raises(DebugError, match="no object at 0xffffffff"):
        debugger.evaluate("*(int *)-1")


def test_a_value_of_the_selected_robot_is_found_at_another_depth() -> None:
    deep = "int down(int n)\n{\n    if (n == 0)\n        return 0;\n    return down(n - 1);\n}\n"
    source = "int x = 4;\n" + deep + "int main(void)\n{\n    return down(5);\n}\n"
    debugger = debugger_of(source, world="pair.xml")
    said: list[str] = []
    debugger.stop_points.print_log = said.append
    debugger.stop_points.add_breakpoint("4", robot=0, log="{robot0::x}")
    debugger.start()
    debugger.view.frame = 3
    debugger.resume()
    assert said == ["4"] * 6


def test_names_of_the_program_come_first() -> None:
    source = "struct { int x; } robot0 = { 7 };\nint main(void) { return robot0.x; }\n"
    debugger = debugger_of(source)
    debugger.start()
    assert number(debugger, "robot0.x") == 7
    assert number(debugger, "$world.robot0.x") == 0.0


def test_a_change_of_the_world_stops_at_the_same_timesteps_in_both_directions(
    debugger: Debugger,
) -> None:
    name = debugger.names[0]
    start = number(debugger, f"{name}.x")
    debugger.stop_points.add_watchpoint(f"(int)(({name}.x - {start}) * 20)")
    forward = []
    while (stop := debugger.resume()).breakpoints:
        forward.append(stop.position)
    assert len(forward) > 3
    assert all(each.round == 0 and each.robot < 0 for each in forward)
    back = []
    while (stop := debugger.resume(backward=True)).breakpoints:
        back.append(stop.position)
    assert back == forward[::-1]


def test_a_condition_on_the_world_holds_backward_as_forward(debugger: Debugger) -> None:
    name = debugger.names[0]
    x_m = number(debugger, f"{name}.x")
    debugger.stop_points.add_breakpoint("10", robot=0, condition=f"{name}.x > {x_m} + 0.3")
    forward = []
    while (stop := debugger.resume()).breakpoints:
        forward.append(stop.position)
    assert 1 < len(forward) < 7
    back = []
    while (stop := debugger.resume(backward=True)).breakpoints:
        back.append(stop.position)
    assert back == forward[::-1]


def test_of_two_objects_the_unknown_one_is_named(debugger: Debugger) -> None:
    """The known one was said to be undeclared."""
    with pytest.raises(DebugError, match="unknown robot or object 'nowhere'"):
        number(debugger, f"distance({debugger.names[0]}, nowhere)")


def test_a_stop_after_the_end_of_the_selected_program_shows_the_time() -> None:
    """It said only that the condition is true, and that it is for the ended program only."""
    ends = '#include "Nclient.h"\nint main(void) { return 0; }\n'
    debugger = debugger_of(ends, DRIVES, world="pair.xml")
    shell = Shell(debugger)
    commands = "break if $world.timestep == 8", "info breakpoints", "continue"
    _, listed, stopped = ("\n".join(each.text for each in shell.execute(one)) for one in commands)
    assert f"evaluated in {debugger.names[0]}'s program" in listed
    assert "only" not in listed
    assert "$world.timestep == 8 is true\nt = " in stopped
