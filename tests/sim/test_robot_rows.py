"""What kernels change of a state lies in rows, and is seen through the state's arrays."""

from __future__ import annotations

from dataclasses import replace
from operator import attrgetter

import numpy as np
import pytest

from crs_cc.requests import CODES, MESSAGE
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.model.world import Pose
from crs_cc.sim.state import robot_rows

WORLD = parse_world(
    b"""<world version="1"><area length="6m" width="6m"/><box x="3m" y="3m" length="1m" width="1m"/>
    <robot x="1m" y="1m"/><robot x="1m" y="4m" setup="noisy"/><robot x="5m" y="1m"/></world>""",
    "rows",
)


def drive_on(environment: Environment, steps: int) -> None:
    """Set speeds that soon time out, and run for some steps."""
    robots = np.arange(len(environment.state.heading_rad))
    for name, values in (("CONNECT", ()), ("CONF_TM", (1,)), ("VM", (90, 40))):
        messages = np.zeros(len(robots), MESSAGE)
        messages["i"][:, : len(values)] = values
        now_s = np.full(len(robots), environment.time_s)
        environment.serve(CODES[name], robots, messages, now_s)
    for _ in range(steps):
        environment.step()


def assert_in_rows(environment: Environment) -> None:
    state = environment.state
    rows = state.rows
    for (parts, _), table in zip(
        robot_rows._TABLES, (rows.table, rows.bodies, rows.batteries, rows.sonars), strict=True
    ):
        for path, names in parts:
            for name in names:
                array = getattr(attrgetter(path)(state) if path else state, name)
                assert np.shares_memory(array, table), f"{path}.{name}"


def test_no_array_leaves_the_rows() -> None:
    environment = Environment(WORLD, seed=1)
    drive_on(environment, 30)
    assert_in_rows(environment)
    assert (environment.state.drive.command == CODES["CONF_TM"]).all()
    snapshot, wanted = environment.snapshot(), environment.hash()
    drive_on(environment, 5)
    environment.restore(snapshot)
    assert environment.hash() == wanted
    drive_on(environment, 5)
    assert_in_rows(environment)
    environment.add_robot(replace(WORLD.robots[0], id="late", start=Pose(5, 5)))
    drive_on(environment, 5)
    assert_in_rows(environment)
    environment.restore(snapshot)
    assert environment.hash() == wanted


def test_two_worlds_have_rows_of_their_own() -> None:
    first, second = Environment(WORLD, seed=1), Environment(WORLD, seed=1)
    drive_on(first, 10)
    before = first.hash()
    drive_on(second, 20)
    assert first.hash() == before
    assert not np.shares_memory(first.state.rows.table, second.state.rows.table)


def test_more_robots_than_kernels_have_room_for_run_the_same(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    hashes = []
    for room in (robot_rows.ROBOTS, 2):
        monkeypatch.setattr(robot_rows, "ROBOTS", room)
        environment = Environment(WORLD, seed=1)
        drive_on(environment, 30)
        hashes.append(environment.hash())
    assert hashes[0] == hashes[1]
