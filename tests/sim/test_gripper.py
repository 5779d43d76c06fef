"""Grasps of a gripper: the nearest object between its fingers that fits, and nothing else."""

import math
import re
from pathlib import Path

import numpy as np
import pytest

from crs_cc.core.errors import WorldError
from crs_cc.sim.devices.gripper import inspect
from crs_cc.sim.devices.gripper.fingers import between
from crs_cc.sim.files.world_xml import load_robot
from crs_cc.sim.geometry.scene import Scene
from tests.device.robot import scout_with
from tests.sim.driver import world_of
from tests.sim.gripping import CLOSE, OPEN, gripping, kinds, tell

WIDE = 'length="100m" width="100m" origin="centre" edge="0"'
ROBOT = '<robot x="0" y="0"/>'


def found(elements, mount=(0.0, 0.0, 0.0), strip=(0.2, 0.3)):
    """Return what is between fingers at a place: right, left and nearest point [m]."""
    scene = Scene(world_of('<robot x="9m" y="9m"/>' + elements, WIDE))
    moving = scene.moving(scene.start[:, :2], scene.start[:, 2])
    rows = between(moving, 1, np.array([mount]), np.array([strip]))
    return [
        (scene.names[obj], *(round(float(value), 6) for value in values))
        for obj, *values in zip(rows.object, rows.right_m, rows.left_m, rows.near_m, strict=True)
    ]


def test_width_of_box_along_fingers_is_used():
    r"""Palm at 20 cm, tips at 30 cm; the box from 25 to 65 cm.

      ═════════
    ▐  ┌───┬─────┐ 4 cm
    ▐  └───┴─────┘
      ═════════
    """
    box = '<box x="45cm" y="2cm" length="40cm" width="4cm" mass="1kg"/>'
    assert found(box) == [("box0", 0.0, 0.04, 0.25)]


def test_width_of_rotated_box_is_that_between_fingers():
    """A square on its tip: 4 cm behind its tip it is 8 cm wide."""
    box = '<box x="40cm" y="0" heading="45" length="20cm" width="20cm" mass="1kg"/>'
    tip_m = 0.4 - 0.1 * math.sqrt(2)
    depth_m = 0.3 - tip_m
    assert found(box) == [("box0", *np.round([-depth_m, depth_m, tip_m], 6).tolist())]


def test_width_of_cylinder_is_chord_at_tips_or_diameter():
    chord_m = round(math.sqrt(0.05**2 - 0.03**2), 6)
    assert found('<cylinder x="33cm" y="0" radius="5cm" mass="1kg"/>') == [
        ("cylinder0", -chord_m, chord_m, 0.28)
    ]
    assert found('<cylinder x="26cm" y="1cm" radius="5cm" mass="1kg"/>') == [
        ("cylinder0", -0.04, 0.06, 0.21)
    ]


def test_rotated_mount_gives_same_result():
    box = '<box x="2m" y="3.45m" heading="90" length="40cm" width="4cm" mass="1kg"/>'
    assert found(box, (2.0, 3.0, math.pi / 2)) == [("box0", -0.02, 0.02, 0.25)]


def test_object_outside_fingers_is_not_found():
    assert found('<cylinder x="40cm" y="0" radius="5cm" mass="1kg"/>') == []
    assert found('<box x="-45cm" y="0" length="40cm" width="4cm" mass="1kg"/>') == []


def test_fingers_stop_at_width_of_object(tmp_path):
    """20 cm apart, closing in 1 s: after 0.6 s they are 8 cm apart, as the can is wide."""
    can = '<cylinder x="26cm" y="0" radius="4cm" mass="1500g"/>'
    driver = gripping(tmp_path, ROBOT + can, WIDE)
    assert tell(driver) == [79, 1, 0]
    driver.post("GRIPPER", CLOSE)
    driver.run_s(0.3)
    assert tell(driver) == [55, 1, 0]
    assert kinds(driver.run_s(0.25)) == []
    assert kinds(driver.run_s(0.05)) == ["grip"]
    driver.run_s(2)
    assert tell(driver) == [31, 1, 1500]
    driver.post("GRIPPER", OPEN)
    driver.run_s(0.3)
    assert tell(driver) == [55, 1, 0]
    driver.run_s(1)
    assert tell(driver) == [79, 1, 0]


