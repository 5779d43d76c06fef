"""Beams against walls, boxes, cylinders and robots: by hand, and against thousands of thin rays."""

import math
import tracemalloc

import numpy as np
import pytest

from crs_cc.sim.geometry.obstacles import Obstacles
from crs_cc.sim.geometry.placement import misplaced
from crs_cc.sim.geometry.rays import Fan, nearest
from crs_cc.sim.geometry.scene import NOTHING, Scene
from crs_cc.sim.model.robot import Drive, RobotModel
from crs_cc.sim.model.world import Area, Box, Cylinder, Polygon, Pose, Robot, Wall, WorldModel

TEN_DEG = math.radians(10)


def measure(*elements, beams=((0.0, 0.0, 0.0, TEN_DEG, 8.0),), pose=(0.0, 0.0, 0.0)):
    """Return the distances that beams measure from a pose."""
    world = WorldModel(
        "w",
        Area(-50, -50, 100, 100, 0),
        walls=tuple(obj for obj in elements if isinstance(obj, Wall)),
        boxes=tuple(obj for obj in elements if isinstance(obj, Box)),
        cylinders=tuple(obj for obj in elements if isinstance(obj, Cylinder)),
        polygons=tuple(obj for obj in elements if isinstance(obj, Polygon)),
        robots=tuple(obj for obj in elements if isinstance(obj, Robot)),
    )
    scene, fan = Scene(world), Fan.of(beams)
    start = scene.start.reshape(-1, 3)
    moving = scene.moving(start[:, :2], start[:, 2])
    obstacles = Obstacles(scene.fixed, moving, fan.reach_m, fan.start_m)
    return nearest(fan, np.array([pose]), obstacles)[0].tolist()


def wall(x1, y1, x2, y2):
    return Wall("wall", x1, y1, x2, y2, 0.2)


BY_HAND = {
    "a wall ahead is heard at its near side": (wall(2, -5, 2, 5), 1.9),
    # Turned by 8 degrees the perpendicular still lies within the cone of 10 degrees.
    "a wall turned a little is heard at the foot of the perpendicular": (
        wall(2 - 5 * math.sin(math.radians(8)), 5 * math.cos(math.radians(8)),
             2 + 5 * math.sin(math.radians(8)), -5 * math.cos(math.radians(8))),
        2 * math.cos(math.radians(8)) - 0.1,
    ),
    # Turned by 45 degrees, the side of the cone hits first: x = 2 + y there, at tan 10 = -y / x.
    "a wall at 45 degrees is heard where the side of the cone meets it": (
        wall(2 - 5, -5, 2 + 5, 5),
        (2 - 0.1 * math.sqrt(2)) / (1 + math.tan(TEN_DEG)) / math.cos(TEN_DEG),
    ),
    "a wall that runs along the beam and beside it is not heard": (wall(1, 3, 9, 3), math.inf),
    "the round end of a wall": (wall(3, 0, 3, 5), 2.9),
    "a wall behind is not heard": (wall(-2, -5, -2, 5), math.inf),
    "a wall beyond the range is not heard": (wall(8.2, -5, 8.2, 5), math.inf),
    "a wall just within the range": (wall(8.05, -5, 8.05, 5), 7.95),
    "a cylinder ahead": (Cylinder("c", Pose(3, 0), 0.5), 2.5),
    "a cylinder aside, its middle within the cone": (
        Cylinder("c", Pose(3, 0.3), 0.5), math.hypot(3, 0.3) - 0.5
    ),
    # Seen in the frame of the cone's side, the middle lies at 4 along it and 0.3 from it.
    "a cylinder aside that the side of the cone meets": (
        Cylinder("c", Pose(4 * math.cos(TEN_DEG) - 0.3 * math.sin(TEN_DEG),
                           4 * math.sin(TEN_DEG) + 0.3 * math.cos(TEN_DEG)), 0.5),
        4 - 0.4,
    ),
    "a cylinder that the cone just misses": (
        Cylinder("c", Pose(4 * math.cos(TEN_DEG) - 0.51 * math.sin(TEN_DEG),
                           4 * math.sin(TEN_DEG) + 0.51 * math.cos(TEN_DEG)), 0.5),
        math.inf,
    ),
    "a thin pillar far away, between any two rays": (
        Cylinder("c", Pose(7 * math.cos(0.123), 7 * math.sin(0.123)), 0.01), 6.99
    ),
    "the flat side of a box": (Box("b", Pose(3, 0.5), 2, 2), 2.0),
    "the corner of a box": (Box("b", Pose(3, 0, math.pi / 4), 1, 1), 3 - math.sqrt(0.5)),
    "the corner of a box, aside but within the cone": (
        Box("b", Pose(3 + 0.5, 0.2 + 0.5), 1, 1), math.hypot(3, 0.2)
    ),
    "the side of a polygon": (Polygon.of("p", ((2, -2), (3, 0), (2, 2))), 2.0),
    "the dent of a polygon": (
        Polygon.of("p", ((2, 3), (4, 0), (2, -3), (6, -3), (6, 3))),
        # The dent's side runs from 4, 0 to 2, 3; the beam's side meets it where y = x tan 10.
        6 / (1.5 + math.tan(TEN_DEG)) / math.cos(TEN_DEG),
    ),
    "a robot": (Robot("r", RobotModel("m", 0.25, Drive(0.3)), Pose(2, 0)), 1.75),
}  # fmt: skip


