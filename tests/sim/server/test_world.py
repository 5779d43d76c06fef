"""Obstacles that programs add, move and take away while the world runs."""

import numpy as np
import pytest

from crs_cc.sim.devices.vendor_state import BUMPER
from crs_cc.sim.engine.server import world as server
from tests.sim.driver import INCH, SCOUT_RADIUS_M, Driver, open_world, world_of

BLOCK = ((300, -200), (500, -200), (500, 200), (300, 200))
BESIDE = ((300, 300), (500, 300), (500, 500))


def vertices(corners) -> bytes:
    return np.array(corners, "<i4").tobytes()


def obstacle(driver: Driver, name: str, corners, *by: int, robot: int = 0):
    """Post a request about a polygon and gives the message that came back."""
    message, _ = driver.post(name, len(corners), *by, robot=robot, data=vertices(corners))
    return message


def ahead(driver: Driver, robot: int = 0, sonar: int = 0) -> float:
    """Return what a sonar hears in a new cycle [in]; 0 is the one ahead."""
    driver.run(1)
    message, _ = driver.post("SONAR", 1, robot=robot)
    return int(message["data"][:64].view("<i4")[sonar]) / 10


def test_an_obstacle_is_heard_moved_and_heard_no_more():
    driver = Driver.of(open_world())
    assert obstacle(driver, "ADD_OBSTACLE", BLOCK)["result"] == 1
    assert ahead(driver) == 30 - 8
    moved = obstacle(driver, "MOVE_OBSTACLE", BLOCK, 200, -100)
    assert moved["result"] == 1
    assert moved["i"][0] == 4
    corners = moved["data"][:32].view("<i4").reshape(-1, 2)
    assert corners.tolist() == [[x + 200, y - 100] for x, y in BLOCK]
    assert ahead(driver) == 50 - 8
    assert obstacle(driver, "DELETE_OBSTACLE", corners)["result"] == 1
    assert ahead(driver) < 0


def test_a_robot_drives_into_an_obstacle_and_on_when_it_is_gone():
    driver = Driver.of(open_world())
    obstacle(driver, "ADD_OBSTACLE", BLOCK)
    driver.ask("VM", 200, 200)
    steps = driver.run_s(3)
    names = [step.names[other] for step in steps for other in step.contacts.other]
    assert names == ["obstacle-0"]
    assert driver.ask("GS")[BUMPER] != 0
    assert driver.state.x_m[0] == pytest.approx(30 * INCH - SCOUT_RADIUS_M, abs=0.001)
    obstacle(driver, "DELETE_OBSTACLE", BLOCK)
    driver.run_s(1)
    assert driver.ask("GS")[BUMPER] == 0
    assert driver.state.x_m[0] > 35 * INCH


def test_a_program_gets_a_change_back_at_the_end_of_the_timestep():
    driver = Driver.of(open_world())
    _, at_s = driver.post("ADD_OBSTACLE", 4, at_s=0.01, data=vertices(BLOCK))
    assert at_s == 0.05


@pytest.mark.parametrize("start", range(4))
@pytest.mark.parametrize("step", [1, -1])
def test_an_obstacle_is_known_by_its_corners_whichever_comes_first(start, step):
    driver = Driver.of(open_world())
    obstacle(driver, "ADD_OBSTACLE", np.roll(BLOCK, start, axis=0)[::step])
    assert obstacle(driver, "DELETE_OBSTACLE", BLOCK)["result"] == 1
    assert obstacle(driver, "DELETE_OBSTACLE", BLOCK)["result"] == 0


WRONG = {
    "two corners": BLOCK[:2],
    "eleven corners": [(300 + 10 * n, (n % 2) * 100 - 10 * n) for n in range(11)],
    "no area": [(300, 0), (400, 0), (500, 0)],
    "crossing sides": [(300, 0), (500, 200), (300, 200), (500, 0)],
    "a corner twice": [(300, 0), (500, 0), (500, 0), (300, 200)],
    "on a robot": [(-50, -50), (50, -50), (50, 50), (-50, 50)],
    "a robot inside": [(-500, -500), (500, -500), (500, 500), (-500, 500)],
    "reaching under a robot": [(79, -5), (500, -5), (500, 5), (79, 5)],
    "too far away": [(2**31 - 1, 0), (2**31 - 1, 100), (2**31 - 100, 50)],
    "as far as it goes": [(-(2**31), 0), (-(2**31), 100), (0, 1000)],
}


