"""The synchro drive: translation, steering and turret, above a base that never turns."""

import math

import numpy as np
import pytest

from crs_cc.sim.devices.vendor_state import (
    BUMPER,
    CONF_STEER,
    CONF_TURRET,
    CONF_X,
    CONF_Y,
    MOTOR_STATUS,
    SONAR_0,
    VEL_LEFT,
    VEL_RIGHT,
    VEL_TURRET,
)
from crs_cc.sim.engine.step import describe_slice
from tests.sim.driver import INCH, Driver, open_world, world_of

N200 = '<robot definition="nomad200" x="0" y="0"/>'
N150 = '<robot definition="nomad150" x="0" y="0"/>'


def nomad(elements: str = N200) -> Driver:
    driver = Driver.of(open_world(elements))
    driver.ask("AC", 300, 500, 500)
    driver.ask("SP", 100, 300, 300)
    return driver


def test_translation_follows_steering():
    driver = nomad()
    driver.ask("PR", 0, 900, 0)
    driver.run_s(5)
    driver.ask("PR", 200, 0, 0)
    driver.run_s(5)
    assert driver.state.x_m[0] == pytest.approx(0, abs=1e-9)
    assert driver.state.y_m[0] == pytest.approx(20 * INCH)
    told = driver.ask("GS")
    assert told[[CONF_X, CONF_Y, CONF_STEER, CONF_TURRET]].tolist() == [0, 200, 900, 0]


def test_turret_turns_independently_and_base_never():
    driver = nomad()
    driver.ask("PR", 0, 900, -450)
    driver.run_s(5)
    state = driver.state
    assert math.degrees(state.heading_rad[0]) == pytest.approx(90)
    assert math.degrees(state.mount_rad[0]) == pytest.approx(315)
    assert state.base_rad[0] == 0
    assert driver.ask("GET_RC")[[CONF_STEER, CONF_TURRET]].tolist() == [900, 3150]


def test_translation_with_steering_drives_circle():
    driver = nomad()
    driver.ask("VM", 100, 300, 0)
    driver.run_s(30)
    start = driver.state.bodies.position_m[0].copy()
    driver.run_s(12)  # 30 deg/s: once around, on a radius of 10 in/s over 30 deg/s
    assert driver.state.bodies.position_m[0] == pytest.approx(start, abs=1e-9)
    driver.run_s(6)
    across_m = np.hypot(*(driver.state.bodies.position_m[0] - start))
    assert across_m == pytest.approx(2 * 10 * INCH / math.radians(30))


def test_speeds_have_unit_of_axis_and_motors_are_bits():
    driver = nomad()
    driver.ask("VM", 50, -200, 450)
    driver.run_s(3)
    told = driver.ask("GET_RV")
    assert told[[VEL_RIGHT, VEL_LEFT, VEL_TURRET]].tolist() == [50, -200, 450]
    assert driver.ask("GS")[MOTOR_STATUS] == 7
    driver.ask("MV", 0, 0, 1, 0, 0, 0)
    driver.run_s(3)
    assert driver.ask("GS")[MOTOR_STATUS] == 5


def test_each_axis_has_its_own_limits():
    driver = nomad()
    driver.ask("VM", 10_000, -10_000, 10_000)
    driver.run_s(3)
    told = driver.ask("GET_RV")
    assert told[[VEL_RIGHT, VEL_LEFT, VEL_TURRET]].tolist() == [200, -450, 450]


def test_sonars_turn_with_turret_and_bumpers_stay_with_base():
    wall = '<wall x1="60in" y1="-3m" x2="60in" y2="3m" thickness="2in"/>'
    driver = nomad(N200 + wall)
    ahead = driver.ask("GET_SN")[SONAR_0]
    driver.ask("PR", 0, 0, 900)
    driver.run_s(5)
    turned = driver.ask("GET_SN")[SONAR_0 : SONAR_0 + 16]
    assert turned[12] == ahead
    assert turned[0] == 255
    driver.ask("PR", 0, 1800, 0)
    driver.run_s(6)
    driver.ask("VM", -200, 0, 0)  # backwards, towards the wall
    driver.run_s(8)
    assert driver.ask("GET_BP")[BUMPER] == 1


