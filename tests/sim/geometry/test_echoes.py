"""Echoes of single pings, worked out by hand and compared with those of a whole ring."""

import math
import tracemalloc

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from crs_cc.sim.geometry.echoes import first_echo
from crs_cc.sim.geometry.obstacles import Obstacles
from crs_cc.sim.geometry.pings import ANY_ANGLE, Pings, Points
from crs_cc.sim.geometry.rays import Fan
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.kernels import surveys
from crs_cc.sim.model.robot import Drive, RobotModel
from crs_cc.sim.model.world import Area, Box, Cylinder, Pose, Robot, Wall, WorldModel
from tests.sim.geometry.test_rays import RING, TEN_DEG, crowd, look_around

RANGE_M = 8.0
CRITICAL = math.radians(30)
LOBE = math.radians(7.5)


def obstacles_of(*elements) -> Obstacles:
    world = WorldModel(
        "w",
        Area(-50, -50, 100, 100, 0),
        walls=tuple(obj for obj in elements if isinstance(obj, Wall)),
        boxes=tuple(obj for obj in elements if isinstance(obj, Box)),
        cylinders=tuple(obj for obj in elements if isinstance(obj, Cylinder)),
        robots=tuple(obj for obj in elements if isinstance(obj, Robot)),
    )
    scene = Scene(world)
    start = scene.start.reshape(-1, 3)
    return Obstacles(scene.fixed, scene.moving(start[:, :2], start[:, 2]), RANGE_M, 0.5)


def hear(*elements, half=TEN_DEG, lobe=0.0, critical=ANY_ANGLE, toward=0.0, voices=None) -> float:
    """Return the distance that a transducer at the origin measures."""
    ping = Pings.of([(0j, 0j, toward)], half, RANGE_M, lobe, critical)
    return float(first_echo(ping, obstacles_of(*elements), voices)[0])


def wall_at(distance, turned_deg, length=60.0):
    """Return a thin wall with its foot at a distance and its normal turned off the axis."""
    turn = math.radians(turned_deg)
    x, y = distance * math.cos(turn), distance * math.sin(turn)
    along_x, along_y = -math.sin(turn) * length / 2, math.cos(turn) * length / 2
    thick = 0.02
    x, y = x + thick / 2 * math.cos(turn), y + thick / 2 * math.sin(turn)
    return Wall("wall", x - along_x, y - along_y, x + along_x, y + along_y, thick)


# -- faces -------------------------------------------------------------------------------------


@pytest.mark.parametrize("turned", [0, 4, -9, 9.99])
def test_echo_comes_from_the_foot_of_the_perpendicular(turned):
    for critical in (ANY_ANGLE, CRITICAL, 0.0):
        assert hear(wall_at(2, turned), critical=critical) == pytest.approx(2)


@pytest.mark.parametrize(("turned", "heard"), [(20, True), (39, True), (41, False), (60, False)])
def test_wall_returns_an_echo_up_to_the_critical_angle(turned, heard):
    # Its nearest point in the beam lies on the side, where sound comes in at turned - 10 degrees.
    at_side = 2 / math.cos(math.radians(turned - 10))
    expected = at_side if heard else math.inf
    assert hear(wall_at(2, turned), critical=CRITICAL) == pytest.approx(expected)
    assert hear(wall_at(2, turned)) == pytest.approx(at_side)


def test_smooth_wall_returns_an_echo_only_from_its_foot():
    assert hear(wall_at(2, 11), critical=0.0) == math.inf
    assert hear(wall_at(2, 9), critical=0.0) == pytest.approx(2)


def test_silent_wall_hides_objects_behind_it():
    mirror = wall_at(2, 60)
    assert hear(mirror, Cylinder("c", Pose(6, 0), 0.5), critical=CRITICAL) == math.inf
    assert hear(mirror, Box("b", Pose(7, 0), 1, 1), critical=CRITICAL) == math.inf
    assert hear(mirror, wall_at(7.5, 0), critical=CRITICAL) == math.inf


