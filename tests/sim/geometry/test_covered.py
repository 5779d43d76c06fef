"""A sonar that touches or overlaps an object reads 0, not the distance of the far side."""

import math

import numpy as np
import pytest

from crs_cc.sim.devices.ray_caster import RayCaster
from crs_cc.sim.devices.sonar import SonarRing
from crs_cc.sim.devices.vendor_state import BUMPER, SONAR_0
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.geometry.contact_mask import Pieces
from crs_cc.sim.geometry.placement import distance_from_m
from crs_cc.sim.geometry.rays import Fan
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.model.registry import device
from crs_cc.sim.model.world import Area, Box, Polygon, Pose, Wall, WorldModel
from tests.sim.driver import SCOUT_RADIUS_M, Driver, open_world, world_of

HAIR_M = 0.0004  # less than what physics lets objects overlap

ELEMENTS = {  # all have their near side at x = 2 m
    "box": '<box x="2.15m" y="1.5m" length="30cm" width="60cm"/>',
    "turned box": '<box x="2.15m" y="1.5m" heading="90" length="60cm" width="30cm"/>',
    "thin box": '<box x="2.01m" y="1.5m" length="2cm" width="60cm"/>',
    "pushable box": '<box x="2.15m" y="1.5m" length="30cm" width="60cm" mass="50kg"/>',
    "wall": '<wall x1="2.05m" y1="0m" x2="2.05m" y2="3m" thickness="10cm"/>',
    "thin wall": '<wall x1="2.01m" y1="3m" x2="2.01m" y2="0m" thickness="2cm"/>',
    "end of a wall": '<wall x1="2.1m" y1="1.5m" x2="4m" y2="1.5m" thickness="20cm"/>',
    "box beside a wall": (
        '<box x="2.01m" y="1.5m" length="2cm" width="60cm"/>'
        '<wall x1="2.07m" y1="0m" x2="2.07m" y2="3m" thickness="10cm"/>'
    ),
    "box thicker than the range": '<box x="6m" y="1.5m" length="8m" width="3m"/>',
    "polygon": '<polygon points="2m,1.2m 2.3m,1.2m 2.3m,1.8m 2m,1.8m 2m,1.5m"/>',
    "pushable polygon": '<polygon points="2m,1.2m 2.6m,1.5m 2m,1.8m" mass="50kg"/>',
    "cylinder": '<cylinder x="2.3m" y="1.5m" radius="30cm"/>',
    "robot": f'<robot x="{2 + SCOUT_RADIUS_M}m" y="1.5m"/>',
}


def sonars_at(deep_m: float, elements: str, heading: int = 0, y_m: float = 1.5) -> list[int]:
    """Return the readings of a Scout whose shell reaches x = 2 m and `deep_m` more.

    The first reading is that of the sonar that points along x.
    """
    world = open_world(f'<robot x="0" y="0"/>{elements}')
    state = Environment(world, 1).state
    state.x_m[0], state.y_m[0] = 2 + deep_m - SCOUT_RADIUS_M, y_m
    state.heading_rad[0] = math.radians(heading)
    ring, pose = SonarRing(device("sonar"), world, 1), [state.x_m[0], y_m, state.heading_rad[0]]
    rays = RayCaster(Scene(world), ring.fans)
    readings = ring.look(state, rays, np.array([0]), np.array([pose]))[0].tolist()
    turned = round(heading / 22.5)
    return readings[-turned:] + readings[:-turned]


@pytest.mark.parametrize("deep_m", [0.0, 1e-12, HAIR_M, 0.005])
@pytest.mark.parametrize("heading", [0, 90])
@pytest.mark.parametrize("name", ELEMENTS)
def test_transducer_slightly_inside_does_not_read_the_far_side(name, heading, deep_m):
    assert sonars_at(deep_m, ELEMENTS[name], heading)[0] == 0


@pytest.mark.parametrize("name", ELEMENTS)
def test_transducer_just_outside_is_not_masked(name):
    assert sonars_at(-0.0254, ELEMENTS[name])[0] == 1


def test_only_transducers_inside_read_0():
    readings = sonars_at(HAIR_M, ELEMENTS["wall"])
    # Sonar 1 sits 0.61 in behind the front of the shell; its cone begins at 12.5 degrees.
    gap_in = 8 * (1 - math.cos(math.radians(22.5))) - HAIR_M / 0.0254
    assert readings[1] == readings[15] == round(gap_in / math.cos(math.radians(12.5)))
    assert readings[5:12] == [255] * 7
    # A wall that went on beyond its end at y = 0 would cover the foremost sonar here.
    assert sonars_at(HAIR_M, ELEMENTS["wall"], y_m=-0.5)[0] > 0


ROOM = 'length="5m" width="3m"'
LATE = 2  # cycles until a sonar that fires every 40 ms has told of a contact
OBSTACLES = {
    "box": '<box x="2m" y="1.5m" length="30cm" width="60cm"/>',
    "thin box": '<box x="2m" y="1.5m" length="2cm" width="60cm"/>',
    "wall": '<wall x1="2m" y1="0.5m" x2="2m" y2="2.5m" thickness="2cm"/>',
    "turned wall": '<wall x1="2.4m" y1="0m" x2="1.6m" y2="3m" thickness="10cm"/>',
    "polygon": '<polygon points="1.9m,0.9m 2.2m,1.5m 1.9m,2.1m 1.7m,1.5m"/>',
    "edge wall": "",
}


