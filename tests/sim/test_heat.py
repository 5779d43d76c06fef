"""Heat: the readings of a robot's sensor, and the effect of tagging."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from crs_cc.core.errors import WorldError
from crs_cc.sim.files import world_xml
from crs_cc.sim.files.world_xml import load_robot, load_world
from tests.sim.driver import SCOUT_RADIUS_M, Driver, open_world, world_of

ROBOTS = Path(world_xml.__file__).parent / "robots"


def heat(driver: Driver, robot: int = 0) -> int:
    message, _ = driver.post("HEAT", robot=robot)
    assert message["result"] == 1
    return int(message["i"][0])


def of(elements: str, robot: str = '<robot x="0" y="0"/>') -> Driver:
    return Driver.of(open_world(robot + elements))


def test_sensor_reads_0_without_heat():
    assert heat(of('<cylinder x="1m" y="0" radius="20cm"/>')) == 0


def test_heat_in_range_is_summed_independently_of_distance():
    stove = '<cylinder x="{}m" y="0" radius="20cm" heat="{}"/>'
    assert heat(of(stove.format(1, 1))) == 1
    assert heat(of(stove.format(-3, 1))) == 1
    assert heat(of(stove.format(1, 1) + stove.format(-3, 2.5) + stove.format(9, 5))) == 4


@pytest.mark.parametrize(
    ("obj", "edge_m"),
    [
        ('<cylinder x="{}m" y="0" radius="50cm" heat="1"/>', 0.5),
        ('<box x="{}m" y="0" length="2m" width="1m" heat="1"/>', 1.0),
        ('<box x="{}m" y="0" heading="90" length="2m" width="1m" heat="1" mass="9kg"/>', 0.5),
        ('<box x="0" y="{}m" length="2m" width="1m" heat="1"/>', 0.5),
        ('<robot x="0" y="{}m" heat="1"/>', SCOUT_RADIUS_M),
        ('<wall x1="{0}m" y1="-4m" x2="{0}m" y2="1m" thickness="20cm" heat="1"/>', 0.1),
        ('<wall x1="{}m" y1="0" x2="8m" y2="0" thickness="20cm" heat="1"/>', 0.1),
        ('<polygon points="{0},-1 {0},1 9,0" heat="1"/>', 0.0),
        ('<polygon points="{0},0 9,-1 9,1" heat="1" mass="2kg"/>', 0.0),
    ],
)
def test_distance_is_that_of_nearest_point(obj: str, edge_m: float):
    assert heat(of(obj.format(3 + edge_m - 0.01))) == 1
    assert heat(of(obj.format(3 + edge_m + 0.01))) == 0


def test_robot_in_concavity_is_outside_polygon():
    """A U of hot walls around the robot, 4 m from it: the distance is that of the nearest."""
    around = "-5,-5 5,-5 5,5 4,5 4,-4 -4,-4 -4,5 -5,5"
    assert heat(of(f'<polygon points="{around}" heat="1"/>')) == 0
    nearer = around.replace("-4,-4", "-4,-2.9").replace("4,-4", "4,-2.9")
    assert heat(of(f'<polygon points="{nearer}" heat="1"/>')) == 1


def test_walls_do_not_stop_heat():
    wall = '<wall x1="50cm" y1="-5m" x2="50cm" y2="5m"/>'
    assert heat(of(wall + '<cylinder x="1m" y="0" radius="20cm" heat="1"/>')) == 1


def test_robots_sense_heat_of_others_only():
    driver = of("", '<robot x="0" y="0" heat="3"/><robot x="1m" y="0" heat="4"/>')
    assert (heat(driver, 0), heat(driver, 1)) == (4, 3)


def test_tagging_removes_heat_in_range_for_all_robots():
    elements = '<cylinder x="2m" y="0" radius="20cm" heat="1"/><robot x="1m" y="0" heat="1"/>'
    far = '<cylinder x="5m" y="0" radius="20cm" heat="7"/>'
    driver = of(elements + far, '<robot x="0" y="0" heat="2"/>')
    assert heat(driver, 0) == 2
    message, _ = driver.post("TAG")
    assert (message["result"], message["i"][0]) == (1, 2)
    assert driver.state.heat.left.tolist() == [2.0, 0.0, 0.0, 7.0]
    assert heat(driver, 0) == 0
    assert heat(driver, 1) == 2, "its own heat stays with the one who tags"
    message, _ = driver.post("TAG")
    assert message["i"][0] == 0


def test_heat_moves_with_pushed_object():
    box = '<box x="5m" y="5m" length="40cm" width="40cm" mass="1kg" heat="1"/>'
    driver = Driver.of(world_of(box + '<robot x="3m" y="5m"/><robot x="9m" y="5m"/>'))
    assert heat(driver, 1) == 0
    driver.ask("VM", 300, 300)
    driver.run_s(5)
    assert driver.state.bodies.position_m[2, 0] > 6
    assert heat(driver, 1) == 1


def test_batched_readings_equal_single_readings():
    generator = np.random.default_rng(7)
    places = generator.uniform(0.5, 19.5, (60, 2))
    elements = "".join(
        f'<robot x="{x:.3f}m" y="{y:.3f}m" heat="{1 + number % 3}"/>'
        for number, (x, y) in enumerate(places.round(3))
        if all(np.hypot(*(places[:number] - (x, y)).T) > 0.5)
    )
    driver = Driver.of(world_of(elements, 'length="20m" width="20m" edge="0"'))
    state = driver.state
    for robot in range(len(state.x_m)):
        apart_m = np.hypot(state.x_m - state.x_m[robot], state.y_m - state.y_m[robot])
        near = apart_m <= 3 + SCOUT_RADIUS_M
        near[robot] = False
        assert heat(driver, robot) == state.heat.left[near].sum()


def test_heat_is_part_of_snapshot_and_hash():
    driver = of('<cylinder x="2m" y="0" radius="20cm" heat="1"/>')
    before, hash_before = driver.environment.snapshot(), driver.environment.hash()
    driver.post("TAG")
    assert driver.environment.hash() != hash_before
    driver.environment.restore(before)
    assert driver.environment.hash() == hash_before
    assert heat(driver) == 1


def test_robot_without_heat_sensor_refuses(tmp_path):
    bare = """<robot-definition version="1" name="bare"><body radius="10cm" mass="3kg"/>
        <drive wheel-base="20cm" speed-limit="1m/s" acceleration-limit="1m/s2" speed="1m/s"
               acceleration="1m/s2"/>{}</robot-definition>"""
    (tmp_path / "bare.xml").write_text(bare.format(""))
    (tmp_path / "hot.xml").write_text(bare.format('<heat range="2m" tag-range="1m"/>'))
    world = """<world version="1"><area length="9m" width="9m"/>
        <robot x="2m" y="2m" definition="bare.xml"/><robot x="4m" y="2m" definition="hot.xml"/>
        <cylinder x="5.5m" y="2m" radius="20cm" heat="1"/></world>"""
    (tmp_path / "world.xml").write_text(world)
    driver = Driver.of(load_world(tmp_path / "world.xml"))
    for request in ("HEAT", "TAG"):
        message, _ = driver.post(request, robot=0)
        assert (message["result"], message["i"][0]) == (0, 0)
        assert driver.state.heat.left[2:].max() == 1.0
    assert heat(driver, 1) == 1
    message, _ = driver.post("TAG", robot=1)
    assert (message["result"], message["i"][0]) == (1, 0), "as near as 1m is nothing hot"


@pytest.mark.parametrize("heat_", ["-1", "warm", "1m", "1e9"])
def test_invalid_heat_is_refused(heat_: str):
    with pytest.raises(WorldError, match="heat"):
        of(f'<cylinder x="2m" y="0" radius="20cm" heat="{heat_}"/>')


def test_errors_of_the_element_of_two_devices_are_reported_once(tmp_path):
    scout = (ROBOTS / "scout.xml").read_text()
    wrong = '<heat range="-3m" tag-range="near"/>'
    (tmp_path / "wrong.xml").write_text(scout.replace('<heat range="3m"/>', wrong))
    with pytest.raises(WorldError) as error:
        load_robot(tmp_path / "wrong.xml")
    assert str(error.value).count("heat, range: ") == str(error.value).count("tag-range: ") == 1


def test_tagging_device_needs_no_sensor(tmp_path):
    scout = (ROBOTS / "scout.xml").read_text()
    tags = '<heat range="0m" tag-range="2m"/>'
    (tmp_path / "tags.xml").write_text(scout.replace('<heat range="3m"/>', tags))
    model = load_robot(tmp_path / "tags.xml")
    assert (model.device("heat"), model.device("tag").range_m) == (None, 2.0)
