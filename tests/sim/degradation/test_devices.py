"""Each device of a robot with something wrong with it, as a program is told.

wall |    <-- 2 m -->  (robot, looking at it)
"""

import math

import numpy as np
import pytest

from crs_cc.requests import CODES
from crs_cc.sim.devices.vendor_state import BUMPER, COMPASS, IR_0, SONAR_0
from tests.sim.driver import INCH, SCOUT_RADIUS_M, Driver, open_world, own_world

WALL_IN = 80
WALL_M = WALL_IN * INCH + SCOUT_RADIUS_M
WALL = f'<wall x1="{WALL_M + 0.05}" y1="-50" x2="{WALL_M + 0.05}" y2="50" thickness="10cm"/>'
SCOUT = '<robot x="0" y="0"/>'


def fault(device: str, attributes: str, robot: str = "robot0") -> str:
    return f'<degradation robot="{robot}" device="{device}" {attributes}/>'


def sonars(attributes: str, seconds: float = 2.0) -> list[int]:
    """Return what the sonars tell of a wall 80 in ahead."""
    driver = Driver.of(open_world(SCOUT + WALL + fault("sonar", attributes)))
    driver.run_s(seconds)
    return driver.ask("GET_SN")[SONAR_0 : SONAR_0 + 16].tolist()


# Along the side of each beam that is nearest to the wall's normal, from where sonar n sits:
# (88 - 8 cos 22.5n) / cos (22.5n - 10), in whole inches.
SOUND = [80, 83, 101, 158, *[255] * 9, 158, 101, 83]


@pytest.mark.parametrize(
    ("attributes", "told"),
    [
        ('dropouts="0.5" onset="50s"', SOUND),
        ('element="0" bias="10in"', [90, *SOUND[1:]]),
        ('element="0" bias="-100in"', [0, *SOUND[1:]]),
        ('element="0" gain="0.5"', [40, *SOUND[1:]]),
        ('element="0" gain="9"', [255, *SOUND[1:]]),  # beyond what can be heard in time
        ('element="0" step="50in"', [100, *SOUND[1:]]),
        ('element="4" stuck="7in"', [*SOUND[:4], 7, *SOUND[5:]]),
        ('element="0" dead="yes"', [255, *SOUND[1:]]),
        ('dead="yes"', [255] * 16),
        ('dropouts="1"', [255] * 16),
        ('dead="yes" duration="0.5s"', SOUND),
    ],
)
def test_sonars(attributes, told):
    assert sonars(attributes) == told


def test_sonars_that_stick_or_lag_tell_of_where_the_robot_was():
    """It backs from the wall by 10 in from 2 s on; both last heard of it before."""
    for attributes in ('stuck="hold" onset="2s"', 'delay="20s" onset="2s"'):
        driver = Driver.of(open_world(SCOUT + WALL + fault("sonar", f'element="0" {attributes}')))
        driver.run_s(2)
        driver.ask("PR", -100, -100)
        driver.run_s(6)
        told = driver.ask("GET_SN")[SONAR_0 : SONAR_0 + 16]
        assert (told[0], told[1]) == (80, 93)


def test_the_sonar_noise_is_that_of_each_robot_alone():
    def told(elements: str) -> list[list[int]]:
        driver = Driver.of(open_world(elements))
        rows = []
        for _ in range(40):
            driver.run(2)
            rows.append(driver.ask("GET_SN", robot=0)[SONAR_0:BUMPER].tolist())
        return rows

    two = SCOUT + '<robot x="0" y="5"/>' + WALL
    noisy = fault("sonar", 'noise="5in"')
    alone, both = told(two + noisy), told(two + noisy + fault("sonar", 'noise="5in"', "robot1"))
    assert alone == both
    assert np.std([row[0] for row in alone]) == pytest.approx(5.0, rel=0.5)


