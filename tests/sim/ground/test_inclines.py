"""Slopes: motion of robots and objects, compared with mechanics worked out by hand.

Most worlds here are one wide ramp that rises along x by `slope` with each metre:

                          ____--- 40 * slope
      robot   ____----
      _----
    x = -20        0         20
"""

import math

import numpy as np
import pytest

from crs_cc.sim.devices.vendor_state import CONF_X
from crs_cc.sim.model.mass_properties import FLOOR_FRICTION, GRAVITY_MPS2
from tests.sim.driver import INCH, Driver, open_world

MASS_KG, FORCE_N, GRIP_N, ROLL_OUT_MPS2 = 23.0, 60.0, 90.0, 0.3  # scout.xml


def ramp(slope: float, elements: str = '<robot x="0" y="0"/>', timestep: str = "10ms") -> Driver:
    surface = f'<ramp x="0" y="0" length="40m" width="40m" to="{40 * slope}m"/>'
    return Driver.of(open_world(f"<surface>{surface}</surface>{elements}", timestep))


def slide(driver: Driver, time_s: float) -> list[float]:
    """Return the horizontal displacements of all bodies down the slope [m]."""
    before = driver.state.bodies.position_m.copy()
    driver.run_s(time_s)
    moved = before - driver.state.bodies.position_m
    assert np.abs(moved[:, 1]).max() < 1e-6
    return moved[:, 0].tolist()


@pytest.mark.parametrize("heading", [0, 180])
def test_limp_robot_accelerates_downhill_by_gravity(heading):
    """The acceleration along the ground is g sin a - r cos a, with r = rolling friction / mass."""
    driver, a = ramp(0.2, f'<robot x="0" y="0" heading="{heading}"/>'), math.atan(0.2)
    driver.ask("LP")
    went_m = slide(driver, 2.0)[0] / math.cos(a)
    expected_m = (GRAVITY_MPS2 * math.sin(a) - ROLL_OUT_MPS2 * math.cos(a)) * 2.0**2 / 2
    assert went_m == pytest.approx(expected_m, rel=0.01)
    turned_in = driver.ask("GS")[CONF_X] / 10  # its wheels roll, so its encoders count
    assert abs(turned_in) * INCH == pytest.approx(went_m, rel=0.01)


def test_rolling_friction_holds_a_limp_robot_on_a_gentle_slope():
    """The limit is rolling friction over weight, r / g = 0.0306."""
    for slope, rolls in [(0.030, False), (0.032, True)]:
        driver = ramp(slope)
        driver.ask("LP")
        assert (slide(driver, 1.0)[0] > 1e-4) is rolls


def test_limp_robot_rolling_uphill_stops_and_returns():
    """It reaches v^2 / 2 (g sin a + r cos a) along the ground."""
    driver, a = ramp(0.1), math.atan(0.1)
    driver.ask("VM", 197, 197)  # 0.5 m/s
    driver.run_s(2.0)
    start_m = float(driver.state.x_m[0])
    driver.ask("LP")
    furthest_m = 0.0
    for _ in range(200):
        driver.run(1)
        furthest_m = max(furthest_m, float(driver.state.x_m[0]) - start_m)
    slows_mps2 = GRAVITY_MPS2 * math.sin(a) + ROLL_OUT_MPS2 * math.cos(a)
    expected_m = 0.5**2 / (2 * slows_mps2) * math.cos(a)
    assert furthest_m == pytest.approx(expected_m, rel=0.03)
    assert driver.state.x_m[0] < start_m


def test_wheels_hold_a_limp_robot_across_the_slope():
    driver = ramp(0.2, '<robot x="0" y="0" heading="90"/>')
    driver.ask("LP")
    assert abs(slide(driver, 1.0)[0]) < 1e-6


