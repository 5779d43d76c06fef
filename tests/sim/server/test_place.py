"""Robots that are put somewhere else."""

import math
import pickle

import pytest

from crs_cc.sim.devices.vendor_state import CONF_STEER, CONF_TURRET, CONF_X, CONF_Y, SONAR_0
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.engine.step import describe_slice
from tests.sim.driver import INCH, Driver, world_of

ROOM = 'length="400in" width="400in"'
DESK = '<box id="desk" x="200in" y="200in" length="100in" width="100in"/>'
TWO = '<robot x="50in" y="50in"/><robot x="350in" y="50in" heading="90"/>'


def put(driver: Driver, *pose: int, robot: int = 0):
    """Places a robot; gives the result, and when the program goes on."""
    message, goes_on_s = driver.post("PLACE_ROBOT", *pose, robot=robot)
    return int(message["result"]), goes_on_s


def test_a_robot_stands_where_it_was_put_and_knows_it():
    driver = Driver.of(world_of(TWO, ROOM))
    driver.run(3)
    result, goes_on_s = put(driver, 1000, 3000, 900, 450)
    assert (result, goes_on_s) == (1, pytest.approx(0.2))
    driver.run(1)
    state = driver.state
    assert [state.x_m[0], state.y_m[0]] == pytest.approx([100 * INCH, 300 * INCH])
    assert math.degrees(state.heading_rad[0]) == pytest.approx(90)
    told = driver.ask("GET_RC")[[CONF_X, CONF_Y, CONF_STEER, CONF_TURRET]]
    assert told.tolist() == [1000, 3000, 900, 0]  # a Scout has no turret
    driver.ask("PR", 500, 500)
    driver.run_s(10)
    assert [state.x_m[0], state.y_m[0]] == pytest.approx([100 * INCH, 350 * INCH])


def test_no_state_comes_with_the_answer():
    # The axes have been turned to the instant of the request; the program goes on at a later one.
    driver = Driver.of(world_of(TWO, ROOM))
    message, _ = driver.post("PLACE_ROBOT", 1000, 3000, 900, 450, at_s=0.01)
    assert message["size"] == 0
    (step,) = driver.run(1)
    assert describe_slice(step, 0).answers[-1].values == {}


def test_sensors_see_from_the_new_place_and_others_see_it_there():
    driver = Driver.of(world_of(TWO, ROOM))
    driver.run_s(2)
    assert put(driver, 3500, 2500, 2700, 0)[0] == 1
    driver.run_s(2)
    for robot in range(2):  # face to face, 200 in apart
        assert driver.ask("GET_SN", robot=robot)[SONAR_0] == pytest.approx(200 - 16, abs=1)


@pytest.mark.parametrize(
    "pose",
    [
        (2000, 2000), (1440, 2000), (3500, 600), (70, 2000), (2000, 3930), (-500, 0),
        (2**31 - 1, -(2**31)),
    ],
)  # fmt: skip
def test_a_place_that_is_not_free_is_refused_and_nothing_changes(pose):
    driver = Driver.of(world_of(TWO + DESK, ROOM))
    before = driver.state.bodies.position_m.copy()
    assert put(driver, *pose, 0, 0)[0] == 0
    driver.run(1)
    assert driver.state.bodies.position_m.tolist() == before.tolist()


def test_touching_is_allowed():
    driver = Driver.of(world_of(TWO + DESK, ROOM))
    assert put(driver, 1420, 2000, 0, 0)[0] == 1
    assert put(driver, 80, 80, 0, 0, robot=1)[0] == 1


def test_what_was_pushed_away_leaves_its_place_free():
    can = '<cylinder x="100in" y="50in" radius="6in" mass="1kg"/>'
    driver = Driver.of(world_of(TWO + can, ROOM))
    assert put(driver, 1000, 500, 0, 0, robot=1)[0] == 0
    driver.ask("VM", 100, 100)
    driver.run_s(12)
    driver.ask("VM", -100, -100)
    driver.run_s(10)
    assert put(driver, 1000, 500, 0, 0, robot=1)[0] == 1


def test_a_motion_goes_on_from_the_new_place():
    driver = Driver.of(world_of(TWO, ROOM))
    driver.ask("PR", 600, 600)
    driver.run_s(2)
    went_in = driver.state.x_m[0] / INCH - 50
    assert put(driver, 1000, 3000, 900, 0)[0] == 1
    driver.run_s(10)
    assert driver.state.y_m[0] / INCH == pytest.approx(300 + 60 - went_in)


def test_a_nomad_is_put_with_its_turret_and_keeps_its_base():
    nomad = '<robot definition="nomad200" x="50in" y="50in"/>'
    driver = Driver.of(world_of(nomad, ROOM))
    assert put(driver, 1000, 1000, 900, 1800)[0] == 1
    driver.run(1)
    state = driver.state
    angles = [state.heading_rad[0], state.mount_rad[0], state.base_rad[0]]
    assert [math.degrees(angle) for angle in angles] == pytest.approx([90, 180, 0])
    assert driver.ask("GET_RC")[[CONF_STEER, CONF_TURRET]].tolist() == [900, 1800]


def test_after_a_place_everything_goes_on_from_a_snapshot_to_the_same_bits():
    world = world_of(TWO + '<cylinder x="90in" y="50in" radius="6in" mass="1kg"/>', ROOM)
    driver = Driver.of(world)
    driver.ask("VM", 200, 200)
    driver.run(20)
    assert put(driver, 600, 510, 0, 0)[0] == 1
    driver.run(7)
    snapshot = pickle.loads(pickle.dumps(driver.environment.snapshot()))
    driver.run(60)
    other = Environment(world, 1)
    other.restore(snapshot)
    for _ in range(60):
        other.step()
    assert other.hash() == driver.environment.hash()
