"""Plans of other programs become worlds, and worlds become plans; hostile ones an error."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path

import pytest

from crs_cc.builder.importing.plan import read_plan
from crs_cc.builder.world_builder import WorldBuilder
from crs_cc.cli.main import main
from crs_cc.core.errors import WorldError
from crs_cc.sim.model.world import Wall

WORLDS = Path(__file__).parents[2] / "worlds"

FLAT = """<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://i" xmlns:xlink="http://x"
     width="600mm" height="400mm" viewBox="0 0 600 400">
  <title>A flat</title>
  <g inkscape:groupmode="layer" inkscape:label="brick walls" id="layer1"
     style="fill:none;stroke:#9c5a3c" transform="translate(0,100)">
    <line x1="0" y1="0" x2="300" y2="0"/>
    <path d="m 300 0 v 200 h-100"/>
    <polyline points="0,0 0,200 100,200"/>
    <path d="M 0 0 C 1 1 2 2 3 3"/>
  </g>
  <g id="wood" fill="steelblue">
    <rect x="400" y="50" width="100" height="60"/>
    <rect x="400" y="50" width="20" height="10" transform="rotate(90 400 50)"/>
    <polygon points="100,20 150,20 125,60"/>
    <circle cx="500" cy="300" r="25"/>
    <image xlink:href="http://example.org/x.png"/><use xlink:href="#a"/><text>Hi</text>
    <script>alert(1)</script>
  </g>
</svg>
"""
STAGE = """# Stage
include "pioneer.inc"
window ( size [ 600 400 ] )
define chunk model ( color "brown" size [ 1 0.5 0.5 ] gui_nose 0 )
define floorplan model ( color "gray30" obstacle_return 1 fiducial_return 0 )
floorplan ( name "cave" size [16 8 0.8] pose [0 0 0 0] bitmap "walls.png" )
floorplan ( name "lost" size [16 8 0.8] bitmap "../secret.png" )
chunk ( pose [ 3 -3 0 90 ] )
model ( size [2 2 1] pose [5 1 0 0]
  block ( points 3 point[0] [0 0] point[1] [1 0] point[2] [0 1] z [0 1] ) )
pioneer2dx ( name "r0" pose [ -3 0 0 45 ] sick_laser ( range 8 ) )
"""
SDF = """<sdf version="1.6"><world name="w"><physics/><light name="sun"/>
  <model name="shelf"><static>true</static><pose>1 2 0.5 0 0 1.5707963</pose><link name="l">
    <collision name="c"><geometry><box><size>2 0.4 1</size></box></geometry></collision>
    <collision name="d"><pose>0 0 0 0.5 0 0</pose><geometry><box><size>1 1 1</size></box></geometry>
    </collision></link></model>
  <model name="drum"><link name="l"><inertial><mass>12</mass></inertial>
    <collision name="c"><geometry><cylinder><radius>0.3</radius><length>0.9</length></cylinder>
    </geometry></collision></link></model>
  <model name="duck"><link name="l"><collision name="c"><geometry><mesh><uri>file:///etc/passwd</uri>
    </mesh></geometry></collision></link></model><include><uri>model://x</uri></include>
