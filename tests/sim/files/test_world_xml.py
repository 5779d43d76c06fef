"""World files: models that are read, and errors with their messages and locations."""

import math
import pickle
import re
from pathlib import Path

import numpy as np
import pytest
from lxml import etree

from crs_cc.core.errors import WorldError
from crs_cc.sim.devices.sonar.model import sonars_of
from crs_cc.sim.files.world_xml import (
    empty_world,
    known_robots,
    load_robot,
    load_world,
    parse_world,
)
from crs_cc.sim.files.xml_document import MAX_BYTES
from crs_cc.sim.geometry.scene import corners_m
from crs_cc.sim.model.world import Area, Box, Cylinder, Pose, Wall

WORLDS = sorted((Path(__file__).parents[3] / "worlds").glob("*.xml"))
SIM = Path(__file__).parents[3] / "crs_cc" / "sim"

AREA = '<area length="6m" width="5m"/>'
ROBOT = '<robot x="3m" y="2m"/>'
SCHEMA = etree.parse(SIM / "files" / "world.xsd")
ELEMENTS = SCHEMA.xpath(
    "//x:element[@name='world']//x:choice/x:element/@name",
    namespaces={"x": "http://www.w3.org/2001/XMLSchema"},
)


def lines(*rows: str, version: str = 'version="1"') -> bytes:
    """Return a world with the rows in lines 2, 3, ..."""
    return "\n".join([f"<world {version}>", *rows, "</world>"]).encode()


def messages_of(text: bytes) -> list[str]:
    with pytest.raises(WorldError) as caught:
        parse_world(text, "w.xml")
    return [message.render().splitlines()[0] for message in caught.value.diagnostics]


# -- what is read ------------------------------------------------------------------------------


@pytest.mark.parametrize("path", WORLDS, ids=lambda path: path.stem)
def test_bundled_worlds_are_valid(path):
    world = load_world(path)
    assert world.name == path.stem
    for robot in world.robots:
        name = robot.model.name
        assert name in known_robots() or [*path.parent.rglob(f"{name}.xml")]
    assert pickle.loads(pickle.dumps(world)) == world
    assert hash(load_world(path)) == hash(world)


def test_all_elements_are_read_with_their_units():
    world = parse_world(
        lines(
            '<area length="10ft" width="200cm" origin="centre" edge="50mm"/>',
            '<wall id="screen" x1="-10in" y1="0" x2="10in" y2="0.5m" thickness="5cm"/>',
            '<box id="crate" x="1m" y="0" heading="90" length="30cm" width="0.2" mass="2000g"/>',
            '<cylinder x="-1m" y="0m" radius="1e-1"/>',
            '<polygon points="1m,-50cm  1ft,-0.8 1m,-80cm" mass="1"/>',
            '<robot id="r" x="0" y="-0.5" heading="1.57rad">',
            "<argument> one two </argument><argument/></robot>",
            version='version="1" name="full" timestep="20ms"',
        ),
        "w.xml",
    )
    ten_feet_m = 10 * (12 * 0.0254)
    assert world.name == "full"
    assert world.timestep_s == 0.02
    assert world.area == Area(-0.5 * ten_feet_m, -1.0, ten_feet_m, 2.0, 0.05)
    assert world.walls == (Wall("screen", -0.254, 0.0, 0.254, 0.5, 0.05),)
    assert world.boxes == (Box("crate", Pose(1.0, 0.0, math.pi / 2), 0.3, 0.2, 2.0),)
    assert world.cylinders == (Cylinder("cylinder0", Pose(-1.0, 0.0), 0.1),)
    assert [polygon.id for polygon in world.polygons] == ["polygon0"]
    assert world.polygons[0].mass_kg == 1.0
    foot_m = 12 * 0.0254
    assert corners_m(world.polygons[0]) == pytest.approx(
        np.array([(1.0, -0.8), (1.0, -0.5), (foot_m, -0.8)])[[1, 2, 0]]
    )
    robot = world.robots[0]
    assert (robot.id, robot.start) == ("r", Pose(0.0, -0.5, 1.57))
    assert robot.arguments == ("one two", "")


