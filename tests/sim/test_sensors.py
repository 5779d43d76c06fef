"""Sonar, bumpers and odometry as a program sees them: in `State`, in the vendor's units."""

import math

import numpy as np
import pytest

from crs_cc.sim.devices.vendor_state import (
    BUMPER,
    CONF_STEER,
    CONF_X,
    CONF_Y,
    MOTOR_STATUS,
    SONAR_0,
    VEL_LEFT,
    VEL_RIGHT,
)
from tests.sim.driver import INCH, SCOUT_RADIUS_M, Driver, open_world, world_of

RING = slice(SONAR_0, SONAR_0 + 16)


def sonars(elements: str, heading: float = 0.0) -> list[int]:
    """Return the readings of a Scout at the origin of a wide world."""
    driver = Driver.of(open_world(f'<robot x="0" y="0" heading="{heading}"/>{elements}'))
    return driver.ask("GET_SN")[RING].tolist()


# -- sonar -------------------------------------------------------------------------------------


def test_sonars_measure_whole_inches_from_the_shell():
    # The wall's near side lies 100 in ahead of the shell, 108 in from the middle.
    readings = sonars('<wall x1="109in" y1="-5m" x2="109in" y2="5m" thickness="2in"/>')
    assert readings[0] == 100
    # Sonar 1 looks 22.5 degrees to the left, and its cone begins at 12.5: there the wall is
    # nearest. It sits at 8 in times cos 22.5, sin 22.5.
    near_in = (108 - 8 * math.cos(math.radians(22.5))) / math.cos(math.radians(12.5))
    assert readings[1] == readings[15] == round(near_in)
    assert readings[4:13] == [255] * 9


@pytest.mark.parametrize("number", range(16))
def test_sonars_are_numbered_counterclockwise_from_front(number):
    angle = math.radians(22.5) * number
    x_in, y_in = 98 * math.cos(angle), 98 * math.sin(angle)
    readings = sonars(f'<cylinder x="{x_in}in" y="{y_in}in" radius="10in"/>')
    assert readings[number] == 98 - 10 - 8
    assert readings[(number + 8) % 16] == 255
    assert sonars('<cylinder x="0" y="98in" radius="10in"/>', 90 - 22.5 * number)[number] == 80


def test_corner_of_box_is_measured():
    half_m = 0.3
    corner = f'x="{2 + half_m}" y="0" heading="45" length="{half_m * math.sqrt(2)}"'
    readings = sonars(f'<box {corner} width="{half_m * math.sqrt(2)}"/>')
    assert readings[0] == round((2 - SCOUT_RADIUS_M) / INCH)


@pytest.mark.parametrize(
    "obj",
    [
        '<box x="18.5m" y="3m" length="1m" width="1m"/>',
        '<box x="18.5m" y="3m" length="1m" width="1m" mass="2kg"/>',
        '<polygon points="18m,2.5m 19m,2.5m 18m,4m"/>',
    ],
)
def test_sonar_in_line_with_side_measures_object_ahead(obj):
    for x_m in (18.0, 18.000001):
        driver = Driver.of(open_world(f'<robot x="{x_m}m" y="1m"/>{obj}'))
        assert driver.ask("GET_SN")[SONAR_0 + 4] == 51


def test_nothing_within_range_reads_255():
    assert sonars("") == [255] * 16
    assert sonars('<wall x1="264in" y1="-9m" x2="264in" y2="9m" thickness="1in"/>')[0] == 255
    assert sonars('<wall x1="262.5in" y1="-9m" x2="262.5in" y2="9m" thickness="1in"/>')[0] == 254


def tenths(driver: Driver, *, fire: int) -> list[int]:
    """Return the readings in the units of the CRS report."""
    message, _ = driver.post("SONAR", fire)
    assert (message["result"], message["size"]) == (1, 64)
    return message["data"][:64].view("<i4").tolist()


def test_report_ranges_are_tenths_of_inches_and_minus_1_for_no_echo():
    driver = Driver.of(open_world('<robot x="0" y="0"/><cylinder x="50.3in" y="0" radius="10in"/>'))
    readings = tenths(driver, fire=1)
    assert readings[0] == 323
    assert readings[2:15] == [-1] * 13
    assert tenths(driver, fire=0) == readings
    driver.ask("CONF_SN", 15, data=bytes([4, 5]))
    assert tenths(driver, fire=0) == [-1] * 16, "sonar 0 is not in the firing order any more"
    assert tenths(driver, fire=1) == readings


