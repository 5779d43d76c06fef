"""The noise of a robot's sensors is independent of other robots' devices."""

import numpy as np

from crs_cc.sim.files.world_xml import load_world
from crs_cc.sim.state.random_streams import SONAR, Noise
from tests.sim.driver import Driver

NOISY = """<infrared step="4cm" noise="2in"/><compass noise="2deg"/>
    <laser field-of-view="90deg" range="5m" noise="5mm"/><gps noise="1in"/>
    <inclinometer noise="1deg"/><camera noise="9mm"/>"""
BARE = """<robot-definition version="1" name="{name}"><body radius="10cm" mass="3kg"/>
    <drive wheel-base="20cm" speed-limit="1m/s" acceleration-limit="1m/s2" speed="1m/s"
           acceleration="1m/s2"/>{devices}</robot-definition>"""


def told(tmp_path, first: str) -> list:
    """Return the replies to robot 1, 0.7 m from a wall; the first robot is far away."""
    for name, devices in (("with", NOISY), ("without", "")):
        (tmp_path / f"{name}.xml").write_text(BARE.format(name=name, devices=devices))
    (tmp_path / "world.xml").write_text(
        f"""<world version="1"><area length="99m" width="99m" origin="centre" edge="0"/>
        <wall x1="30cm" y1="-2m" x2="30cm" y2="2m"/>
        <robot x="0" y="40m" definition="{first}.xml"/>
        <robot x="0" y="0" definition="with.xml"/></world>"""
    )
    driver = Driver.of(load_world(tmp_path / "world.xml"))
    driver.post("CONF_LS", 51, 20, 20, 482, 1, robot=1)
    driver.post("CONF_CP", 1, robot=1)
    found = []
    for _ in range(3):
        driver.run_s(1.0)
        found += [driver.ask(name, robot=1).tolist() for name in ("GET_IR", "GET_CP")]
        found += [driver.post(name, robot=1)[0]["i"].tolist() for name in ("GPS", "TILT")]
        state = driver.state
        driver.post("CAMERA", robot=1)
        driver.post("LASER", robot=1)
        found += [
            state.devices.camera.readings.value[-1].tolist(),
            state.devices.laser.readings.value[-1].tolist(),
        ]
    return found


def test_noise_is_independent_of_devices_of_other_robots(tmp_path):
    beside_one_with, beside_one_without = (told(tmp_path, name) for name in ("with", "without"))
    for sensor in range(6):
        readings = beside_one_with[sensor::6]
        assert readings == beside_one_without[sensor::6]
        assert readings[0] != readings[1] or readings[1] != readings[2], "there is noise"


def test_rows_of_a_stream_in_one_call_are_those_of_many_calls():
    """Also if they are in different blocks, of which only one is held."""
    numbers = np.array([700, 0, 63, 64, 65, 0, 128, 64, 700])
    streams = np.array([1, 0, 0, 0, 1, 1, 0, 0, 1])
    alone = Noise(seed=1, sensor=SONAR, width=3, robots=2)
    rows = [alone.rows(streams[i : i + 1], numbers[i : i + 1])[0] for i in range(len(numbers))]
    together = Noise(seed=1, sensor=SONAR, width=3, robots=2)
    assert np.array_equal(together.rows(streams, numbers), rows)
