"""Sources and nests: who takes which item when, and what is left."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from crs_cc.requests import CODES, MESSAGE
from crs_cc.sim.devices.carrier import CarrierState
from crs_cc.sim.devices.foraging import NestResult, SourceResult
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.model.world import WorldModel
from tests.device.robot import scout_with
from tests.sim.driver import Driver

MakeWorld = Callable[..., WorldModel]
ONE = '<robot x="2m" y="2m"/>'


@pytest.fixture
def world(tmp_path) -> MakeWorld:
    """Return a function that returns a world of Scouts that carry up to three items."""
    robot = scout_with(tmp_path, '<carrier capacity="3"/>')

    def make(places: str, robots: str = ONE) -> WorldModel:
        text = f'<world version="1"><area length="9m" width="4m"/>{places}{robots}</world>'
        return parse_world(text.encode(), "test", "", robot)

    return make


def take(driver: Driver, robot: int = 0) -> int:
    return int(driver.post("TAKE_ITEM", robot=robot)[0]["result"])


def drop(driver: Driver) -> int:
    return int(driver.post("DROP_ITEM")[0]["result"])


def items(driver: Driver) -> list[int]:
    return driver.state.device("carrier", CarrierState).items.tolist()


def test_robot_takes_as_many_as_it_holds_and_drops_them_one_by_one(world):
    driver = Driver.of(world('<source x="2m" y="2m"/><nest x="2m" y="2m"/>'))
    assert [drop(driver), *(take(driver) for _ in range(4))] == [0, 1, 1, 1, 0]
    assert [drop(driver) for _ in range(4)] == [1, 1, 1, 0]
    assert driver.environment.sources == (SourceResult("source0", 3, None),)
    assert driver.environment.nests == (NestResult("nest0", 3),)
    assert [event.text for event in driver.run(1)[0].events] == [
        *(3 * ["took an item from 'source0'"]),
        *(3 * ["brought an item to 'nest0'"]),
    ]


def test_centre_of_the_robot_must_be_in_the_place(world):
    near = '<source x="2m" y="2.3m" radius="0.3m"/>'
    far = '<source x="2m" y="2.31m" radius="0.3m"/><nest x="2.31m" y="2m"/>'
    assert take(Driver.of(world(near))) == 1
    driver = Driver.of(world(far))
    assert (take(driver), drop(driver)) == (0, 0)


def test_first_source_that_has_an_item_is_taken_from(world):
    places = '<source id="a" x="2m" y="2m" items="1"/><source id="b" x="2m" y="2m" items="5"/>'
    driver = Driver.of(world(places))
    assert [take(driver) for _ in range(3)] == [1, 1, 1]
    assert driver.environment.sources == (SourceResult("a", 1, 0), SourceResult("b", 2, 3))


def test_first_robot_of_the_world_gets_the_last_item(world):
    robots = '<robot x="2m" y="2m"/><robot x="2.5m" y="2m"/><robot x="1.5m" y="2m"/>'
    environment = Environment(world('<source x="2m" y="2m" radius="1m" items="2"/>', robots), 1)
    messages, at_s = np.zeros(3, MESSAGE), np.array([0.04, 0.02, 0.0])
    environment.serve(CODES["TAKE_ITEM"], np.arange(3), messages, at_s)
    assert messages["result"].tolist() == [1, 1, 0]


def test_source_is_refilled_up_to_its_first_number(world):
    """Counted in timesteps of 50 ms, from when it was full or had its last new item."""
    driver = Driver.of(world('<source x="2m" y="2m" items="2" refill="0.5s"/>'))

    def left() -> int | None:
        return driver.environment.sources[0].left

    driver.run(7)
    assert [take(driver), take(driver), take(driver)] == [1, 1, 0]
    driver.run(9)
    assert (left(), take(driver)) == (0, 0)
    driver.run(1)
    assert (left(), take(driver), left()) == (1, 1, 0)
    driver.run(9)
    assert left() == 0
    driver.run(1)
    assert left() == 1
    driver.run(100)
    assert left() == 2


def test_snapshot_has_the_items(world):
    driver = Driver.of(world('<source x="2m" y="2m" items="3"/><nest x="2m" y="2m"/>'))
    take(driver)
    kept = driver.environment.snapshot()
    before = driver.environment.sources, driver.environment.nests, items(driver)
    take(driver)
    drop(driver)
    driver.environment.restore(kept)
    assert (driver.environment.sources, driver.environment.nests, items(driver)) == before


def test_refilling_does_not_keep_time_from_being_skipped(world):
    driver = Driver.of(world('<source x="2m" y="2m" items="3" refill="1s"/>'))
    take(driver)
    driver.run(5)
    assert driver.environment.quiet_until() > 1000


def test_world_without_places_has_no_state_of_them(world):
    driver = Driver.of(world(""))
    assert driver.state.foraging is None
    assert (take(driver), drop(driver), driver.environment.sources) == (0, 0, ())
