"""Parts of robots that are moved in their definitions."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from crs_cc.builder.robot_shapes import robot_shapes
from crs_cc.builder.world_builder import WorldBuilder

WORLDS = Path(__file__).parents[2] / "worlds"
ROBOT = """<robot-definition version="1" name="rover">
  <body radius="1ft" mass="9kg"/>
  <drive wheel-base="40cm" speed-limit="1m/s" acceleration-limit="1m/s2" speed="1m/s"
         acceleration="1m/s2"/>
  <odometry/>
  <camera forward="10cm" direction="30deg"/>
  <laser field-of-view="90deg" range="2m"/>
  <arm x="5cm"/>
  <sonars order="0"/>
  <sensor>
    <id>0</id><type>sonar</type>
    <position>
      <x-relative>.5ft</x-relative><y-relative>0</y-relative><z-relative>20cm</z-relative>
      <range>3m</range><radius>1m</radius><dir-relative>0.5</dir-relative>
    </position>
  </sensor>
</robot-definition>
"""


def leaves(builder: WorldBuilder) -> dict[str, str]:
    return {node.tag: node.text for node in builder.element("sensor/position").children}


def test_a_sensor_is_moved_in_its_own_units_and_bare_directions_stay_radians() -> None:
    builder = WorldBuilder(text=ROBOT)
    assert not builder.problems()
    builder.move("sensor", x="-3.048cm", y="10cm")
    found = leaves(builder)
    assert (found["x-relative"], found["y-relative"]) == ("0.4ft", "10cm")
    assert found["dir-relative"] == "0.5"
    builder.undo()
    builder.turn("sensor", "90deg")
    assert leaves(builder)["dir-relative"] == "2.0707963"
    assert leaves(builder)["x-relative"] == ".5ft"
    builder.turn("sensor", "90deg", x=0, y=0)
    assert leaves(builder)["y-relative"] == "15.24cm"
    assert not builder.problems()


def test_cameras_lasers_and_arms_are_moved_by_their_attributes() -> None:
    builder = WorldBuilder(text=ROBOT)
    builder.move(["camera", "laser", "arm"], x="5cm", y="1cm")
    assert builder.get("camera") == {"forward": "15cm", "left": "1cm", "direction": "30deg"}
    assert builder.get("laser")["forward"] == "0.05m"
    assert builder.get("arm") == {"x": "10cm", "y": "1cm"}
    builder.turn("camera", "-10deg")
    assert builder.get("camera")["direction"] == "20deg"
    with pytest.raises(ValueError, match="body has no position"):
        builder.move("body", x=1)
    assert not builder.problems()


def test_a_camera_without_a_direction_gets_one_when_it_is_turned() -> None:
    """It was a KeyError."""
    builder = WorldBuilder(text=ROBOT.replace(' direction="30deg"', ""))
    builder.turn("camera", "40deg")
    assert builder.get("camera")["direction"] == "40deg"


def test_a_robot_has_shapes_as_far_as_its_numbers_are_valid() -> None:
    builder = WorldBuilder(text=ROBOT)
    shapes = robot_shapes(builder.document)
    assert list(shapes) == ["body", "drive", "camera", "laser", "arm", "sensor"]
    assert [shape["kind"] for shape in shapes["drive"]] == ["wheel", "wheel"]
    assert [shape["kind"] for shape in shapes["sensor"]] == ["beam", "sensor"]
    builder.set_text("sensor/position/range", "far")
    builder.set("body", radius="")
    assert "sensor" not in robot_shapes(builder.document)
    assert robot_shapes(builder.document)["body"][0]["radius"] == 0.2


def test_new_devices_and_sensors_are_inserted_in_schema_order() -> None:
    builder = WorldBuilder(WORLDS / "lib" / "climber.xml")
    assert builder.add("compass") == "compass"
    tags = [node.tag for node in builder.document.root.children]
    assert tags.index("compass") == tags.index("link") - 1
    builder.add("setup", name="noisy")
    builder.add("sensor")
    tags = [node.tag for node in builder.document.root.children]
    assert tags[-2:] == ["sensor", "setup"]


def test_copies_of_a_sonar_do_not_repeat_references_to_the_original() -> None:
    """Each of a ring was said to be in front."""
    text = ROBOT.replace("<id>0</id>", "<!-- a --> <id>0</id><!-- in front -->")
    text = text.replace("    <position>\n", "    <!-- of\n    two lines -->\n    <position>\n")
    builder = WorldBuilder(text=text)
    builder.ring("sensor", 2)
    assert not builder.problems()
    before, _, copy = builder.text.rpartition("  <sensor>")
    assert text.startswith(before.rpartition("</sensor>")[0].replace('"0 1"', '"0"'))
    assert copy.splitlines()[1:3] == ["    <id>1</id><type>sonar</type>", "    <position>"]


def test_sonars_go_around_the_robot_with_numbers_of_their_own() -> None:
    builder = WorldBuilder(text=ROBOT)
    assert builder.ring("sensor", 8) == [f"sensor[{number}]" for number in range(1, 8)]
    assert not builder.problems()
    assert builder.element("sonars").attributes["order"] == "0 1 2 3 4 5 6 7"
    ids = [builder.element(f"sensor[{number}]/id").text for number in range(8)]
    assert ids == [str(number) for number in range(8)]
    poses = [shape[1] for name, shape in robot_shapes(builder.document).items() if "sensor" in name]
    for number, pose in enumerate(poses):
        angle = 0.5 + math.tau * number / 8
        assert math.isclose(pose["x"], 0.1524 * math.cos(angle - 0.5), abs_tol=1e-5)
        assert math.isclose(math.remainder(pose["heading"] - angle, math.tau), 0, abs_tol=1e-5)
    with pytest.raises(ValueError, match=r"17 sonars are too many \(maximum: 16\)"):
        builder.array("sensor[7]", columns=10, x="1cm")
    builder.undo()
    assert builder.text == ROBOT
    with pytest.raises(ValueError, match="a ring needs the x and y of its centre"):
        builder.ring("camera", 8)
