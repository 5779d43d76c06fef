"""Mirrored and scaled elements."""

from __future__ import annotations

from pathlib import Path

import pytest

from crs_cc.builder.world_builder import WorldBuilder
from crs_cc.sim.geometry.scene import corners_m
from crs_cc.sim.model.world import Box, Cylinder, Polygon, Wall

WORLDS = Path(__file__).parents[2] / "worlds"
ROOM = """<world version="1">
  <area length="12m" width="12m" origin="centre"/>
  <define name="hook">
    <box id="bar" x="0" y="0" length="1m" width="10cm"/>
    <box id="tip" x="45cm" y="20cm" length="10cm" width="30cm"/>
  </define>
  <define name="even">
    <cylinder id="left" x="1ft" y="20cm" radius="5cm" colour="red"/>
    <cylinder id="right" x="30.48cm" y="-20cm" radius="5cm" colour="red"/>
    <polygon id="roof" points="0,10cm 0,-10cm 50cm,0"/>
  </define>
  <define name="rack">
    <object id="h" ref="hook" x="0" y="1m" heading="30deg"/>
    <object id="e" ref="even" x="-1m" y="0"/>
    <wall id="w" x1="0" y1="0" x2="1m" y2="0"/>
  </define>
  <object id="a" ref="rack" x="2m" y="1m" heading="20deg"/>
  <object id="b" ref="even" x="-2m" y="-3m" heading="70deg"/>
  <robot x="5m" y="-5m"/>
</world>
"""


def seen(builder: WorldBuilder, mirrored: bool) -> list[tuple[object, ...]]:
    """Return what stands in a world, or what its mirror image in x would be."""
    sign = -1 if mirrored else 1
    found: list[tuple[object, ...]] = []
    for solid in builder.world().solids()[4:]:
        if isinstance(solid, Wall):
            points = [(solid.x1_m, solid.y1_m), (solid.x2_m, solid.y2_m)]
        elif isinstance(solid, Cylinder):
            points = [(solid.pose.x_m, solid.pose.y_m)]
        else:
            assert isinstance(solid, Box | Polygon)
            points = [(float(x), float(y)) for x, y in corners_m(solid)]
        rounded = sorted((round(sign * x, 4) + 0.0, round(y, 4) + 0.0) for x, y in points)
        found.append((type(solid).__name__, *rounded))
    return sorted(found, key=str)


def test_objects_that_are_not_symmetric_are_mirrored_with_their_definitions() -> None:
    """They kept their shape: a hook to the left stayed one to the left."""
    builder = WorldBuilder(text=ROOM)
    wanted = seen(builder, mirrored=True)
    builder.mirror(["a", "b"], "x", at=0)
    assert seen(builder, mirrored=False) == wanted
    assert builder.get("a")["ref"] == "rack-mirrored"
    assert builder.get("b")["ref"] == "even"
    assert builder.names("define") == [
        f"define[{name}]" for name in ("hook", "even", "rack", "hook-mirrored", "rack-mirrored")
    ]
    before = len(builder.text)
    builder.mirror(["a", "b"], "x", at=0)
    assert builder.get("a")["ref"] == "rack"
    assert len(builder.text) < before + 20  # no more definitions
    assert seen(builder, mirrored=True) == wanted


def test_an_object_of_another_file_is_mirrored_if_it_is_symmetric(tmp_path: Path) -> None:
    builder = WorldBuilder(WORLDS / "canteen.xml")
    builder.mirror("p1")
    assert builder.get("p1")["ref"] == "place"
    lib = tmp_path / "lib.xml"
    definition = ROOM[ROOM.index("<define") : ROOM.index('<object id="a"')]
    lib.write_text(f'<definitions version="1">{definition}</definitions>')
    world = '<world version="1"><area length="9m" width="9m"/><include file="lib.xml"/>'
    (tmp_path / "room.xml").write_text(
        world + '<object id="a" ref="hook" x="2m" y="1m"/><robot x="5m" y="5m"/></world>'
    )
    with pytest.raises(ValueError, match=r"a cannot be mirrored: the definition 'hook' is not"):
        WorldBuilder(tmp_path / "room.xml").mirror("a")


def test_elements_are_scaled_from_above() -> None:
    builder = WorldBuilder.new(9, 9)
    builder.add("wall", x1="100cm", y1=1, x2="200cm", y2=1, thickness="20cm")
    builder.add("box", x="2m", y="2m", length="40cm", width="1ft", height="1m")
    builder.add("polygon", x="3m", y="3m", heading="90deg", points="0,0 1m,0 0,1m")
    builder.add("reach", x=5, y=5, radius="50cm")
    builder.scale(["wall0", "box0", "polygon0", "goal0"], 0.5, x=1, y=1)
    assert builder.get("wall0")["x2"] == "150cm"
    assert builder.get("wall0")["thickness"] == "20cm"
    box = builder.get("box0")
    assert (box["x"], box["length"], box["width"], box["height"]) == ("1.5m", "20cm", "0.5ft", "1m")
    polygon = builder.get("polygon0")
    assert (polygon["x"], polygon["points"]) == ("2m", "0,0 0.5m,0 0,0.5m")
    assert builder.get("goal0/reach") == {"x": "3m", "y": "3m", "radius": "25cm"}
    builder.add("robot", x=5, y=5)
    with pytest.raises(ValueError, match="robot0 cannot be scaled: it has the size of its robot"):
        builder.scale("robot0", 2)
    with pytest.raises(ValueError, match=r"the factor must be 0\.001 to 1000"):
        builder.scale("box0", -1)
