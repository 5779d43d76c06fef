"""Odometry against the true pose: counts, errors of the wheels, random errors."""

import math

import numpy as np
import pytest

from crs_cc.sim.devices.vendor_state import CONF_STEER, CONF_X, CONF_Y
from crs_cc.sim.files.world_xml import load_robot, load_world
from tests.sim.driver import INCH, Driver, open_world
from tests.sim.test_traction import SCOUT

BASE_M = 13.590 * INCH


def scout_with(folder, odometry: str, robots: str = '<robot x="0" y="0"/>', seed: int = 1):
    """Return Scouts in the open whose definition has another <odometry>."""
    text = SCOUT.read_text().replace('<odometry resolution="0.1mm"/>', f"<odometry {odometry}/>")
    (folder / "own.xml").write_text(text)
    world = folder / "world.xml"
    robots = robots.replace("<robot ", '<robot definition="own.xml" ')
    world.write_text(
        '<world version="1"><area length="900m" width="900m" origin="centre" edge="0"/>'
        f"{robots}</world>"
    )
    return Driver.of(load_world(world), seed)


def run(driver: Driver, right: int, left: int, robot: int = 0) -> None:
    """Drive a move to its end."""
    driver.ask("PR", right, left, robot=robot)
    driver.run_s(2 + max(abs(right), abs(left)) / 100)


def truth(driver: Driver, robot: int = 0) -> list[float]:
    state = driver.state
    heading_rad = (state.heading_rad[robot] + math.pi) % math.tau - math.pi
    return [float(state.x_m[robot]), float(state.y_m[robot]), float(heading_rad)]


def belief(driver: Driver, robot: int = 0) -> list[float]:
    told = driver.state.odometry
    heading_rad = (told.heading_rad[robot] + math.pi) % math.tau - math.pi
    return [float(told.x_m[robot]), float(told.y_m[robot]), float(heading_rad)]


def test_ideal_scout_is_accurate_to_an_encoder_count():
    driver = Driver.of(open_world())
    for right, left in ((500, 500), (300, -300), (700, 200), (-400, 100)):
        run(driver, right, left)
        x_m, y_m, heading_rad = np.subtract(truth(driver), belief(driver))
        assert math.hypot(x_m, y_m) < 0.001
        assert abs(heading_rad) < 0.0002  # half a count of each wheel, over the wheel base


def test_positions_are_reported_in_whole_counts(tmp_path):
    driver = scout_with(tmp_path, 'resolution="1in"')
    driver.ask("VM", 37, 37)
    told = [int(driver.ask("GET_RC")[CONF_X]) for _ in range(100) if driver.run(1)]
    assert {x % 10 for x in told} == {0}
    assert told == sorted(told)
    assert len(set(told)) == 19  # 18 in in 5 s
    driver.ask("VM", 0, 0)


def test_counts_are_not_lost_between_readings(tmp_path):
    driver = scout_with(tmp_path, 'resolution="5mm"')
    for _ in range(40):
        driver.ask("PR", 1, 1)
        driver.run_s(0.5)
    assert driver.ask("GET_RC")[CONF_X] == pytest.approx(40, abs=1)


def test_wheels_of_different_size_drive_circle_while_odometry_shows_line(tmp_path):
    driver = scout_with(tmp_path, 'diameters="1.02"')
    run(driver, 2000, 2000)
    told = driver.ask("GET_RC")
    assert told[[CONF_X, CONF_Y, CONF_STEER]].tolist() == [2000, 0, 0]
    # The right wheel runs 2 * 1.02 / 2.02 of 200 in, the left one 2 / 2.02.
    turn = 200 * INCH * (2 * 0.02 / 2.02) / BASE_M
    radius_m = 200 * INCH / turn
    expected = [radius_m * math.sin(turn), radius_m * (1 - math.cos(turn)), turn]
    assert truth(driver) == pytest.approx(expected, abs=1e-6)


def test_longer_wheel_base_turns_less(tmp_path):
    driver = scout_with(tmp_path, 'wheel-base="1.05"')
    quarter = round(BASE_M / INCH * 10 * math.pi / 4)
    run(driver, quarter, -quarter)
    turned = 2 * quarter * INCH / 10 / BASE_M
    assert belief(driver)[2] == pytest.approx(turned, abs=1e-6)
    assert truth(driver)[2] == pytest.approx(turned / 1.05)


