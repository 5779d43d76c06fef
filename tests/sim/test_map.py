"""Walls from pictures."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from crs_cc.core.errors import WorldError
from crs_cc.sim.files.map_elements import rectangles
from crs_cc.sim.files.world_xml import load_world, parse_world
from crs_cc.sim.model.world import WorldModel

ROOM = """
##########
#...#....#
#...#....#
#........#
##########
"""


def draw(path: Path, plan: str) -> None:
    rows = plan.split()
    grey = [[0 if letter == "#" else 255 for letter in row] for row in rows]
    Image.fromarray(np.array(grey, dtype=np.uint8)).save(path)


def load(folder: Path, attributes: str, area: str = 'length="5m" width="2.5m"') -> WorldModel:
    (folder / "w.xml").write_text(
        f"""<world version="1"><area {area} edge="0"/>
<map image="plan.png" {attributes}/>
<robot x="1" y="1"/></world>"""
    )
    return load_world(folder / "w.xml")


def message(folder: Path, attributes: str) -> str:
    with pytest.raises(WorldError) as caught:
        load(folder, attributes)
    only = caught.value.diagnostics[0]
    return only.render().splitlines()[0].replace(f"{folder}/", "")


def test_dark_pixels_become_few_boxes(tmp_path: Path):
    """Pixels of 50 cm: four walls around a room, and half a wall in it from above."""
    draw(tmp_path / "plan.png", ROOM)
    world = load(tmp_path, 'id="plan" resolution="50cm" sonar="0.5" heat="2"')
    assert len(world.boxes) == 5
    top = world.boxes[0]
    assert (top.id, top.pose.x_m, top.pose.y_m) == ("plan.0", 2.5, 2.25)
    assert (top.length_m, top.width_m) == (5.0, 0.5)
    assert (top.heat, top.material.sonar) == (2.0, 0.5)
    inner = [box for box in world.boxes if 0.5 < box.pose.x_m < 4.5 and box.length_m < 5]
    assert [(box.pose.x_m, box.pose.y_m, box.width_m) for box in inner] == [(2.25, 1.5, 1.0)]


def test_picture_can_be_placed_anywhere(tmp_path: Path):
    draw(tmp_path / "plan.png", "#.")
    corner = 'length="10m" width="10m" origin="centre"'
    (box,) = load(tmp_path, 'resolution="1m"', corner).boxes
    assert (box.pose.x_m, box.pose.y_m) == (-4.5, -4.5)
    (box,) = load(tmp_path, 'resolution="1m" x="-1m" y="2m" heading="90deg"', corner).boxes
    assert (box.pose.x_m, box.pose.y_m) == pytest.approx((-1.5, 2.5))


def test_threshold_selects_dark_pixels(tmp_path: Path):
    grey = np.array([[0, 100, 205, 254]], dtype=np.uint8)
    Image.fromarray(grey).save(tmp_path / "plan.png")
    widths = [
        sum(box.length_m for box in load(tmp_path, f'resolution="10cm" threshold="{share}"').boxes)
        for share in (0.3, 0.5, 0.9, 1)
    ]
    assert widths == pytest.approx([0.1, 0.2, 0.3, 0.4])


def test_rectangles_cover_dark_pixels_once():
    generator = np.random.default_rng(3)
    for share in (0.0, 0.1, 0.5, 0.9, 1.0):
        dark = generator.random((23, 31)) < share
        covered = np.zeros(dark.shape, dtype=int)
        for top, end, left, right in rectangles(dark).tolist():
            covered[top:end, left:right] += 1
        assert np.array_equal(covered, dark.astype(int))


@pytest.mark.parametrize(
    ("attributes", "expected"),
    [
        ('resolution="0"', "map, resolution: '0' must be greater than 0"),
        ('resolution="5"', "map, resolution: the map would be too large"),
        ('resolution="1cm"', "map, image 'plan.png': the dark pixels form "),
        ('resolution="1cm" threshold="0"', "map, threshold: must be greater than 0 and at most 1"),
    ],
)
def test_invalid_maps_are_refused(tmp_path: Path, attributes: str, expected: str):
    noise = np.random.default_rng(1).integers(0, 256, (200, 2100), dtype=np.uint8)
    Image.fromarray(noise if "5" not in attributes else noise * 0).save(tmp_path / "plan.png")
    assert message(tmp_path, attributes).startswith(f"w.xml:2: error: {expected}")


def test_unreadable_pictures_are_refused(tmp_path: Path):
    assert message(tmp_path, 'resolution="1m"') == (
        "w.xml:2: error: map, image 'plan.png': no such file"
    )
    (tmp_path / "plan.png").write_bytes(b"GIF89a")
    assert message(tmp_path, 'resolution="1m"') == (
        "w.xml:2: error: map, image 'plan.png': not a PNG file"
    )
    text = b"""<world version="1"><area length="1" width="1"/><map image="a.png" resolution="1"/>
        <robot x=".5" y=".5"/></world>"""
    with pytest.raises(WorldError, match="images require a world that is read from a file"):
        parse_world(text, "w.xml")
