"""The plot of a run, read back as XML."""

from __future__ import annotations

import itertools
import math
from dataclasses import replace

import numpy as np
import pytest
from lxml import etree

from crs_cc.plot.picture import Picture, RobotPath
from crs_cc.plot.tracks import Tracks, simplified
from crs_cc.sim.engine.drawings import LINE, ROBOT, Drawing
from crs_cc.sim.engine.robot_colours import colour
from crs_cc.sim.model.foraging import Nest, Source
from crs_cc.sim.model.ground import Ground, HeightMap, Patch
from crs_cc.sim.model.robot import Drive, RobotModel
from crs_cc.sim.model.world import (
    Area,
    Box,
    Cylinder,
    Material,
    Polygon,
    Pose,
    Robot,
    Wall,
    WorldModel,
)
from tests.sim.gripping import GRIPPER, gripping

SVG = "{http://www.w3.org/2000/svg}"
SCOUT = RobotModel("scout", 0.2, Drive(0.35))
ROOM = WorldModel(
    "room",
    Area(0.0, 0.0, 6.0, 4.0),
    walls=(Wall("screen", 3.0, 0.0, 3.0, 2.0),),
    polygons=(Polygon.of("wedge", ((4, 1), (5, 1), (4.2, 1.2), (4, 2))),),
    boxes=(Box("crate", Pose(1.0, 3.0, 0.3), 0.5, 0.4, mass_kg=3.0),),
    cylinders=(Cylinder("pillar", Pose(5.0, 3.0), 0.3),),
    robots=(Robot("robot0", SCOUT, Pose(1.0, 1.0, math.pi / 2)),),
)
OPEN = WorldModel("open", Area(-5.0, -5.0, 10.0, 10.0, edge_m=0.0))


def trip(*places: tuple[float, float], name: str = "robot0", heading_rad: float = 0.0) -> RobotPath:
    robot = Robot(name, SCOUT, Pose(*places[0], math.pi / 2))
    return RobotPath(robot, np.array(places), heading_rad)


def draw(picture: Picture) -> etree._Element:
    return etree.fromstring(picture.render())


def all_points(root: etree._Element) -> list[tuple[float, float]]:
    rows = [row.get("points") for row in root.iter(f"{SVG}polyline", f"{SVG}polygon")]
    pairs = [pair.split(",") for row in rows for pair in row.split()]
    circles = [(row.get("cx"), row.get("cy")) for row in root.iter(f"{SVG}circle")]
    return [(float(x), float(y)) for x, y in [*pairs, *circles]]


def texts(root: etree._Element) -> list[str]:
    return [row.text for row in root.iter(f"{SVG}text")]


def test_it_shows_world_path_contact_names_and_title() -> None:
    picture = Picture("wander.c", "60 s", ROOM, [trip((1, 1), (1, 2), (2, 2))], [(0, 3.0, 1.0)])
    root = draw(picture)
    shown = texts(root)
    assert {"wander.c", "60 s", "robot0", "start", "end", "contact"} <= set(shown)
    assert len(root.findall(f".//{SVG}polyline")) == 1
    walls = [row for row in root.iter(f"{SVG}line") if row.get("stroke-linecap") == "round"]
    assert len(walls) == 5
    assert len([row for row in root.iter(f"{SVG}line") if row.get("stroke") == "#d1242f"]) == 4


def test_objects_have_the_colours_of_their_materials() -> None:
    red, blue = Material((255, 0, 0)), Material((0, 0, 255))
    room = replace(
        ROOM,
        walls=(replace(ROOM.walls[0], material=red),),
        boxes=(replace(ROOM.boxes[0], material=blue),),
    )
    painted = draw(Picture("", "", room, [trip((1, 1), (1, 2))])).xpath("//@stroke | //@fill")
    assert {"#ff0000", "#0000ff"} <= set(painted)


def test_walls_as_light_as_the_background_have_an_outline() -> None:
    white = Wall("white", -3.0, 0.0, 3.0, 0.0, material=Material((255, 255, 255)))
    plain = Wall("plain", -3.0, 2.0, 3.0, 2.0)
    root = draw(Picture("", "", replace(OPEN, walls=(white, plain)), [trip((1, 1), (1, 2))]))
    lines = root.xpath("//*[@stroke-linecap='round'][@x1]")
    wide = [float(line.get("stroke-width")) for line in lines]
    assert [line.get("stroke") == "#ffffff" for line in lines] == [False, True, False]
    assert wide[0] > wide[1] == wide[2]


def test_up_in_the_world_is_up_on_the_page() -> None:
    root = draw(Picture("", "", OPEN, [trip((0, 0), (3, 0), (3, 1))]))
    points = root.find(f".//{SVG}polyline").get("points").split()
    (x1, y1), (x2, y2), (x3, y3) = ([float(part) for part in point.split(",")] for point in points)
    assert x2 > x1
    assert y1 == y2
    assert y3 < y2
    assert x3 - x2 == pytest.approx(0.0)
    assert (x2 - x1) == pytest.approx(3 * (y2 - y3), abs=0.5)