def test_program_path_is_relative_to_the_world(tmp_path):
    (tmp_path / "wander.c").write_text("main() {}")
    path = tmp_path / "w.xml"
    path.write_bytes(lines(AREA, '<robot x="1" y="1" program="wander.c"/>'))
    assert load_world(path).robots[0].program == str(tmp_path / "wander.c")


def test_built_in_world_has_one_scout_at_the_origin():
    world = empty_world()
    assert [robot.start for robot in world.robots] == [Pose()]
    assert world.solids() == ()


def test_scout_matches_the_vendor_manual():
    scout = empty_world().robots[0].model
    assert [sonar.id for sonar in sonars_of(scout).sonars] == list(range(16))
    for sonar in sonars_of(scout).sonars:
        assert sonar.direction_rad == pytest.approx(math.radians(22.5) * sonar.id)
        assert math.hypot(sonar.x_m, sonar.y_m) == pytest.approx(scout.radius_m, abs=1e-6)
        bearing = math.atan2(sonar.y_m, sonar.x_m) % math.tau
        assert math.cos(bearing - sonar.direction_rad) == pytest.approx(1.0)
        assert math.degrees(sonar.half_angle_rad) == pytest.approx(10, abs=0.05)
    # RIGHT(trans, steer) of the vendor header: 0.118597 in for each degree, at each wheel.
    assert pytest.approx(math.pi * scout.drive.wheel_base_m, rel=1e-4) == 0.118597 * 0.0254 * 360


def test_definition_path_is_relative_to_the_world(tmp_path):
    text = (
        (SIM / "files" / "robots" / "scout.xml").read_text().replace('name="scout"', 'name="own"')
    )
    (tmp_path / "own.xml").write_text(text)
    path = tmp_path / "w.xml"
    path.write_bytes(lines(AREA, '<robot definition="own.xml" x="1" y="1"/>'))
    assert load_world(path).robots[0].model.name == "own"


def test_sensor_element_of_the_report_is_read(tmp_path):
    """The report's example: directions without a unit are in radians."""
    sensor = """<sensor><id>2</id><type>sonar</type><position>
      <x-relative>3.2</x-relative><y-relative>0</y-relative><z-relative>0</z-relative>
      <range>6</range><radius>0.1</radius><dir-relative>4.712388980</dir-relative>
    </position></sensor>"""
    path = tmp_path / "robot.xml"
    path.write_text(
        f"""<robot-definition version="1" name="r"><body radius="3.2" mass="1"/>
        <drive wheel-base="1" speed-limit="1" acceleration-limit="1" speed="1" acceleration="1"/>
        {sensor}</robot-definition>"""
    )
    (sonar,) = sonars_of(load_robot(path)).sonars
    assert (sonar.id, sonar.x_m, sonar.y_m, sonar.range_m, sonar.radius_m) == (2, 3.2, 0, 6, 0.1)
    assert math.degrees(sonar.direction_rad) == pytest.approx(270)


def test_every_built_in_definition_can_be_loaded():
    assert "scout" in known_robots()
    for name in known_robots():
        assert load_robot(SIM / "files" / "robots" / f"{name}.xml").name == name


# -- what is refused ---------------------------------------------------------------------------

