"""Contacts: bounded penetration, bounded pushing, and runs that repeat to the bit."""

import math
import pickle

import numpy as np
import pymunk
import pytest

from crs_cc.sim.geometry.placement import distance_from_m
from crs_cc.sim.geometry.scene import Scene
from crs_cc.sim.physics.simulation import Physics
from crs_cc.sim.state.bodies import NO_CONTACTS, Bodies, Pull
from tests.sim.driver import SCOUT_RADIUS_M, Driver, world_of

DT = 0.05
THIN_ROOM = 'length="2m" width="1.6m" edge="5cm"'
MAZE = (
    '<wall x1="1.3m" y1="0.7m" x2="1.3m" y2="1.6m" thickness="5cm"/>'
    '<box x="0.75m" y="1.2m" heading="30" length="0.3m" width="0.05m"/>'
    '<cylinder x="1.75m" y="1.35m" radius="5cm"/>'
)


class Bench:
    """The physics of a world alone."""

    def __init__(self, world):
        self.scene = Scene(world)
        self.world = world
        self.bodies = Bodies.at_start(self.scene)
        self.physics = Physics(world, self.scene, self.bodies)

    def push(self, *ways_m, limp=False):
        return self.pull(np.array(ways_m, dtype=np.float64), limp)

    def pull(self, ways_m, limp=False):
        """Move robots by displacements; all face ahead, along x."""
        count = len(ways_m)
        pull = Pull(ways_m, np.zeros(count), np.full(count, limp))
        if self.physics.may_skip_cycle(self.bodies, ways_m, pull.facing_rad):
            self.bodies.position_m[:count] += ways_m
            self.bodies.velocity_mps[:count] = ways_m / self.world.timestep_s
            return NO_CONTACTS
        return self.physics.step(self.bodies, pull)

    def depth_m(self) -> float:
        """Return the largest penetration of a robot into a fixed solid."""
        places = self.bodies.position_m[: self.scene.robots]
        rooms = [
            distance_from_m(solid, places[:, 0], places[:, 1]).min()
            for solid in self.scene.fixed_solids
        ]
        return SCOUT_RADIUS_M - min(rooms)

    def digest(self):
        arrays = [getattr(self.bodies, name) for name in Bodies.__slots__ if name != "holds"]
        return [array.tobytes() for array in arrays]


# -- walls hold --------------------------------------------------------------------------------


@pytest.mark.parametrize(("timestep", "drive_s"), [("1ms", 6), ("50ms", 60), ("100ms", 60)])
def test_penetration_at_full_speed_is_bounded(timestep, drive_s):
    world = world_of(MAZE + '<robot x="0.3m" y="0.3m"/>', THIN_ROOM, timestep)
    bench = Bench(world)
    rng = np.random.default_rng(11)
    dt, worst_m, touched = world.timestep_s, 0.0, set()
    for _ in range(round(drive_s / 1.5)):  # another direction every second and a half
        angle = rng.uniform(0, math.tau)
        way_m = dt * math.cos(angle), dt * math.sin(angle)
        for _ in range(round(1.5 / dt)):
            contacts = bench.push(way_m)
            touched |= {bench.scene.names[other] for other in contacts.other}
            worst_m = max(worst_m, bench.depth_m())
    assert worst_m < 0.01
    assert len(touched) >= drive_s / 10


def test_robot_driven_into_a_corner_stays_there():
    bench = Bench(world_of('<robot x="1m" y="0.8m"/>', THIN_ROOM))
    for angle_deg in (225, 200, 250, 181, 269):
        angle = math.radians(angle_deg)
        for _ in range(60):
            bench.push((DT * math.cos(angle), DT * math.sin(angle)))
            assert bench.depth_m() < 0.01
    assert bench.bodies.position_m[0] == pytest.approx([SCOUT_RADIUS_M] * 2, abs=0.01)


@pytest.mark.parametrize("timestep", ["1ms", "50ms", "100ms"])
def test_a_robot_at_full_speed_goes_at_most_8_mm_in_a_substep(timestep, monkeypatch):
    """That is how deep it can get into a wall before it is stopped; and no time is left out."""
    substeps_s, step = [], pymunk.Space.step
    monkeypatch.setattr(
        pymunk.Space, "step", lambda space, dt: substeps_s.append(dt) or step(space, dt)
    )
    world = world_of('<robot x="9m" y="5m"/>', timestep=timestep)
    bench, speed_mps = Bench(world), world.robots[0].model.drive.wheels.speed_limit
    while True:
        substeps_s.clear()
        if len(bench.push((speed_mps * world.timestep_s, 0.0)).other):
            break
    assert sum(substeps_s) == pytest.approx(world.timestep_s)
    assert max(substeps_s) * speed_mps <= 0.008 + 1e-9