def test_object_beside_a_silent_wall_is_heard():
    # The wall covers the left half of the beam, from 0.5 degrees on.
    end = 3 * np.exp(1j * math.radians(0.5))
    mirror = Wall("w", end.real, end.imag + 0.01, end.real - 5, end.imag + 5, 0.02)
    pillar = Cylinder("c", Pose(5, -0.5), 0.3)
    heard = hear(mirror, pillar, critical=CRITICAL)
    assert heard == pytest.approx(abs(end), abs=0.02)  # the wall's end
    pillar_alone = hear(wall_at(2.5, 70, 1.0), pillar, critical=CRITICAL)
    assert pillar_alone == pytest.approx(abs(5 - 0.5j) - 0.3)


def test_wall_at_exactly_the_critical_angle_returns_an_echo():
    # The side of the beam does so, but for rounding one way or the other.
    for turned in (45, -45):
        for half_deg in range(5, 25):
            half, critical = math.radians(half_deg), math.radians(45 - half_deg)
            at_side = 2 / math.cos(math.radians(45 - half_deg))
            heard = hear(wall_at(2, turned), half=half, critical=critical)
            assert heard == pytest.approx(at_side)


# -- corners and cylinders ---------------------------------------------------------------------


def test_box_corner_returns_an_echo_independent_of_its_faces():
    box = Box("b", Pose(3, 0, math.pi / 4), 1, 1)
    for critical in (ANY_ANGLE, CRITICAL, 0.0):
        assert hear(box, critical=critical) == pytest.approx(3 - math.sqrt(0.5))


def test_room_corner_returns_an_echo_where_its_walls_do_not():
    # Two walls that cross at (4, 0), each turned by 45 degrees; their faces meet a bit before.
    thick = 0.1
    walls = (
        Wall("a", 1, -3, 5, 1, thick),
        Wall("b", 1, 3, 5, -1, thick),
    )
    corner = 4 - thick / 2 * math.sqrt(2)
    assert hear(*walls, critical=CRITICAL) == pytest.approx(corner)
    beside = math.tan(TEN_DEG)
    assert hear(*walls) == pytest.approx(corner / (1 + beside) / math.cos(TEN_DEG))


@pytest.mark.parametrize("length", [0.1, 0.31, 0.5])
def test_wall_of_collinear_pieces_has_no_corners(length):
    turn = math.radians(60)
    along = np.array([-math.sin(turn), math.cos(turn)])
    foot = 2.1 * np.array([math.cos(turn), math.sin(turn)])
    ends = [foot + along * length * piece for piece in range(-100, 101)]
    pieces = [
        Wall(f"w{n}", *ends[n].tolist(), *ends[n + 1].tolist(), 0.2) for n in range(len(ends) - 1)
    ]
    assert hear(*pieces, critical=CRITICAL) == math.inf
    ahead = 100 - round(2 * math.tan(turn) / length)
    assert hear(*pieces[:ahead], critical=CRITICAL) == pytest.approx(4, abs=0.6)


@pytest.mark.parametrize("y", [0.0, 0.3, -0.5])
def test_cylinder_always_returns_an_echo(y):
    pillar = Cylinder("c", Pose(3, y), 0.25)
    for critical in (ANY_ANGLE, CRITICAL, 0.0):
        assert hear(pillar, critical=critical) == pytest.approx(math.hypot(3, y) - 0.25)


def test_cylinder_flank_returns_an_echo_if_its_front_is_outside():
    middle = 4 * np.exp(1j * TEN_DEG) + 0.3j * np.exp(1j * TEN_DEG)
    pillar = Cylinder("c", Pose(middle.real, middle.imag), 0.5)
    for critical in (ANY_ANGLE, 0.0):
        assert hear(pillar, critical=critical) == pytest.approx(4 - 0.4)


