"""What operations make of a file that people have written, and when it is saved."""

from __future__ import annotations

import difflib
import math
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from crs_cc.builder.addresses import address, find, find_all
from crs_cc.builder.shapes import shapes
from crs_cc.builder.world_builder import WorldBuilder
from crs_cc.core.errors import WorldError
from crs_cc.sim.files.known_robots import ROBOTS
from crs_cc.sim.files.world_xml import examine, load_world
from crs_cc.sim.model.beacons import Light, Sound
from crs_cc.sim.model.world import Box, Cylinder, Pose, Robot, Wall

WORLDS = Path(__file__).parents[2] / "worlds"
FILES = sorted([*WORLDS.rglob("*.xml"), *ROBOTS.glob("*.xml")])
ROOM = """<?xml version="1.0" encoding="UTF-8"?>
<!-- A room. -->
<world version="1" name="room">
  <area length="6m" width="5m"/>

  <wall id="screen" x1="2.4m" y1="3.6m" x2="2.4m" y2="5m"   thickness='10cm'/>
  <box id="crate"  x="75in" y="1.2m" length="50cm" width="50cm"
       mass="2kg"/>
  <cylinder x="1.2m" y="3.2m" radius="20cm"/>

  <robot id="robot0" x="1m" y="1m" heading="45deg"><argument>a &lt; b</argument></robot>
  <goal id="there"><bring objects="crate" x="3m" y="3m" radius="1m"/></goal>
  <goal id="near"><approach object="cylinder0" distance="1m"/></goal>
</world>
"""


def changed(builder: WorldBuilder, before: str = ROOM) -> list[str]:
    """Return the lines that differ, as diff shows them."""
    rows = difflib.ndiff(before.splitlines(), builder.text.splitlines())
    return [row for row in rows if row[0] in "+-"]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_a_file_is_saved_as_it_was_and_one_number_changes_one_line(
    path: Path, tmp_path: Path
) -> None:
    text = path.read_bytes()
    builder = WorldBuilder(path)
    assert builder.document.text == text
    assert not builder.problems()
    node = next(
        node
        for node in builder.document.root.all()
        if any(re.fullmatch(r"[0-9.]+(m|in|cm|kg|s)", value) for value in node.attributes.values())
    )
    name, value = next(
        row for row in node.attributes.items() if re.fullmatch(r"[0-9.]+[a-z]+", row[1])
    )
    where = text[: node.value_at[name].begin].count(b"\n")
    copy = tmp_path / path.name
    copy.write_bytes(text)
    copied = WorldBuilder(copy)
    copied.set(address(node), {name: "7.5" + value.lstrip("0123456789.")})
    old, new = text.split(b"\n"), copied.document.text.split(b"\n")
    rows = enumerate(zip(old, new, strict=True))
    assert [row for row, pair in rows if pair[0] != pair[1]] == [where]
    copied.undo()
    assert copied.document.text == text
    assert not copied.is_changed


def test_moving_keeps_units_quotes_and_what_is_not_moved() -> None:
    builder = WorldBuilder(text=ROOM)
    builder.move(["screen", "crate"], x="10cm", y=0.5)
    assert changed(builder) == [
        """-   <wall id="screen" x1="2.4m" y1="3.6m" x2="2.4m" y2="5m"   thickness='10cm'/>""",
        """+   <wall id="screen" x1="2.5m" y1="4.1m" x2="2.5m" y2="5.5m"   thickness='10cm'/>""",
        '-   <box id="crate"  x="75in" y="1.2m" length="50cm" width="50cm"',
        '+   <box id="crate"  x="78.93701in" y="1.7m" length="50cm" width="50cm"',
    ]
    builder.undo()
    assert builder.text == ROOM


def test_turning_mirroring_and_placing() -> None:
    builder = WorldBuilder(text=ROOM)
    builder.turn("robot0", math.pi / 4)
    builder.turn(["cylinder0", "screen"], "90deg", x=0.0, y=0.0)
    builder.mirror("crate", at="2m")
    builder.mirror("robot0")
    builder.place("there", x="1m", y="2m")
    assert builder.get("robot0")["heading"] == "90deg"
    builder.place("robot0", x=2, heading="10deg")
    assert builder.get("robot0") == {"id": "robot0", "x": "2m", "y": "1m", "heading": "10deg"}
    assert builder.get("cylinder0") == {"x": "-3.2m", "y": "1.2m", "radius": "20cm"}
    ends = {name: builder.get("screen")[name] for name in ("x1", "y1", "x2", "y2")}
    assert ends == {"x1": "-3.6m", "y1": "2.4m", "x2": "-5m", "y2": "2.4m"}
    assert builder.get("crate")["x"] == "82.48031in"
    assert builder.get("there/bring")["x"] == "1m"


