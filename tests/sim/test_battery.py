"""Batteries that drain, and the clock of the sensor board."""

from pathlib import Path

import numpy as np
import pytest

from crs_cc.core.errors import WorldError
from crs_cc.sim.devices.battery.state import motors_of
from crs_cc.sim.devices.battery.supplies import COMPUTERS, MOTORS
from crs_cc.sim.devices.vendor_state import CONF_X, MOTOR_STATUS, VEL_RIGHT
from crs_cc.sim.files import world_xml
from crs_cc.sim.files.world_xml import load_world
from tests.sim.driver import INCH, Driver, open_world, own_world, world_of

CPU = 'capacity="204Wh" power="20W" curve="10.5 11.5 11.8 12.0 12.2 12.4 12.7"'
MOTOR = (
    'capacity="408Wh" power="5W" curve="10.5 11.5 11.8 12.0 12.2 12.4 12.7"\n'
    '                 friction="20N" efficiency="0.5" stall="60W" cutoff="10.8V" in-status="no"'
)


def volts(driver: Driver, name: str = "GS", robot: int = 0, at_s: float = 0.0) -> tuple:
    """Return the voltages of the computers' and of the motors' battery, as the client does."""
    message, _ = driver.post(name, robot=robot, at_s=at_s)
    cpu, motor = message["i"][1:3].tolist()
    return (2 + cpu * 3 / 255) * COMPUTERS, (2 + motor * 3 / 255) * MOTORS


def test_computer_battery_drains_with_time(tmp_path):
    # 1 Wh at 360 W lasts 10 s; halfway the voltage is in the middle of the line from 10 to 12 V.
    own = own_world(tmp_path, (CPU, 'capacity="1Wh" power="360W" curve="10 12"'), timestep="100ms")
    driver = Driver.of(own)
    byte_v = 3 / 255 * COMPUTERS
    assert volts(driver)[0] == pytest.approx(12.0, abs=byte_v)
    driver.run(50)
    assert volts(driver)[0] == pytest.approx(11.0, abs=byte_v)
    driver.run(100)
    assert volts(driver)[0] == pytest.approx(10.0, abs=byte_v)


def test_every_state_reply_contains_voltages():
    driver = Driver.of(open_world())
    for name in ("GS", "VM", "GET_SN", "GET_BP", "ZR", "CONF_TM"):
        cpu, motor = volts(driver, name)
        assert cpu == 12.0  # the largest byte stands for 12.0 V; the battery has more
        assert motor == pytest.approx(12.7, abs=0.02)


def test_motors_use_energy_of_friction_and_acceleration(tmp_path):
    own = own_world(
        tmp_path,
        (MOTOR, 'capacity="1Wh" power="0W" curve="10 12" friction="20N" efficiency="0.5"'),
    )
    driver = Driver.of(own)
    driver.ask("PR", 400, 400)
    driver.run_s(10)
    friction_j = 2 * 20 * 40 * INCH
    kinetic_j = 23 / 2 * (10 * INCH) ** 2
    expected_j = (friction_j + kinetic_j) / 0.5
    assert motors_of(driver.state).moved_j[0] == pytest.approx(expected_j, rel=0.01)
    left = 1 - expected_j / 3600
    assert volts(driver)[1] == pytest.approx(10 + 2 * left, abs=3 / 255 * MOTORS)


def test_stalled_robot_uses_more_energy():
    free = Driver.of(world_of('<robot x="2m" y="5m"/><robot x="9.7m" y="2m"/>'))
    for robot in range(2):
        free.ask("VM", 100, 100, robot=robot)
    free.run_s(6)
    used = motors_of(free.state).moved_j
    assert free.state.collisions.tolist() == [0, 1]
    # Stalled for nearly all of the six seconds, in which the wheels do not rub.
    assert used[1] > 0.9 * 60 * 5
    assert used[1] > 2 * used[0]


def test_energy_of_turning_axis_is_that_at_shell(tmp_path):
    cells = 'friction="50N" efficiency="0.5" stall="120W"'
    plain = 'friction="50N" efficiency="1" stall="0W"'
    driver = Driver.of(own_world(tmp_path, (cells, plain), robot="nomad200"))
    driver.ask("PR", 0, 0, 1800)
    driver.run_s(12)
    rim_m, rim_mps = np.pi * 0.225, np.radians(30) * 0.225
    expected_j = 50 * rim_m + 60 / 2 * rim_mps**2
    assert motors_of(driver.state).moved_j[0] == pytest.approx(expected_j, rel=0.01)


def test_empty_motor_battery_makes_axes_limp(tmp_path):
    # The cut-off of 11 V is half of the charge: 1800 J at 360 W are gone after 5 s.
    cells = 'capacity="1Wh" power="360W" curve="10 12" cutoff="11V"'
    driver = Driver.of(own_world(tmp_path, (MOTOR, cells)))
    driver.ask("VM", 10, 10)
    driver.run_s(4.9)
    assert driver.ask("GS")[VEL_RIGHT] == 10
    driver.run_s(1.5)
    assert driver.ask("GS")[[VEL_RIGHT, MOTOR_STATUS]].tolist() == [0, 0]
    x = driver.ask("GS")[CONF_X]
    for name in ("VM", "PR"):
        message, _ = driver.post(name, 200, 200)
        assert message["result"] == 1
        driver.run_s(3)
    driver.ask("MV", 1, 100, 1, 100)
    driver.run_s(3)
    assert driver.ask("GS")[CONF_X] == x
    assert driver.post("WS", 1, 1, 0, 9)[1] == driver.environment.time_s


