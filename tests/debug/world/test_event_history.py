"""What happened is known behind and ahead of where a run stands."""

from __future__ import annotations

import numpy as np
import pytest

from crs_cc.debug.engine import Debugger
from crs_cc.debug.program import DebugProgram
from crs_cc.debug.timeline.change import Change
from crs_cc.debug.world.event_history import EventHistory
from crs_cc.debug.world.events import WorldEvent
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import empty_world, parse_world
from tests.debug.debuggers import debug_program

DRIVE = """\
#include "Nclient.h"
int main(void)
{
    connect_robot(1, MODEL_SCOUT, "", 0);
    scout_vm(100, 0);
    ws(1, 1, 0, 5);
    return 0;
}
"""
WALL = parse_world(
    b"""<world version="1"><area length="4m" width="4m"/>
        <wall x1="2.6m" y1="1m" x2="2.6m" y2="3m"/><robot id="scout" x="2m" y="2m"/></world>""",
    "wall",
)


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> DebugProgram:
    path = tmp_path_factory.mktemp("chronicle") / "drive.c"
    path.write_text(DRIVE)
    return debug_program(path)


@pytest.fixture
def crashed(program: DebugProgram) -> Debugger:
    debugger = Debugger(WALL, [program])
    debugger.resume()
    return debugger


def kinds(debugger: Debugger) -> list[str]:
    return [each.kind for each in debugger.run.event_history.world_events()]


def test_stops_are_recorded_for_every_user_interface(program: DebugProgram) -> None:
    debugger = Debugger(WALL, [program])
    debugger.stop_points.add_breakpoint("main")
    debugger.resume()
    debugger.goto_timestep(0)
    debugger.resume()
    told = [each.text for each in debugger.run.event_history.world_events() if each.kind == "stop"]
    assert told == ["breakpoint 1"]


def test_events_are_kept_and_recorded_once(
    crashed: Debugger,
) -> None:
    known = crashed.run.event_history.world_events()
    assert "collision" in kinds(crashed)
    assert [each.time_s for each in known] == sorted(each.time_s for each in known)
    timesteps = crashed.run.event_history.timesteps
    crashed.goto_time(0.5)
    crashed.resume()
    assert crashed.run.event_history.world_events() == known
    assert crashed.run.event_history.timesteps == timesteps


def test_paths_end_at_the_current_position(crashed: Debugger) -> None:
    event_history = crashed.run.event_history
    (path,) = event_history.paths(10)
    assert path.shape == (10, 2)
    assert (np.diff(path[:, 0]) >= 0).all()
    assert event_history.paths(0) == []


def test_a_change_discards_later_events_but_not_those_of_branches(
    crashed: Debugger,
) -> None:
    known = crashed.run.event_history.world_events()
    crashed.goto_timestep(3)
    crashed.branches.add("other")
    assert kinds(crashed) == []
    assert crashed.run.event_history.timesteps == 3
    crashed.branches.switch("main")
    assert crashed.run.event_history.world_events() == known
    crashed.run.record_change(Change(crashed.position, ""))
    assert kinds(crashed) == []


def test_memory_is_bounded() -> None:
    event_history, environment = EventHistory(), Environment(empty_world(), seed=1)
    step = environment.step()
    for timestep in range(9_000):
        event_history._record_poses(
            timestep, environment
        ) if timestep % event_history._stride == 0 else None
    assert len(event_history.paths(9_000)[0]) <= 2_000
    for number in range(25_000):
        event_history._add(number, WorldEvent(float(number), "collision", 0, "it touched a wall"))
    assert len(event_history.world_events()) <= 20_000
    event_history.record_step(step, environment)
    assert event_history.timesteps == 1


def test_repeated_events_are_recorded_once() -> None:
    event_history = EventHistory()
    for _ in range(2):
        event_history.note(3, WorldEvent(0.15, "stop", 0, "breakpoint 1"))
    assert len(event_history.world_events()) == 1


def test_contacts_have_positions_up_to_the_current_timestep(
    crashed: Debugger,
) -> None:
    event_history, timestep = crashed.run.event_history, crashed.position.timestep
    ((robot, x_m, y_m), *_) = event_history.contacts(timestep)
    assert robot == 0
    assert (x_m, y_m) == pytest.approx((2.55, 2.0), abs=0.01)  # the wall is 10 cm thick
    assert event_history.contacts(3) == []


def test_a_path_is_interrupted_where_the_robot_was_moved_by_hand(program: DebugProgram) -> None:
    debugger = Debugger(WALL, [program])
    debugger.goto_timestep(10)
    debugger.edit_world("move scout to 1 1")
    debugger.goto_timestep(12)
    (path,) = debugger.run.event_history.paths(12)
    assert np.isnan(path[:, 0]).tolist() == [False] * 10 + [True] + [False] * 2
    assert path[9] == pytest.approx([2.0, 2.0], abs=0.1)
    assert path[11] == pytest.approx([1.0, 1.0], abs=0.1)
