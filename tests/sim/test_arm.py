"""The arm's joints, the position of its tip, and what the hand grasps and releases."""

import math
from pathlib import Path

import numpy as np
import pytest

from crs_cc.core.errors import WorldError
from crs_cc.sim.devices.arm import inspect
from crs_cc.sim.files.world_xml import load_robot
from tests.device.robot import scout_with
from tests.sim.gripping import CLOSE, OPEN, gripping, kinds, place

WIDE = 'length="100m" width="100m" origin="centre" edge="0"'
ROBOT = '<robot x="0" y="0"/>'
ARM = (
    '<arm x="10cm" y="2cm" upper="30cm" fore="20cm" shoulder-min="-90deg" shoulder-max="90deg"'
    ' elbow-min="-120deg" elbow-max="120deg" shoulder-speed="30deg/s" elbow-speed="60deg/s"'
    ' hand="5cm" max-mass="2kg"/>'
)
CAN = '<cylinder x="60cm" y="2cm" radius="4cm" mass="1kg"/>'
"""Position of the tip of the extended arm."""


def arm_of(tmp_path, elements="", robot=ROBOT):
    return gripping(tmp_path, robot + elements, WIDE, ARM)


def tell(driver, robot=0):
    """Return shoulder and elbow [0.1 deg], the tip [0.1 in], and the held weight [g]."""
    message, _ = driver.post("GET_ARM", robot=robot)
    return message["i"][:5].tolist()


def tip(shoulder_deg, elbow_deg):
    """Return the hand-computed tip [0.1 in]."""
    one, two = math.radians(shoulder_deg), math.radians(shoulder_deg + elbow_deg)
    x_m = 0.10 + 0.30 * math.cos(one) + 0.20 * math.cos(two)
    y_m = 0.02 + 0.30 * math.sin(one) + 0.20 * math.sin(two)
    return [round(x_m / 0.00254), round(y_m / 0.00254)]


@pytest.mark.parametrize(("shoulder", "elbow"), [(0, 0), (45, 0), (90, -90), (-30, 120)])
def test_tip_position_follows_from_joint_angles(tmp_path, shoulder, elbow):
    """Upper link 30 cm, fore link 20 cm, shoulder 10 cm ahead and 2 cm to the left."""
    driver = arm_of(tmp_path)
    driver.post("ARM", 0, 10 * shoulder, 10 * elbow)
    driver.run_s(5)
    assert tell(driver) == [10 * shoulder, 10 * elbow, *tip(shoulder, elbow), 0]


def test_each_joint_turns_at_its_own_speed_to_its_target(tmp_path):
    driver = arm_of(tmp_path)
    driver.post("ARM", 0, 600, -600)
    driver.run_s(0.5)
    assert tell(driver)[:2] == [150, -300]
    driver.run_s(1)
    assert tell(driver)[:2] == [450, -600]
    driver.post("ARM", 1, -100, 50)  # on from where they are
    driver.run_s(1)
    assert tell(driver)[:2] == [350, -550]


def test_angles_are_clipped_to_joint_limits(tmp_path):
    driver = arm_of(tmp_path)
    driver.post("ARM", 0, 2**31 - 1, -(2**31))
    driver.run_s(5)
    assert tell(driver)[:2] == [900, -1200]
    driver.post("ARM", 1, 2**31 - 1, 2**31 - 1)
    driver.run_s(5)
    assert tell(driver)[:2] == [900, 1200]


def test_held_object_moves_and_turns_with_tip(tmp_path):
    """The can is moved by 90 degrees about the shoulder, while its robot turns by 30."""
    driver = arm_of(tmp_path, CAN)
    driver.post("HAND", CLOSE)
    assert kinds(driver.run(1)) == ["grip"]
    driver.post("ARM", 0, 900, 0)
    turn = round(math.radians(30) * 0.345186 / 2 / 0.00254)
    driver.post("PR", turn, -turn)
    driver.run_s(4)
    heading_rad = driver.state.heading_rad[0]
    assert heading_rad == pytest.approx(math.radians(30), abs=0.01)
    own = np.array([0.10, 0.02 + 0.50])
    cos, sin = math.cos(heading_rad), math.sin(heading_rad)
    there = [cos * own[0] - sin * own[1], sin * own[0] + cos * own[1]]
    assert place(driver) == pytest.approx(there, abs=1e-9)
    turned_rad = driver.state.bodies.angle_rad[1]
    assert turned_rad == pytest.approx(heading_rad + math.pi / 2)
    assert tell(driver)[4] == 1000
    driver.post("HAND", OPEN)
    assert kinds(driver.run(1)) == ["release"]
    driver.post("ARM", 0, 0, 0)
    driver.run_s(4)
    assert place(driver) == pytest.approx(there, abs=1e-9)