def test_new_elements_are_inserted_next_to_their_kind_and_have_ids() -> None:
    builder = WorldBuilder(text=ROOM)
    assert builder.add("wall", x1=0, y1=4, x2="1m", y2=4.25) == "wall1"
    assert (
        builder.add("ramp", {"x": 3, "y": 2, "length": 1, "width": 1, "to": 0.1}) == "surface/ramp"
    )
    assert (
        builder.add("ramp", {"x": 4, "y": 2, "length": 1, "width": 1, "to": 0.1})
        == "surface/ramp[1]"
    )
    assert builder.add("light", x=1, y=1) == "light0"
    assert builder.add("define", name="t", text="") == "define[t]"
    assert builder.add("box", into="define[t]", x=0, y=0, length=0.1, width=0.1) == "define[t]/box0"
    assert changed(builder) == [
        "+   <surface>",
        '+     <ramp x="3m" y="2m" length="1m" width="1m" to="0.1m"/>',
        '+     <ramp x="4m" y="2m" length="1m" width="1m" to="0.1m"/>',
        "+   </surface>",
        '+   <define name="t">',
        '+     <box id="box0" x="0m" y="0m" length="0.1m" width="0.1m"/>',
        "+   </define>",
        '+   <wall id="wall1" x1="0m" y1="4m" x2="1m" y2="4.25m"/>',
        '+   <light id="light0" x="1m" y="1m"/>',
    ]
    assert not builder.problems()


def test_things_of_a_model_are_added_as_they_would_be_written() -> None:
    builder = WorldBuilder(text=ROOM)
    model = builder.world().robots[0].model
    builder.add(Wall("w", 3.0, 1.0, 4.0, 1.0))
    builder.add(Box("b", Pose(5.0, 4.0, 0.5), 0.5, 0.25, mass_kg=2.0))
    builder.add(Cylinder("c", Pose(5.0, 2.0), 0.1))
    builder.add(Light("l", 1.0, 1.0, 50.0))
    builder.add(Sound("s", 1.0, 1.0, 50.0, 3))
    builder.add(Robot("r", model, Pose(4.0, 3.0), arguments=("-v", "a & b")))
    world = builder.world()
    assert world.walls[-1] == Wall("w", 3.0, 1.0, 4.0, 1.0)
    assert world.boxes[-1] == Box("b", Pose(5.0, 4.0, 0.5), 0.5, 0.25, mass_kg=2.0)
    assert world.robots[-1].arguments == ("-v", "a & b")
    assert (world.lights[0].id, world.sounds[0].id) == ("l", "s")
    while builder.undo():
        pass
    assert builder.text == ROOM


def test_sources_and_nests_are_shown_moved_and_scaled() -> None:
    places = '<nest x="1m" y="1m"/><source x="3m" y="1m" radius="20cm"/>'
    elements = f'<area length="4m" width="3m"/>{places}<robot x="2m" y="2m"/>'
    builder = WorldBuilder(text=f'<world version="1">{elements}</world>')
    builder.move(["nest0", "source0"], y=1)
    builder.scale("source0", 2)
    found = shapes(builder.document, builder.world())
    assert found["nest0"] == [{"kind": "nest", "x": 1.0, "y": 2.0, "radius": 0.3}]
    assert found["source0"] == [{"kind": "source", "x": 3.0, "y": 2.0, "radius": 0.4}]


