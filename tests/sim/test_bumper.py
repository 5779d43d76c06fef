"""Bumpers: the switches that contacts press, and for how long."""

import math

import numpy as np
import pytest

from crs_cc.core.errors import WorldError
from crs_cc.sim.devices.bumper import Bumpers
from crs_cc.sim.devices.vendor_state import BUMPER
from tests.sim.driver import INCH, SCOUT_RADIUS_M, Driver, own_world, world_of

EIGHT = '<ring switches="8"/>'
NOMAD_200 = (
    '<ring switches="10" first="0deg" span="18deg" bits="0 2 4 6 8 10 12 14 16 18"/>'
    '<ring switches="10" first="18deg" span="18deg" bits="1 3 5 7 9 11 13 15 17 19"/>'
)


def bits_at(folder, rings: str, *bearings_deg: float) -> list[int]:
    """Return the bumper's state for a contact at each bearing."""
    bumpers = Bumpers(own_world(folder, (EIGHT, rings)))
    bearing_rad = np.radians(np.array(bearings_deg))
    return bumpers.pressed(np.zeros(len(bearings_deg), np.intp), bearing_rad).tolist()


def test_switches_of_ring_are_adjacent_without_overlap(tmp_path):
    assert bits_at(tmp_path, EIGHT, 0, 22.4, 22.6, 45, -22.4, -22.6, 180, 337.6) == [
        1, 1, 2, 2, 1, 128, 16, 1,
    ]  # fmt: skip
    for edge in range(8):
        pressed = bits_at(tmp_path, EIGHT, 22.5 + 45 * edge)
        assert pressed[0].bit_count() == 1, edge


def test_nomad_200_has_20_switches_in_two_rings_18_degrees_apart(tmp_path):
    bearings = [18.0 * number for number in range(20)]
    assert bits_at(tmp_path, NOMAD_200, *bearings) == [1 << number for number in range(20)]
    assert bits_at(tmp_path, NOMAD_200, 8.9, 9.1) == [1, 2]


def test_contact_in_overlap_presses_both_switches(tmp_path):
    rings = '<ring switches="4" span="100deg"/>'
    assert bits_at(tmp_path, rings, 0, 41, 45, 49, 51) == [1, 3, 3, 3, 2]


def test_contact_in_gap_presses_nothing(tmp_path):
    rings = '<ring switches="3" first="0deg" spacing="60deg" span="40deg"/>'
    assert bits_at(tmp_path, rings, 0, 19, 21, 39, 41, 120, 180, 270) == [1, 1, 0, 0, 2, 4, 0, 0]


def test_switches_may_be_clockwise_and_set_any_bit(tmp_path):
    rings = '<ring switches="4" first="45deg" direction="clockwise" bits="23 7 0 7"/>'
    assert bits_at(tmp_path, rings, 45, -45, -135, 135) == [1 << 23, 1 << 7, 1, 1 << 7]


def test_collision_of_robots_presses_facing_switches():
    driver = Driver.of(
        world_of('<robot x="3m" y="5m" heading="0"/><robot x="5m" y="5m" heading="90"/>')
    )
    driver.ask("VM", 200, 200, robot=0)
    driver.run_s(5)
    # Robot 0 drives east with its front; robot 1 looks north, its left is west.
    assert driver.ask("GET_BP", robot=0)[BUMPER] == 1
    assert driver.ask("GET_BP", robot=1)[BUMPER] == 1 << 2
    driver.ask("ST", robot=0)
    driver.run_s(3)
    for robot, bits in ((0, 1), (1, 1 << 2)):  # both stand, and still touch
        assert driver.ask("GET_BP", robot=robot)[BUMPER] == bits
    driver.ask("VM", -100, -100, robot=0)
    driver.run_s(2)
    for robot in range(2):
        assert driver.ask("GET_BP", robot=robot)[BUMPER] == 0


def test_bearing_of_oblique_contact_selects_switch():
    # Robot 1 stands 10 in to the left of the way of robot 0: they meet when their middles are
    # 16 in apart, at asin(10 / 16) = 38.7 degrees to the left: switch 1 of robot 0 (22.5 to 67.5);
    # robot 1 heads the same way and is hit from behind at 180 + 38.7 degrees: switch 5.
    y_m = 5 + 10 * INCH
    driver = Driver.of(world_of(f'<robot x="3m" y="5m"/><robot x="4m" y="{y_m}m"/>'))
    driver.ask("VM", 50, 50)
    while not driver.state.collisions[0]:
        driver.run(1)
    assert math.degrees(math.asin(10 / 16)) == pytest.approx(38.7, abs=0.1)
    assert driver.ask("GET_BP", robot=0)[BUMPER] == 1 << 1
    assert driver.ask("GET_BP", robot=1)[BUMPER] == 1 << 5


def test_corner_presses_both_sides():
    near_m = SCOUT_RADIUS_M + 0.02
    driver = Driver.of(world_of(f'<robot x="{10 - near_m}m" y="{10 - near_m}m" heading="45"/>'))
    driver.ask("VM", 100, 100)
    driver.run_s(2)
    assert driver.ask("GET_BP")[BUMPER] == 1 << 1 | 1 << 7


def test_hit_is_recorded_once_per_press():
    driver = Driver.of(world_of('<robot x="9m" y="5m"/>'))
    assert driver.state.devices.bumper.hit.at_s[0] < 0
    driver.ask("VM", 200, 200)
    while not driver.state.devices.bumper.pressed[0]:
        driver.run(1)
    hit_s = driver.state.devices.bumper.hit.at_s[0]
    hit_x = driver.state.devices.bumper.hit.configuration[0, 0]
    assert hit_s == driver.environment.time_s
    assert hit_x == driver.ask("GET_RC")[34]
    driver.run_s(1)
    assert driver.state.devices.bumper.hit.at_s[0] == hit_s
    assert driver.state.devices.bumper.hit.configuration[0, 0] == hit_x


@pytest.mark.parametrize(
    ("ring", "message"),
    [
        ('<ring switches="25"/>', "ring, switches: '25' is not an integer from 1 to 24"),
        ('<ring switches="2" bits="1"/>', "bits: expected 2 numbers, one for each switch, not 1"),
        ('<ring switches="2" bits="1 24"/>', "bits: 24 is too large (maximum: 23)"),
        ('<ring switches="2" span="-1deg"/>', "span: '-1deg' must be greater than 0"),
    ],
)
def test_invalid_rings_are_refused(tmp_path, ring, message):
    with pytest.raises(WorldError) as caught:
        own_world(tmp_path, (EIGHT, ring))
    assert any(message in each.render() for each in caught.value.diagnostics)