</world></sdf>
"""


def png(rows: list[str]) -> bytes:
    """Return a grey picture, `#` black."""
    raw = b"".join(b"\0" + bytes(0 if each == "#" else 255 for each in row) for row in rows)
    head = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    chunks = (b"IHDR", head), (b"IDAT", zlib.compress(raw)), (b"IEND", b"")
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        for kind, data in chunks
    )


def test_a_drawing_becomes_a_world_with_its_layers_as_materials(tmp_path: Path) -> None:
    (tmp_path / "flat.svg").write_text(FLAT)
    builder, left_out = WorldBuilder.from_plan(tmp_path / "flat.svg", scale=0.01, thickness=0.05)
    world = builder.world()
    assert left_out == [
        "1 of <image>", "1 of <path>: it has curves", "1 of <script>", "1 of <text>", "1 of <use>"
    ]  # fmt: skip
    assert [builder.get(name) for name in builder.names("material")] == [
        {"name": "brick-walls", "colour": "#9c5a3c"}, {"name": "wood", "colour": "#4682b4"}
    ]  # fmt: skip
    assert len(world.walls) == 5
    first = world.walls[0]
    assert (first.thickness_m, first.x2_m - first.x1_m, first.y2_m - first.y1_m) == pytest.approx(
        (0.05, 3.0, 0.0)
    )
    assert first.material.colour == (0x9C, 0x5A, 0x3C)
    assert [(box.length_m, box.width_m) for box in world.boxes] == [(1.0, 0.6), (0.2, 0.1)]
    assert world.boxes[0].pose.y_m - first.y1_m == pytest.approx(0.2)
    assert world.boxes[1].pose.heading_rad == pytest.approx(-1.5707963)
    assert world.cylinders[0].radius_m == pytest.approx(0.25)
    assert len(world.polygons) == 1
    assert len(world.robots) == 1
    builder.save(tmp_path / "flat.xml")


def test_physical_sizes_are_taken_and_others_need_a_scale(tmp_path: Path) -> None:
    path = tmp_path / "plan.svg"
    path.write_text(FLAT)
    names, _ = WorldBuilder(WORLDS / "empty.xml").import_plan(path)
    assert len(names) == 9
    path.write_text(FLAT.replace('width="600mm"', 'width="600"'))
    with pytest.raises(WorldError, match="no physical size: give the scale"):
        read_plan(path)
    (tmp_path / "plan.png").write_bytes(png(["##", "#."]))
    with pytest.raises(WorldError, match="the size of a pixel"):
        read_plan(tmp_path / "plan.png")
    builder, _ = WorldBuilder.from_plan(tmp_path / "plan.png", 1.5)
    sizes = [(box.length_m, box.width_m) for box in builder.world().boxes]
    assert sorted(sizes) == [(1.5, 1.5), (3.0, 1.5)]


def test_a_world_of_stage_becomes_a_world(tmp_path: Path) -> None:
    (tmp_path / "cave.world").write_text(STAGE)
    (tmp_path / "walls.png").write_bytes(png(["####", "#..#", "####"]))
    builder, left_out = WorldBuilder.from_plan(tmp_path / "cave.world")
    world = builder.world()
    assert left_out[0].startswith("1 of <bitmap>: ../secret.png: must be a relative path")
    assert left_out[1:] == ["1 of <window>"]
    assert (len(world.boxes), len(world.polygons), len(world.robots)) == (5, 1, 1)
    chunk, robot = world.boxes[-1], world.robots[0]
    assert (chunk.length_m, chunk.width_m) == (1.0, 0.5)
    assert chunk.pose.x_m - robot.start.x_m == pytest.approx(6.0)
    assert robot.start.heading_rad == pytest.approx(0.7853982)


def test_boxes_and_cylinders_of_sdf_go_both_ways(tmp_path: Path) -> None:
    (tmp_path / "w.sdf").write_text(SDF)
    builder, left_out = WorldBuilder.from_plan(tmp_path / "w.sdf")
    assert left_out == [
        "1 of <collision>: it does not stand upright", "1 of <include>", "1 of <light>",
        "1 of <mesh>",
    ]  # fmt: skip
    box, drum = builder.world().boxes[0], builder.world().cylinders[0]
    assert (box.length_m, box.width_m, box.height_m) == (2.0, 0.4, 1.0)
    assert (drum.radius_m, drum.height_m, drum.mass_kg) == (0.3, 0.9, 12.0)
    room = WorldBuilder(WORLDS / "room.xml")
    assert room.export(tmp_path / "room.sdf") == ["1 of robot"]
    again = read_plan(tmp_path / "room.sdf")
    before = [each for each in room.world().solids() if not isinstance(each, Wall)]
    boxes = [each for tag, each in again.elements if tag == "box" and "heading" in each]
    assert len(again.elements) == 4 + 1 + len(before)
    assert any(each["heading"].startswith("30") for each in boxes)
    assert any(each.get("mass") == "3kg" for _, each in again.elements)


def test_pictures_are_written(tmp_path: Path) -> None:
    slope = WorldBuilder(WORLDS / "slope.xml")
    assert slope.export(tmp_path / "slope.svg") == slope.export(tmp_path / "slope.png") == []
    assert b"robot0" in (tmp_path / "slope.svg").read_bytes()
    assert (tmp_path / "slope.png").read_bytes().startswith(b"\x89PNG")
    with pytest.raises(ValueError, match=r"unknown format '.jpg'"):
        slope.export(tmp_path / "slope.jpg")


def svg(inner: str) -> bytes:
    return f'<svg width="1m" viewBox="0 0 9 9" height="1m">{inner}</svg>'.encode()


@pytest.mark.parametrize(
    ("name", "content", "wrong"),
    [
        ("a.svg", b"<!DOCTYPE svg [<!ENTITY a 'b'>]><svg>&a;</svg>", "document type"),
        ("a.svg", b"<html/>", "must be <svg>"),
        ("a.svg", svg(""), "it is empty"),
        ("a.svg", svg("<g>" * 300 + "</g>" * 300), "nested more than 256"),
        ("a.svg", svg('<line x2="5" transform="scale(1e300)" stroke="red"/>'), "is larger than"),
        ("a.svg", svg('<line x2="5" transform="scale(nan)" stroke="red"/>'), "is larger than"),
        ("a.svg", svg('<path stroke="red" d="M 0 0' + " 1 1" * 300_000 + '"/>'), "too many points"),
        ("a.svg", svg('<polyline points="' + "1,2 " * 500_000 + '"/>'), "more than 200000 points"),
        ("a.svg", svg('<line x2="5" stroke="red"/>' * 10_001), "more than 10000 elements"),
        ("a.svg", svg('<line x2="5"/>'), "it cannot be seen"),
        ("a.png", b"GIF89a", "not a PNG file"),
        ("a.world", b"model ( " * 40, "nested more than 32"),
        ("a.world", b"model ( size [ 1 2", "a name is missing"),
        ("a.world", b"model ( size [ x 2 1 ] )", "could not convert"),
        ("a.world", b"model ( size [ nan 2 1 ] )", "not finite"),
        ("a.world", b"(" * 10, "unexpected '\\('"),
        ("a.sdf", SDF.replace("2 0.4 1", "inf 1 1").encode(), "not finite"),
        ("a.sdf", b"<world/>", "must be <sdf>"),
        ("a.dxf", b"", "unknown kind of plan '.dxf'"),
    ],
)  # fmt: skip
def test_hostile_plans_are_errors(name: str, content: bytes, wrong: str, tmp_path: Path) -> None:
    path = tmp_path / name
    path.write_bytes(content)
    with pytest.raises(WorldError, match=wrong):
        read_plan(path, 0.05 if name == "a.png" else None)


def test_the_command_imports_and_exports(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("flat.svg").write_text(FLAT)
    assert main(["world", "import", "flat.xml", "flat.svg", "--scale", "1cm"]) == 0
    said = capfd.readouterr().err
    assert said.startswith("13 elements in flat.xml\nleft out: 1 of <image>\n")
    assert main(["world", "import", "flat.xml", "flat.svg", "--x", "20m", "--y", "3m"]) == 0
    assert main(["world", "export", "flat.xml", "flat.sdf"]) == 0
    assert "left out: 2 of polygon\n" in capfd.readouterr().err
    assert main(["world", "export", "flat.xml", "flat.jpg"]) == 2
    assert main(["world", "import", "flat.xml", "flat.svg", "--scale", "big"]) == 2
    assert main(["world", "import", "flat.xml", "none.svg"]) == 122
    assert main(["check", "-q", "flat.xml"]) == 0