def test_arrays_rings_lines_and_groups() -> None:
    builder = WorldBuilder(text=ROOM)
    assert builder.array("cylinder0", columns=2, rows=2, x="1m", y="-50cm") == [
        "cylinder1", "cylinder2", "cylinder3"
    ]  # fmt: skip
    assert builder.get("cylinder3") == {
        "id": "cylinder3", "x": "2.2m", "y": "2.7m", "radius": "20cm"
    }  # fmt: skip
    builder.align(["cylinder0", "cylinder3", "screen"], "left")
    assert [builder.get(name)["x"] for name in ("cylinder0", "cylinder3")] == ["1.2m", "1.2m"]
    assert builder.get("screen")["x1"] == "1.05m"
    builder.ring("crate", 4, x=3.0, y=2.5)
    builder.distribute(["cylinder0", "cylinder1", "robot0"], "x")
    assert float(builder.get("cylinder0")["x"][:-1]) == pytest.approx(1.6)
    with pytest.raises(ValueError, match="must be 1 to 10000"):
        builder.array("crate", columns=99_999_999)


def test_several_elements_are_found_as_each_of_them_is() -> None:
    root = WorldBuilder(text=ROOM.replace('id="crate"', 'id="world"')).document.root
    names = ["world", "cylinder0", "area", "cylinder0", ""]
    assert find_all(root, names) == [find(root, name) for name in names]
    with pytest.raises(ValueError, match="unknown element 'wall9'"):
        find_all(root, ["cylinder0", "wall9"])


def test_a_brush_changes_the_heights_that_it_reaches_and_no_others() -> None:
    builder = WorldBuilder.new(2, 1)
    builder.add("robot", x=1.7, y=0.5)
    builder.raise_ground([(0.5, 0.5)], radius=0.2, rise="10cm")
    made = builder.get("surface/heightmap")
    assert (made["resolution"], made["columns"]) == ("0.05m", "40")
    world = builder.world().surface.heightmap
    assert world is not None
    assert max(world.heights_m) == pytest.approx(0.1 * (1 - 2 * 0.025**2 / 0.2**2), abs=6e-4)
    assert sum(height > 0 for height in world.heights_m) == 52  # pixels within 20 cm
    builder.set("surface/heightmap", heights="10cm\t0 .2 0.1m  0 0", columns="3", resolution="1m")
    text = builder.text
    builder.raise_ground([(0.5, 0.5), (0.5, 0.6)], radius=0.3, rise=-2)
    assert builder.text == text.replace("0.1m  0 0", "0  0 0")
    builder.raise_ground([(2.5, 0.5)], radius=0.3, rise="1m")
    assert builder.text == text.replace("0.1m  0 0", "0  0 1")
    for wrong in ("1", "1,2 x,3", "", "1,2 " * 2001):
        with pytest.raises(ValueError, match=r"point|number|length"):
            builder.apply("raise", (), {"path": wrong})
    with pytest.raises(ValueError, match="radius"):
        builder.raise_ground([(0.5, 0.5)], radius=0)


def test_a_map_from_a_picture_gets_numbers_when_it_is_changed(tmp_path: Path) -> None:
    (tmp_path / "lib").mkdir()
    shutil.copy(WORLDS / "lib/climber.xml", tmp_path / "lib")
    shutil.copy(WORLDS / "hills.xml", tmp_path)
    shutil.copy(WORLDS / "hills.png", tmp_path)
    builder = WorldBuilder(tmp_path / "hills.xml")
    before = builder.world().surface.heightmap
    assert before is not None
    middle = before.x_m + before.columns / 2 * before.pixel_m
    builder.raise_ground([(middle, before.y_m + before.pixel_m)], radius=3 * before.pixel_m)
    after = builder.world().surface.heightmap
    assert after is not None
    assert "image" not in builder.get("surface/heightmap")
    changes = [new - old for new, old in zip(after.heights_m, before.heights_m, strict=True)]
    assert 0.03 < max(changes) < 0.051
    assert sum(abs(each) > 6e-4 for each in changes) < 40


def test_what_is_referred_to_by_a_default_id_keeps_it() -> None:
    small = '<cylinder x="5m" y="4m" radius="1cm"/>'
    text = ROOM.replace("<cylinder", f"{small}<cylinder", 1).replace("cylinder0", "cylinder1")
    builder = WorldBuilder(text=text)
    builder.remove("cylinder0")
    assert builder.names("cylinder") == ["cylinder1"]
    assert not builder.problems()


