"""Worlds that are written are read again with equal values."""

from __future__ import annotations

import re
import shutil
from dataclasses import fields, replace
from pathlib import Path

import pytest

from crs_cc.core.errors import WorldError
from crs_cc.sim.files.world_writer import world_text
from crs_cc.sim.files.world_xml import empty_world, load_robot, load_world, parse_world
from crs_cc.sim.model.robot import Drive, RobotModel
from crs_cc.sim.model.world import Area, Box, Cylinder, Material, Polygon, Pose, Robot, WorldModel

ROOT = Path(__file__).parents[3]
WORLDS = sorted([*ROOT.glob("worlds/*.xml"), *ROOT.glob("samples/teaching/**/*.xml")])
ALL = b"""<world version="1" timestep="20ms" duration="90s" seed="7">
  <area length="9m" width="7m" origin="centre" edge="20cm" colour="silver"/>
  <surface><ramp x="3m" y="2m" length="1m" width="1m" to="10cm" heading="15deg"/>
    <plateau x="-3m" y="2m" length="1m" width="1m" height="5cm"/></surface>
  <define name="cart"><polygon id="top" points="0,0 50cm,0 50cm,30cm 0,33cm"/>
    <cylinder id="post" x="10cm" y="10cm" radius="5cm"/></define>
  <cylinder id="first" x="2m" y="-2m" radius="10cm" mass="1kg" heat="3" spread="2m"/>
  <object id="c1" ref="cart" x="1m" y="1m" heading="33deg" mass="7.3kg"/>
  <object id="c2" ref="cart" x="-1m" y="1m" heading="33deg"/>
  <polygon points="3m,-1m 3.7m,-1m 3.1m,0m" height="40cm"/>
  <box x="4m" y="3m" length="20cm" width="10cm" heading="-3deg" mass="1kg"/>
  <wall x1="-3m" y1="-3m" x2="-2m" y2="-3m" sonar="0.3"/>
  <robot id="r" x="0" y="0" heading="12.5deg" setup="noisy" join="2s" leave="60s" heat="5"
         program="p.c" dialect="nomad" colour="red"><argument>two words</argument></robot>
  <robot id="s" definition="nomad200" x="0" y="-2m"/>
  <light x="1m" y="1m" brightness="5"/><sound x="1m" y="2m" level="7" tone="3"/>
  <degradation robot="r" device="sonar" element="3" bias="5cm" onset="1s" duration="2s"/>
  <degradation robot="r" device="drive" element="left" gain="0.5" delay="1s"/>
  <degradation robot="r" device="sonar" stuck="hold" id="frozen"/>
  <degradation robot="s" device="compass" dead="yes" recovery="1s"/>
  <communication><channel name="radio" range="7m" loss="0.1"/>
    <channel name="light" walls="0" bandwidth="9600bit/s" queue="3" drop="oldest"/>
    <shut channel="light" from="r" at="1s" until="2s"/></communication>
  <goal id="g" name="There" points="2.5" robots="r" within="10s">
    <reach x="1m" y="2m" radius="30cm" stay="2s"/></goal>
  <goal id="near" after="g"><approach object="c2.post" distance="1m"/></goal>
  <goal id="round"><visit><place x="1m" y="1m" radius="1m"/></visit></goal>
  <goal id="clean"><no-collision except="first r" until="g"/></goal>
  <goal id="cold"><cool objects="first" heat="1"/></goal>
  <goal id="floor"><cover share="0.3" cell="25cm"/></goal>
  <goal id="push"><bring objects="first" x="1m" y="0" radius="1m"/></goal>
  <field name="trail" cell="10cm" evaporation="90s" diffusion="3cm2/s" saturation="50"/>
  <source x="1m" y="2m" radius="40cm" items="7" refill="1500ms"/><nest id="home" x="0" y="0"/>
  <goal id="behind"><follow target="s" least="1m" most="2m" share="0.9"/></goal>
</world>"""