def test_motor_status_contains_charge_if_configured(tmp_path):
    cells = 'capacity="1Wh" power="360W" curve="10 12" in-status="yes"'
    driver = Driver.of(own_world(tmp_path, (MOTOR, cells), timestep="100ms"))
    levels = []
    for _ in range(6):
        levels.append(int(driver.ask("GS")[MOTOR_STATUS]))
        driver.run(20)
    assert levels == [8, 8, 4, 4, 0, 0]
    assert Driver.of(open_world()).ask("GS")[MOTOR_STATUS] == 0


def test_unspecified_batteries_are_unlimited(tmp_path):
    text = [(f"<computer-battery {CPU}/>", ""), (f"<motor-battery {MOTOR}/>", "")]
    driver = Driver.of(own_world(tmp_path, *text, timestep="100ms"))
    driver.ask("VM", 100, 100)
    driver.run(200)
    assert driver.ask("GS")[VEL_RIGHT] == 100
    cpu, motor = volts(driver)
    assert (cpu, motor) == (12.0, pytest.approx(12.0, abs=0.02))


def test_only_robots_with_a_battery_use_it_up(tmp_path):
    """The first of two robots has none; that of the second is below its cut-off after 5 s."""
    cells = 'capacity="1Wh" power="360W" curve="10 12" cutoff="11V"'
    scout = (Path(world_xml.__file__).parent / "robots" / "scout.xml").read_text()
    robots = ""
    for name, battery in (("bare", ""), ("full", f"<motor-battery {cells}/>")):
        text = scout.replace(f"<motor-battery {MOTOR}/>", battery)
        (tmp_path / f"{name}.xml").write_text(text)
        robots += f'<robot definition="{name}.xml" x="0" y="{len(robots)}cm"/>'
    area = '<area length="99m" width="99m" origin="centre"/>'
    (tmp_path / "world.xml").write_text(f'<world version="1">{area}{robots}</world>')
    driver = Driver.of(load_world(tmp_path / "world.xml"))
    for robot in (0, 1):
        driver.ask("VM", 10, 10, robot=robot)
    driver.run_s(6.4)
    assert [driver.ask("GS", robot=robot)[VEL_RIGHT] for robot in (0, 1)] == [10, 0]
    charge = driver.environment.charges
    assert charge(0)[1] == 1.0
    assert charge(1)[1] < 0.5
    with pytest.raises(ValueError, match="the motor battery is unlimited"):
        driver.environment.charge(0, 0.5)
    driver.environment.charge(1, 0.75)
    assert charge(1)[1] == pytest.approx(0.75)


def test_share_with_many_digits_is_read(tmp_path):
    """The schema limits only the digits behind the point."""
    cells = f'capacity="1Wh" curve="12" charge="{"0" * 80}.5"'
    driver = Driver.of(own_world(tmp_path, (MOTOR, cells)))
    assert driver.environment.charges(0)[1] == 0.5


@pytest.mark.parametrize(
    ("cells", "message"),
    [
        ('capacity="0Wh" curve="12"', "capacity: '0Wh' must be greater than 0"),
        ('capacity="1W" curve="12"', "'1W' is not an energy"),
        ('capacity="1Wh" curve="12" efficiency="0"', "efficiency"),
        ('capacity="1Wh" curve="12 -1"', "curve"),
        ('capacity="1Wh" curve=""', "curve"),
        ('capacity="1Wh" curve="12" charge="1.5"', "charge"),
    ],
)
def test_invalid_batteries_are_refused(tmp_path, cells, message):
    with pytest.raises(WorldError) as caught:
        own_world(tmp_path, (MOTOR, cells))
    assert any(message in each.render() for each in caught.value.diagnostics)


# -- the clock of the sensor board -------------------------------------------------------------


def board_ms(driver: Driver, at_s: float = 0.0) -> float:
    return float(driver.post("GS", at_s=at_s)[0]["f"][0])


def test_clock_counts_ms_in_steps_of_16_4():
    driver = Driver.of(open_world())
    assert board_ms(driver) == 0
    assert board_ms(driver, 0.0163) == 0
    assert board_ms(driver, 0.0165) == 16  # 16.4
    assert board_ms(driver, 0.0329) == 32  # 32.8
    driver.run_s(10)
    assert board_ms(driver) == 9987  # 609 ticks


def test_clock_overflows_at_2_to_the_32(tmp_path):
    start_s = 2**32 / 1000 - 1
    changes = ('clock="0s"', f'clock="{start_s}s"')
    driver = Driver.of(own_world(tmp_path, changes, timestep="100ms"))
    seen = [board_ms(driver)]
    for _ in range(20):
        driver.run(1)
        seen.append(board_ms(driver))
    assert 2**32 - 1020 < seen[0] < 2**32 - 980
    assert seen[-1] == pytest.approx(1000, abs=20)
    steps = np.diff(seen)
    assert (steps < 0).sum() == 1
    assert all(seen[i] == int(seen[i]) and 0 <= seen[i] < 2**32 for i in range(len(seen)))
