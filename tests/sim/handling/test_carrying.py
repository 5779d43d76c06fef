"""Loads move with their robots, do not penetrate objects, and replay to the bit."""

import math

import numpy as np
import pytest

from tests.sim.driver import SCOUT_RADIUS_M
from tests.sim.gripping import CLOSE, GRIPPER, OPEN, gripping, kinds, place, tell

WIDE = 'length="100m" width="100m" origin="centre" edge="0"'
CAN = '<cylinder x="26cm" y="0" radius="4cm" mass="1kg"/>'
BAR = '<box x="0" y="0" length="60cm" width="5cm" mass="2kg"/>'
FACING = '<robot x="-53cm" y="0"/><robot x="53cm" y="0" heading="180"/>'
"""Two robots, 3 cm from the ends of a bar that is between their fingers."""


def holding(tmp_path, elements, area=WIDE):
    """Return a world in which all robots have closed their grippers."""
    driver = gripping(tmp_path, elements, area)
    for robot in range(len(driver.state.heading_rad)):
        driver.post("GRIPPER", CLOSE, robot=robot)
    driver.run_s(1.1)
    return driver


def test_load_keeps_its_pose_in_the_gripper(tmp_path):
    driver = holding(tmp_path, '<robot x="0" y="0"/>' + CAN)
    driver.post("VM", 120, 60)
    driver.run_s(5)
    state = driver.state
    heading_rad = state.heading_rad[0]
    away_m = 0.26 * np.array([math.cos(heading_rad), math.sin(heading_rad)])
    assert place(driver) == pytest.approx(state.bodies.position_m[0] + away_m, abs=1e-12)
    assert state.bodies.angle_rad[1] % (2 * math.pi) == pytest.approx(heading_rad)


def test_load_does_not_change_the_robots_motion(tmp_path):
    driver = holding(tmp_path, '<robot x="0" y="0"/><robot x="0" y="5m"/>' + CAN)
    for robot in (0, 1):
        driver.post("VM", 120, 60, robot=robot)
    driver.run_s(5)
    with_load, without = driver.state.bodies.position_m[:2]
    assert with_load == pytest.approx(without - [0, 5], abs=1e-9)


def test_wall_that_stops_the_load_stops_the_robot(tmp_path):
    """The can's front is 30 cm ahead of the robot's centre, the wall's face at 1 m."""
    wall = '<wall x1="1.05m" y1="-1m" x2="1.05m" y2="1m" thickness="10cm"/>'
    driver = holding(tmp_path, '<robot x="0" y="0"/>' + CAN + wall)
    driver.post("VM", 150, 150)
    steps = driver.run_s(8)
    assert driver.state.x_m[0] == pytest.approx(0.70, abs=0.004)
    assert place(driver)[0] == pytest.approx(0.96, abs=0.004)
    assert kinds(steps) == []
    assert not driver.state.devices.bumper.pressed.any()


def test_load_turned_into_a_wall_slides_along_it(tmp_path):
    """A rod of 30 cm ahead of the robot, whose side faces a wall 25 cm away."""
    rod = '<box x="36cm" y="0" length="30cm" width="4cm" mass="1kg"/>'
    wall = '<wall x1="-2m" y1="30cm" x2="2m" y2="30cm" thickness="10cm"/>'
    driver = holding(tmp_path, '<robot x="0" y="0"/>' + rod + wall)
    driver.post("PR", *_turn(90))
    deepest_m, steps = 0.0, []
    for _ in range(120):
        steps += driver.run(1)
        deepest_m = max(deepest_m, _tip_y_m(driver, 0.15, 0.02) - 0.25)
    assert deepest_m < 0.005
    assert kinds(steps) == []
    assert driver.state.heading_rad[0] == pytest.approx(math.pi / 2, abs=0.01)
    assert driver.state.y_m[0] == pytest.approx(0.25 - 0.51, abs=0.02)


def test_load_that_cannot_turn_is_torn_from_the_gripper(tmp_path):
    """A rod in a passage of 60 cm, between walls that are 2 cm thick."""
    rod = '<box x="36cm" y="0" length="30cm" width="4cm" mass="1kg"/>'
    walls = "".join(
        f'<wall x1="-2m" y1="{y}cm" x2="2m" y2="{y}cm" thickness="2cm"/>' for y in (-31, 31)
    )
    driver = holding(tmp_path, '<robot x="0" y="0"/>' + rod + walls)
    driver.post("VM", -300, 300)
    steps = driver.run_s(5)
    assert kinds(steps) == ["lost"]
    assert tell(driver)[2] == 0
    assert abs(place(driver)[1]) < 0.3
    assert abs(driver.state.y_m[0]) < 0.30 - SCOUT_RADIUS_M + 0.02


def test_released_load_stays_at_rest(tmp_path):
    driver = holding(tmp_path, '<robot x="0" y="0"/>' + CAN)
    driver.post("VM", 120, 120)
    driver.run_s(2)
    driver.post("VM", 0, 0)
    driver.run_s(1)
    driver.post("GRIPPER", OPEN)
    assert kinds(driver.run(1)) == ["release"]
    there = place(driver).copy()
    driver.post("PR", -200, -200)
    driver.run_s(3)
    assert place(driver).tolist() == there.tolist()