def test_the_reports_command_is_told_the_same():
    driver = Driver.of(open_world(SCOUT + WALL + fault("sonar", 'element="0" bias="10in"')))
    for now in (0, 1):
        message, _ = driver.post("SONAR", now)
        assert message["data"][:8].view("<i4").tolist() == [900, pytest.approx(826, abs=5)]


@pytest.mark.parametrize(
    ("attributes", "told"), [("", 0), ('element="3" stuck="1"', 8), ('stuck="1"', 255)]
)
def test_a_bumper_can_stick_though_nothing_touches_it(attributes, told):
    faults = fault("bumper", attributes) if attributes else ""
    driver = Driver.of(open_world(SCOUT + faults))
    driver.run(2)
    assert driver.ask("GET_BP")[BUMPER] == told


@pytest.mark.parametrize(
    ("attributes", "told"),
    [('dropouts="0.5" onset="99s"', 1), ('element="0" dead="yes"', 0), ('element="1" bias="1"', 3),
     ('element="0" gain="0.4"', 0), ('element="0" gain="0.6"', 1)],
)  # fmt: skip
def test_a_bumper_that_is_pressed(attributes, told):
    elements = SCOUT.replace('x="0"', f'x="{WALL_M - SCOUT_RADIUS_M - 0.01}"') + WALL
    driver = Driver.of(open_world(elements + fault("bumper", attributes)))
    driver.ask("VM", 100, 100)
    driver.run(20)
    assert driver.ask("GET_BP")[BUMPER] == told


RING = 'half-angle="5deg"'


@pytest.mark.parametrize(
    ("attributes", "told"),
    [
        ('bias="3in"', 8),
        ('gain="0.4"', 2),
        ('dead="yes"', 15),
        ('stuck="1in"', 1),
        ('step="3in"', 6),
    ],
)
def test_infrared(attributes, told):
    x_in = 22.5 / 2.54 + 5 + 1
    wall = f'<wall x1="{x_in}in" y1="-5m" x2="{x_in}in" y2="5m" thickness="2in"/>'
    nomad = '<robot definition="nomad200" x="0" y="0"/>'
    faults = fault("infrared", f'element="0" {attributes}')
    readings = Driver.of(open_world(nomad + wall + faults)).ask("GET_IR")[IR_0 : IR_0 + 16]
    assert (readings[0], readings[8]) == (told, 15)


@pytest.mark.parametrize(
    ("attributes", "told"),
    [('bias="-40deg"', 3500), ('stuck="12.5deg"', 125), ('dead="yes"', 0), ('step="45deg"', 450),
     ('gain="2"', 600)],
)  # fmt: skip
def test_the_compass(attributes, told):
    nomad = '<robot definition="nomad200" x="0" y="0" heading="30"/>'
    driver = Driver.of(open_world(nomad + fault("compass", attributes)))
    driver.ask("CONF_CP", 1)
    assert driver.ask("GET_CP")[COMPASS] == told


def test_a_compass_without_a_value_keeps_telling_the_last_one():
    nomad = '<robot definition="nomad200" x="0" y="0" heading="30"/>'
    driver = Driver.of(open_world(nomad + fault("compass", 'dead="yes" onset="1s"')))
    driver.ask("CONF_CP", 1)
    driver.ask("GET_CP")
    driver.ask("PR", 0, 0, 900)
    driver.run_s(9)
    assert driver.ask("GET_CP")[COMPASS] == 300


LASER = 'points="482" field-of-view="34.2deg"'


def laser_points(tmp_path, attributes: str) -> list[list[int]]:
    faults = fault("laser", attributes) if attributes else ""
    driver = Driver.of(open_world(
        '<robot definition="nomad200" x="0" y="0"/>'
        '<wall x1="2.05" y1="-5" x2="2.05" y2="5" thickness="10cm"/>' + faults
    ))  # fmt: skip
    driver.post("CONF_LS", 51, 0, 0, 5, 1)
    count = int(driver.post("GET_LS")[0]["i"][0])
    page, _ = driver.post("LASER_PAGE", 0)
    return page["data"][: 8 * count].view("<i4").reshape(-1, 2).tolist()