def test_sonars_of_nomad_150_stay_with_base():
    wall = '<wall x1="60in" y1="-3m" x2="60in" y2="3m" thickness="2in"/>'
    driver = nomad(N150 + wall)
    ahead = driver.ask("GET_SN")[SONAR_0]
    driver.ask("PR", 0, 900, 900)
    driver.run_s(5)
    told = driver.ask("GS")
    assert told[[CONF_STEER, CONF_TURRET]].tolist() == [900, 0]
    assert told[SONAR_0] == ahead


def test_da_sets_both_angles():
    driver = nomad()
    driver.ask("DA", 3700, -100)
    assert driver.ask("GET_RC")[[CONF_STEER, CONF_TURRET]].tolist() == [100, 3500]


def test_slice_names_axes():
    driver = nomad()
    driver.ask("PR", 10, 300, -300)
    part = describe_slice(driver.run_s(3)[-1], 0)
    assert [axis.name for axis in part.axes] == ["translation", "steering", "turret"]
    assert [axis.total for axis in part.axes] == pytest.approx(
        [INCH, math.radians(30), math.radians(-30)]
    )


def test_robots_of_all_drives_share_world():
    robots = "".join(
        f'<robot definition="{name}" x="5m" y="{2 + 2 * row}m"/>'
        for row, name in enumerate(("scout", "nomad200", "nomad150"))
    )
    driver = Driver.of(world_of(robots))
    for robot in range(3):
        driver.ask("PR", 100, 100, 100, robot=robot)
    driver.run_s(10)
    assert np.degrees(driver.state.heading_rad) == pytest.approx([0, 10, 10])
    assert np.degrees(driver.state.mount_rad) == pytest.approx([0, 10, 0])
    assert np.degrees(driver.state.base_rad) == pytest.approx([0, 0, 0])


def test_zr_turns_to_zero_marks_the_shorter_way_and_zeroes():
    driver = nomad()
    driver.ask("PR", 100, 900, -2700)
    driver.run_s(12)
    driver.ask("CONF_TM", 1)
    _, goes_on_s = driver.post("ZR")
    assert math.isinf(goes_on_s)
    steps = driver.run_s(5)
    # 90 degrees at 30 deg/s and 50 deg/s2 take 3 s and 30/50 s: they go on though no command comes.
    assert [float(step.at_s[0]) for step in steps if len(step.at_s)] == [pytest.approx(15.6)]
    assert driver.state.heading_rad[0] % math.tau == pytest.approx(0, abs=1e-9)
    assert driver.state.mount_rad[0] % math.tau == pytest.approx(0, abs=1e-9)
    told = driver.ask("GS")
    assert told[[CONF_X, CONF_Y, CONF_STEER, CONF_TURRET, MOTOR_STATUS]].tolist() == [0] * 5
    driver.ask("VM", 0, 300, 0)
    driver.run_s(0.9)
    assert driver.ask("GET_RV")[VEL_LEFT] == 300  # and conf_tm counts again
    driver.run_s(2)
    assert driver.ask("GET_RV")[VEL_LEFT] == 0


def test_zr_times_out_after_two_minutes():
    driver = nomad()
    driver.ask("DA", 123, 45)
    driver.ask("PR", 0, 900, 0)
    driver.run_s(5)
    driver.ask("SP", 100, 5, 5)  # 90 degrees would take three minutes
    driver.post("ZR")
    (step,) = [step for step in driver.run_s(125) if len(step.robots)]
    assert step.at_s[0] == pytest.approx(125)
    assert step.messages["result"][0] == 0
    assert driver.ask("GET_RC")[CONF_STEER] != 0


def test_zr_of_both_drives_in_one_batch():
    driver = Driver.of(open_world('<robot x="0" y="3"/>' + N200))
    for robot in range(2):
        driver.ask("PR", 0, 450, 0, robot=robot)
    driver.run_s(8)
    assert driver.post("ZR", robot=0)[1] == pytest.approx(8.0)
    assert math.isinf(driver.post("ZR", robot=1)[1])
    assert driver.ask("GET_RC", robot=0)[CONF_STEER] == 0
    ended = [step.robots.tolist() for step in driver.run_s(8) if len(step.robots)]
    assert ended == [[1]]