@pytest.mark.parametrize("places", [[(0.0, 0.0)], [(5.0, 5.0)] * 3, [(0, 0), (1e4, 3.0)]])
def test_everything_is_on_the_page_for_any_path(
    places: list[tuple[float, float]],
) -> None:
    root = draw(Picture("t", "", OPEN, [trip(*places)]))
    width, height = float(root.get("width")), float(root.get("height"))
    for x, y in all_points(root):
        assert 0 <= x <= width
        assert 0 <= y <= height


def test_drawings_of_programs_are_clipped_to_the_frame() -> None:
    drawings = [
        Drawing.of(0, [LINE, 0, 0, 100, 100, 0, 0, 18]),
        Drawing.of(0, [LINE, 0, 0, 10**9, 0, 0, 0, 1]),
        Drawing.of(0, [ROBOT, 50, 50, 0, 900, 0, 0, 3]),
    ]
    picture = Picture("t", "", OPEN, [trip((0, 0), (1, 1))], drawings=drawings)
    root = draw(picture)
    (group,) = [row for row in root.iter(f"{SVG}g") if row.get("clip-path")]
    strokes = [(row.get("stroke"), row.get("points")) for row in group.iter(f"{SVG}polyline")]
    assert [paint for paint, _ in strokes] == ["#ff0000", *["#000000"] * 4]
    assert float(root.get("width")) < 1200
    frame = root.find(f".//{SVG}clipPath/{SVG}rect")
    left, width = float(frame.get("x")), float(frame.get("width"))
    # The area ends at x = 5 m, where the long line leaves it.
    start, end = (pair.split(",") for pair in strokes[1][1].split())
    assert float(start[0]) < left + width / 2
    assert float(end[0]) > left + width