EXPECTED = "expected " + " or ".join(f"<{name}>" for name in ["surface", *ELEMENTS])
CRATE = 'id="crate" y="2" length="50cm" width="50cm" mass="2kg"'
BROKEN = {
    "wrong element": (
        (AREA, "<wal/>", ROBOT),
        (f"w.xml:3: error: unexpected element <wal>; {EXPECTED}"),
    ),
    "polygon of too few corners": (
        (AREA, ROBOT, '<polygon points="1,1 2,1"/>'),
        "w.xml:4: error: polygon 'polygon0': fewer than 3 corners",
    ),
    "polygon whose sides cross": (
        (AREA, ROBOT, '<polygon id="bow" points="1,1 2,2 1,2 2,1"/>'),
        (
            "w.xml:4: error: polygon 'bow': "
            "the side from corner 1 to 2 meets the side from corner 3 to 4"
        ),
    ),
    "flat polygon": (
        (AREA, ROBOT, '<polygon points="1,1 2,1 3,1"/>'),
        (
            "w.xml:4: error: polygon 'polygon0': "
            "the side from corner 2 to 3 meets the side from corner 3 to 1"
        ),
    ),
    "polygon with a corner twice": (
        (AREA, ROBOT, '<polygon points="1,1 2,1 2,1 2,2"/>'),
        "w.xml:4: error: polygon 'polygon0': corners 2 and 3 are less than 1mm apart",
    ),
    "points in another form": (
        (AREA, ROBOT, '<polygon points="1, 1 2, 1"/>'),
        (
            "w.xml:4: error: polygon, points: "
            "expected x,y of each corner, separated by spaces: 1m,0 2m,0 2m,50cm"
        ),
    ),
    "points that are no lengths": (
        (AREA, ROBOT, '<polygon points="1,1 2,1 2,far"/>'),
        (
            "w.xml:4: error: polygon, points: 'far' is not a length "
            "(expected a number and one of m, cm, mm, in, ft, such as 1.5m)"
        ),
    ),
    "too many corners": (
        (AREA, ROBOT, f'<polygon points="{"1,1 " * 251}"/>'),
        "w.xml:4: error: polygon, points: more than 250 corners",
    ),
    "robot inside a polygon": (
        (AREA, ROBOT, '<polygon points="2.5,1.5 3.5,1.5 3.5,2.5 2.5,2.5"/>'),
        "w.xml:3: error: robot 'robot0' overlaps polygon 'polygon0'",
    ),
    "missing attribute": (
        (AREA, ROBOT, '<wall x1="1" y1="1" x2="2"/>'),
        "w.xml:4: error: missing attribute 'y2' in <wall>",
    ),
    "unknown attribute": (
        (AREA, '<robot x="1" y="1" weight="red"/>'),
        "w.xml:3: error: unknown attribute 'weight' in <robot>",
    ),
    "wrong element behind a robot": (
        (AREA, ROBOT, "<robto/>"),
        (f"w.xml:4: error: unexpected element <robto>; {EXPECTED}"),
    ),
    "no area": ((ROBOT,), "w.xml:2: error: unexpected element <robot>; expected <area>"),
    "nothing at all": ((), "w.xml:1: error: missing element in <world>; expected <area>"),
    "text between elements": (
        (AREA, "hello", ROBOT),
        "w.xml:1: error: text is not allowed in <world>",
    ),
    "wrong word": (
        ('<area length="6m" width="5m" origin="middle"/>', ROBOT),
        "w.xml:2: error: <area>: invalid value 'middle'; expected corner or centre",
    ),
    "no robot": ((AREA,), "w.xml:1: error: no robot in the world"),
    "unknown unit": (
        (AREA, '<robot x="3 furlongs" y="1"/>'),
        (
            "w.xml:3: error: robot, x: '3 furlongs' is not a length "
            "(expected a number and one of m, cm, mm, in, ft, such as 1.5m)"
        ),
    ),
    "unit of another kind": (
        (AREA, '<robot x="1" y="1" heading="1m"/>'),
        (
            "w.xml:3: error: robot, heading: '1m' is not an angle "
            "(expected a number and one of deg, rad, such as 90deg)"
        ),
    ),
    "not a number": (
        (AREA, '<robot x="nan" y="1"/>'),
        (
            "w.xml:3: error: robot, x: 'nan' is not a length "
            "(expected a number and one of m, cm, mm, in, ft, such as 1.5m)"
        ),
    ),
    "infinite": (
        (AREA, '<robot x="1e999" y="1"/>'),
        "w.xml:3: error: robot, x: '1e999' is too large for a length here",
    ),
    "huge": (
        ('<area length="1e6m" width="5m"/>', ROBOT),
        "w.xml:2: error: area, length: '1e6m' is too large for a length here",
    ),
    "negative size": (
        (AREA, ROBOT, '<box x="1" y="1" length="-1m" width="1m"/>'),
        "w.xml:4: error: box, length: '-1m' must be greater than 0",
    ),
    "zero size": (
        (AREA, ROBOT, '<cylinder x="1" y="1" radius="0"/>'),
        "w.xml:4: error: cylinder, radius: '0' must be greater than 0",
    ),
    "tiny size": (
        (AREA, ROBOT, '<cylinder x="1" y="1" radius="1e-9"/>'),
        "w.xml:4: error: cylinder, radius: must be 1mm or more",
    ),
    "no mass": (
        (AREA, ROBOT, '<cylinder x="1" y="1" radius="0.1" mass="0kg"/>'),
        "w.xml:4: error: cylinder, mass: '0kg' must be greater than 0",
    ),
    "wall without length": (
        (AREA, ROBOT, '<wall x1="1" y1="1" x2="1" y2="1"/>'),
        "w.xml:4: error: wall 'wall0' has zero length: both its ends are the same point",
    ),
    "duplicate id": (
        (AREA, '<robot id="r" x="1" y="1"/>', '<box id="r" x="3" y="3" length="1" width="1"/>'),
        "w.xml:4: error: duplicate id 'r' (first used in line 3)",
    ),
    "id that is no name": (
        (AREA, '<robot id="r 1" x="1" y="1"/>'),
        (
            "w.xml:3: error: invalid id 'r 1': "
            "must be 1 to 64 letters, digits, _ . -, and start with a letter or _"
        ),
    ),
    "id of an edge": (
        (AREA, '<robot id="edge-north" x="1" y="1"/>'),
        "w.xml:3: error: invalid id 'edge-north': the prefix edge- is reserved",
    ),
    "unknown definition": (
        (AREA, '<robot x="1" y="1" definition="scoot"/>'),
        (
            "w.xml:3: error: unknown robot definition 'scoot' "
            "(known: amigobot, nomad150, nomad200, pioneer2dx, scout)"
        ),
    ),
    "definition outside the folder": (
        (AREA, '<robot x="1" y="1" definition="../scout.xml"/>'),
        (
            "w.xml:3: error: unknown robot definition '../scout.xml' "
            "(known: amigobot, nomad150, nomad200, pioneer2dx, scout)"
        ),
    ),
    "program by an absolute path": (
        (AREA, '<robot x="1" y="1" program="/etc/x.c"/>'),
        ("w.xml:3: error: program '/etc/x.c': must be a relative path to a C file (.c)"),
    ),
    "program that is no C file": (
        (AREA, '<robot x="1" y="1" program="passwd"/>'),
        "w.xml:3: error: program 'passwd': must be a relative path to a C file (.c)",
    ),
    "robot outside": (
        (AREA, '<robot x="7" y="1"/>'),
        "w.xml:3: error: robot 'robot0' is not completely inside the world",
    ),
    "robot in the edge": (
        (AREA, '<robot x="0.1" y="1"/>'),
        "w.xml:3: error: robot 'robot0' is not completely inside the world",
    ),
    "robot in a wall": (
        (AREA, '<wall id="w" x1="2" y1="0" x2="2" y2="3"/>', '<robot x="2.2" y="1"/>'),
        "w.xml:4: error: robot 'robot0' overlaps wall 'w'",
    ),
    "robot in a turned box": (
        (
            AREA,
            '<robot x="2" y="1"/>',
            '<box id="b" x="3" y="1" heading="45" length="1.2" width="1.2"/>',
        ),
        "w.xml:3: error: robot 'robot0' overlaps box 'b'",
    ),
    "robot in the middle of a box": (
        (AREA, '<robot x="3" y="2"/>', '<box x="3" y="2" length="2" width="2"/>'),
        "w.xml:3: error: robot 'robot0' overlaps box 'box0'",
    ),
    "robot in a cylinder": (
        (AREA, '<robot x="3" y="2"/>', '<cylinder x="3" y="2.3" radius="0.1"/>'),
        "w.xml:3: error: robot 'robot0' overlaps cylinder 'cylinder0'",
    ),
    "robot in a robot": (
        (AREA, '<robot id="a" x="3" y="2"/>', '<robot id="b" x="3.4" y="2"/>'),
        "w.xml:4: error: robot 'b' overlaps robot 'a'",
    ),
}