def test_robot_slides_along_a_wall():
    bench = Bench(world_of('<robot x="1m" y="5m"/>'))
    angle = math.radians(30)
    for _ in range(400):
        bench.push((0.3 * DT * math.cos(angle), 0.3 * DT * math.sin(angle)))
    x, y = bench.bodies.position_m[0]
    assert y < 10
    for _ in range(400):
        bench.push((0.3 * DT * math.cos(angle), 0.3 * DT * math.sin(angle)))
    assert bench.bodies.position_m[0][0] > x + 0.5
    assert bench.bodies.position_m[0][1] == pytest.approx(10 - SCOUT_RADIUS_M, abs=0.01)


def test_robots_stop_each_other():
    bench = Bench(world_of('<robot x="4m" y="5m"/><robot x="6m" y="5m"/>'))
    for _ in range(100):
        contacts = bench.push((0.5 * DT, 0), (-0.5 * DT, 0))
    apart = bench.bodies.position_m[1] - bench.bodies.position_m[0]
    assert apart == pytest.approx([2 * SCOUT_RADIUS_M, 0], abs=0.01)
    assert contacts.robot.tolist() == [0, 1]
    assert contacts.other.tolist() == [1, 0]


def test_contacts_have_object_and_position():
    bench = Bench(world_of('<cylinder id="pillar" x="5m" y="5m" radius="20cm"/>'
                           '<robot x="4m" y="5m"/>'))  # fmt: skip
    for _ in range(40):
        contacts = bench.push((0.5 * DT, 0))
    assert [bench.scene.names[other] for other in contacts.other] == ["pillar"]
    assert contacts.x_m == pytest.approx([4.8], abs=0.01)
    assert contacts.y_m == pytest.approx([5.0], abs=0.01)


# -- pushing -----------------------------------------------------------------------------------


def push_box(mass: str, seconds: float = 4.0) -> Bench:
    bench = Bench(
        world_of(
            f'<box x="3m" y="5m" length="40cm" width="40cm" mass="{mass}"/><robot x="2m" y="5m"/>'
        )
    )
    for _ in range(round(seconds / DT)):
        bench.push((0.3 * DT, 0.0))
    return bench


def test_light_box_moves_and_stops_with_the_robot():
    bench = push_box("5kg")
    robot_x, box_x = bench.bodies.position_m[:, 0]
    assert robot_x == pytest.approx(2 + 4 * 0.3, abs=0.05)
    assert box_x == pytest.approx(robot_x + SCOUT_RADIUS_M + 0.2, abs=0.01)
    for _ in range(20):
        bench.push((0.0, 0.0))
    rested = bench.bodies.position_m.copy()
    for _ in range(20):
        bench.push((0.0, 0.0))
    assert np.array_equal(bench.bodies.position_m, rested)
    assert rested[1, 0] - box_x < 0.05


def test_box_too_heavy_for_the_push_does_not_move():
    # Friction of the floor: 0.4 * 9.80665 * 20 kg = 78 N, the Scout pushes with 60 N. The blow at
    # first gives both 23 * 0.3 / 43 = 0.16 m/s, which friction takes away within 3 cm.
    bench = push_box("20kg", seconds=20)
    assert bench.bodies.position_m[1, 0] == pytest.approx(3.03, abs=0.01)
    assert bench.bodies.velocity_mps[1] == pytest.approx([0, 0], abs=1e-6)


def test_box_pushed_off_centre_turns():
    bench = Bench(
        world_of(
            '<box x="3m" y="5.18m" length="40cm" width="40cm" mass="3kg"/><robot x="2m" y="5m"/>'
        )
    )
    for _ in range(80):
        bench.push((0.3 * DT, 0.0))
    assert bench.bodies.angle_rad[1] > 0.1


def test_polygon_behaves_as_a_box_of_the_same_shape():
    box, corners = push_box("5kg"), "2.8m,4.8m 3.2m,4.8m 3.2m,5.2m 2.8m,5.2m"
    polygon = Bench(world_of(f'<polygon points="{corners}" mass="5kg"/><robot x="2m" y="5m"/>'))
    for _ in range(80):
        polygon.push((0.3 * DT, 0.0))
    assert polygon.bodies.position_m == pytest.approx(box.bodies.position_m, abs=0.01)


def test_robot_can_enter_a_concave_polygon():
    bench = Bench(
        world_of(
            '<polygon points="2m,3m 4m,4.6m 4m,5.4m 2m,7m 6m,7m 6m,3m"/><robot x="2m" y="5m"/>'
        )
    )
    contacts = [bench.push((0.5 * DT, 0.0)) for _ in range(100)]
    assert bench.depth_m() == pytest.approx(0, abs=0.001)
    assert bench.bodies.position_m[0] == pytest.approx((4 - SCOUT_RADIUS_M, 5), abs=0.001)
    assert contacts[-1].other.tolist() == [bench.scene.names.index("polygon0")]


