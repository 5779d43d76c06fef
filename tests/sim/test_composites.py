"""Objects put together from simple ones, here and in other files."""

from __future__ import annotations

import math
from pathlib import Path

import pytest

from crs_cc.core.errors import WorldError
from crs_cc.sim.files.world_xml import load_world, parse_world
from crs_cc.sim.model.world import Pose, WorldModel

LEG = '<define name="leg"><cylinder id="post" x="0" y="0" radius="2cm" heat="1"/></define>'
TABLE = """<define name="table"><box id="top" x="0" y="0" length="1m" width="60cm"/>
<object ref="leg" id="leg0" x="-40cm" y="20cm"/><wall x1="0" y1="0" x2="1" y2="0"/>
<polygon points="0,0 1,0 0,1"/></define>"""


def world(*rows: str) -> WorldModel:
    return parse_world(text(*rows), "w.xml")


def text(*rows: str) -> bytes:
    body = "\n".join(rows)
    return f"""<world version="1"><area length="9m" width="9m"/>
<robot x="1" y="1"/>
{body}</world>""".encode()


def messages(*rows: str) -> list[str]:
    with pytest.raises(WorldError) as caught:
        world(*rows)
    return [message.render().splitlines()[0] for message in caught.value.diagnostics]


def test_object_is_placed_with_its_parts():
    """A table turned by 90 degrees: what was 40 cm behind its centre is below it."""
    room = world(TABLE, LEG, '<object ref="table" id="t1" x="5m" y="4m" heading="90deg"/>')
    assert [solid.id for solid in room.solids()[4:]] == [
        "t1.wall0", "t1.top", "t1.leg0.post", "t1.polygon0",
    ]  # fmt: skip
    (post,), (top,), (wall,) = room.cylinders, room.boxes, room.walls
    assert (post.pose.x_m, post.pose.y_m) == pytest.approx((5 - 0.2, 4 - 0.4))
    assert post.heat == 1.0
    assert top.pose == Pose(5.0, 4.0, math.pi / 2)
    assert (wall.x2_m, wall.y2_m) == pytest.approx((5.0, 5.0))


def test_definition_can_be_used_repeatedly():
    rows = [f'<object ref="leg" x="{n}" y="5"/>' for n in range(2, 5)]
    room = world(LEG, *rows)
    assert [leg.id for leg in room.cylinders] == [f"object{n}.post" for n in range(3)]
    assert [leg.pose.x_m for leg in room.cylinders] == [2, 3, 4]


@pytest.mark.parametrize(
    ("rows", "expected"),
    [
        (
            ['<object ref="tabel" x="5" y="5"/>'],
            "3: error: object, ref: unknown definition 'tabel' (known: none)",
        ),
        ([LEG, LEG], "4: error: duplicate definition 'leg' (first defined in line 3)"),
        (
            [
                '<define name="a"><object ref="b" x="0" y="0"/></define>',
                '<define name="b"><object ref="a" x="0" y="0"/></define>',
            ],
            "4: error: 'a' contains itself: a in b in a",
        ),
        (
            ['<define name="a"><object ref="a" x="0" y="0"/></define>'],
            "3: error: 'a' contains itself: a in a",
        ),
        (
            ['<define name="a"><box x="0" y="0" length="1" width="-1"/></define>'],
            "3: error: box, width: '-1' must be greater than 0",
        ),
        (
            [
                '<define name="a"><box id="b" x="0" y="0" length="1" width="1"/>',
                '<box id="b" x="0" y="0" length="1" width="1"/></define>',
            ],
            "4: error: duplicate id 'b' (first used in line 3)",
        ),
        (
            [
                LEG,
                '<object ref="leg" id="t" x="5" y="5"/><robot id="t.post" x="7" y="5"/>',
            ],
            "4: error: duplicate id 't.post'",
        ),
        (
            [LEG, f'<object ref="leg" id="{"t" * 60}" x="5" y="5"/>'],
            f"4: error: the id '{'t' * 60}.post' of a part is longer than 64 characters",
        ),
        (
            ['<define name="a"><box x="0" y="0" length="1" width="1" mass="1"/></define>'],
            "3: error: box, mass: not allowed on a part of an object",
        ),
        (
            [LEG, '<object ref="leg" x="1" y="1"/>'],
            "2: error: robot 'robot0' overlaps cylinder 'object0.post'",
        ),
    ],
)
def test_errors_are_reported_at_their_line(rows: list[str], expected: str):
    assert messages(*rows) == [f"w.xml:{expected}"]


@pytest.mark.parametrize("order", [1, -1])
def test_nesting_of_definitions_is_limited(order: int):
    deep = [f'<define name="d{n}"><object ref="d{n + 1}" x="0" y="0"/></define>' for n in range(30)]
    deep.append('<define name="d30"><wall x1="0" y1="0" x2="1" y2="0"/></define>')
    assert any("more than 8 deep" in message for message in messages(*deep[::order]))


