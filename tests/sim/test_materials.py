"""Materials of objects in a world file: by name, and by attributes of the objects."""

from __future__ import annotations

import math

import pytest

from crs_cc.core.errors import WorldError
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.model.world import PLAIN, TALL_M, Material, WorldModel

WOOD = '<material name="wood" colour="brown" sonar="0.9" infrared="0.25"/>'


def world(*rows: str) -> WorldModel:
    text = "\n".join(
        ['<world version="1">', '<area length="9m" width="9m"/>', *rows, '<robot x="1" y="1"/>']
    )
    return parse_world(f"{text}</world>".encode(), "w.xml")


def complaint(*rows: str) -> str:
    with pytest.raises(WorldError) as caught:
        world(*rows)
    (message,) = caught.value.diagnostics
    return message.render().splitlines()[0]


def test_default_object_is_plain_and_tall():
    (box,) = world('<box x="5" y="5" length="1" width="1"/>').boxes
    assert (box.material, box.heat, box.height_m) == (PLAIN, 0.0, TALL_M)


@pytest.mark.parametrize(
    "obj",
    [
        '<wall x1="5" y1="5" x2="6" y2="5" {}/>',
        '<box x="5" y="5" length="1" width="1" {}/>',
        '<cylinder x="5" y="5" radius="1" {}/>',
        '<polygon points="5,5 6,5 6,6" {}/>',
    ],
)
def test_every_solid_has_material_heat_and_height(obj: str):
    attributes = 'colour="#0a141E" sonar=".5" infrared="1" heat="2.5" height="18in"'
    *_, solid = world(obj.format(attributes)).solids()
    assert solid.material == Material((10, 20, 30), 0.5, 1.0)
    assert solid.heat == 2.5
    assert math.isclose(solid.height_m, 18 * 0.0254)


def test_attributes_of_object_override_its_material():
    (door,) = world(WOOD, '<box x="5" y="5" length="1" width="1" material="wood" sonar="0"/>').boxes
    assert door.material == Material((165, 42, 42), 0.0, 0.25)


def test_material_may_extend_previous_one():
    oak = '<material name="oak" material="wood" colour="#8b5a2b"/>'
    (door,) = world(WOOD, oak, '<box x="5" y="5" length="1" width="1" material="oak"/>').boxes
    assert door.material == Material((139, 90, 43), 0.9, 0.25)
    assert (
        complaint(oak, WOOD)
        == "w.xml:3: error: material, material: unknown material 'wood' (known: none)"
    )


def test_edges_and_robots_have_material():
    text = f"""<world version="1"><area length="9m" width="9m" material="wood"/>{WOOD}
        <robot x="1" y="1" colour="lime"/></world>"""
    room = parse_world(text.encode(), "w.xml")
    assert {wall.material.colour for wall in room.edge_walls()} == {(165, 42, 42)}
    assert room.robots[0].material.colour == (0, 255, 0)


@pytest.mark.parametrize(
    ("row", "expected"),
    [
        (
            '<material name="m" sonar="1.5"/>',
            "material, sonar: '1.5' must be from 0 to 1",
        ),
        (
            '<material name="m" infrared="bright"/>',
            "material, infrared: 'bright' is not a share (expected a number, such as 0.5)",
        ),
        (
            '<material name="m" colour="#12345"/>',
            "material, colour: unknown colour '#12345' (use #rrggbb or one of aqua, black",
        ),
        (f"{WOOD}{WOOD}", "duplicate material 'wood' (first defined in line 3)"),
        (
            '<wall x1="5" y1="5" x2="6" y2="5" material="wool"/>',
            "wall, material: unknown material 'wool' (known: none)",
        ),
        (
            '<wall x1="5" y1="5" x2="6" y2="5" height="0"/>',
            "wall, height: '0' must be greater than 0",
        ),
    ],
)
def test_errors_are_reported(row: str, expected: str):
    assert complaint(row).startswith(f"w.xml:3: error: {expected}")


@pytest.mark.parametrize("name", ["duration", "seed"])
def test_seed_and_duration_are_numbers(name: str):
    text = f"""<world version="1" {name}="-1"><area length="9m" width="9m"/>
        <robot x="1" y="1"/></world>"""
    with pytest.raises(WorldError, match=f"world, {name}: "):
        parse_world(text.encode(), "w.xml")