def test_larger_wheels_move_further(tmp_path):
    driver = scout_with(tmp_path, 'scale="1.01"')
    run(driver, 1000, 1000)
    assert truth(driver)[0] == pytest.approx(101 * INCH)
    assert driver.ask("GET_RC")[CONF_X] == 1000


def test_umbmark_squares_separate_wheel_base_and_diameter_errors(tmp_path):
    """Squares to the left and to the right end on sides that tell which error it is."""
    ends = {}
    for odometry in ('wheel-base="1.02"', 'diameters="1.005"'):
        for side in (1, -1):
            driver = scout_with(tmp_path, odometry)
            quarter = round(BASE_M / INCH * 10 * math.pi / 4) * side
            for _ in range(4):
                run(driver, 1000, 1000)
                run(driver, quarter, -quarter)
            ends[odometry, side] = truth(driver)[1]
            assert belief(driver)[1] == pytest.approx(0, abs=0.03)
    # A wrong base mirrors the two squares (Borenstein and Feng's type A), wheels that differ
    # turn one of them out and the other one in (type B): y has opposite or equal signs.
    assert ends['wheel-base="1.02"', 1] * ends['wheel-base="1.02"', -1] < 0
    assert ends['diameters="1.005"', 1] * ends['diameters="1.005"', -1] > 0


def test_random_errors_have_standard_deviation_of_definition(tmp_path):
    robots = "".join(f'<robot x="{10 * n}m" y="0"/>' for n in range(40))
    noise = 'way-noise="2cm" turn-noise="2deg" spin-noise="3deg"'
    driver = scout_with(tmp_path, noise, robots)
    start_m = driver.state.x_m.copy()
    for robot in range(40):
        driver.ask("PR", 1600, 1600, robot=robot)  # 4.064 m
    driver.run_s(20)
    off_m = driver.state.x_m - start_m - 160 * INCH
    turned = (driver.state.heading_rad + math.pi) % math.tau - math.pi
    assert np.degrees(turned.std()) == pytest.approx(2 * math.sqrt(4.064), rel=0.4)
    # What the way is short of because it bends is small beside what is random in it.
    assert off_m.std() == pytest.approx(0.02 * math.sqrt(4.064), rel=0.5)
    assert driver.ask("GET_RC")[CONF_X] == 1600


def test_random_errors_depend_on_seed_and_robot(tmp_path):
    robots = '<robot x="0" y="0"/><robot x="0" y="9m"/>'
    noise = 'way-noise="1cm" turn-noise="1deg" spin-noise="1deg"'
    ends = []
    for seed, both in ((1, True), (1, False), (2, True)):
        driver = scout_with(tmp_path, noise, robots, seed)
        driver.ask("VM", 100, 90)
        if both:
            driver.ask("VM", 100, 90, robot=1)
        driver.run_s(5)
        ends.append([truth(driver), truth(driver, 1)])
    assert ends[0][0] == ends[1][0]
    assert ends[0][0] != ends[2][0]
    assert ends[0][0][2] != ends[0][1][2]


def test_robot_at_rest_does_not_drift(tmp_path):
    driver = scout_with(tmp_path, 'way-noise="1cm" turn-noise="1deg" spin-noise="1deg"')
    driver.run_s(5)
    assert truth(driver) == [0, 0, 0]


def test_ideal_scout_has_no_errors_and_noisy_one_has():
    ideal, noisy = (load_robot(SCOUT, setup).odometry for setup in ("ideal", "noisy"))
    assert (ideal.scale, ideal.diameters, ideal.wheel_base) == (1, 1, 1)
    assert (ideal.way_noise_m, ideal.turn_noise_rad, ideal.spin_noise_rad) == (0, 0, 0)
    assert noisy.diameters != 1
    assert noisy.turn_noise_rad > 0
    assert noisy.resolution_m == ideal.resolution_m


def test_synchro_drive_drifts_with_distance(tmp_path):
    nomad = SCOUT.with_name("nomad200.xml").read_text()
    changed = nomad.replace("<odometry ", '<odometry drift="2deg" ', 1)
    (tmp_path / "own.xml").write_text(changed)
    world = tmp_path / "world.xml"
    world.write_text(
        '<world version="1"><area length="900m" width="900m" origin="centre" edge="0"/>'
        '<robot definition="own.xml" x="0" y="0"/></world>'
    )
    driver = Driver.of(load_world(world))
    driver.ask("PR", 2000, 0, 0)
    driver.run_s(25)
    assert truth(driver)[2] == pytest.approx(math.radians(2 * 200 * INCH))
    assert driver.ask("GET_RC")[CONF_STEER] == 0
