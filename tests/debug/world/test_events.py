"""Catchpoints' sources: what happened in a timestep, in words."""

import numpy as np
import pytest

from crs_cc.debug.errors import DebugError
from crs_cc.debug.world.events import KINDS, check_event_kind, world_events
from crs_cc.sim.model.degradation import Degradation
from crs_cc.sim.state.events import KINDS as EVENT_KINDS
from tests.sim.driver import Driver, open_world, world_of

ALL = tuple(KINDS)


def told(driver, wanted, most=200):
    """Run on until something happens that is wanted; return it and its instants."""
    for _ in range(most):
        step = driver.environment.step()
        if found := world_events(step, driver.environment.world, wanted):
            return [(round(each.time_s, 9), each.kind, each.robot, each.text) for each in found]
    return []


def test_a_collision_names_both_and_presses_the_bumper_at_the_end_of_its_timestep() -> None:
    wall = '<wall id="screen" x1="5.05m" y1="4m" x2="5.05m" y2="6m" thickness="10cm"/>'
    world = world_of(f'<robot x="4m" y="5m"/>{wall}')
    driver = Driver.of(world)
    driver.ask("VM", 100, 100)
    found = told(driver, ["collision", "bumper"])
    (end_s,) = {time_s for time_s, *_ in found}
    assert end_s == pytest.approx(driver.environment.time_s)
    assert [row[1:] for row in found] == [
        ("collision", 0, "robot0 touched screen at 5.001, 5.000 m"),
        ("bumper-pressed", 0, "robot0's bumper 0 (ahead) was pressed"),
    ]
    driver.ask("VM", -100, -100)
    assert [row[1:] for row in told(driver, ["bumper"])] == [
        ("bumper-released", 0, "robot0's bumper 0 (ahead) was released")
    ]


def test_robots_that_touch_each_other_both_do() -> None:
    driver = Driver.of(open_world('<robot x="0" y="0"/><robot x="0.5m" y="0"/>'))
    driver.ask("VM", 100, 100)
    assert [row[2:] for row in told(driver, ["collision"])] == [
        (0, "robot0 touched robot1 at 0.298, 0.000 m"),
        (1, "robot1 touched robot0 at 0.298, 0.000 m"),
    ]


def test_message_events_name_the_outcome() -> None:
    world = open_world('<robot x="0" y="0"/><robot x="1m" y="0"/>')
    driver = Driver.of(world)
    driver.environment.communication.shut(receiver="robot1")
    driver.ask("SEND", 1, -1, 3, 0, data=b"x")
    kinds = [kind for _, kind, _, _ in told(driver, ["message"])]
    assert kinds == ["message-way", "message-sent", "message-lost"]
    driver.environment.communication.open(receiver="robot1")
    driver.ask("SEND", 1, -1, 3, 0, data=b"x")
    found = told(driver, ["message-arrived"])
    assert [(kind, robot) for _, kind, robot, _ in found] == [("message-arrived", 1)]
    assert found[0][3].startswith("radio message 1 from robot0 to robot1, type 3, 1 byte:")


def test_events_of_degradations_and_joining_name_the_robot() -> None:
    world = open_world('<robot x="0" y="0"/><robot x="3m" y="0" join="0.1s" leave="0.2s"/>')
    driver = Driver.of(world)
    driver.environment.degradations.add(Degradation("robot0", "sonar", 3, dead=True, onset_s=0.02))
    assert [row[1:] for row in told(driver, ["degradation"])] == [
        ("degradation", 0, "robot0: sonar 3, dead (degradation0 added)"),
        ("degradation", 0, "robot0: sonar 3, dead (degradation0 began)"),
    ]
    assert told(driver, ["join", "leave"]) == [(0.1, "join", 1, "robot1 joined")]
    assert told(driver, ["join", "leave"]) == [(0.2, "leave", 1, "robot1 left")]


def test_unwanted_kinds_are_not_returned() -> None:
    driver = Driver.of(open_world())
    step = driver.environment.step()
    assert world_events(step, driver.environment.world, []) == []
    assert [each.kind for each in world_events(step, driver.environment.world, ALL)] == ["tick"]


def test_only_the_kinds_of_the_table_can_be_caught() -> None:
    assert {kind.partition("-")[0] for kind in KINDS} >= EVENT_KINDS.keys()
    with pytest.raises(DebugError, match=r"'crash' \(known: exit, tick"):
        check_event_kind("crash")


def test_presses_and_releases_do_not_depend_on_the_kinds_wanted() -> None:
    driver = Driver.of(open_world('<robot x="0" y="0"/><robot x="0.5m" y="0"/>'))
    before = driver.state.devices.bumper.pressed.copy()
    driver.ask("VM", 100, 100)
    for _ in range(60):
        step = driver.environment.step()
        now = driver.state.devices.bumper.pressed
        assert np.array_equal(step.pressed, now & ~before)
        assert np.array_equal(step.released, before & ~now)
        before = now.copy()
    assert before.tolist() == [1, 1 << 4]
