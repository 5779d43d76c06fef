"""The compass: where it points, when it measures, how it is calibrated."""

import math

import numpy as np
import pytest

from crs_cc.sim.devices.vendor_state import COMPASS, CONF_TURRET
from tests.sim.driver import Driver, open_world, own_world

PLAIN = 'offset="0deg" deviation="0deg" calibration="180s" rate="10Hz" noise="0deg" on="no"'


def nomad(folder, compass: str = PLAIN, heading: float = 30.0) -> Driver:
    things = f'<robot x="0" y="0" heading="{heading}"/>'
    return Driver.of(own_world(folder, (PLAIN, compass), things=things, robot="nomad200"))


def test_it_reads_the_turrets_direction_in_the_world_in_tenths_of_a_degree(tmp_path):
    driver = nomad(tmp_path)
    assert driver.post("CONF_CP", 1)[0]["result"] == 1
    assert driver.ask("GET_CP")[COMPASS] == 300
    driver.ask("DA", 0, 0)  # the odometry means nothing to it
    driver.ask("PR", 0, 0, 505)
    driver.run_s(10)
    assert driver.ask("GET_CP")[COMPASS] == 805
    driver.ask("PR", 0, 900, -1000)
    driver.run_s(10)
    assert driver.ask("GS")[COMPASS] == 3600 + 805 - 1000


def test_an_offset_says_where_north_is(tmp_path):
    driver = nomad(tmp_path, PLAIN.replace('offset="0deg"', 'offset="-90deg"'))
    driver.ask("CONF_CP", 1)
    assert driver.ask("GET_CP")[COMPASS] == 3000


def test_while_it_is_off_the_reading_stays(tmp_path):
    driver = nomad(tmp_path)
    assert driver.ask("GET_CP")[COMPASS] == 0
    driver.ask("CONF_CP", 1)
    assert driver.ask("GET_CP")[COMPASS] == 300
    driver.ask("CONF_CP", 0)
    driver.ask("PR", 0, 0, 400)
    driver.run_s(10)
    assert driver.ask("GET_CP")[COMPASS] == 300


def test_it_measures_ten_times_a_second_at_most(tmp_path):
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


def test_calibration_turns_the_turret_once_around_and_takes_the_deviation_out(tmp_path):
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
def test_other_modes_are_refused(tmp_path, mode):
    assert nomad(tmp_path).post("CONF_CP", mode)[0]["result"] == 0


def test_a_scout_has_none():
    driver = Driver.of(open_world())
    for name in ("GET_CP", "CONF_CP"):
        assert driver.post(name, 1)[0]["result"] == 0
    assert driver.ask("GS")[COMPASS] == 0


def test_noise_has_the_spread_of_the_definition(tmp_path):
    driver = nomad(tmp_path, PLAIN.replace('noise="0deg"', 'noise="2deg"'))
    driver.ask("CONF_CP", 1)
    seen = []
    for _ in range(300):
        driver.run(2)
        seen.append(int(driver.ask("GET_CP")[COMPASS]) / 10)
    assert np.mean(seen) == pytest.approx(30, abs=0.5)
    assert np.std(seen) == pytest.approx(2, abs=0.4)
    assert math.isfinite(driver.state.compass.measured.at_s[0])