@pytest.mark.parametrize("name", WRONG)
def test_a_polygon_that_cannot_be_is_refused(name):
    driver = Driver.of(open_world())
    before = driver.state.obstacles
    assert obstacle(driver, "ADD_OBSTACLE", WRONG[name])["result"] == 0
    assert driver.state.obstacles is before
    assert obstacle(driver, "DELETE_OBSTACLE", WRONG[name])["result"] == 0
    assert obstacle(driver, "MOVE_OBSTACLE", WRONG[name], 1, 1)["result"] == 0


def test_an_obstacle_may_touch_a_robot():
    driver = Driver.of(open_world())
    assert obstacle(driver, "ADD_OBSTACLE", [(80, -5), (500, -5), (500, 5)])["result"] == 1


@pytest.mark.parametrize("by", [(-300, 0), (2**31 - 1, 0)])
def test_a_move_to_where_nothing_may_stand_changes_nothing(by):
    driver = Driver.of(open_world())
    obstacle(driver, "ADD_OBSTACLE", BLOCK)
    assert obstacle(driver, "MOVE_OBSTACLE", BLOCK, *by)["result"] == 0
    assert ahead(driver) == 30 - 8


def test_there_is_an_end_to_the_obstacles_of_a_robot_and_of_all(monkeypatch):
    monkeypatch.setattr(server, "MAX_OWN", 3)
    monkeypatch.setattr(server, "MAX_ALL", 5)
    driver = Driver.of(open_world('<robot x="0" y="0"/><robot x="0" y="-1m"/>'))
    places = [[(x + 300 * n, y) for x, y in BESIDE] for n in range(8)]
    told = [obstacle(driver, "ADD_OBSTACLE", place)["result"] for place in places[:4]]
    assert told == [1, 1, 1, 0]
    told = [obstacle(driver, "ADD_OBSTACLE", place, robot=1)["result"] for place in places[4:]]
    assert told == [1, 1, 0, 0]
    # Anybody may move or take away what another one added; it stays the other one's.
    assert obstacle(driver, "MOVE_OBSTACLE", places[4], 0, 500)["result"] == 1
    assert driver.state.obstacles.owners.tolist() == [0, 0, 0, 1, 1]
    assert obstacle(driver, "DELETE_OBSTACLE", places[0], robot=1)["result"] == 1
    assert obstacle(driver, "ADD_OBSTACLE", places[0], robot=1)["result"] == 1


ELEMENTS = (
    '<wall x1="3m" y1="-2m" x2="3m" y2="2m"/><box x="1.2m" y="0" length="60cm" width="60cm"/>'
    '<cylinder x="2m" y="0" radius="20cm" mass="2kg"/><polygon points="-3,0 -2,0 -2,1" id="p"/>'
    '<robot x="0" y="0"/><robot x="0" y="-1m"/>'
)


def test_new_world_takes_everything_away_but_the_edge_and_the_robots():
    area = 'length="10m" width="10m" origin="centre"'
    driver = Driver.of(world_of(ELEMENTS, area))
    obstacle(driver, "ADD_OBSTACLE", [(100, 400), (200, 400), (200, 500)])
    assert ahead(driver) == pytest.approx((0.9 - SCOUT_RADIUS_M) / INCH, abs=0.1)
    message, _ = driver.post("NEW_WORLD")
    assert message["result"] == 1
    assert ahead(driver) == pytest.approx((5 - SCOUT_RADIUS_M) / INCH, abs=0.1)
    assert [solid.id[:5] for solid in driver.environment.world_now.solids()] == ["edge-"] * 4
    assert driver.state.heat.left.shape == (6,)
    assert ahead(driver, 1, 4) == pytest.approx((1 - 2 * SCOUT_RADIUS_M) / INCH, abs=0.1)