def test_expansion_of_definitions_is_limited():
    """Ten of ten of ten of ten: 10,000 walls from 40 lines."""
    rows = ['<define name="d0"><wall x1="0" y1="0" x2="1" y2="0"/></define>']
    for n in range(1, 8):
        inner = "".join(f'<object ref="d{n - 1}" x="{m}" y="0"/>' for m in range(10))
        rows.append(f'<define name="d{n}">{inner}</define>')
    found = messages(*rows, '<object ref="d7" x="0" y="0"/>')
    assert found == ["w.xml:6: error: 'd3' has more than 250 parts"]


# -- other files -----------------------------------------------------------------------------------


def put(path: Path, *rows: str) -> None:
    path.parent.mkdir(exist_ok=True)
    path.write_text("\n".join(['<definitions version="1">', *rows, "</definitions>"]))


def load(folder: Path, *rows: str) -> WorldModel:
    (folder / "w.xml").write_bytes(text(*rows))
    return load_world(folder / "w.xml")


def told(folder: Path, *rows: str) -> list[str]:
    with pytest.raises(WorldError) as caught:
        load(folder, *rows)
    found = (message.render().splitlines()[0] for message in caught.value.diagnostics)
    return [message.replace(f"{folder}/", "") for message in found]


def test_definitions_and_materials_come_from_other_files(tmp_path: Path):
    wood = '<material name="wood" colour="brown"/>'
    put(tmp_path / "lib" / "materials.xml", wood)
    include = '<include file="materials.xml"/>'
    put(tmp_path / "lib" / "furniture.xml", include, LEG, TABLE)
    put(tmp_path / "lib" / "more.xml", include, '<material name="oak" material="wood"/>')
    room = load(
        tmp_path,
        '<include file="lib/furniture.xml"/><include file="lib/more.xml"/>',
        '<object ref="table" x="5" y="5"/><wall x1="1" y1="5" x2="2" y2="5" material="oak"/>',
    )
    assert len(room.solids()) == 4 + 5
    (wall,) = (wall for wall in room.walls if wall.id == "wall0")
    assert wall.material.colour == (165, 42, 42)


def test_errors_in_included_files_name_the_file(tmp_path: Path):
    put(
        tmp_path / "f.xml",
        '<define name="a"><cylinder x="0" y="0" radius="-1"/></define>',
        '<material name="m" sonar="7"/>',
    )
    assert told(tmp_path, '<include file="f.xml"/>', '<object ref="b" x="5" y="5"/>') == [
        "f.xml:3: error: material, sonar: '7' must be from 0 to 1",
        "f.xml:2: error: cylinder, radius: '-1' must be greater than 0",
        "w.xml:4: error: object, ref: unknown definition 'b' (known: a)",
    ]
    put(tmp_path / "f.xml", "<wal/>")
    first, second = told(tmp_path, '<include file="f.xml"/>')
    assert first == "w.xml:3: error: 'f.xml' cannot be included"
    assert second.startswith("f.xml:2: error: unexpected element <wal>")


def test_mutual_includes_are_refused(tmp_path: Path):
    put(tmp_path / "a.xml", '<include file="b.xml"/>')
    put(tmp_path / "b.xml", '<include file="./a.xml"/>')
    assert told(tmp_path, '<include file="a.xml"/>') == [
        "b.xml:2: error: './a.xml' includes itself: a.xml in b.xml in a.xml"
    ]
    put(tmp_path / "c.xml", *[f'<include file="d{n}.xml"/>' for n in range(99)])
    for number in range(99):
        put(tmp_path / f"d{number}.xml")
    assert set(told(tmp_path, '<include file="c.xml"/>')) == {
        f"c.xml:{line}: error: more than 32 included files" for line in range(33, 101)
    }
    for number in range(20):
        put(tmp_path / f"e{number}.xml", f'<include file="e{number + 1}.xml"/>')
    assert told(tmp_path, '<include file="e0.xml"/>') == [
        "e7.xml:2: error: includes are nested more than 8 deep"
    ]


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("../f.xml", "must be a relative path to a file (.xml) in the world's folder or below"),
        ("/etc/f.xml", "must be a relative path to a file (.xml) in the world's folder or below"),
        ("link.xml", "symbolic links are not allowed"),
        ("lib/f.xml", "symbolic links are not allowed"),
        ("none.xml", "no such file"),
        ("w.xml", "the root element must be <definitions>, not <world>"),
    ],
)
def test_includes_are_restricted_to_folder_of_world(tmp_path: Path, name: str, reason: str):
    put(tmp_path / "outside" / "f.xml", LEG)
    folder = tmp_path / "world"
    folder.mkdir()
    (folder / "link.xml").symlink_to(tmp_path / "outside" / "f.xml")
    (folder / "lib").symlink_to(tmp_path / "outside")
    first, *more = told(folder, f'<include file="{name}"/>')
    assert first.startswith("w.xml:3: error: ")
    assert reason in (more or [first])[0]


def test_world_without_file_cannot_include():
    assert messages('<include file="f.xml"/>') == [
        "w.xml:3: error: include: only allowed in a world that is read from a file"
    ]