BROKEN |= {
    "crate in a wall": (
        (AREA, ROBOT, '<wall id="w" x1="1" y1="1" x2="1" y2="4"/>', f'<box x="1.2" {CRATE}/>'),
        "w.xml:5: error: box 'crate' overlaps wall 'w'",
    ),
    "crate in the edge": (
        (AREA, ROBOT, f'<box x="0.2" {CRATE}/>'),
        "w.xml:4: error: box 'crate' overlaps wall 'edge-west'",
    ),
    "crate in a crate": (
        (
            AREA,
            ROBOT,
            f'<box x="1" {CRATE}/>',
            '<cylinder id="barrel" x="1.4" y="2" radius="20cm" mass="1kg"/>',
        ),
        "w.xml:5: error: cylinder 'barrel' overlaps box 'crate'",
    ),
    "crate in the middle of a polygon": (
        (
            AREA,
            ROBOT,
            '<polygon id="p" points="0.1,0.1 2,0.1 2,4 0.1,4"/>',
            f'<box x="1" {CRATE}/>',
        ),
        "w.xml:5: error: box 'crate' overlaps polygon 'p'",
    ),
}


@pytest.mark.parametrize("name", BROKEN)
def test_invalid_world_is_rejected_with_the_line(name):
    rows, expected = BROKEN[name]
    assert expected in messages_of(lines(*rows))


