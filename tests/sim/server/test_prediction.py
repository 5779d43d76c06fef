"""What sensors are told to read somewhere is what they read there."""

import numpy as np
import pytest

from crs_cc.sim.devices.vendor_state import BUMPER, IR_0, SONAR_0
from crs_cc.sim.engine.environment import Environment
from tests.sim.driver import Driver, told, world_of

ELEMENTS = (
    '<wall x1="200in" y1="0" x2="200in" y2="240in"/><cylinder x="60in" y="150in" radius="9in"/>'
    '<box x="150in" y="60in" heading="20" length="40in" width="20in"/>'
    '<polygon points="90in,200in 130in,180in 120in,230in 100in,210in"/>'
    '<robot x="250in" y="200in"/>'
)
ROOM = 'length="300in" width="250in"'
PLACES = [(40, 40, 0), (100, 120, 37), (160, 150, 200), (30, 225, 295), (128, 84, 90)]


def robot(definition: str, x: float, y: float, heading: float) -> Driver:
    """Return a robot that stands somewhere in the room, as the first one."""
    there = f'<robot x="{x}in" y="{y}in" heading="{heading}" definition="{definition}"/>'
    return Driver.of(world_of(there + ELEMENTS, ROOM))


def predicted(driver: Driver, x: float, y: float, heading: float):
    """Return the reply for a robot whose turret points ahead."""
    pose = (round(10 * number) for number in (x, y, heading, heading))
    return driver.post("PREDICT", *pose)[0]


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("definition", ["scout", "nomad200", "nomad150"])
def test_what_is_predicted_for_a_place_is_measured_there(definition, place):
    x, y, heading = place
    # The base of a Nomad 150 keeps its direction.
    first = robot(definition, 20, 120, heading if definition == "nomad150" else 0)
    state = told(predicted(first, x, y, heading))
    there = robot(definition, x, y, heading)
    there.ask("CT", data=bytes([0] + [1] * 43))
    measured = there.ask("GS")
    sonars = slice(SONAR_0, BUMPER)
    # Only the robot itself is elsewhere: where it started, its own sensors do not see it.
    assert state[sonars].tolist() == measured[sonars].tolist()
    assert state[IR_0:SONAR_0].tolist() == measured[IR_0:SONAR_0].tolist()
    assert not state[BUMPER:].any()
    assert state[SONAR_0:BUMPER].min() < 60
    if definition == "nomad200":
        assert state[IR_0:SONAR_0].min() <= 15


def pages(driver: Driver, count: int, is_predicted: int) -> list[int]:
    numbers: list[int] = []
    for first in range(0, count, 31):
        message, _ = driver.post("LASER_PAGE", first, is_predicted)
        numbers += message["data"][: message["size"]].view("<i4").tolist()
    return numbers


@pytest.mark.parametrize("mode", [51, 33])
def test_the_laser_is_predicted_as_it_is_set(mode):
    x, y, heading = 150, 130, 10
    first, there = robot("nomad200", 20, 120, 0), robot("nomad200", x, y, heading)
    for driver in (first, there):
        driver.ask("CT", data=bytes([0] + [1] * 43))
        driver.ask("CONF_LS", mode, 20, 20, 100, 4)
    count = int(predicted(first, x, y, heading)["i"][0])
    message, _ = there.post("GS")
    assert count == message["i"][0] > 0
    assert pages(first, count, 1) == pages(there, count, 0)
    first.ask("CONF_LS", 0, 20, 20, 100, 4)
    assert predicted(first, x, y, heading)["i"][0] == 0


def test_noise_and_order_mean_nothing_to_a_prediction():
    elements = '<robot x="20in" y="120in" setup="noisy"/>' + ELEMENTS
    driver = Driver(Environment(world_of(elements, ROOM), 1))
    driver.ask("CONNECT")
    state = told(predicted(driver, *PLACES[0]))
    driver.ask("CONF_SN", 15, data=bytes([255]))
    driver.run_s(2)
    assert np.array_equal(told(predicted(driver, *PLACES[0])), state)
    assert state[SONAR_0:BUMPER].min() < 60


@pytest.mark.parametrize("pose", [(-(2**31), 2**31 - 1, 2**31 - 1, 0), (10**6, 0, -1, -1)])
def test_far_away_there_is_nothing(pose):
    driver = robot("scout", 20, 120, 0)
    message, _ = driver.post("PREDICT", *pose)
    assert message["result"] == 1
    assert set(told(message)[SONAR_0:BUMPER].tolist()) == {255}
