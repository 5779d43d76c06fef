"""Robot models that are written are read again with equal values."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import crs_cc
from crs_cc.core.errors import WorldError
from crs_cc.sim.devices.arm.model import Arm
from crs_cc.sim.devices.bumper.element import Switch, Switches
from crs_cc.sim.devices.gripper.model import Gripper
from crs_cc.sim.devices.sonar.model import SonarMode, sonars_of
from crs_cc.sim.devices.tag import Tag
from crs_cc.sim.files.known_robots import ROBOTS
from crs_cc.sim.files.robot_writer import robot_text
from crs_cc.sim.files.world_xml import load_robot, parse_robot
from crs_cc.sim.model.robot import Drive, Link, RobotModel

ROOT = Path(__file__).parents[3]
DEFINITIONS = [
    path
    for folder in (ROBOTS, ROOT / "worlds", ROOT / "samples" / "scout_c")
    for path in sorted(folder.rglob("*.xml"))
    if "<robot-definition" in path.read_text("utf-8")
]
PLAIN = RobotModel("mine", 0.2, Drive(0.3))
SCOUT = load_robot(ROBOTS / "scout.xml")


@pytest.mark.parametrize("path", DEFINITIONS, ids=lambda path: path.stem)
def test_a_written_definition_is_read_again_with_equal_values(path: Path) -> None:
    setups = re.findall(r'<setup name="([^"]+)"', path.read_text("utf-8"))
    for setup in ["", *setups]:
        model = load_robot(path, setup)
        assert parse_robot(robot_text(model), "again") == model


@pytest.mark.parametrize(
    "model",
    [
        PLAIN,
        replace(PLAIN, height_m=0.4, link=Link(9600, (("PR", 70_000), ("VM", 3)), 0.002)),
        PLAIN.with_device("arm", Arm(elbow_radps=1.0 / 3.0)).with_device("gripper", Gripper(0.21)),
        PLAIN.with_device("bumper", Switches((Switch(3, 1.1, 0.1), Switch(3, 0.2, 0.3)))),
        PLAIN.with_device("tag", Tag(3.0)),
        SCOUT.with_device("bumper", None),
    ],
    ids=["plain", "link", "hands", "switches", "tag", "no bumper"],
)
def test_a_model_made_in_python_is_written(model: RobotModel) -> None:
    assert parse_robot(robot_text(model), "again") == model


def test_devices_are_equal_in_any_order() -> None:
    one = PLAIN.with_device("arm", Arm()).with_device("tag", Tag(1.0))
    assert one == PLAIN.with_device("tag", Tag(1.0)).with_device("arm", Arm())


@pytest.mark.parametrize(
    ("model", "message"),
    [
        (PLAIN.with_device("jetpack", 1), "'jetpack' would be read differently"),
        (PLAIN.with_device("arm", Arm(x_m="left")), "<arm>, x: "),  # type: ignore[arg-type]
        (SCOUT.with_device("tag", Tag(1.0)), "'tag' would be read differently"),
        (replace(PLAIN, drive=Drive(0.0)), "wheel-base: '0m' must be greater than 0"),
        (replace(PLAIN, vendor_model=7), "vendor_model 7"),
        (replace(PLAIN, radius_m=float("nan")), "radius"),
    ],
)
def test_what_cannot_be_written_is_an_error(model: RobotModel, message: str) -> None:
    with pytest.raises((ValueError, WorldError), match=re.escape(message)):
        robot_text(model)


def test_a_sonar_mode_whose_beams_have_no_common_range_is_an_error() -> None:
    own: Any = sonars_of(SCOUT)
    uneven = (replace(own.sonars[0], range_m=1.0), *own.sonars[1:])
    modes = (SonarMode("uneven", uneven, own.board),)
    with pytest.raises(ValueError, match="sonar mode 'uneven'"):
        robot_text(SCOUT.with_device("sonar", replace(own, own_modes=modes)))


def test_a_changed_robot_is_written_and_so_is_its_world(tmp_path: Path) -> None:
    changed = replace(crs_cc.load_robot("scout", setup="noisy"), radius_m=0.25, name="wide")
    model = crs_cc.write_robot(changed, tmp_path / "wide.xml")
    assert crs_cc.load_robot(tmp_path / "wide.xml") == changed
    robots = (crs_cc.Robot("r", model, crs_cc.Pose(1.0, 1.0)),)
    world = crs_cc.WorldModel("hall", crs_cc.Area(0.0, 0.0, 3.0, 3.0), robots=robots)
    crs_cc.write_world(world, tmp_path / "hall.xml")
    assert crs_cc.load_world(tmp_path / "hall.xml") == world