def test_boxes_and_polygons_of_the_world_file_can_be_moved_and_taken_away():
    driver = Driver.of(open_world(ELEMENTS))
    box = [(354, -118), (591, -118), (591, 118), (354, 118)]
    moved = obstacle(driver, "MOVE_OBSTACLE", box, 0, 1000)
    assert moved["result"] == 1
    assert ahead(driver) == pytest.approx((1.8 - SCOUT_RADIUS_M) / INCH, abs=0.1)
    assert obstacle(driver, "DELETE_OBSTACLE", box)["result"] == 0
    now = moved["data"][:32].view("<i4").reshape(-1, 2)
    assert obstacle(driver, "DELETE_OBSTACLE", now)["result"] == 1
    triangle = [
        (round(x * 1e4 / 25.4), round(y * 1e4 / 25.4)) for x, y in [(-2, 1), (-3, 0), (-2, 0)]
    ]
    assert obstacle(driver, "DELETE_OBSTACLE", triangle)["result"] == 1
    assert [solid.id for solid in driver.environment.world_now.solids()] == ["wall0", "cylinder0"]


def test_what_is_pushed_stays_where_it_is_when_obstacles_come_and_go():
    elements = (
        '<box x="60cm" y="0" length="30cm" width="30cm" mass="2kg" heat="7"/>'
        '<cylinder x="0" y="3m" radius="10cm" heat="5"/><robot x="0" y="0"/>'
    )
    driver = Driver.of(open_world(elements))
    driver.ask("VM", 100, 100)
    driver.run_s(3)
    collisions = driver.state.collisions.copy()
    for change in ("ADD_OBSTACLE", "DELETE_OBSTACLE"):
        bodies = driver.state.bodies.position_m.copy()
        obstacle(driver, change, BESIDE)
        assert np.array_equal(driver.state.bodies.position_m, bodies)
        driver.run_s(1)
        assert driver.state.bodies.position_m[1, 0] > bodies[1, 0] + 0.15
    assert np.array_equal(driver.state.collisions, collisions)  # the contact with the box goes on
    assert driver.state.heat.left.tolist() == [0, 7, 5]


def crowd() -> Driver:
    places = [(x, y) for x in (1, 2) for y in (1, 2)]
    robots = "".join(f'<robot x="{x}m" y="{y}m" heading="{90 * x}"/>' for x, y in places)
    driver = Driver.of(world_of(f'{robots}<box x="3m" y="2m" length="0.3" width="0.3" mass="2"/>'))
    for robot in range(4):
        driver.ask("VM", 150, 140 - 20 * robot, robot=robot)
    return driver


CORNERS = ((1000, 1000), (1300, 1000), (1300, 1300), (1100, 1100))
CHANGES = (
    ("ADD_OBSTACLE", CORNERS), ("MOVE_OBSTACLE", CORNERS, -400, 30), ("ADD_OBSTACLE", CORNERS),
    ("NEW_WORLD", ()), ("ADD_OBSTACLE", CORNERS),
)  # fmt: skip


def change(driver: Driver, first: int, last: int) -> None:
    """Adds and removes objects in a world of robots in motion."""
    for number, (name, corners, *by) in enumerate(CHANGES[first:last], first):
        assert obstacle(driver, name, corners, *by, robot=number % 4)["result"] == 1
        driver.run(15)


@pytest.mark.parametrize("at", [1, 2, 3, 4])
def test_a_changed_world_goes_on_from_a_snapshot_to_the_same_bits(at, monkeypatch):
    monkeypatch.setattr("crs_cc.sim.physics.simulation.REBUILD", 7)
    straight = crowd()
    change(straight, 0, len(CHANGES))
    driver, fresh = crowd(), crowd()
    change(driver, 0, 1)
    first = driver.environment.snapshot()
    change(driver, 1, at)
    fresh.environment.restore(driver.environment.snapshot())
    change(fresh, at, len(CHANGES))
    assert fresh.environment.hash() == straight.environment.hash()
    driver.environment.restore(first)
    change(driver, 1, len(CHANGES))
    assert driver.environment.hash() == straight.environment.hash()