def test_a_new_world_finds_what_is_beside_the_file_in_which_it_will_be_saved(
    tmp_path: Path,
) -> None:
    """A program that is not there was a problem only after the world was saved."""
    path = tmp_path / "hall.xml"
    builder = WorldBuilder.new(4, 3, path=path)
    builder.add("robot", x=1, y=1, program="go.c")
    (problem,) = builder.problems()
    assert problem.text == "program 'go.c': no such file"
    assert problem.location.file == str(path)
    builder.set("robot0", x=2)
    (tmp_path / "go.c").touch()
    builder.undo()
    assert not builder.problems()
    assert builder.world().robots[0].program == str(tmp_path / "go.c")
    assert builder.world().name == "hall"
    assert builder.save() == path
    other = WorldBuilder.new(4, 3, path=path)
    other.add("robot", x=1, y=1)
    with pytest.raises(WorldError, match="exists"):
        other.save()


def test_references_follow_a_new_id() -> None:
    builder = WorldBuilder(text=ROOM)
    builder.set("crate", id="chest")
    builder.set("cylinder0", id="pillar")
    assert builder.get("there/bring")["objects"] == "chest"
    assert builder.get("near/approach")["object"] == "pillar"
    assert not builder.problems()
    with pytest.raises(ValueError, match="cannot have the same id"):
        builder.set(["chest", "pillar"], id="x")


def test_a_group_is_where_its_parts_were_and_moves_as_one_body() -> None:
    builder = WorldBuilder(text=ROOM.replace('\n       mass="2kg"', ""))
    builder.remove(["there", "near"])
    before = {solid.id: solid for solid in builder.world().solids()}
    assert builder.group(["crate", "cylinder0"], "table") == "table"
    after = {solid.id: solid for solid in builder.world().solids()}
    for old, new in (("crate", "table.crate"), ("cylinder0", "table.cylinder0")):
        one, other = before[old], after[new]
        assert not isinstance(one, Wall)
        assert not isinstance(other, Wall)
        assert one.pose.x_m == pytest.approx(other.pose.x_m, abs=1e-5)
        assert one.pose.y_m == pytest.approx(other.pose.y_m, abs=1e-5)
    builder.array("table", columns=2, x=2)
    assert builder.names("object") == ["table", "table-2"]
    builder.turn("table-2", "90deg")
    builder.set("define[table]/crate", width="10cm")
    assert len([box for box in builder.world().boxes if box.width_m == 0.1]) == 2
    builder.set("define[table]", name="desk")
    assert builder.get("table-2")["ref"] == "desk"
    assert builder.ungroup("table-2") == ["table-2-crate", "table-2-cylinder0"]
    one, other = after["table.crate"], builder.world().boxes[-1]
    assert not isinstance(one, Wall)
    assert other.id == "table-2-crate"
    assert other.pose.heading_rad == pytest.approx(one.pose.heading_rad + math.pi / 2)
    assert not builder.problems()


def test_elements_go_from_one_world_to_another_with_what_they_need() -> None:
    canteen = WorldBuilder(WORLDS / "canteen.xml")
    clip = canteen.cut(["p1", "curtain"])
    assert canteen.names("object") == ["p2", "p3", "p4", "p5"]
    assert canteen.undo() == "remove"
    builder = WorldBuilder(text=ROOM)
    assert builder.paste(clip, x=1, y=-1.0) == ["p1", "curtain"]
    assert builder.paste(clip, x=2, y=-1.0) == ["p2", "curtain-2"]
    assert builder.names("define") == [
        "define[leg]", "define[table]", "define[chair]", "define[place]"
    ]  # fmt: skip
    assert builder.names("material") == ["material[wood]", "material[steel]", "material[cloth]"]
    assert all("unknown" not in each.text for each in builder.problems())
    with pytest.raises(ValueError, match="not a copied part"):
        builder.paste("<world/>")
    with pytest.raises(WorldError, match="document type"):
        builder.paste('<!DOCTYPE clip [<!ENTITY a "b">]><clip>&a;</clip>')


def test_problems_are_those_of_crs_check() -> None:
    builder = WorldBuilder(text=ROOM)
    builder.set("crate", length="wide", material="felt")
    builder.place("robot0", x=2.4, y=4.0)
    texts = [each.render() for each in builder.problems()]
    assert texts[0].startswith("world:8: error: box, length: 'wide' is not a length")
    assert any("unknown material 'felt'" in text for text in texts)
    assert any("robot 'robot0' overlaps wall 'screen'" in text for text in texts)
    builder.set("crate", color="red")
    assert builder.problems()[0].hint == "did you mean 'colour'?"
    assert builder.visible() is None