def test_the_laser(tmp_path):
    sound = laser_points(tmp_path, "")
    assert len(sound) == 5
    assert laser_points(tmp_path, 'element="2" dead="yes"') == sound[:2] + sound[3:]
    assert laser_points(tmp_path, 'dead="yes"') == []
    farther = laser_points(tmp_path, 'element="2" bias="10in"')
    assert farther[2][0] == sound[2][0] + 100
    assert farther[:2] == sound[:2]
    assert len(laser_points(tmp_path, 'stuck="1m"')) == 5  # as requested, of 482


def gps(tmp_path, attributes: str) -> Driver:
    change = ("<computer-battery", '<gps rate="10Hz"/><computer-battery')
    elements = '<robot x="30in" y="-4in"/>' + fault("gps", attributes)
    return Driver.of(own_world(tmp_path, change, elements=elements))


@pytest.mark.parametrize(
    ("attributes", "told"),
    [('bias="10in"', (1, 400, 60)), ('element="x" gain="2"', (1, 600, -40)),
     ('step="1m"', (1, 394, 0)), ('element="y" dead="yes"', (0,)), ('dropouts="1"', (0,))],
)  # fmt: skip
def test_gps(tmp_path, attributes, told):
    message, _ = gps(tmp_path, attributes).post("GPS")
    assert (int(message["result"]), *message["i"][: len(told) - 1].tolist()) == told


def test_gps_has_a_fix_again_when_it_is_over(tmp_path):
    driver = gps(tmp_path, 'dead="yes" duration="1s"')
    results = []
    for _ in range(30):
        results.append(int(driver.post("GPS")[0]["result"]))
        driver.run(1)
    assert results == [0] * 20 + [1] * 10


HOT = '<box x="1" y="0" length="10cm" width="10cm" heat="5"/>'


@pytest.mark.parametrize(
    ("attributes", "told"),
    [('gain="3"', 15), ('bias="-9"', 0), ('dead="yes"', 0), ('stuck="7"', 7), ('step="4"', 4)],
)
def test_the_heat_sensor(attributes, told):
    driver = Driver.of(open_world(SCOUT + HOT + fault("heat", attributes)))
    assert driver.post("HEAT")[0]["i"][0] == told


@pytest.mark.parametrize(
    ("attributes", "tagged"),
    [('gain="0.1"', 0), ('gain="0.9"', 1), ('dead="yes"', 0), ('bias="9"', 1)],
)
def test_the_tag(attributes, tagged):
    driver = Driver.of(open_world(SCOUT + HOT + fault("tag", attributes)))
    message, _ = driver.post("TAG")
    assert (message["result"], message["i"][0]) == (1, tagged)
    assert driver.post("HEAT")[0]["i"][0] == (0 if tagged else 5)


def test_the_batteries():
    """A byte n stands for (2 + 3 n / 255) * 12 / 5 V of the computers."""
    sound = Driver.of(open_world(SCOUT)).post("GS")[0]["i"][1:3].tolist()
    low = Driver.of(open_world(SCOUT + fault("battery", 'element="computers" stuck="11V"')))
    assert low.post("GS")[0]["i"][1:3].tolist() == [220, sound[1]]
    dead = Driver.of(open_world(SCOUT + fault("battery", 'dead="yes"')))
    assert dead.post("GS")[0]["i"][1:3].tolist() == [0, 0]


def test_predictions_know_nothing_of_it():
    elements = SCOUT + WALL + fault("sonar", 'bias="10in"')
    driver = Driver.of(open_world(elements))
    message, _ = driver.post("PREDICT", 0, 0, 0, 0)
    assert CODES["PREDICT"]
    assert message["data"][:180].view("<i4")[SONAR_0] == 80
    assert math.isfinite(driver.state.devices.sonar.echo_m[0, 0])