def test_robot_returns_an_echo_but_does_not_hear_itself():
    model = RobotModel("m", 0.25, Drive(0.3))
    robots = Robot("a", model, Pose(0, 0)), Robot("b", model, Pose(2, 0))
    ping = Pings.of([(0j, 0.25 + 0j, 0.0)], TEN_DEG, RANGE_M)
    own = Pings(*(getattr(ping, name) for name in Pings.__slots__[:-1]), own=np.array([0]))
    assert first_echo(own, obstacles_of(*robots))[0] == pytest.approx(1.5)


# -- the lobe ----------------------------------------------------------------------------------


@pytest.mark.parametrize("angle_deg", [0, 3, 7.5, 9.9])
def test_range_off_the_axis_follows_the_lobe(angle_deg):
    reach = RANGE_M * 2 ** -((angle_deg / 7.5) ** 2)
    angle, radius = math.radians(angle_deg), 0.01

    def pillar(front):
        away = front + radius
        return Cylinder("c", Pose(away * math.cos(angle), -away * math.sin(angle)), radius)

    assert hear(pillar(reach - 0.01), lobe=LOBE) == pytest.approx(reach - 0.01)
    # A little of it lies nearer to the axis, where the lobe reaches farther.
    assert hear(pillar(reach + 0.4), lobe=LOBE) == math.inf
    assert hear(pillar(min(reach + 0.4, RANGE_M - 0.01))) < math.inf


def test_turned_wall_is_heard_where_the_lobe_reaches_it():
    # Its foot lies outside of the beam; on the side the lobe reaches 8 * 2^-(10/7.5)^2 = 2.33 m.
    heard = hear(wall_at(4, 25), lobe=LOBE)
    nearest = 4 / math.cos(math.radians(15))
    assert heard > nearest
    angles = np.radians(np.linspace(-10, 10, 4001))
    away = 4 / np.cos(np.radians(25) - angles)
    reached = away <= RANGE_M * np.exp2(-((angles / LOBE) ** 2))
    assert heard == pytest.approx(away[reached].min(), rel=0.02)
    assert heard >= away[reached].min() - 1e-9


# -- voices ------------------------------------------------------------------------------------


def voice(place: complex, told: float) -> Points:
    return Points(np.array([0]), np.array([place]), np.array([told]), np.ones(1))


def test_further_target_is_heard_if_it_is_first_and_visible():
    assert hear(voices=voice(3 + 0.1j, 1.0)) == 1.0
    assert hear(wall_at(5, 0), voices=voice(3 + 0.1j, 1.0)) == 1.0
    assert hear(wall_at(5, 0), voices=voice(3 + 0.1j, 6.0)) == pytest.approx(5)
    assert hear(voices=voice(3 + 1j, 1.0)) == math.inf
    assert hear(wall_at(2, 0), voices=voice(3 + 0.1j, 1.0)) == pytest.approx(2)


# -- inside of objects --------------------------------------------------------------------------


@pytest.mark.parametrize("deep", [0.0, 1e-12, 0.004, 0.05])
def test_transducer_in_or_behind_a_thin_wall_reads_0(deep):
    wall = obstacles_of(Wall("w", 2.005, -3, 2.005, 3, 0.01))
    ping = Pings.of([(1.8 + deep + 0j, 2.0 + deep + 0j, 0.0)], TEN_DEG, RANGE_M)
    assert first_echo(ping, wall)[0] == 0.0


# -- all together ------------------------------------------------------------------------------


@pytest.mark.parametrize("robots", [40, 300])
def test_single_pings_match_whole_rings(robots):
    world, fan = crowd(robots, seed=robots), Fan.of(RING)
    rings = look_around(world, fan)
    scene = Scene(world)
    moving = scene.moving(scene.start[:, :2], scene.start[:, 2])
    obstacles = Obstacles(scene.fixed, moving, fan.reach_m, fan.start_m)
    pings = pings_of(scene.start[: len(world.robots)])
    assert first_echo(pings, obstacles).reshape(-1, 16) == pytest.approx(rings, abs=1e-9)
    some = np.random.default_rng(1).permutation(len(pings))[:100]
    picked = Pings(*(getattr(pings, name)[some] for name in Pings.__slots__))
    alone = first_echo(picked, obstacles)
    assert np.array_equal(alone, first_echo(pings, obstacles)[some])