@pytest.mark.parametrize(
    ("operation", "names", "values", "wrong"),
    [
        ("fly", ["crate"], {}, "unknown operation 'fly'"),
        ("move", ["crat"], {}, r"unknown element 'crat' .*; did you mean 'crate'\?"),
        ("move", ["crate"], {"x": "1kg"}, "x: '1kg' is not a length"),
        ("move", ["crate"], {"z": "1m"}, "unknown value of move 'z'"),
        ("move", ["near"], {"x": "1m"}, "near has no position"),
        ("turn", ["crate"], {}, "missing value 'angle'"),
        ("turn", ["crate"], {"angle": math.nan}, "nan is not an angle"),
        ("mirror", ["crate"], {"axis": "z"}, "unknown word 'z'"),
        ("ring", ["crate"], {"count": "-1", "x": 0, "y": 0}, "'-1' is not a whole number"),
        ("place", [], {}, "acts on one element, not 0"),
        ("remove", ["area"], {}, "<area> cannot be removed"),
        ("ungroup", ["crate"], {}, "crate is not an object"),
        ("group", ["robot0"], {"name": "t"}, "robot0 cannot be a part"),
        ("add", [], {"kind": "bx"}, "unknown element of <world> 'bx'"),
        ("text", ["robot0"], {"text": "x"}, "has elements"),
    ],
)
def test_invalid_operations_report_the_reason_and_have_no_effect(
    operation: str, names: list[str], values: dict[str, str | float | None], wrong: str
) -> None:
    builder = WorldBuilder(text=ROOM)
    with pytest.raises(ValueError, match=wrong):
        builder.apply(operation, names, values)
    assert builder.text == ROOM
    assert not builder.undo()


def both(builder: WorldBuilder) -> None:
    with builder.together("rearrange"):
        builder.move("crate", x=1)
        builder.remove("screen")


def test_several_changes_are_one_to_undo_or_none() -> None:
    builder = WorldBuilder(text=ROOM)
    both(builder)
    after = builder.text
    with pytest.raises(ValueError, match="screen"):
        both(builder)
    assert builder.text == after
    assert builder.undo() == "rearrange"
    assert builder.text == ROOM
    assert builder.redo() == "rearrange"
    assert builder.text == after


def test_robot_definitions_are_edited_as_well(tmp_path: Path) -> None:
    source = (ROBOTS / "scout.xml").read_bytes()
    path = tmp_path / "mine.xml"
    path.write_bytes(source)
    builder = WorldBuilder(path)
    builder.set("body", mass="30kg")
    builder.set_text("sensor[3]/position/range", "200in")
    builder.save()
    rows = zip(source.splitlines(), path.read_bytes().splitlines(), strict=True)
    assert sum(old != new for old, new in rows) == 2


# -- the file --------------------------------------------------------------------------------------


def test_a_file_is_saved_if_it_is_valid_and_unchanged_on_disk(tmp_path: Path) -> None:
    path = tmp_path / "room.xml"
    path.write_text(ROOM)
    path.chmod(0o640)
    builder, other = WorldBuilder(path), WorldBuilder(path)
    builder.move("robot0", x=5)
    with pytest.raises(WorldError, match="not completely inside the world"):
        builder.save()
    assert path.read_text() == ROOM
    builder.undo()
    builder.move("robot0", x=0.1)
    assert builder.is_changed
    builder.save()
    assert not builder.is_changed
    assert path.read_text() == builder.text
    assert path.stat().st_mode & 0o777 == 0o640
    other.move("robot0", y=0.1)
    with pytest.raises(WorldError, match="changed by another program"):
        other.save()
    other.save(tmp_path / "other.xml")
    assert load_world(tmp_path / "other.xml").robots[0].start.y_m == 1.1
    with pytest.raises(WorldError, match="exists already"):
        builder.save(tmp_path / "other.xml")
    path.unlink()
    builder.move("robot0", x=0.1)
    with pytest.raises(WorldError, match="has been removed"):
        builder.save()
    assert sorted(each.name for each in tmp_path.iterdir()) == ["other.xml"]


def test_a_link_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "real.xml").write_text(ROOM)
    (tmp_path / "link.xml").symlink_to("real.xml")
    builder = WorldBuilder(tmp_path / "link.xml")
    builder.move("robot0", x=0.1)
    builder.save()
    assert (tmp_path / "link.xml").is_symlink()
    assert (tmp_path / "real.xml").read_text() == builder.text