def drive_into(elements: str, time_s: float, heading: int = 0) -> list[tuple[int, int]]:
    """Return the front sonar and the bumpers in each cycle of a drive straight ahead."""
    driver = Driver.of(world_of(f'{elements}<robot x="1m" y="1.5m" heading="{heading}"/>', ROOM))
    driver.ask("CONF_SN", 0, data=bytes([0]))
    driver.ask("VM", 100, 100)
    told = []
    for _ in range(round(time_s / driver.environment.timestep_s)):
        driver.run(1)
        state = driver.ask("GS")
        told.append((int(state[SONAR_0]), int(state[BUMPER])))
    return told


@pytest.mark.parametrize("name", OBSTACLES)
def test_readings_fall_to_0_in_a_collision_and_stay_there(name):
    turned = "turned" in name
    heading = round(math.degrees(math.atan2(0.8, 3))) if turned else 0
    told = drive_into(OBSTACLES[name], 16 if name == "edge wall" else 6, heading)
    readings = [reading for reading, _ in told]
    assert readings == sorted(readings, reverse=True)
    assert readings[0] > 10
    touching = [reading for reading, bumper in told if bumper]
    assert len(touching) > 10
    assert set(touching[LATE:]) == {0}


def test_robot_pushing_a_box_reads_0():
    box = '<box x="2m" y="1.5m" length="30cm" width="60cm" mass="3kg"/>'
    told = drive_into(box, 14)
    first = next(number for number, (_, bumper) in enumerate(told) if bumper)
    assert len(told) - first > 50
    assert {reading for reading, _ in told[first + LATE :]} == {0}


def crowd() -> tuple[WorldModel, np.ndarray]:
    """Return many objects, half of them movable, and positions of robots among them."""
    rng = np.random.default_rng(5)
    boxes = tuple(
        Box(f"b{n}", Pose(*rng.uniform(0, 20, 2), rng.uniform(0, 7)), *rng.uniform(0.02, 2, 2),
            mass_kg=5.0 if n % 2 else math.inf)
        for n in range(80)
    )  # fmt: skip
    polygons = tuple(
        Polygon.of(f"p{n}", rng.uniform(0, 20, 2) + star(rng), 5.0 if n % 2 else math.inf)
        for n in range(40)
    )
    walls = tuple(Wall(f"w{n}", *rng.uniform(0, 20, 4), rng.uniform(0.02, 1)) for n in range(20))
    poses = np.column_stack([rng.uniform(0, 20, (200, 2)), rng.uniform(0, 7, 200)])
    return WorldModel("w", Area(0, 0, 20, 20), walls, boxes, (), polygons), poses


def star(rng: np.random.Generator) -> np.ndarray:
    """Return the corners of a concave polygon around the origin."""
    angles = np.arange(9) * math.tau / 9
    return rng.uniform(0.3, 1.5, (9, 1)) * np.column_stack([np.cos(angles), np.sin(angles)])


def inside(x: float, y: float, solid: Box | Wall | Polygon) -> bool:
    """Return whether a point is in an object, or in a wall without its round ends."""
    if isinstance(solid, Polygon):
        return bool(distance_from_m(solid, np.array(x), np.array(y)) <= 0)
    if isinstance(solid, Box):
        x, y = x - solid.pose.x_m, y - solid.pose.y_m
        cos, sin = math.cos(solid.pose.heading_rad), math.sin(solid.pose.heading_rad)
        length, width = solid.length_m, solid.width_m
    else:
        x, y = x - (solid.x1_m + solid.x2_m) / 2, y - (solid.y1_m + solid.y2_m) / 2
        length = math.dist((solid.x1_m, solid.y1_m), (solid.x2_m, solid.y2_m))
        cos, sin = (solid.x2_m - solid.x1_m) / length, (solid.y2_m - solid.y1_m) / length
        width = solid.thickness_m
    return abs(x * cos + y * sin) <= length / 2 and abs(y * cos - x * sin) <= width / 2


@pytest.mark.parametrize("few", [0, 10**9])
def test_vectorised_contact_mask_matches_pairwise_computation(few, monkeypatch):
    monkeypatch.setattr("crs_cc.sim.geometry.cell_list._FEW_PAIRS", few)
    world, poses = crowd()
    scene = Scene(world)
    ring = [(0.2 * math.cos(a), 0.2 * math.sin(a), a, 0.1, 6.0) for a in (4.0, 0.5, 2.0)]
    fan = Fan.of(ring)
    pieces = Pieces(scene, fan.start_m)
    pieces.place(scene.start[::-1, :2], scene.start[::-1, 2])  # each where another began
    pieces.place(scene.start[:, :2], scene.start[:, 2])
    expected = [
        [
            any(
                inside(x + 0.2 * math.cos(turn + a), y + 0.2 * math.sin(turn + a), solid)
                for solid in world.solids()
            )
            for _, _, a, _, _ in ring
        ]
        for x, y, turn in poses
    ]
    assert pieces.cover(fan, poses).tolist() == expected
    assert 0.1 < np.mean(expected) < 0.9


@pytest.mark.parametrize("pairs", [1, 500])
def test_block_size_changes_no_bit(pairs, monkeypatch):
    world, poses = crowd()
    fan = Fan.of([(0.2 * math.cos(a), 0.2 * math.sin(a), a, 0.1, 6.0) for a in (4.0, 0.5, 2.0)])
    pieces = Pieces(Scene(world), fan.start_m)
    elements = [np.full((len(poses), len(fan)), -1) for _ in range(2)]
    whole = pieces.cover(fan, poses, elements[0])
    monkeypatch.setattr("crs_cc.sim.geometry.cell_list.PAIRS_IN_BLOCK", pairs)
    assert np.array_equal(whole, pieces.cover(fan, poses, elements[1]))
    assert np.array_equal(*elements)