def test_an_echo_does_not_depend_on_pings_of_other_kinds():
    scene = Scene(crowd(20, seed=20))
    moving = scene.moving(scene.start[:, :2], scene.start[:, 2])
    obstacles = Obstacles(scene.fixed, moving, 6.7, 0.3)
    poses = scene.start[:20]
    kinds = [pings_of(poses), pings_of(poses, 0.0, CRITICAL), pings_of(poses, LOBE, CRITICAL)]
    columns = zip(
        *([getattr(each, name) for name in Pings.__slots__] for each in kinds), strict=True
    )
    order = np.random.default_rng(2).permutation(sum(map(len, kinds)))
    mixed = Pings(*(np.concatenate(column)[order] for column in columns))
    alone = np.concatenate([first_echo(each, obstacles) for each in kinds])[order]
    assert np.array_equal(first_echo(mixed, obstacles), alone)
    heard = Points(
        np.array([3, 5]), np.array([1.0 + 0j, 0.5 + 0.01j]), np.array([1.0, 0.5]), np.ones(2)
    )
    found = first_echo(mixed, obstacles, heard)
    others = np.delete(np.arange(len(mixed)), heard.ping)
    assert np.array_equal(found[others], alone[others])


def pings_of(poses, lobe=0.0, critical=ANY_ANGLE) -> Pings:
    """Return a ring of pings for each robot."""
    turn = np.repeat(np.exp(1j * poses[:, 2]), len(RING))
    place = np.repeat(poses[:, 0] + 1j * poses[:, 1], len(RING))
    offset = np.tile([x + 1j * y for x, y, _, _, _ in RING], len(poses))
    axis = np.tile([np.exp(1j * way) for _, _, way, _, _ in RING], len(poses))
    count = len(place)
    return Pings(
        place,
        place + offset * turn,
        axis * turn,
        np.full(count, TEN_DEG),
        np.full(count, 6.5),
        np.full(count, 1 / lobe**2 if lobe else 0.0),
        np.full(count, critical),
        np.repeat(np.arange(len(poses)), len(RING)),
    )


@settings(max_examples=30, deadline=None)
@given(st.integers(0, 10_000), st.floats(0.05, 0.5), st.floats(0.0, ANY_ANGLE), st.floats(0.0, 1.0))
def test_narrower_beam_never_hears_a_nearer_object(seed, lobe, critical, less):
    world = crowd(12, seed=seed)
    scene = Scene(world)
    obstacles = Obstacles(
        scene.fixed, scene.moving(scene.start[:, :2], scene.start[:, 2]), 6.7, 0.3
    )
    poses = scene.start[: len(world.robots)]
    ideal = first_echo(pings_of(poses), obstacles)
    real = first_echo(pings_of(poses, lobe, critical), obstacles)
    stricter = first_echo(pings_of(poses, lobe, critical * less), obstacles)
    assert (real >= ideal - 1e-9).all()
    assert (stricter >= real - 1e-9).all()


def test_echoes_are_invariant_under_rotation():
    world = crowd(20, seed=5)
    scene = Scene(world)
    poses = scene.start[: len(world.robots)]
    fixed = scene.fixed
    moving = scene.moving(scene.start[:, :2], scene.start[:, 2])
    straight = first_echo(pings_of(poses, LOBE, CRITICAL), Obstacles(fixed, moving, 6.7, 0.3))
    turn = np.exp(0.7j)

    def turned(outlines):
        ends = outlines.segments[:, [0, 2]] + 1j * outlines.segments[:, [1, 3]]
        ends = ends * turn
        middle = (outlines.circles[:, 0] + 1j * outlines.circles[:, 1]) * turn
        segments = np.column_stack(
            [ends[:, 0].real, ends[:, 0].imag, ends[:, 1].real, ends[:, 1].imag,
             outlines.segments[:, 4]]
        )  # fmt: skip
        circles = np.column_stack([middle.real, middle.imag, outlines.circles[:, 2]])
        return type(outlines)(segments, circles, outlines.owners, outlines.segment_owners)

    place = (poses[:, 0] + 1j * poses[:, 1]) * turn
    others = np.column_stack([place.real, place.imag, poses[:, 2] + 0.7])
    obstacles = Obstacles(turned(fixed), turned(moving), 6.7, 0.3)
    crooked = first_echo(pings_of(others, LOBE, CRITICAL), obstacles)
    assert crooked == pytest.approx(straight, abs=1e-6)


