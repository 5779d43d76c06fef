"""Robots of other makers: directions of their sonars, turns, and the reported state.

A robot is at the centre of a square room, 4 m from wall to wall, facing east:

    +-----------+
    |           |
    |     R>    |
    |           |
    +-----------+
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from crs_cc.sim.devices.sonar.model import sonars_of
from crs_cc.sim.files.world_xml import load_robot
from tests.sim.driver import Driver, world_of
from tests.sim.files.test_world_xml import SIM

HALF_BEAM_RAD = math.radians(7.5)
SCOUT = 2


def room(kind: str) -> Driver:
    robot = f'<robot definition="{kind}" x="2m" y="2m"/>'
    return Driver.of(world_of(robot, 'length="4m" width="4m"'))


def echo_m(away_m: float, off_deg: float) -> float:
    """Return the distance of a wall at an angle off a beam of 15 degrees."""
    beyond_rad = max(math.radians(off_deg) - HALF_BEAM_RAD, 0.0)
    return away_m / math.cos(beyond_rad)


@pytest.mark.parametrize(
    ("sonar", "expected_m"),
    [
        (0, 2.0 - 0.136),  # from 13.6 cm left of the middle to the left
        (3, echo_m(2.0 - 0.166, 10)),  # ahead, 10 degrees to the left
        (4, echo_m(2.0 - 0.166, 10)),
        (7, 2.0 - 0.136),
        (8, 2.0 - 0.136),
        (12, echo_m(2.0 - 0.255, 10)),  # behind
        (13, echo_m(2.0 - 0.237, 30)),
        (15, 2.0 - 0.136),
    ],
)
def test_sonars_of_pioneer_have_directions_of_its_parameters(sonar: int, expected_m: float):
    echoes = room("pioneer2dx").state.devices.sonar.echo_m[0]
    assert echoes[sonar] == pytest.approx(expected_m, abs=1e-6)


@pytest.mark.parametrize(
    ("sonar", "expected_m"),
    [
        (0, 2.0 - 0.1),
        (2, echo_m(2.0 - 0.15, 15)),
        (5, 2.0 - 0.1),
        (6, echo_m(2.0 - 0.14, 35)),
        (8, math.inf),
        (15, math.inf),
    ],
)
def test_sonars_of_amigobot_have_directions_of_its_parameters(sonar: int, expected_m: float):
    echoes = room("amigobot").state.devices.sonar.echo_m[0]
    assert echoes[sonar] == pytest.approx(expected_m, abs=1e-6)


@pytest.mark.parametrize("kind", ["pioneer2dx", "amigobot"])
def test_sonars_are_symmetric(kind: str):
    places = {(s.x_m, s.y_m, round(s.direction_rad, 6)) for s in sonars_of(_model(kind)).sonars}
    assert places == {(x, -y, -direction) for x, y, direction in places}


@pytest.mark.parametrize(("kind", "wheel_base_m"), [("pioneer2dx", 0.35714), ("amigobot", 0.18182)])
def test_turn_takes_arc_of_half_the_wheel_base(kind: str, wheel_base_m: float):
    """Each wheel runs a quarter of the circle through both: the robot turns by 90 degrees."""
    driver = room(kind)
    quarter_m = wheel_base_m * math.pi / 4
    tenths = round(quarter_m / 0.00254)
    driver.ask("PR", tenths, -tenths)
    driver.run_s(5.0)
    turned_rad = 2 * tenths * 0.00254 / wheel_base_m
    assert driver.state.heading_rad[0] == pytest.approx(turned_rad, abs=1e-4)
    assert turned_rad == pytest.approx(math.pi / 2, abs=0.03)


@pytest.mark.parametrize("kind", ["pioneer2dx", "amigobot"])
def test_robot_reports_state_like_scout(kind: str):
    driver = room(kind)
    message, _ = driver.post("CONNECT")
    assert message["i"][0] == SCOUT
    state = driver.ask("GS")
    assert (state[33], state[42]) == (0, 0)  # no bumpers, no compass
    sonars = len(sonars_of(_model(kind)).sonars)
    assert np.array_equal(state[17 + sonars : 33], np.full(16 - sonars, 255))


@pytest.mark.parametrize("kind", ["pioneer2dx", "amigobot"])
def test_noisy_setup_deviates(kind: str):
    noisy = load_robot(SIM / "files" / "robots" / f"{kind}.xml", "noisy")
    assert sonars_of(noisy).board.noise_m > 0.0
    assert sonars_of(noisy).sonars == sonars_of(_model(kind)).sonars


def _model(kind: str):
    return load_robot(SIM / "files" / "robots" / f"{kind}.xml")