@pytest.mark.parametrize(
    "elements", ['<box x="0" y="0" length="1m" width="1m"', '<cylinder x="0" y="0" radius="30cm"']
)
def test_object_slides_if_the_slope_exceeds_its_friction(elements):
    """From tan a = mu on, by g (sin a - mu cos a)."""
    for slope in (FLOOR_FRICTION - 0.005, FLOOR_FRICTION + 0.005, 1.0):
        driver = ramp(slope, f'{elements} mass="5kg"/><robot x="-30m" y="-9m"/>')
        went_m, a = slide(driver, 1.0)[1], math.atan(slope)
        mps2 = max(0.0, GRAVITY_MPS2 * (math.sin(a) - FLOOR_FRICTION * math.cos(a)))
        assert went_m == pytest.approx(mps2 / 2 * math.cos(a), rel=0.02, abs=1e-9)


def test_motor_force_limits_the_slope_that_a_robot_climbs():
    """Up to sin a = F / (m g) = 0.266."""
    steepest = math.tan(math.asin(FORCE_N / (MASS_KG * GRAVITY_MPS2)))
    up, down = (ramp(steepest * share, timestep="50ms") for share in (0.99, 1.01))
    for driver in (up, down):
        driver.ask("VM", 100, 100)
        driver.run_s(3.0)
    assert up.state.x_m[0] == pytest.approx(
        (10 * 3 - 2.5) * INCH * math.cos(math.atan(steepest * 0.99)), rel=0.02
    )
    assert not up.state.drive.hindered[0]
    assert down.state.drive.hindered[0]
    down.run_s(6.0)
    assert down.state.x_m[0] < 0.0


@pytest.mark.parametrize("heading", [0, 37, 90])
def test_traction_limits_the_slope_on_which_brakes_hold(heading):
    """Up to tan a = grip / (m g) = 0.399, for any heading."""
    steepest = GRIP_N / (MASS_KG * GRAVITY_MPS2)
    for slope, slips in [(steepest * 0.98, False), (steepest * 1.02, True)]:
        driver = ramp(slope, f'<robot x="0" y="0" heading="{heading}"/>')
        went = driver.state.x_m[0]
        driver.run_s(1.0)
        assert bool(driver.state.x_m[0] < went - 1e-4) is slips
        assert driver.ask("GS")[CONF_X] == 0  # its wheels stand


def test_distance_on_a_slope_is_projected():
    """50 in up a slope of 0.2, across it, and down."""
    for heading, share in [(0, 1 / math.hypot(1, 0.2)), (90, 1.0), (180, 1 / math.hypot(1, 0.2))]:
        driver = ramp(0.2, f'<robot x="0" y="0" heading="{heading}"/>', "50ms")
        driver.ask("PR", 500, 500)
        driver.run_s(7.0)
        went_m = math.hypot(driver.state.x_m[0], driver.state.y_m[0])
        assert went_m == pytest.approx(50 * INCH * share, abs=1e-6)
        assert driver.ask("GS")[CONF_X] == 500
        assert driver.state.distance_m[0] == pytest.approx(50 * INCH, abs=1e-6)


def test_robot_driving_across_a_slope_does_not_slip():
    """The force across, 77 N, is more than that of its motors, but less than its traction."""
    driver = ramp(
        math.tan(math.asin(77 / (MASS_KG * GRAVITY_MPS2))), '<robot x="0" y="0" heading="90"/>'
    )
    driver.ask("VM", 100, 100)
    driver.run_s(2.0)
    assert abs(driver.state.x_m[0]) < 1e-9
    assert driver.state.y_m[0] > 0.3


def test_robots_far_from_slopes_move_as_in_a_flat_world():
    """Equal to the bit, whether others are on a slope or not."""
    robots = '<robot x="0" y="0"/><robot x="60m" y="0" heading="20"/>'
    surface = '<surface><ramp x="0" y="0" length="9m" width="9m" to="2m"/></surface>'
    done = []
    for elements in (robots, surface + robots):
        driver = Driver.of(open_world(elements))
        driver.ask("VM", 200, 150)
        driver.ask("VM", 200, 150, robot=1)
        driver.run_s(3.0)
        done.append((driver.state.x_m[1], driver.state.y_m[1], driver.state.odometry.x_m[1]))
    assert done[0] == done[1]
