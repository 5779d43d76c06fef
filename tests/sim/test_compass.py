"""The compass: its direction, its rate, and its calibration."""

import math

import numpy as np
import pytest

from crs_cc.sim.devices.compass import compasses
from crs_cc.sim.devices.vendor_state import COMPASS, CONF_TURRET
from tests.sim.driver import Driver, open_world, own_world

PLAIN = 'offset="0deg" deviation="0deg" calibration="180s" rate="10Hz" noise="0deg" on="no"'


def nomad(folder, compass: str = PLAIN, heading: float = 30.0) -> Driver:
    elements = f'<robot x="0" y="0" heading="{heading}"/>'
    return Driver.of(own_world(folder, (PLAIN, compass), elements=elements, robot="nomad200"))


def test_reads_world_direction_of_turret_in_tenths_of_degree(tmp_path):
    driver = nomad(tmp_path)
    assert driver.post("CONF_CP", 1)[0]["result"] == 1
    assert driver.ask("GET_CP")[COMPASS] == 300
    driver.ask("DA", 0, 0)  # it is independent of the odometry
    driver.ask("PR", 0, 0, 505)
    driver.run_s(10)
    assert driver.ask("GET_CP")[COMPASS] == 805
    driver.ask("PR", 0, 900, -1000)
    driver.run_s(10)
    assert driver.ask("GS")[COMPASS] == 3600 + 805 - 1000


def test_offset_sets_north(tmp_path):
    driver = nomad(tmp_path, PLAIN.replace('offset="0deg"', 'offset="-90deg"'))
    driver.ask("CONF_CP", 1)
    assert driver.ask("GET_CP")[COMPASS] == 3000


def test_reading_is_constant_while_off(tmp_path):
    driver = nomad(tmp_path)
    assert driver.ask("GET_CP")[COMPASS] == 0
    driver.ask("CONF_CP", 1)
    assert driver.ask("GET_CP")[COMPASS] == 300
    driver.ask("CONF_CP", 0)
    driver.ask("PR", 0, 0, 400)
    driver.run_s(10)
    assert driver.ask("GET_CP")[COMPASS] == 300


def test_rate_is_limited_to_10_hz(tmp_path):
    driver = nomad(tmp_path)
    driver.ask("CONF_CP", 1)
    driver.ask("SP", 100, 100, 450)
    driver.ask("PR", 0, 0, 3000)
    driver.run_s(2)
    seen = []
    for _ in range(20):
        seen.append(int(driver.ask("GET_CP")[COMPASS]))
        driver.run(1)
    assert len(set(seen)) == 10


def test_calibration_turns_turret_once_and_removes_deviation(tmp_path):
    text = PLAIN.replace('deviation="0deg"', 'deviation="10deg"').replace("180s", "20s")
    driver = nomad(tmp_path, text, heading=90)
    driver.ask("CONF_CP", 1)
    assert driver.ask("GET_CP")[COMPASS] == 900 + 100  # sin 90 deg
    assert driver.post("CONF_CP", 2)[0]["result"] == 1
    driver.run_s(10)
    half = driver.ask("GS")
    assert half[CONF_TURRET] == pytest.approx(1800, abs=60)
    driver.run_s(12)
    done = driver.ask("GS")
    assert done[CONF_TURRET] in {0, 3599}
    assert done[COMPASS] == 900


@pytest.mark.parametrize("mode", [-1, 3, 2**31 - 1])
def test_unknown_modes_are_refused(tmp_path, mode):
    assert nomad(tmp_path).post("CONF_CP", mode)[0]["result"] == 0


def test_scout_has_no_compass():
    driver = Driver.of(open_world())
    for name in ("GET_CP", "CONF_CP"):
        assert driver.post(name, 1)[0]["result"] == 0
    assert driver.ask("GS")[COMPASS] == 0


def test_noise_has_standard_deviation_of_definition(tmp_path):
    driver = nomad(tmp_path, PLAIN.replace('noise="0deg"', 'noise="2deg"'))
    driver.ask("CONF_CP", 1)
    seen = []
    for _ in range(300):
        driver.run(2)
        seen.append(int(driver.ask("GET_CP")[COMPASS]) / 10)
    assert np.mean(seen) == pytest.approx(30, abs=0.5)
    assert np.std(seen) == pytest.approx(2, abs=0.4)
    assert math.isfinite(compasses(driver.state).measured.at_s[0])