def test_many_soft_objects_in_one_place_take_bounded_memory_and_time():
    rng = np.random.default_rng(1)
    places = zip(*rng.uniform([[3.0], [-0.3], [0.0]], [[3.6], [0.3], [1.5]], (3, 300)), strict=True)
    boxes = [Box(f"b{number}", Pose(*place), 1, 1) for number, place in enumerate(places)]
    around, echo_range = obstacles_of(*boxes), np.full(len(boxes), 0.8)
    pings = Pings.of([(0j, 0j, toward) for toward in np.linspace(-0.2, 0.2, 16)], 0.4, RANGE_M)
    tracemalloc.start()
    found_m = first_echo(pings, around, echo_range=echo_range)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 100e6  # all pairs of corners and sides at once were 1.7 GB
    assert found_m == pytest.approx(first_echo(pings, around), abs=1e-6)


def test_many_pings_near_many_objects_take_bounded_memory():
    """All pairs of a ping and a side at once are 0.15 GB."""
    around = obstacles_of(*(Box(f"b{number}", Pose(3, 0), 1, 1) for number in range(2_000)))
    pings = Pings.of([(0j, 0j, toward) for toward in np.linspace(-0.2, 0.2, 70)], 0.4, RANGE_M)
    around.segments_near(np.zeros(1, np.complex128))  # lists them by cells, once
    tracemalloc.start()
    found_m = first_echo(pings, around)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 120e6
    assert found_m == pytest.approx(2.5)


def test_equal_soft_objects_take_time_in_proportion_to_their_number(monkeypatch):
    """Each corner was compared with each side: 99,000 boxes would have taken an hour."""
    boxes = [Box(f"b{number}", Pose(3, 0), 1, 1) for number in range(5_000)]
    around, echo_range = obstacles_of(*boxes), np.full(len(boxes), 0.8)
    pings, faces = Pings.of([(0j, 0j, 0.2)], 0.4, RANGE_M), []

    def counted(instance, tables, *others, **options):
        faces.append(len(tables[1]))
        return all_echoes(instance, tables, *others, **options)

    all_echoes = surveys.echoes
    monkeypatch.setattr(surveys, "echoes", counted)
    assert first_echo(pings, around, echo_range=echo_range) == pytest.approx(2.5)
    assert sum(faces) < 10


@pytest.mark.parametrize("pairs", [1, 500])
@pytest.mark.parametrize("lobe", [0.0, LOBE])
def test_block_size_changes_no_bit(pairs, lobe, monkeypatch):
    scene = Scene(crowd(60, seed=7))
    moving = scene.moving(scene.start[:, :2], scene.start[:, 2])
    around = Obstacles(scene.fixed, moving, 6.7, 0.3)
    pings = pings_of(scene.start[: scene.robots], lobe)
    which = np.arange(0, len(pings), 3)
    place = np.random.default_rng(1).uniform(0.5, 2.0, len(which)) + 0j
    voices = Points(which, place, np.abs(place), np.ones(len(which)))
    echo_range = np.random.default_rng(2).uniform(0.3, 1.0, len(scene.names))

    def heard():
        return [
            first_echo(pings, around),
            first_echo(pings, around, voices),
            first_echo(pings, around, echo_range=echo_range),
        ]

    whole = heard()
    monkeypatch.setattr("crs_cc.sim.geometry.cell_list.PAIRS_IN_BLOCK", pairs)
    assert all(map(np.array_equal, whole, heard()))