def test_arm_passes_over_objects_and_releases_only_into_free_space(tmp_path):
    """A box stands 45 degrees to the left, just where the can would be put down."""
    box = '<box x="45.36cm" y="37.36cm" length="10cm" width="10cm"/>'
    driver = arm_of(tmp_path, CAN + box)
    driver.post("HAND", CLOSE)
    driver.run(1)
    driver.post("ARM", 0, 450, 0)
    driver.run_s(2)
    driver.post("HAND", OPEN)
    assert kinds(driver.run_s(1)) == []
    assert tell(driver)[4] == 1000
    driver.post("ARM", 0, 900, 0)
    assert kinds(driver.run_s(2)) == ["release"]
    assert tell(driver)[4] == 0
    away_m = np.hypot(*(place(driver) - [0.4536, 0.3736]))
    assert 0.04 + 0.05 < away_m < 0.04 + 0.05 * math.sqrt(2) + 0.02


def test_hand_does_not_grasp_far_heavy_or_held_objects(tmp_path):
    """The can's side is 6 cm from the tip, 4 cm, 4 cm; the last stands in another robot's hand."""
    for obj, grips in (
        ('<cylinder x="70cm" y="2cm" radius="4cm" mass="1kg"/>', []),
        ('<cylinder x="68cm" y="2cm" radius="4cm" mass="1kg"/>', ["grip"]),
        ('<cylinder x="68cm" y="2cm" radius="4cm" mass="3kg"/>', []),
    ):
        driver = arm_of(tmp_path, obj)
        driver.post("HAND", CLOSE)
        assert kinds(driver.run(2)) == grips
    facing = ROBOT + '<robot x="120cm" y="4cm" heading="180"/>'
    driver = arm_of(tmp_path, CAN, facing)
    for robot in (0, 1):
        driver.post("HAND", CLOSE, robot=robot)
    assert kinds(driver.run(2)) == ["grip"]
    assert [tell(driver, robot)[4] for robot in (0, 1)] == [1000, 0]


def test_missing_arm_and_invalid_values_are_refused(tmp_path):
    driver = arm_of(tmp_path)
    assert driver.post("HAND", 2)[0]["result"] == 0
    assert driver.post("HAND", -1)[0]["result"] == 0
    other = gripping(tmp_path, ROBOT, WIDE)
    assert [other.post(name)[0]["result"] for name in ("ARM", "GET_ARM", "HAND")] == [0, 0, 0]


def test_run_from_snapshot_with_held_object_is_bitwise_equal(tmp_path):
    driver = arm_of(tmp_path, CAN)
    driver.post("HAND", CLOSE)
    driver.run(1)
    driver.post("ARM", 0, 900, -500)
    driver.post("VM", 100, 80)
    driver.run_s(1)
    snapshot, hashes = driver.environment.snapshot(), []
    for _ in range(2):
        driver.environment.restore(snapshot)
        driver.run_s(1)
        driver.post("HAND", OPEN)
        driver.run_s(2)
        hashes.append(driver.environment.hash())
    assert hashes[0] == hashes[1]
    assert tell(driver)[4] == 0


@pytest.mark.parametrize(("fault", "joints"), [
    ('element="elbow" bias="10deg"', [300, 400]),
    ('element="shoulder" gain="0.5"', [150, 300]),
    ('element="0" dead="yes"', [0, 300]),
])  # fmt: skip
def test_degraded_joint_reaches_other_angle(tmp_path, fault, joints):
    driver = arm_of(tmp_path, f'<degradation robot="robot0" device="arm" {fault}/>')
    driver.post("ARM", 0, 300, 300)
    driver.run_s(3)
    assert tell(driver)[:2] == joints


def test_near_object_without_overlap_leaves_space_free(tmp_path):
    """Beside a box's corner: the discs around both overlap, they themselves do not."""
    box = '<box x="67cm" y="9cm" length="6cm" width="6cm" mass="9kg"/>'
    driver = arm_of(tmp_path, CAN + box)
    driver.post("HAND", CLOSE)
    driver.run(1)
    driver.post("HAND", OPEN)
    assert kinds(driver.run(1)) == ["release"]


def test_inspector_shows_commands_of_joints_and_hand(tmp_path):
    driver = arm_of(tmp_path)
    driver.post("ARM", 0, 450, -300)
    driver.post("HAND", CLOSE)
    assert inspect(driver.state, 0) == "shoulder to 45deg, elbow to -30deg, hand: close"


def test_crossed_joint_limits_are_refused(tmp_path):
    arm = '<arm elbow-min="20deg" elbow-max="10deg"/>'
    with pytest.raises(WorldError, match="arm, elbow-min: must not be greater than elbow-max"):
        load_robot(Path(scout_with(tmp_path, arm)))