def test_load_pushes_objects_ahead_of_it(tmp_path):
    box = '<box id="z" x="60cm" y="0" length="20cm" width="20cm" mass="2kg"/>'
    driver = holding(tmp_path, '<robot x="0" y="0"/>' + CAN + box)
    driver.post("PR", 200, 200)
    driver.run_s(6)
    x_m = 0.508 + 0.30 + 0.10  # the way, the can's front, half of the box
    assert place(driver, 0)[0] == pytest.approx(x_m, abs=0.01)


def test_two_grippers_move_a_bar_together(tmp_path):
    driver = holding(tmp_path, FACING + BAR)
    assert [tell(driver, robot) for robot in (0, 1)] == [[20, 1, 1000]] * 2
    driver.post("PR", -100, -100, robot=0)
    driver.post("PR", 100, 100, robot=1)
    steps = driver.run_s(4)
    assert kinds(steps) == []
    assert place(driver) == pytest.approx([-0.254, 0], abs=0.005)


def test_robots_can_turn_about_a_shared_load(tmp_path):
    driver = holding(tmp_path, FACING + BAR)
    driver.post("PR", *_turn(20), robot=0)
    steps = driver.run_s(3)
    state = driver.state
    assert kinds(steps) == []
    assert state.heading_rad[0] == pytest.approx(math.radians(20), abs=0.01)
    grip_m = SCOUT_RADIUS_M + 0.05
    ahead = np.array([math.cos(state.heading_rad[0]), math.sin(state.heading_rad[0])])
    angle_rad = state.bodies.angle_rad[2]
    end_m = place(driver) - 0.2768 * np.array([math.cos(angle_rad), math.sin(angle_rad)])
    assert state.bodies.position_m[0] + grip_m * ahead == pytest.approx(end_m, abs=0.01)


def test_remaining_gripper_keeps_a_shared_load(tmp_path):
    driver = holding(tmp_path, FACING + BAR)
    driver.post("GRIPPER", OPEN, robot=0)
    driver.run(1)
    assert tell(driver, 1)[2] == 2000
    before = place(driver) - driver.state.bodies.position_m[1]
    driver.post("PR", -100, -100, robot=1)
    driver.run_s(3)
    assert driver.state.x_m[1] == pytest.approx(0.53 + 0.254, abs=0.003)
    assert place(driver) - driver.state.bodies.position_m[1] == pytest.approx(before, abs=1e-9)


def test_excessive_force_tears_a_shared_load_off(tmp_path):
    """Both move away from each other, with more force than the grippers' 5 N."""
    driver = gripping(tmp_path, FACING + BAR, WIDE, GRIPPER.replace("/>", ' force="5N"/>'))
    for robot in (0, 1):
        driver.post("GRIPPER", CLOSE, robot=robot)
    driver.run_s(1)
    for robot in (0, 1):
        driver.post("PR", -100, -100, robot=robot)
    assert "lost" in kinds(driver.run_s(3))
    assert driver.state.x_m[0] < -0.53 - 0.2
    assert driver.state.x_m[1] > 0.53 + 0.2


def test_teleported_robot_releases_its_load(tmp_path):
    driver = holding(tmp_path, FACING + BAR)
    driver.post("PLACE_ROBOT", 500, 500, 0, 0, robot=0)
    driver.run(2)
    assert tell(driver, 0)[2] == 0
    assert tell(driver, 1)[2] == 2000
    assert place(driver) == pytest.approx([0, 0], abs=1e-6)


def test_removed_object_is_released(tmp_path):
    driver = holding(tmp_path, '<robot x="0" y="0"/>' + CAN)
    driver.post("NEW_WORLD")
    driver.run(3)
    assert tell(driver) == [0, 0, 0]


@pytest.mark.parametrize("elements", [
    '<robot x="0" y="0"/>' + CAN + '<box x="1.2m" y="0.3m" length="4cm" width="1m"/>',
    FACING + BAR + '<box id="y" x="0" y="30cm" length="20cm" width="20cm" mass="1kg"/>',
])  # fmt: skip
def test_snapshot_while_carrying_replays_to_the_same_bits(tmp_path, elements):
    driver = holding(tmp_path, elements)
    for robot in range(len(driver.state.heading_rad)):
        driver.post("VM", 100, 90 - 200 * robot, robot=robot)
    driver.run_s(1.5)
    snapshot, hashes = driver.environment.snapshot(), []
    for _ in range(2):
        driver.environment.restore(snapshot)
        driver.run_s(1)
        driver.post("GRIPPER", OPEN)
        driver.run_s(4)
        hashes.append(driver.environment.hash())
    assert hashes[0] == hashes[1]


def _turn(degrees: float) -> tuple[int, int]:
    """Return the arguments of PR that turn a Scout on the spot, to the left."""
    tenths = round(math.radians(degrees) * 0.345186 / 2 / 0.00254)
    return tenths, -tenths


def _tip_y_m(driver, half_length_m, half_width_m):
    """Return the largest y of a rod's corners."""
    angle_rad = driver.state.bodies.angle_rad[-1]
    up_m = abs(math.sin(angle_rad)) * half_length_m + abs(math.cos(angle_rad)) * half_width_m
    return place(driver)[1] + up_m