def test_box_against_a_wall_stops_the_robot():
    bench = Bench(
        world_of(
            '<box x="1.5m" y="0.8m" length="40cm" width="40cm" mass="1kg"/>'
            '<robot x="0.5m" y="0.8m"/>',
            THIN_ROOM,
        )
    )
    for _ in range(200):
        bench.push((0.5 * DT, 0.0))
    assert bench.bodies.position_m[1, 0] == pytest.approx(1.8, abs=0.01)
    assert bench.bodies.position_m[0, 0] == pytest.approx(1.6 - SCOUT_RADIUS_M, abs=0.02)


def test_contacts_never_turn_a_robot():
    driver = Driver.of(world_of('<robot x="9m" y="5m" heading="70"/>'))
    driver.ask("VM", 300, 300)
    driver.run_s(20)
    assert driver.state.collisions[0] == 2  # the east edge, then the corner
    assert math.degrees(driver.state.heading_rad[0]) == pytest.approx(70)


# -- the same again ----------------------------------------------------------------------------

SCRUM = "".join(
    f'<robot x="{1 + column * 0.6}m" y="{1 + row * 0.6}m"/>'
    for row in range(4)
    for column in range(4)
) + "".join(
    f'<box x="{1.3 + number * 0.6}m" y="4m" length="30cm" width="30cm" mass="2kg"/>'
    f'<cylinder x="{1.3 + number * 0.6}m" y="4.7m" radius="15cm" mass="1kg"/>'
    for number in range(4)
)


def scrum(count: int, seed: int):
    """Return displacements for a crowd that keeps colliding with itself and its objects."""
    rng = np.random.default_rng(seed)
    angle = rng.uniform(0, math.tau, 16)
    for number in range(count):
        if number % 20 == 0:
            angle = rng.uniform(0, math.tau, 16)
        yield DT * 0.6 * np.column_stack([np.cos(angle), np.sin(angle)])


def go_back(bench, snapshot):
    physics, bodies = snapshot
    bench.physics.restore(physics)
    bench.bodies = bodies.copy()


def test_snapshot_in_a_scrum_replays_to_the_same_bits(monkeypatch):
    monkeypatch.setattr("crs_cc.sim.physics.simulation.REBUILD", 30)
    bench = Bench(world_of(SCRUM, 'length="4m" width="5.5m"'))
    ways = list(scrum(90, seed=2))
    touched = sum(len(bench.pull(way).robot) for way in ways[:30])
    assert touched > 100
    for at in (0, 30, 31, 47, 59):
        bench = Bench(bench.world)
        for way in ways[:at]:
            bench.pull(way)
        snapshot = pickle.loads(pickle.dumps((bench.physics.snapshot(), bench.bodies)))
        for way in ways[at:]:
            bench.pull(way)
        expected = bench.digest()
        for _ in range(2):
            go_back(bench, snapshot)
            for way in ways[at:]:
                bench.pull(way)
            assert bench.digest() == expected
        other = Bench(bench.world)
        go_back(other, snapshot)
        for way in ways[at:]:
            other.pull(way)
        assert other.digest() == expected


def test_snapshot_contains_only_cycles_with_near_bodies():
    bench = Bench(world_of('<robot x="5m" y="5m"/>'))
    for _ in range(70):
        bench.push((0.5 * DT, 0.0))
    assert bench.physics.snapshot().ran == ()
    while not len(bench.push((0.5 * DT, 0.0)).robot):
        pass
    first, *others = bench.physics.snapshot().ran
    assert first.bodies is not None
    assert first.bodies.position_m[0, 0] < bench.bodies.position_m[0, 0]
    assert all(ran.bodies is None for ran in others)


def test_taking_snapshots_changes_nothing():
    world = world_of(SCRUM, 'length="4m" width="5.5m"')
    quiet, watched = Bench(world), Bench(world)
    for way in scrum(120, seed=3):
        quiet.pull(way)
        watched.pull(way)
        watched.physics.snapshot()
    assert quiet.digest() == watched.digest()


def test_distant_robot_changes_no_bit_of_a_collision():
    """A robot must not affect a distant one, not even by rounding."""
    elements = (
        '<box x="3m" y="5m" length="40cm" width="40cm" mass="2kg"/>'
        '<box x="4m" y="5.1m" length="40cm" width="40cm" mass="2kg"/><robot x="2m" y="5m"/>'
        '<robot x="8m" y="8m"/>'
    )
    alone, beside = Bench(world_of(elements)), Bench(world_of(elements))
    rng = np.random.default_rng(4)
    for number in range(300):
        angle = 0.02 * number
        mine = (0.4 * DT * math.cos(angle), 0.4 * DT * math.sin(angle))
        alone.push(mine, (0.0, 0.0))
        beside.push(mine, tuple(rng.uniform(-0.02, 0.02, 2)))
    near = [0, 2, 3]  # the first robot and both boxes
    assert np.array_equal(alone.bodies.position_m[near], beside.bodies.position_m[near])
    assert np.array_equal(alone.bodies.angle_rad[near], beside.bodies.angle_rad[near])
    assert not np.array_equal(alone.bodies.position_m[1], beside.bodies.position_m[1])