@pytest.mark.parametrize("name", BY_HAND)
def test_beam_measures_the_computed_distance(name):
    obj, expected_m = BY_HAND[name]
    assert measure(obj)[0] == pytest.approx(expected_m, abs=1e-9)


@pytest.mark.parametrize("heading_deg", [0, 17, 90, 135, 250])
def test_beams_turn_with_the_robot(heading_deg):
    heading = math.radians(heading_deg)
    cylinder = Cylinder("c", Pose(5 + 3 * math.cos(heading), 1 + 3 * math.sin(heading)), 0.5)
    assert measure(cylinder, pose=(5, 1, heading)) == pytest.approx([2.5])


def test_nearest_object_wins():
    near, far = Cylinder("c", Pose(3, 0), 0.5), wall(5, -5, 5, 5)
    assert measure(far, near) == pytest.approx([2.5])


def test_distance_is_measured_from_the_sensor():
    left = (0.0, 0.2, math.pi / 2, TEN_DEG, 8.0)
    assert measure(wall(-5, 2, 5, 2), beams=[left]) == pytest.approx([1.7])


def test_ray_without_width_hits_only_objects_on_it():
    ray = (0.0, 0.0, 0.0, 0.0, 8.0)
    off, on = Cylinder("c", Pose(4, 0.51), 0.5), Cylinder("c", Pose(4, 0.3), 0.5)
    assert measure(off, beams=[ray]) == [math.inf]
    assert measure(on, beams=[ray]) == pytest.approx([4 - 0.4])
    assert measure(wall(3, -1, 3, 1), beams=[ray]) == pytest.approx([2.9])


def test_results_are_in_the_order_of_the_given_beams():
    directions = [math.pi, 0.0, math.pi / 2]
    beams = [(0.0, 0.0, direction, TEN_DEG, 8.0) for direction in directions]
    found = measure(wall(2, -5, 2, 5), wall(-3, -5, -3, 5), wall(-5, 4, 5, 4), beams=beams)
    assert found == pytest.approx([2.9, 1.9, 3.9])


RING = [
    (0.2 * math.cos(direction), 0.2 * math.sin(direction), direction, TEN_DEG, 6.5)
    for direction in (math.tau / 16 * number for number in range(16))
]


