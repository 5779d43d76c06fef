"""The serial line: the lengths of commands, and changes of its speed."""

from __future__ import annotations

import numpy as np
import pytest

from crs_cc.requests import CODES, MESSAGE, REQUESTS
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.known_robots import known_robots
from crs_cc.sim.files.world_xml import empty_world, parse_world

NOWHERE = {
    *("CONNECT", "DISCONNECT", "CREATE"),
    *("LASER_PAGE", "POS_DATA", "READINGS"),  # they came with the reply
}
"""Requests without transmission time."""

OWN = {"host", "network"}
"""Who answers requests that never leave the program's computer."""

TO_SIMULATOR = {
    *("PLACE_ROBOT", "ADD_OBSTACLE", "DELETE_OBSTACLE", "MOVE_OBSTACLE", "NEW_WORLD", "GET_RPX"),
    *("PREDICT", "MOTION_CHECK", "GET_CONF", "DRAW", "REFRESH"),
    *("QUIT_SERVER", "REAL_ROBOT", "SIMULATED_ROBOT"),
}
"""Requests over the network."""


def environment(robot="scout"):
    text = f'<area length="4m" width="4m"/><robot definition="{robot}" x="2m" y="2m"/>'
    return Environment(parse_world(f'<world version="1">{text}</world>'.encode(), "test"), 0)


@pytest.mark.parametrize("robot", known_robots())
def test_exactly_commands_to_robot_take_line_time(robot):
    line = environment(robot)
    takes = {row.name for row in REQUESTS.values() if line.link_s(row.code) > 0}
    assert takes == {row.name for row in REQUESTS.values() if row.server not in OWN} - NOWHERE
    assert {float(line.link_s(CODES[name])) for name in TO_SIMULATOR} == {0.001}


@pytest.mark.parametrize(
    ("link", "expected_s"),
    [("", 0.001), ('<link baud="9600"/>', 0.001), ('<link baud="9600" network="5ms"/>', 0.005)],
)
def test_without_line_all_requests_take_network_time(tmp_path, link, expected_s):
    (tmp_path / "cart.xml").write_text(
        '<robot-definition version="1" name="cart"><body radius="20cm" mass="10kg"/>'
        '<drive wheel-base="30cm" speed-limit="1m/s" acceleration-limit="1m/s2" speed="1m/s"'
        f' acceleration="1m/s2"/><sonars order=""/>{link}<host speed="50MHz"/></robot-definition>'
    )
    line = Environment(empty_world(robot=str(tmp_path / "cart.xml")), 0)
    takes = {row.name: float(line.link_s(row.code)) for row in REQUESTS.values()}
    assert takes == {
        row.name: 0.0 if row.server in OWN or row.name in NOWHERE else expected_s
        for row in REQUESTS.values()
    }


def test_text_takes_time_per_character():
    line = environment()
    spoken, silent = (line.link_s(CODES["TK"], 0, size) for size in (100, 0))
    assert spoken - silent == pytest.approx(100 * 10 / 38400)
    assert line.link_s(CODES["GS"], 0, 100) == line.link_s(CODES["GS"])


@pytest.mark.parametrize(("baud", "good"), [(9600, 1), (4800, 1), (1234, 0), (-1, 0)])
def test_conf_ser_sets_speed(baud, good):
    line = environment()
    before = line.link_s(CODES["GS"])
    for name in ("CONNECT", "CONF_SER"):
        message = np.zeros(1, MESSAGE)
        message["i"][0, 1] = baud if name == "CONF_SER" else 0
        line.serve(CODES[name], np.array([0]), message, np.zeros(1))
    assert message["result"][0] == good
    assert line.link_s(CODES["GS"]) == pytest.approx(before * (38400 / baud if good else 1))


def test_batched_requests_take_time_of_single_ones():
    robots = "".join(
        f'<robot definition="{kind}" x="{x}m" y="2m"/>'
        for x, kind in enumerate([*known_robots(), "scout"], 1)
    )
    text = f'<world version="1"><area length="9m" width="4m"/>{robots}</world>'
    line = Environment(parse_world(text.encode(), "test"), 0)
    line.state.link.baud[-1] = 4800
    codes = np.array([*REQUESTS, 0, -1, 12345])
    code, robot, size = (
        values.ravel()
        for values in np.meshgrid(codes, np.arange(len(line.state.link.baud)), [-5, 0, 7, 10**6])
    )
    together = line.link_s(code, robot, size)
    assert len(set(together.tolist())) > 10
    for place, each in enumerate(zip(code.tolist(), robot.tolist(), size.tolist(), strict=True)):
        assert line.link_s(*each) == together[place]