def test_object_touching_shell_reads_0():
    assert sonars('<cylinder x="18in" y="0" radius="10in"/>')[0] == 0


def test_robots_measure_each_other_but_not_themselves():
    driver = Driver.of(open_world('<robot x="0" y="0"/><robot x="100in" y="0" heading="90"/>'))
    ahead = driver.ask("GET_SN", robot=0)[RING].tolist()
    right = driver.ask("GET_SN", robot=1)[RING].tolist()
    assert ahead[0] == right[4] == 84
    assert ahead[3:14] == [255] * 11


def test_pushed_object_is_measured_at_new_position():
    driver = Driver.of(
        world_of('<box x="3m" y="5m" length="0.4m" width="0.4m" mass="1kg"/><robot x="2m" y="5m"/>')
    )
    driver.ask("CONF_SN", 0, data=bytes([0]))
    before = driver.ask("GET_SN")[SONAR_0]
    assert before == round((1 - 0.2 - SCOUT_RADIUS_M) / INCH)
    driver.ask("VM", 200, 200)
    driver.run_s(4)
    driver.ask("VM", -200, -200)
    driver.run_s(3)
    driver.ask("ST")
    driver.run_s(2)
    box_x = driver.state.bodies.position_m[1, 0]
    expected_in = (box_x - 0.2 - driver.state.x_m[0] - SCOUT_RADIUS_M) / INCH
    assert box_x > 3.5
    assert driver.ask("GET_SN")[SONAR_0] == round(expected_in)


# -- bumpers -----------------------------------------------------------------------------------


@pytest.mark.parametrize("switch", range(8))
def test_bumper_on_side_of_contact_is_pressed(switch):
    heading = -45 * switch  # the wall ahead in the world lies at the switch's bearing
    driver = Driver.of(
        world_of(
            f'<robot x="{10 - SCOUT_RADIUS_M}m" y="5m" heading="{heading}"/>'
            '<robot id="pusher" x="9m" y="5m"/>'
        )
    )
    driver.ask("VM", 100, 100, robot=1)
    driver.run_s(4)
    bits = driver.ask("GET_BP")[BUMPER]
    assert bits == (1 << switch) | (1 << (switch + 4) % 8)  # the wall, and the robot behind


def test_no_bumper_is_pressed_in_the_open():
    driver = Driver.of(open_world())
    driver.ask("VM", 100, 100)
    driver.run_s(2)
    assert driver.ask("GS")[BUMPER] == 0


def test_bumper_stays_pressed_until_robot_backs_off():
    driver = Driver.of(world_of('<robot x="9m" y="5m"/>'))
    driver.ask("VM", 200, 200)
    driver.run_s(3)
    driver.ask("ST")
    for _ in range(20):
        driver.run(1)
        assert driver.ask("GET_BP")[BUMPER] == 1
    driver.ask("VM", -100, -100)
    driver.run_s(1)
    assert driver.ask("GET_BP")[BUMPER] == 0
    assert driver.state.collisions[0] == 1


# -- odometry ----------------------------------------------------------------------------------


def test_straight_move_is_reported_in_tenths_of_an_inch():
    driver = Driver.of(open_world('<robot x="3" y="4" heading="30"/>'))
    driver.ask("PR", 1000, 1000)
    driver.run_s(15)
    told = driver.ask("GS")
    assert told[[CONF_X, CONF_Y, CONF_STEER]].tolist() == [1000, 0, 0]
    assert driver.state.x_m[0] == pytest.approx(3 + 100 * INCH * math.cos(math.radians(30)))
    assert driver.state.y_m[0] == pytest.approx(4 + 100 * INCH * math.sin(math.radians(30)))