@pytest.mark.parametrize(("obj", "beam"), [
    ('<cylinder x="26cm" y="0" radius="4cm" mass="5.1kg"/>', 1),                     # too heavy
    ('<cylinder x="26cm" y="0" radius="4cm"/>', 1),                                  # fixed
    ('<cylinder x="32cm" y="0" radius="11cm" mass="1kg"/>', 1),                      # too wide
    ('<cylinder x="26cm" y="7cm" radius="4cm" mass="1kg"/>', 1),                 # too far aside
    ('<cylinder x="36cm" y="0" radius="4cm" mass="1kg"/>', 0),                   # too far ahead
    ('<robot x="45cm" y="0"/>', 1),
])  # fmt: skip
def test_fingers_close_completely_on_ungraspable_objects(tmp_path, obj, beam):
    driver = gripping(tmp_path, ROBOT + obj, WIDE)
    assert tell(driver)[1] == beam
    driver.post("GRIPPER", CLOSE)
    assert kinds(driver.run_s(1.5)) == []
    assert tell(driver) == [0, beam, 0]


def test_nearer_of_two_objects_is_grasped(tmp_path):
    cans = (
        '<cylinder id="far" x="28cm" y="6cm" radius="3cm" mass="1kg"/>'
        '<cylinder id="near" x="25cm" y="-5cm" radius="3cm" mass="1kg"/>'
    )
    driver = gripping(tmp_path, ROBOT + cans, WIDE)
    driver.post("GRIPPER", CLOSE)
    (event,) = [event for step in driver.run_s(2) for event in step.events]
    assert (event.kind, event.text, event.robot) == ("grip", "took near", 0)


def test_closed_fingers_do_not_grasp(tmp_path):
    can = '<cylinder x="60cm" y="0" radius="4cm" mass="1kg"/>'
    driver = gripping(tmp_path, ROBOT + can, WIDE)
    driver.post("GRIPPER", CLOSE)
    driver.run_s(1)
    driver.post("PR", 130, 130)
    assert kinds(driver.run_s(3)) == []
    assert tell(driver) == [0, 1, 0]


def test_invalid_command_is_refused(tmp_path):
    driver = gripping(tmp_path, ROBOT, WIDE)
    for what in (-1, 2, 2**31 - 1, -(2**31)):
        assert driver.post("GRIPPER", what)[0]["result"] == 0
    assert tell(driver) == [79, 0, 0]


@pytest.mark.parametrize(("fault", "apart"), [
    ('dead="yes"', 79), ('dead="yes" duration="1s"', 0), ('bias="-1"', 79), ('dropouts="1"', 79),
])  # fmt: skip
def test_degraded_gripper_may_ignore_command(tmp_path, fault, apart):
    fault = f'<degradation robot="robot0" device="gripper" {fault}/>'
    driver = gripping(tmp_path, ROBOT + fault, WIDE)
    driver.post("GRIPPER", CLOSE)
    driver.run_s(1.5)
    driver.post("GRIPPER", CLOSE)
    driver.run_s(1.5)
    assert tell(driver) == [apart, 0, 0]


def test_palm_is_at_the_shell_unless_its_place_is_given(tmp_path):
    for element, place_m in (("<gripper/>", 0.2032), ('<gripper place="25cm"/>', 0.25)):
        model = load_robot(Path(scout_with(tmp_path, element))).device("gripper")
        assert model.place_m == pytest.approx(place_m, abs=1e-4)


def test_invalid_radius_is_reported_once(tmp_path):
    """The radius is the default of the place of the palm."""
    robot = Path(scout_with(tmp_path, "<gripper/>"))
    text = robot.read_text()
    robot.write_text(re.sub('radius="[^"]*"', 'radius="-1m"', text, count=1))
    with pytest.raises(WorldError) as wrong:
        load_robot(robot)
    assert str(wrong.value).count("must be greater than 0") == 1
    assert "must not be negative" not in str(wrong.value)


def test_inspector_shows_command_and_distance_of_fingers(tmp_path):
    driver = gripping(tmp_path, ROBOT, WIDE)
    assert inspect(driver.state, 0) == "open, fingers 20.0 cm apart"
    driver.post("GRIPPER", CLOSE)
    driver.run_s(0.5)
    assert inspect(driver.state, 0) == "close, fingers 10.0 cm apart"