def test_hundreds_of_robots_fit() -> None:
    trips = [trip((n % 20, n // 20), (n % 20, n // 20 + 0.5), name=f"r{n}") for n in range(400)]
    root = draw(Picture("crowd", "", OPEN, trips))
    assert len(root.findall(f".//{SVG}polyline")) == 400
    assert any("more" in text for text in texts(root))
    height = float(root.get("height"))
    assert all(float(row.get("y")) < height for row in root.iter(f"{SVG}text"))


def test_no_name_can_break_the_document() -> None:
    root = draw(Picture('</svg>"&<script>\x00\ud800', "", OPEN, [trip((0, 0), name="<b>")]))
    assert "<b>" in texts(root)
    assert not root.findall(f".//{SVG}script")


def test_neighbouring_robots_have_different_colours() -> None:
    colours = [colour(number) for number in range(60)]
    assert len(set(colours)) == 60


def test_a_simplified_path_stays_close_to_the_whole_one() -> None:
    angle = np.linspace(0, 6, 500)
    path = np.column_stack([np.cos(angle) * angle, np.sin(angle) * angle])
    kept = simplified(path, 0.01)
    assert len(kept) < 150
    assert kept[0].tolist() == path[0].tolist()
    assert kept[-1].tolist() == path[-1].tolist()
    for point in path:
        gaps = [_gap(point, a, b) for a, b in itertools.pairwise(kept)]
        assert min(gaps) <= 0.0101


def _gap(point: np.ndarray, a: np.ndarray, b: np.ndarray) -> float:
    share = np.clip((point - a) @ (b - a) / ((b - a) @ (b - a)), 0, 1)
    return float(np.linalg.norm(point - a - share * (b - a)))


def test_a_long_run_keeps_a_bounded_number_of_samples() -> None:
    tracks = Tracks(max_samples=100)
    for step in range(1000):
        tracks.add(np.array([float(step), 0.0]), np.zeros(2))
    tracks.end(np.array([999.0, 0.0]), np.zeros(2))
    path = tracks.path(0)
    assert len(path) <= 52
    assert path[0, 0] == 0.0
    assert path[-1, 0] == 999.0
    assert np.ptp(np.diff(path[:-1, 0])) == 0.0


def test_contacts_at_one_place_are_kept_once() -> None:
    tracks = Tracks()
    for x_m in (1.0, 1.01, 1.02, 2.0):
        tracks.add_contact(0, x_m, 0.0)
    tracks.add_contact(1, 1.0, 0.0)
    assert tracks.contacts == [(0, 1.0, 0.0), (0, 2.0, 0.0), (1, 1.0, 0.0)]


def test_higher_terrain_is_darker_and_arrows_point_up() -> None:
    """A ramp from 0 to 0.5 m along x, and a plateau of 1 m behind it."""
    ramp, plateau = (
        Patch(2.0, 2.0, 0.0, 2.0, 1.0, 0.0, 0.5),
        Patch(4.0, 2.0, 0.0, 1.0, 1.0, 1.0, 1.0),
    )
    world = replace(OPEN, surface=Ground((ramp, plateau)))
    root = draw(Picture("", "", world, []))
    assert {"14.0°", "1.00 m"} <= set(texts(root))
    fills = [row.get("fill") for row in root.iter(f"{SVG}polygon") if row.get("fill") != "none"]
    reds = [int(fill[1:3], 16) for fill in fills[:13]]
    assert reds == sorted(reds, reverse=True)
    assert reds[0] > reds[-1]
    (shaft,) = root.findall(f".//{SVG}g[@stroke='#8a6a48']/{SVG}line")
    assert float(shaft.get("x1")) < float(shaft.get("x2"))
    assert shaft.get("y1") == shaft.get("y2")


def test_the_plot_includes_all_terrain() -> None:
    far = replace(OPEN, surface=Ground((Patch(30.0, 0.0, 0.5, 4.0, 2.0, 0.1, 0.1),)))
    root = draw(Picture("", "", far, [trip((0, 0), (1, 0))]))
    width = float(root.get("width"))
    assert all(0 <= x <= width for x, _ in all_points(root))


def test_height_map_pixels_are_drawn_in_runs() -> None:
    """Two rows of three pixels: 0 1 1 above 0 0 0.5."""
    ground = HeightMap(0.0, 0.0, 1.0, 3, (0.0, 0.0, 0.5, 0.0, 1.0, 1.0))
    root = draw(Picture("", "", replace(OPEN, surface=Ground((), ground)), [trip((0, 0), (3, 2))]))
    boxes = list(root.iter(f"{SVG}rect"))[2:]
    widths = [float(row.get("width")) for row in boxes]
    assert len(boxes) == 2
    assert widths[1] == pytest.approx(2 * widths[0], rel=0.01)
    assert int(boxes[1].get("fill")[1:3], 16) < int(boxes[0].get("fill")[1:3], 16)


def test_lights_sounds_and_fingers_are_drawn(tmp_path):
    """A light is a disc with eight rays, a sound three circles, a gripper two lines."""
    elements = '<robot x="1m" y="1m"/><light x="2m" y="2m"/><sound x="3m" y="1m"/>'
    world = gripping(tmp_path, elements, 'length="4m" width="3m"', GRIPPER).environment.world
    path = np.array([[1.0, 1.0]])
    trips = [RobotPath(world.robots[0], path, 0.0)]
    plain = Picture("t", "s", replace(world, lights=(), sounds=()), trips)
    full = Picture("t", "s", world, trips)
    tags = b"<line", b"<circle"
    shapes = [[each.render().count(tag) for tag in tags] for each in (plain, full)]
    assert [more - less for less, more in zip(*shapes, strict=True)] == [8, 4]
    assert full.render().count(b'stroke-width="2.5"') == 2


def test_sources_and_nests_are_drawn_to_scale_with_their_names():
    places = {"sources": (Source("food", 2.0, 1.0, 0.5),), "nests": (Nest("home", 9.0, 1.0, 0.25),)}
    root = draw(Picture("", "", replace(OPEN, **places), [trip((0, 0), (3, 2))]))
    discs = [each for each in root.iter(f"{SVG}circle") if each.get("fill-opacity") == "0.2"]
    radii_px = [float(disc.get("r")) for disc in discs]
    assert radii_px[0] == pytest.approx(2 * radii_px[1], rel=0.01)
    assert {"food", "home"} <= {each.text for each in root.iter(f"{SVG}text")}


def test_axes_have_units_and_odometrys_path_is_shown_where_it_differs() -> None:
    true = trip((1.0, 1.0), (2.0, 1.0))
    same = replace(true, odometry=true.path)
    root = draw(Picture("t", "s", ROOM, [same]))
    assert {"x [m]", "y [m]"} <= set(texts(root))
    assert "by odometry" not in texts(root)
    other = replace(
        true, odometry=true.path + np.array([[0.0, 0.0], [0.0, 0.5]]), odometry_error_m=0.5
    )
    root = draw(Picture("t", "s", ROOM, [other]))
    assert "by odometry" in texts(root)
    dashed = [each for each in root.iter(f"{SVG}g") if each.get("stroke-dasharray")]
    assert len(dashed[0].findall(f"{SVG}polyline")) == 1


def test_round_times_are_marked_on_the_path() -> None:
    tracks = Tracks(max_samples=50)
    for step in range(100):
        tracks.add(np.array([0.01 * step]), np.array([np.nan if step < 25 else 1.0]))
    tracks.end(np.array([1.0]), np.array([1.0]))
    marks = tracks.places_at(0, 20)
    assert [at for at, _, _ in marks] == [20, 40, 60, 80]
    assert [x_m for _, x_m, _ in marks] == pytest.approx([0.2, 0.4, 0.6, 0.8], abs=0.02)
    marked = replace(trip((0.0, 1.0), (1.0, 1.0)), marks=((0.4, 1.0, "2 s"),))
    assert "2 s" in texts(draw(Picture("t", "s", ROOM, [marked])))