@pytest.fixture(scope="module")
def copies(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("copies")
    for name in ("worlds", "samples"):
        shutil.copytree(ROOT / name, folder / name)
    return folder


@pytest.mark.parametrize("path", WORLDS, ids=lambda path: path.stem)
def test_a_written_world_is_read_again_with_equal_values(path: Path, copies: Path) -> None:
    path = copies / path.relative_to(ROOT)
    world = load_world(path)
    written = path.with_name("written.xml")
    written.write_bytes(world_text(world, path.parent))
    assert load_world(written) == world


def test_every_kind_of_element_is_written(tmp_path: Path) -> None:
    (tmp_path / "p.c").write_text("")
    world = parse_world(ALL, "all", folder=tmp_path)
    for field in fields(WorldModel):
        assert getattr(world, field.name) != field.default, f"{field.name} is missing in ALL"
    assert parse_world(world_text(world, tmp_path), "all", folder=tmp_path) == world


def test_a_world_made_in_python_is_written() -> None:
    scout = empty_world().robots[0].model
    world = WorldModel(
        "mine",
        Area(0.0, 0.0, 5.0, 4.0),
        boxes=(Box("crate", Pose(2.0, 2.0, 0.3), 0.4, 0.3, 5.0, material=Material((1, 2, 3))),),
        polygons=(replace(Polygon.of("wedge", [(3, 3), (4, 3), (4, 3.5)]), pose=Pose(1, 3, 0.7)),),
        robots=(Robot("a", scout, Pose(1.0, 1.0)),),
    )
    assert parse_world(world_text(world), "mine") == world


@pytest.mark.parametrize(
    ("heightmap", "expected"),
    [
        ('columns="2" heights="0 0 0"', "3 numbers (expected 2 to 128 rows of 2)"),
        ('columns="2" heights="0 0 0 x"', "heights: 'x' is not a length"),
        ('columns="2" heights="0 0 0 -1"', "heights: must be 0 to 100m"),
        ('columns="1" heights="0 0 0"', "columns: '1' is not an integer from 2 to 128"),
        ('height="1m"', "missing attribute 'image' in <heightmap> (or give heights)"),
        ('image="x.png"', "missing attribute 'height' in <heightmap> (or give heights)"),
    ],
)
def test_invalid_tables_of_heights_are_refused(heightmap: str, expected: str) -> None:
    text = f"""<world version="1"><area length="4m" width="4m"/>
      <surface><heightmap resolution="1m" {heightmap}/></surface><robot x="3m" y="3m"/></world>"""
    with pytest.raises(WorldError, match=re.escape(expected)):
        parse_world(text.encode(), "hills")


def test_rows_of_heights_begin_at_the_top() -> None:
    text = b"""<world version="1"><area length="4m" width="4m"/>
      <surface><heightmap resolution="1m" columns="2" heights="1 2  3 4"/></surface>
      <robot x="3m" y="3m"/></world>"""
    table = parse_world(text, "hills").surface.heightmap
    assert table is not None
    assert table.heights_m == (3.0, 4.0, 1.0, 2.0)


def test_points_of_a_polygon_may_have_a_frame() -> None:
    text = """<world version="1"><area length="9m" width="9m"/><robot x="8m" y="8m"/>
      <polygon points="0,0 1m,0 1m,1m 0,1m" x="3m" y="2m" heading="90deg"/></world>"""
    (polygon,) = parse_world(text.encode(), "x").polygons
    assert (polygon.pose.x_m, polygon.pose.y_m) == pytest.approx((2.5, 2.5))


def test_what_cannot_be_written_is_an_error() -> None:
    world = empty_world()
    (robot,) = world.robots
    other = replace(robot, model=replace(robot.model, radius_m=0.3))
    with pytest.raises(ValueError, match="not that of its definition 'scout'"):
        world_text(replace(world, robots=(other,)))
    made = replace(robot, model=RobotModel("mine", 0.2, Drive(0.3)))
    with pytest.raises(ValueError, match="is from no definition"):
        world_text(replace(world, robots=(made,)))
    with pytest.raises(ValueError, match="its area would be read differently"):
        world_text(replace(world, area=replace(world.area, x_min_m=-1.0)))
    with pytest.raises(ValueError, match="not in the folder"):
        world_text(replace(world, robots=(replace(robot, program="/x.c"),)), Path("worlds"))
    apart = [
        Cylinder("t.a", Pose(1.0, 1.0), 0.1, 1.0, part_of="t"),
        Cylinder("b", Pose(2.0, 1.0), 0.1, 1.0),
        Cylinder("t.c", Pose(3.0, 1.0), 0.1, 1.0, part_of="t"),
    ]
    with pytest.raises(ValueError, match="'b' and 't' are mixed"):
        world_text(replace(world, cylinders=tuple(apart)))


def test_an_invalid_world_is_refused() -> None:
    world = empty_world()
    (robot,) = world.robots
    with pytest.raises(WorldError, match="overlap"):
        world_text(replace(world, robots=(robot, replace(robot, id="second"))))
    with pytest.raises(WorldError, match="invalid id"):
        world_text(replace(world, robots=(replace(robot, id="1"),)))


def test_a_definition_of_a_file_is_written_as_its_path(copies: Path) -> None:
    model = load_robot(copies / "worlds" / "lib" / "seer.xml")
    world = replace(empty_world(), robots=(Robot("s", model),))
    assert b'definition="lib/seer.xml"' in world_text(world, copies / "worlds")
