"""Where values of the world came from: commands, contacts, changes by hand, degradations."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.core.source import Diagnostics
from crs_cc.debug.engine import Debugger
from crs_cc.debug.program import DebugProgram
from crs_cc.session.build import build_executable
from crs_cc.session.library import library_options
from crs_cc.sim.files.world_xml import load_world
from tests.debug.test_why import explained, nodes

DRIVE = """\
#include "Nclient.h"
static int speed = 100;
static int doubled(int value) { return 2 * value; }
int main(void)
{
    int fast;
    connect_robot(1);
    conf_tm(0);
    fast = doubled(speed);
    vm(fast, fast, 0);
    for (;;)
        gs();
}
"""
STAND = """\
#include "Nclient.h"
int main(void)
{
    connect_robot(1);
    for (;;)
        gs();
}
"""
WORLD = """\
<world version="1">
  <area length="8m" width="4m"/>
  <robot id="near" x="1m" y="2m" heading="0deg"/>
  <robot id="other" x="1m" y="0.7m" heading="90deg"/>
  <box id="crate" x="2m" y="2m" length="40cm" width="40cm" mass="2kg"/>
  <box id="post" x="5m" y="2m" length="40cm" width="40cm"/>
</world>
"""


@pytest.fixture
def debugger(tmp_path: Path) -> Debugger:
    (tmp_path / "world.xml").write_text(WORLD)
    programs = []
    for name, text in (("drive.c", DRIVE), ("stand.c", STAND)):
        path = tmp_path / name
        path.write_text(text)
        built = build_executable([path], Diagnostics(), debug=True)
        programs.append(DebugProgram(built, [path], library_options()))
    return Debugger(load_world(tmp_path / "world.xml"), programs)


def texts(debugger: Debugger, expression: str) -> list[str]:
    return [f"{each.text} {each.how}" for each in nodes(explained(debugger, expression))]


@pytest.mark.parametrize("expression", ["near.x", "$world.near.heading", "2 * near.speed + 1"])
def test_a_robot_is_where_its_command_and_what_that_was_computed_from_brought_it(
    expression: str, debugger: Debugger
) -> None:
    debugger.goto_time(2.0)
    found = [each for each in nodes(explained(debugger, expression)) if "driven" in each.text]
    (command,) = found
    assert command.how == "vm(fast, fast, 0)"
    assert command.location is not None
    assert command.location.line == 10
    assert command.position is not None
    below = {each.text: each.how for each in nodes(command)}
    assert below["fast = 200"] == "fast = doubled(speed)"
    assert below["doubled returned"] == "return 2 * value"
    assert below["speed = 100"] == "its initial value"
    debugger.goto(command.position)
    debugger.view.select_robot("near")
    assert debugger.view.location() == command.location


def test_what_a_robot_touches_is_a_cause(debugger: Debugger) -> None:
    debugger.goto_time(15.0)  # it has stood at the crate, which a post stops, for some seconds
    found = texts(debugger, "near.x")
    assert any(each.startswith("it touches crate") for each in found), found
    assert any(each.startswith("near touched crate at") for each in found), found
    collisions = texts(debugger, "near.collisions")
    assert any(each.startswith("near touched crate at") for each in collisions), collisions
    assert not any("driven" in each for each in collisions)


def test_an_object_is_where_a_robot_pushed_it(debugger: Debugger) -> None:
    debugger.goto_time(4.0)
    found = texts(debugger, "crate.x")
    assert found[1].startswith("near touched crate at"), found
    assert found[2:4] == ["near touched it ", "near was driven vm(fast, fast, 0)"], found


def test_a_change_by_hand_and_a_degradation_are_causes(debugger: Debugger) -> None:
    debugger.goto_time(1.0)
    assert texts(debugger, "other.x") == ["other.x = 1.0 a value of the world"]
    debugger.edit_world("move other to 6 3 90")
    debugger.edit_world("degrade near drive gain 0.5")
    debugger.goto_time(2.0)
    assert "you changed it: move other to 6 3 90 " in texts(debugger, "other.x")
    assert any("bent by the degradation" in each for each in texts(debugger, "near.x"))
    debugger.goto_time(0.5)
    assert len(texts(debugger, "other.x")) == 1


def test_a_position_in_the_state_vector_leads_to_the_command(debugger: Debugger) -> None:
    debugger.goto_time(2.0)
    assert "near was driven vm(fast, fast, 0)" in texts(debugger, "State[34]")


@pytest.mark.parametrize(
    ("expression", "cause"),
    [
        ("near.nearest", "sonar 0 fired"),
        ("near.odometry_x", "near was driven"),
        ("distance(near, post)", "near was driven"),
        ("$world.near", "near was driven"),
    ],
)
def test_each_value_has_causes_of_its_kind(expression: str, cause: str, debugger: Debugger) -> None:
    debugger.goto_time(2.0)
    assert any(each.startswith(cause) for each in texts(debugger, expression))


@pytest.mark.parametrize(
    ("expression", "cause"),
    [
        ("$world.time", "40 timesteps of 0.05 s have been simulated"),
        ("$world.timestep", "40 timesteps of 0.05 s have been simulated"),
        ("near.motor_battery", "it had 100% of 1.4688e+06 J at first"),
        ("near.motor_battery", "5 W for 2.000 s have taken 10 J"),
        ("near.motor_battery", "moving has taken"),
        ("near.computer_battery", "20 W for 2.000 s have taken 40 J"),
    ],
)
def test_time_and_charges_say_what_they_are_made_of(
    expression: str, cause: str, debugger: Debugger
) -> None:
    debugger.goto_time(2.0)
    assert any(each.startswith(cause) for each in texts(debugger, expression))


@pytest.mark.parametrize("expression", ["$world.queued", "near.present", "post.x"])
def test_a_value_without_causes_is_reported(expression: str, debugger: Debugger) -> None:
    debugger.goto_time(1.0)
    (found,) = texts(debugger, expression)
    assert found.endswith("a value of the world")
