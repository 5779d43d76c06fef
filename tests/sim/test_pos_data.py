"""Positions attached to readings: posDataRequest's bits, pages, times of the sensor board."""

import math

import numpy as np
import pytest

from crs_cc.requests import CODES, MESSAGE
from tests.sim.driver import INCH, Driver, open_world, own_world, world_of

INFRARED, SONAR, BUMPER, LASER, COMPASS = 1, 2, 4, 8, 16
NOMAD = '<robot definition="nomad200" x="0" y="0"/>'
X, Y, STEER, TURRET, TRANS = range(5)
CONFIG_TIME, TIME = 7, 8


def request(driver: Driver, kinds: int, robot: int = 0) -> None:
    mask = bytes([kinds] + [1] * 43)
    assert driver.post("CT", data=mask, robot=robot)[0]["result"] == 1


def pos_data(driver: Driver, kind: int, robot: int = 0) -> np.ndarray:
    """Return the PosData of a kind of sensor, as the client fetches it, (sensors, 9)."""
    found: list = []
    while True:
        page, _ = driver.post("POS_DATA", kind, len(found), robot=robot)
        size = int(page["result"])
        if not size:
            return np.array(found)
        assert size <= 6
        assert page["size"] == 36 * size
        found += page["data"][: 36 * size].view("<i4").reshape(size, 9).tolist()


def board_ms(time_s: float) -> int:
    return math.floor(time_s / 0.0164 + 1e-9) * 164 // 10


def test_rings_have_sixteen_entries_and_others_one():
    driver = Driver.of(open_world(NOMAD))
    assert len(pos_data(driver, SONAR)) == 0  # nobody has asked
    request(driver, INFRARED | SONAR | BUMPER | LASER | COMPASS)
    counts = [len(pos_data(driver, kind)) for kind in (INFRARED, SONAR, BUMPER, LASER, COMPASS)]
    assert counts == [16, 16, 1, 1, 1]
    for kind in (0, 3, 32, -1):
        assert len(pos_data(driver, kind)) == 0


def test_configuration_is_that_at_reading():
    driver = Driver.of(open_world(NOMAD))
    driver.ask("CONF_CP", 1)
    driver.ask("CONF_LS", 51, 20, 20, 20, 4)
    request(driver, INFRARED | LASER | COMPASS)
    driver.ask("VM", 100, 100, -50)
    driver.run_s(3)
    at_s = driver.environment.time_s + 0.013
    told = driver.ask("GS", at_s=at_s)
    for kind in (INFRARED, LASER, COMPASS):
        for row in pos_data(driver, kind):
            assert row[:7].tolist() == told[34:41].tolist()
            assert row[CONFIG_TIME] == row[TIME] == board_ms(at_s)


def test_only_requested_kinds_are_reported():
    driver = Driver.of(open_world(NOMAD))
    request(driver, INFRARED)
    driver.run_s(1)
    driver.ask("GS")
    assert pos_data(driver, INFRARED)[0, TIME] == board_ms(1.0)
    assert (pos_data(driver, SONAR) == 0).all()
    request(driver, 0)
    driver.run_s(1)
    driver.ask("GS")
    assert pos_data(driver, INFRARED)[0, TIME] == board_ms(1.0)  # as it was told last


def test_reply_of_one_kind_contains_that_kind():
    driver = Driver.of(open_world(NOMAD))
    request(driver, INFRARED | SONAR | COMPASS)
    driver.ask("CONF_CP", 1)
    driver.run_s(1)
    driver.ask("GET_CP")
    assert pos_data(driver, COMPASS)[0, TIME] == board_ms(1.0)
    assert pos_data(driver, INFRARED)[0, TIME] == 0  # the reply to CONF_CP
    for name in ("GET_RC", "GET_RV", "GET_RA"):
        driver.ask(name)
    assert pos_data(driver, INFRARED)[0, TIME] == 0


def test_sonar_entry_has_time_and_pose_of_ping():
    driver = Driver.of(world_of('<robot x="5m" y="5m"/>'))
    request(driver, SONAR)
    driver.ask("CONF_SN", 15, data=bytes([0, 8, 255]))
    driver.ask("VM", 50, 50)
    driver.run_s(4)
    told = driver.ask("GS")
    rows = pos_data(driver, SONAR)
    fired = rows[[0, 8]]
    assert (np.abs(fired[:, TIME] - 4000) < 200).all()  # a turn of two takes 120 ms
    assert fired[0, TIME] != fired[1, TIME]
    for row in fired:
        assert row[X] == pytest.approx(told[34] - 50 * (4.0 - row[TIME] / 1000), abs=2)
        assert row[TRANS] == 50


def test_bumper_entry_is_that_of_last_hit():
    driver = Driver.of(world_of('<robot x="9m" y="5m"/>'))
    request(driver, BUMPER)
    driver.ask("GS")
    assert (pos_data(driver, BUMPER) == 0).all()  # nothing was hit yet
    driver.ask("VM", 200, 200)
    while not driver.state.devices.bumper.pressed[0]:
        driver.run(1)
    hit_s = driver.environment.time_s
    driver.run_s(2)
    driver.ask("GET_BP")
    (hit,) = pos_data(driver, BUMPER)
    assert hit[TIME] == board_ms(hit_s)
    assert hit[X] == pytest.approx((10 - 9 - 8 * INCH) / INCH * 10, abs=100)


def test_entries_of_missing_devices_are_0():
    driver = Driver.of(open_world())
    request(driver, 31)
    driver.run_s(1)
    driver.ask("GS")
    for kind in (INFRARED, LASER, COMPASS):
        assert (pos_data(driver, kind) == 0).all()


def test_times_above_31_bits_keep_their_bits(tmp_path):
    start = ('clock="0s"', f'clock="{2**31 / 1000}s"')
    driver = Driver.of(own_world(tmp_path, start, robot="nomad200"))
    request(driver, INFRARED)
    driver.run_s(1)
    driver.ask("GS")
    time = int(pos_data(driver, INFRARED)[0, TIME]) % 2**32
    assert time == pytest.approx(2**31 + 1000, abs=20)


def test_each_robot_has_its_own_entries_without_cost_for_others():
    driver = Driver.of(open_world(NOMAD + "".join(f'<robot x="0" y="{y}m"/>' for y in (3, 6, 9))))
    assert len(driver.state.pos_data.reported) == 0
    request(driver, SONAR, robot=2)
    request(driver, INFRARED, robot=0)
    request(driver, SONAR, robot=2)
    assert driver.state.pos_data.row.tolist() == [1, -1, 0, -1]
    driver.run_s(1)
    messages = np.zeros(4, MESSAGE)
    now_s = np.full(4, driver.environment.time_s)
    driver.environment.serve(CODES["GS"], np.arange(4), messages, now_s)
    assert pos_data(driver, INFRARED, robot=0)[0, TIME] == board_ms(1.0)
    assert pos_data(driver, SONAR, robot=2)[:, TIME].max() > 900
    assert len(pos_data(driver, SONAR, robot=1)) == 0
    copy = driver.environment.snapshot()
    before = driver.environment.hash()
    driver.run_s(1)
    driver.ask("GS", robot=2)
    driver.environment.restore(copy)
    assert driver.environment.hash() == before