def test_invalid_world_shows_the_line_and_a_hint():
    with pytest.raises(WorldError) as caught:
        parse_world(lines(AREA, '  <robt x="1"/>'), "w.xml")
    assert str(caught.value).splitlines()[1:] == [
        '      <robt x="1"/>',
        "    hint: did you mean <robot>?",
    ]


def test_all_errors_are_reported_at_once():
    found = messages_of(
        lines(
            AREA,
            '<wall id="w" x1="2" y1="0" x2="2" y2="3" thickness="wide"/>',
            '<box id="b" x="4" y="2" length="0" width="1"/>',
            '<robot id="r" x="9" y="1"/>',
            '<robot id="r" x="1" y="1" definition="tank"/>',
            '<robot id="s" x="3" y="1" program="x.h"/>',
            '<robot id="t" x="3.1" y="1"/>',
        )
    )
    assert [(message.split(":")[1], message.split(": ")[2][:24]) for message in found] == [
        ("3", "wall, thickness"),
        ("4", "box, length"),
        ("5", "robot 'r' is not complet"),
        ("6", "duplicate id 'r' (first "),
        ("6", "unknown robot definition"),
        ("7", "program 'x.h'"),
        ("8", "robot 't' overlaps robot"),
    ]


def test_touching_objects_are_allowed():
    """Two crates and a barrel side by side at a wall, and another crate in the corner of an L."""
    world = parse_world(
        lines(
            AREA,
            ROBOT,
            '<box x="0.25" y="0.25" length="50cm" width="50cm" mass="2kg"/>',
            '<box x="0.75" y="0.25" length="50cm" width="50cm" mass="2kg"/>',
            '<cylinder x="1.2" y="0.2" radius="20cm" mass="2kg"/>',
            '<polygon points="4,4 6,4 6,5 5,5 5,4.5 4,4.5"/>',
            '<box x="4.75" y="4.75" length="50cm" width="50cm" mass="2kg"/>',
        ),
        "w",
    )
    assert len(world.boxes) == 3


def test_sensor_outside_of_the_body_is_rejected(tmp_path):
    scout = (SIM / "files" / "robots" / "scout.xml").read_text()
    (tmp_path / "r.xml").write_text(scout.replace('radius="', 'radius="0.0', 1))
    with pytest.raises(WorldError) as caught:
        load_robot(tmp_path / "r.xml")
    assert "sensor 0 is outside of the body" in str(caught.value)


def test_touching_robots_are_allowed():
    scout_m = 0.2032
    world = parse_world(
        lines(AREA, f'<robot x="{scout_m}" y="1"/>', f'<robot x="{3 * scout_m}" y="1"/>'), "w"
    )
    assert len(world.robots) == 2


def test_number_of_reported_errors_is_limited():
    found = messages_of(lines(AREA, *['<robot x="far" y="1"/>'] * 5000))
    assert len(found) == 101
    assert found[-1] == "w.xml: error: too many errors; the rest is not shown"


def test_number_of_reported_overlaps_is_limited():
    found = messages_of(lines(AREA, *['<robot x="1" y="1"/>'] * 5000))
    assert len(found) == 101
    assert found[-1] == "w.xml: error: too many errors; the rest is not shown"