def test_turn_on_the_spot_by_vendor_macro():
    # scout_pr(0, 900): 900 tenths of a degree are (int)(900 * 0.118597) = 106 tenths of an inch.
    driver = Driver.of(open_world())
    driver.ask("PR", 106, -106)
    driver.run_s(5)
    told = driver.ask("GS")
    turn_deg = math.degrees(2 * 10.6 / 13.59)
    assert told[CONF_STEER] == round(10 * turn_deg)
    assert told[[CONF_X, CONF_Y]].tolist() == [0, 0]
    assert math.degrees(driver.state.heading_rad[0]) == pytest.approx(turn_deg)


def test_right_turn_counts_down_from_360_degrees():
    driver = Driver.of(open_world())
    driver.ask("PR", -106, 106)
    driver.run_s(5)
    assert driver.ask("GS")[CONF_STEER] == 3600 - round(10 * math.degrees(2 * 10.6 / 13.59))


def test_circle_returns_to_start():
    driver = Driver.of(open_world())
    radius_in, base_in = 40.0, 13.590
    right = round(20 * math.pi * (radius_in + base_in / 2))
    left = round(20 * math.pi * (radius_in - base_in / 2))
    # Both wheels must ramp alike for the path to be a circle.
    driver.ask("SP", round(200 * right / left), 200)
    driver.ask("AC", round(200 * right / left), 200)
    driver.ask("PR", right, left)
    driver.run_s(20)
    told = driver.ask("GS")
    assert abs(told[CONF_X]) <= 12
    assert abs(told[CONF_Y]) <= 12
    assert min(told[CONF_STEER], 3600 - told[CONF_STEER]) <= 10


def test_odometry_and_true_pose_agree_after_long_drive():
    rng = np.random.default_rng(3)
    driver = Driver.of(open_world('<robot x="1" y="2" heading="40"/>'))
    for _ in range(400):
        right, left = rng.integers(-390, 390, 2)
        at_s = driver.environment.time_s + rng.uniform(0, 0.05)
        driver.ask("VM", int(right), int(left), at_s=at_s)
        driver.run(int(rng.integers(1, 12)))
    state, turn = driver.state, math.radians(40)
    x, y = float(state.odometry.x_m[0]), float(state.odometry.y_m[0])
    assert state.distance_m[0] > 15  # and all that is lost are parts of counts
    assert state.x_m[0] == pytest.approx(1 + x * math.cos(turn) - y * math.sin(turn), abs=2e-3)
    assert state.y_m[0] == pytest.approx(2 + x * math.sin(turn) + y * math.cos(turn), abs=2e-3)
    off = state.heading_rad[0] - state.odometry.heading_rad[0] - turn
    assert math.remainder(off, math.tau) == pytest.approx(0, abs=3e-4)


def test_dp_da_and_zr_set_odometry_without_motion():
    driver = Driver.of(open_world('<robot x="1" y="2" heading="40"/>'))
    told = driver.ask("DP", 1234, -4321)
    assert told[[CONF_X, CONF_Y, CONF_STEER]].tolist() == [1234, -4321, 0]
    assert driver.ask("DA", 900, 0)[CONF_STEER] == 900
    assert driver.ask("DA", -100, 0)[CONF_STEER] == 3500
    assert driver.ask("DA", 2**31 - 1, 0)[CONF_STEER] == (2**31 - 1) % 3600
    driver.ask("DA", 900, 0)
    driver.ask("PR", 100, 100)
    driver.run_s(5)
    assert driver.ask("GET_RC")[[CONF_X, CONF_Y]].tolist() == [1234, -4221]
    told = driver.ask("ZR")
    assert told[[CONF_X, CONF_Y, CONF_STEER]].tolist() == [0, 0, 0]
    assert driver.state.x_m[0] == pytest.approx(1 + 0.254 * math.cos(math.radians(40)))


def test_speeds_and_motor_status_are_reported():
    driver = Driver.of(open_world())
    driver.ask("VM", 100, -50)
    driver.run_s(2)
    told = driver.ask("GET_RV")
    assert told[[VEL_RIGHT, VEL_LEFT, MOTOR_STATUS]].tolist() == [100, -50, 3]
    driver.ask("MV", 0, 0, 1, 0)
    driver.run_s(2)
    assert driver.ask("GS")[[VEL_RIGHT, VEL_LEFT, MOTOR_STATUS]].tolist() == [100, 0, 1]