def crowd(robots: int, seed: int) -> WorldModel:
    """Return a crowded world without initial overlaps."""
    rng = np.random.default_rng(seed)
    size_m = 2.5 * math.sqrt(robots)
    model = RobotModel("m", 0.2, Drive(0.3))

    def pose():
        return Pose(*rng.uniform(0.5, size_m - 0.5, 2), rng.uniform(0, math.tau))

    boxes = tuple(
        Box(f"b{n}", pose(), 0.6, 0.4, mass_kg=5.0 if n % 2 else math.inf)
        for n in range(robots // 4)
    )
    ends = rng.uniform(0, size_m, (robots // 8, 4))
    walls = tuple(Wall(f"w{n}", *row, 0.1) for n, row in enumerate(ends))
    cylinders = tuple(Cylinder(f"c{n}", pose(), 0.15) for n in range(robots // 8))
    kept = [Robot(f"r{n}", model, pose()) for n in range(robots)]
    world = WorldModel("w", Area(0, 0, size_m, size_m), walls, boxes, cylinders, robots=tuple(kept))
    bad = {robot for robot, _ in misplaced(world)}
    kept = [robot for number, robot in enumerate(kept) if number not in bad]
    return WorldModel("w", world.area, walls, boxes, cylinders, robots=tuple(kept))


def look_around(world: WorldModel, fan: Fan, elements: np.ndarray | None = None):
    scene = Scene(world)
    moving = scene.moving(scene.start[:, :2], scene.start[:, 2])
    obstacles = Obstacles(scene.fixed, moving, fan.reach_m, fan.start_m)
    count = len(world.robots)
    return nearest(fan, scene.start[:count], obstacles, own=np.arange(count), objects=elements)


@pytest.mark.parametrize("pairs", [1, 500])
def test_block_size_changes_no_bit(pairs, monkeypatch):
    world, fan = crowd(300, seed=300), Fan.of(RING)
    seen = [np.zeros((len(world.robots), len(fan)), dtype=np.intp) for _ in range(2)]
    whole = look_around(world, fan, seen[0])
    monkeypatch.setattr("crs_cc.sim.geometry.cell_list.PAIRS_IN_BLOCK", pairs)
    assert np.array_equal(whole, look_around(world, fan, seen[1]))
    assert np.array_equal(*seen)


def test_many_beams_and_robots_near_many_objects_take_bounded_memory():
    """All pairs of a beam and a side at once were 1.3 GB."""
    boxes = tuple(Box(f"b{number}", Pose(3.0, 3.0), 1, 1) for number in range(3_000))
    scene = Scene(WorldModel("w", Area(0, 0, 9, 9), boxes=boxes))
    fan = Fan.of([(0.2, 0.0, way, 0.01, 9.0) for way in np.linspace(-1.0, 1.0, 200)])
    obstacles = Obstacles(scene.fixed, NOTHING, fan.reach_m, fan.start_m)
    poses = np.tile([0.5, 3.0, 0.0], (20, 1))
    tracemalloc.start()
    found_m = nearest(fan, poses, obstacles)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 150e6
    assert np.array_equal(found_m, np.tile(nearest(fan, poses[:1], obstacles), (20, 1)))


def test_cone_matches_many_thin_rays():
    world = crowd(30, seed=3)
    cones = look_around(world, Fan.of(RING))
    thin = 201
    angles = np.linspace(-TEN_DEG, TEN_DEG, thin)
    beams = [(x, y, way + angle, 0.0, 6.5) for x, y, way, _, _ in RING for angle in angles]
    fine = look_around(world, Fan.of(beams)).reshape(-1, len(RING), thin).min(axis=2)
    assert (cones <= fine + 1e-6).all()  # rays can only miss something
    both = np.isfinite(cones) & np.isfinite(fine)
    assert np.median(np.abs(cones[both] - fine[both])) < 1e-3
    assert (np.isinf(fine) & np.isfinite(cones)).mean() < 0.02