SAVER = """
import sys
from crs_cc.builder.shapes import shapes
from crs_cc.builder.world_builder import WorldBuilder
builder = WorldBuilder(sys.argv[1])
print("go", flush=True)
while True:
    builder.move("robot0", x=0.1)
    builder.save()
    builder.undo()
    builder.save()
"""


def test_a_killed_save_leaves_the_old_file_or_the_new_one(tmp_path: Path) -> None:
    path = tmp_path / "room.xml"
    path.write_text(ROOM)
    builder = WorldBuilder(path)
    builder.move("robot0", x=0.1)
    allowed = {ROOM, builder.text}
    for delay_s in (0.003, 0.0113, 0.0237, 0.0071):
        command = [sys.executable, "-c", SAVER, str(path)]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
            assert process.stdout is not None
            assert process.stdout.readline() == "go\n"
            time.sleep(delay_s)
            os.kill(process.pid, signal.SIGKILL)
        assert path.read_text() in allowed


# -- hostile files ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "wrong"),
    [
        (b"", "no element found"),
        (b"<world>", "no element found"),
        (b"<world><wall></world>", "mismatched tag"),
        (b"<!DOCTYPE world SYSTEM 'http://a/b'><world/>", "document type declaration"),
        (b"<!DOCTYPE w [<!ENTITY a 'aaaa'><!ENTITY b '&a;&a;'>]><w>&b;</w>", "document type"),
        (b"<world a='&b;'/>", "undefined entity"),
        (b"<a>" * 300 + b"</a>" * 300, "nested more than 256 deep"),
        ("<world/>".encode("utf-16"), "UTF-16 cannot be edited"),
        (b"<?xml version='1.0' encoding='koi8-r'?><world/>", "'koi8-r' cannot be edited"),
        (b"<world \xff='1'/>", "invalid token"),
        (b"<world>\0</world>", "invalid token"),
    ],
)
def test_what_is_no_world_is_refused_with_its_place(text: bytes, wrong: str) -> None:
    with pytest.raises(WorldError, match=wrong) as caught:
        WorldBuilder(text=text)
    assert caught.value.diagnostics[0].location.file == "world"


def test_other_encodings_and_characters_are_kept() -> None:
    text = '<?xml version="1.0" encoding="ISO-8859-1"?><world name="Küche" version="1"/>'
    builder = WorldBuilder(text=text.encode("latin-1"))
    builder.set("world", name='Küche "€" <\n')
    assert b'name="K\xfcche &quot;&#8364;&quot; &lt;&#10;"' in builder.document.text
    assert builder.get("world")["name"] == 'Küche "€" <\n'
    with pytest.raises(ValueError, match="not allowed in XML"):
        builder.set("world", name="\x01")


def test_values_never_end_their_attribute() -> None:
    builder = WorldBuilder(text=ROOM)
    builder.set("crate", colour="\"/><robot id='x'/>", heat="'\"&amp;")
    assert builder.get("crate")["colour"] == "\"/><robot id='x'/>"
    assert builder.get("crate")["heat"] == "'\"&amp;"
    with pytest.raises(ValueError, match="not a name"):
        builder.set("crate", {"a='1' b": "2"})
    with pytest.raises(ValueError, match="unknown element of <world>"):
        builder.add("box/><robot")


def test_examined_worlds_have_what_is_right_in_them() -> None:
    text = ROOM.replace('"50cm" width', '"x" width').encode()
    world, messages = examine(text, "room.xml", "room", None)
    assert world is not None
    assert len(messages) == 2
    assert messages[0].location.line == 8


def test_parts_are_aligned_by_their_sides_in_the_frame_of_their_definition() -> None:
    """Their centres were brought into line: what a part covers was not known."""
    builder = WorldBuilder.new(9, 9)
    builder.add("box", id="top", x=2, y=2, length=1, width=1)
    builder.add("cylinder", id="leg", x=2, y=3, radius="10cm")
    desk = builder.group(["top", "leg"], "desk")
    builder.turn(desk, "90deg")
    builder.move(desk, x="3m")
    parts = ["define[desk]/top", "define[desk]/leg"]
    builder.align(parts, "right")
    assert [builder.get(name)["x"] for name in parts] == ["0m", "0.4m"]