BOMB = b"""<!DOCTYPE world [<!ENTITY a "aaaaaaaaaa">%s]>
<world version="1"><area length="&i;" width="5"/></world>""" % b"".join(
    b'<!ENTITY %c "%s">' % (name, b"&%c;" % (name - 1) * 10) for name in range(ord("b"), ord("z"))
)

HOSTILE = {
    "entity bomb": (BOMB, "a document type declaration is not allowed"),
    "entity bomb in text": (
        BOMB.replace(b"&i;", b"5").replace(b"</world>", b"&x;</world>"),
        "a document type declaration is not allowed",
    ),
    "external entity": (
        b'<!DOCTYPE world [<!ENTITY x SYSTEM "file:///etc/passwd">]>\n<world>&x;</world>',
        "a document type declaration is not allowed",
    ),
    "external document type": (
        b'<!DOCTYPE world SYSTEM "http://example.org/world.dtd"><world/>',
        "a document type declaration is not allowed",
    ),
    "harmless document type": (
        b"<!DOCTYPE world>" + lines(AREA, ROBOT), "a document type declaration is not allowed"
    ),
    "document type in UTF-16": (
        ("<!DOCTYPE world>" + lines(AREA, ROBOT).decode()).encode("utf-16"),
        "a document type declaration is not allowed",
    ),
    "deep nesting": (b"<a>" * 100_000, "not well-formed XML: Excessive depth"),
    "no XML": (b"#include <stdio.h>", "not well-formed XML"),
    "nothing": (b"", "not well-formed XML"),
    "null bytes": (b"\0" * 100, "not well-formed XML"),
    "unclosed": (b'<world version="1">', "not well-formed XML"),
    "another document": (b"<html/>", "the root element must be <world>, not <html>"),
    "too large": (b" " * (MAX_BYTES + 1), f"larger than {MAX_BYTES} bytes"),
    "long number": (
        lines(AREA, f'<robot x="{"9" * 100_000}" y="1"/>'), "is not a length"
    ),
    "long exponent": (lines(AREA, '<robot x="1e99999999" y="1"/>'), "is not a length"),
    "included file": (
        (b'<world version="1" xmlns:xi="http://www.w3.org/2001/XInclude">'
        b'<xi:include href="/etc/passwd" parse="text"/></world>'),
        "unexpected element <{http://www.w3.org/2001/XInclude}include>",
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_file_is_rejected_with_one_message(name):
    text, expected = HOSTILE[name]
    (message,) = messages_of(text)
    assert expected in message
    assert len(message) < 400


@pytest.mark.parametrize(
    ("row", "expected"),
    [
        ("<wall </world>", "w.xml:3:7: error: not well-formed XML: error parsing attribute name"),
        (
            "<wall></box>",
            "w.xml:3:13: error: not well-formed XML: Opening and ending tag mismatch: wall and box",
        ),
        ("<wall y='1' y='2'/>", "w.xml:3:18: error: not well-formed XML: Attribute y redefined"),
    ],
)
def test_syntax_error_has_its_position_once(row, expected):
    assert messages_of(lines(AREA, row)) == [expected]


def test_syntax_error_keeps_the_position_of_another_line():
    (message,) = messages_of(lines(AREA, "<wall>", "</box>"))
    assert message.endswith(
        "w.xml:4:7: error: not well-formed XML: Opening and ending tag mismatch: "
        "wall line 3 and box"
    )


def test_unreadable_file_is_rejected(tmp_path):
    large = tmp_path / "large.xml"
    with large.open("wb") as file:
        file.truncate(MAX_BYTES + 1)
    for path, expected in (
        (tmp_path / "missing.xml", "cannot be read: No such file or directory"),
        (tmp_path, "not a regular file"),
        (Path("/dev/zero"), "not a regular file"),
        (large, f"larger than {MAX_BYTES} bytes"),
        (Path("a\0b.xml"), "cannot be read: not a valid file name"),
        (tmp_path / ("x" * 5000), "cannot be read: File name too long"),
    ):
        with pytest.raises(WorldError, match=expected):
            load_world(path)


def test_missing_program_is_rejected(tmp_path):
    path = tmp_path / "w.xml"
    path.write_bytes(lines(AREA, f'<robot x="1" y="1" program="{"x" * 5000}.c"/>'))
    with pytest.raises(WorldError, match="no such file"):
        load_world(path)


def test_linked_robot_definition_is_rejected(tmp_path):
    (tmp_path / "own.xml").symlink_to(SIM / "files" / "robots" / "scout.xml")
    path = tmp_path / "w.xml"
    path.write_bytes(lines(AREA, '<robot definition="own.xml" x="1" y="1"/>'))
    with pytest.raises(WorldError, match="symbolic links are not allowed"):
        load_world(path)


def test_errors_in_a_robot_definition_name_its_file(tmp_path):
    text = (SIM / "files" / "robots" / "scout.xml").read_text()
    bad = text.replace('radius="8in"', 'radius="8"').replace('radius="8"', 'radius="-8in"')
    bad = bad.replace("<id>3</id>", "<id>2</id>").replace('name="VM"', 'name="FLY"')
    bad = bad.replace('switches="8"', 'switches="99"')
    (tmp_path / "own.xml").write_text(bad)
    path = tmp_path / "w.xml"
    path.write_bytes(lines(AREA, '<robot definition="own.xml" x="1" y="1"/>'))
    with pytest.raises(WorldError) as caught:
        load_world(path)
    own = tmp_path / "own.xml"
    found = [message.render().splitlines()[0] for message in caught.value.diagnostics]
    assert found[0] == f"{path}:3: error: robot definition 'own.xml' cannot be used"
    assert all(message.startswith(f"{own}:") for message in found[1:])
    told = "\n".join(found)
    for expected in ("duplicate sensor id 2", "body, radius", "unknown command 'FLY'",
                     "ring, switches: '99' is not an integer from 1 to 24",
                     "order: unknown sonar 3"):  # fmt: skip
        assert expected in told


@pytest.mark.parametrize("kind", ["length", "angle", "mass", "time"])
def test_schema_and_reader_have_the_same_units(kind):
    from crs_cc.core import quantity

    table = {"length": quantity.LENGTH, "angle": quantity.ANGLE, "mass": quantity.MASS,
             "time": quantity.TIME}  # fmt: skip
    schema = etree.parse(SIM / "files" / "world.xsd")
    space = {"xs": "http://www.w3.org/2001/XMLSchema"}
    (pattern,) = schema.xpath(
        f"//xs:simpleType[@name='{kind}']//xs:pattern/@value", namespaces=space
    )
    units = pattern.rsplit("(", 1)[1].split(")")[0].split("|")
    assert units == [name for name, _ in table[kind].units]


def test_program_outside_the_world_folder_is_rejected(tmp_path: Path) -> None:
    (tmp_path / "outside.c").write_text("int main(void) { return 0; }")
    folder = tmp_path / "worlds"
    folder.mkdir()
    (folder / "link.c").symlink_to(tmp_path / "outside.c")
    (folder / "round.c").symlink_to(folder / "round.c")
    for program in ("../outside.c", "link.c", "round.c"):
        text = f'''<world version="1"><area length="2m" width="2m"/>
        <robot x="1m" y="1m" program="{program}"/></world>'''
        (folder / "world.xml").write_text(text)
        with pytest.raises(WorldError, match="must be in the folder of this file"):
            load_world(folder / "world.xml")


# -- setups ------------------------------------------------------------------------------------


def test_setup_changes_only_its_own_attributes():
    ideal, noisy = empty_world().robots[0].model, empty_world("noisy").robots[0].model
    assert sonars_of(ideal).board.noise_m == 0
    assert sonars_of(noisy).board.noise_m > 0
    assert noisy.drive.wheel_base_m == ideal.drive.wheel_base_m
    assert empty_world("ideal") == empty_world()


def test_each_robot_can_have_its_own_setup():
    text = b"""<world version="1"><area length="9" width="9"/>
      <robot x="1" y="1"/><robot x="3" y="3" setup="noisy"/></world>"""
    quiet, noisy = (sonars_of(robot.model).board.noise_m for robot in parse_world(text, "w").robots)
    assert quiet == 0 < noisy
    quiet, noisy = (
        sonars_of(robot.model).board.noise_m for robot in parse_world(text, "w", "ideal").robots
    )
    assert quiet == noisy == 0


@pytest.mark.parametrize("robot", known_robots())
def test_every_built_in_setup_can_be_loaded(robot):
    path = SIM / "files" / "robots" / f"{robot}.xml"
    for setup in re.findall(r'<setup name="([^"]*)"', path.read_text()):
        assert load_robot(path, setup).name == robot


@pytest.mark.parametrize(
    ("attribute", "complaint"),
    [
        ('least-interval="1us"', "'1us' is not a time"),
        ('least-interval="0.1ms"', "must be 1ms or more"),
        ('least-interval="0s"', "greater than 0"),
        ('rate="256"', "0 to 255"),
        ('lobe="1e-200deg"', "0.01deg or more"),
        ('lobe="-1deg"', "must not be negative"),
        ('critical-angle="wide"', "not an angle"),
        ('dropouts="1.5"', "dropouts"),
        ('crosstalk="-1"', "crosstalk"),
        ('blind="much"', "not a length"),
    ],
)
def test_invalid_sonar_board_is_rejected(tmp_path, attribute, complaint):
    setup = f'<setup name="odd"><sonars {attribute}/></setup>'
    with pytest.raises(WorldError, match=complaint):
        load_robot(definition(tmp_path, setup), "odd")


def definition(tmp_path, setup):
    text = (SIM / "files" / "robots" / "scout.xml").read_text()
    path = tmp_path / "own.xml"
    path.write_text(text.replace("</robot-definition>", setup + "</robot-definition>"))
    return path


def test_every_misspelt_name_has_a_suggestion():
    rows = [
        AREA,
        '<robot x="1" y="1" haeding="90"/>',
        '<wal x1="0" y1="1m" x2="2m" y2="1m"/>',
        '<box x="4" y="4" lenght="1m" width="1m" taste="red"/>',
    ]
    with pytest.raises(WorldError) as caught:
        parse_world(lines(*rows), "w.xml")
    *meant, last = [(each.location.line, each.hint) for each in caught.value.diagnostics]
    assert meant == [
        (3, "did you mean 'heading'?"),
        (4, "did you mean <wall>?"),
        (5, "did you mean 'length'?"),
    ]
    assert last[0] == 5
    assert last[1].startswith("known attributes: id, x, y, heading, length, width, mass, ")


TURRET = '<turret speed-limit="1deg/s" acceleration-limit="1" speed="1" acceleration="1"/>'
STEERING = TURRET.replace("turret", "steering")


@pytest.mark.parametrize(
    ("drive", "complaint"),
    [
        (
            f'type="synchro">{TURRET}',
            "<steering> must be given for a synchro drive, and only for it",
        ),
        (
            f'wheel-base="1ft">{STEERING}',
            "<steering> must be given for a synchro drive, and only for it",
        ),
        (f'wheel-base="1ft">{TURRET}', "<turret> is only allowed for a synchro drive"),
        (">", "missing attribute 'wheel-base'"),
        ('type="hovering">', "hovering"),
        (f'type="synchro">{STEERING.replace("1deg/s", "1m/s")}', "is not an angular speed"),
        ('wheel-base="1ft" ws-timeout-zero="later">', "later"),
    ],
)
def test_invalid_drive_is_rejected(tmp_path, drive, complaint):
    limits = 'speed-limit="1m/s" acceleration-limit="1m/s2" speed="1m/s" acceleration="1m/s2" '
    (tmp_path / "own.xml").write_text(
        '<robot-definition version="1" name="own"><body radius="8in" mass="1kg"/>'
        f"<drive {limits}{drive}</drive></robot-definition>"
    )
    with pytest.raises(WorldError, match=complaint):
        load_robot(tmp_path / "own.xml")


@pytest.mark.parametrize(
    ("setup", "name", "complaint"),
    [
        ("", "loud", "unknown setup 'loud'"),
        ('<setup name="odd"><wings span="1m"/></setup>', "odd", "changes <wings>"),
        ('<setup name="odd"><drive wings="1m"/></setup>', "odd", "unknown attribute 'wings'"),
        ('<setup name="odd"><drive force="much"/></setup>', "odd", "'much' is not a force"),
        ('<setup name="odd"><setup name="noisy"/></setup>', "odd", "changes <setup>"),
    ],
)
def test_invalid_setup_is_rejected(tmp_path, setup, name, complaint):
    with pytest.raises(WorldError, match=complaint):
        load_robot(definition(tmp_path, setup), name)
