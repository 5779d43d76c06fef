"""The effect of contacts on wheels: stalls, slips, robots that hold, limp robots."""

import math
from pathlib import Path

import pytest

from crs_cc.sim.devices.vendor_state import CONF_X, CONF_Y, MOTOR_STATUS, VEL_LEFT, VEL_RIGHT
from crs_cc.sim.files import world_xml
from crs_cc.sim.files.world_xml import load_world
from tests.sim.driver import INCH, SCOUT_RADIUS_M, Driver, world_of

SCOUT = Path(world_xml.__file__).parents[0] / "robots" / "scout.xml"
ROOM_IN = 10 / INCH - 8  # x of a robot's centre when it touches the east edge


def changed_scout(folder, elements: str, *changes: tuple[str, str]) -> Driver:
    """Return a world with Scouts whose definition was changed."""
    text = SCOUT.read_text()
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    (folder / "own.xml").write_text(text)
    world = folder / "world.xml"
    world.write_text(
        f'<world version="1"><area length="10m" width="10m"/>{elements}</world>'.replace(
            "<robot ", '<robot definition="own.xml" '
        )
    )
    return Driver.of(load_world(world))


def at_the_wall(driver: Driver, speed: int = 100, seconds: float = 6.0) -> Driver:
    """Drive a robot that starts at 9 m against the edge at 10 m."""
    driver.ask("VM", speed, speed)
    driver.run_s(seconds)
    return driver


ONE = '<robot x="9m" y="5m"/>'


def test_robot_at_wall_stalls_and_odometry_stops():
    driver = at_the_wall(Driver.of(world_of(ONE)))
    went_in = (driver.state.x_m[0] - 9) / INCH
    assert driver.state.x_m[0] == pytest.approx(10 - SCOUT_RADIUS_M, abs=0.005)
    for at_s in (0.0, 0.012, 0.049):  # at any time in the cycle
        told = driver.ask("GS", at_s=driver.environment.time_s + at_s)
        assert told[CONF_X] == pytest.approx(10 * went_in, abs=1)
        assert told[[CONF_Y, VEL_RIGHT, VEL_LEFT]].tolist() == [0, 0, 0]
        assert told[MOTOR_STATUS] == 3  # the motors work, in vain


def test_odometry_is_right_after_backing_off_from_wall():
    driver = at_the_wall(Driver.of(world_of(ONE)))
    driver.ask("VM", -100, -100)
    driver.run_s(5)
    told = driver.ask("GET_RC")
    assert told[CONF_X] == pytest.approx((driver.state.x_m[0] - 9) / INCH * 10, abs=1)
    assert driver.state.x_m[0] < 9


def test_robot_at_wall_can_turn_on_the_spot():
    driver = at_the_wall(Driver.of(world_of(ONE)))
    driver.ask("VM", 50, -50)
    driver.run_s(3)
    assert driver.state.heading_rad[0] == pytest.approx(driver.state.odometry.heading_rad[0])
    assert driver.state.heading_rad[0] > 1


def test_blocked_move_continues_when_path_is_free():
    driver = Driver.of(world_of('<robot x="2m" y="5m"/><robot x="3m" y="5m" heading="90"/>'))
    driver.ask("PR", 600, 600)
    _, ends_s = driver.post("WS", 1, 1, 0, 200)
    driver.run_s(20)  # it would be there after 6.5 s
    assert math.isinf(ends_s)
    assert driver.state.waits.code[0]
    assert driver.state.x_m[0] == pytest.approx(3 - 2 * SCOUT_RADIUS_M, abs=0.02)
    driver.ask("VM", 300, 300, robot=1)  # out of the way
    steps = driver.run_s(10)
    assert [step.robots.tolist() for step in steps if len(step.robots)] == [[0]]
    assert driver.state.x_m[0] == pytest.approx(2 + 60 * INCH, abs=0.005)
    told = driver.ask("GS")
    assert told[CONF_X] == pytest.approx(600, abs=2)
    assert told[MOTOR_STATUS] == 0


def test_wait_for_blocked_move_times_out():
    driver = Driver.of(world_of(ONE))
    driver.ask("PR", 600, 600)
    driver.post("WS", 1, 1, 0, 12)
    ended = [float(step.at_s[0]) for step in driver.run_s(15) if len(step.at_s)]
    assert ended == [pytest.approx(12)]
    assert driver.ask("GS")[MOTOR_STATUS] == 3


@pytest.mark.parametrize("mass_kg", [5, 14])
def test_move_pushing_heavy_box_arrives(mass_kg):
    box = f'<box x="3m" y="5m" length="40cm" width="40cm" mass="{mass_kg}kg"/>'
    driver = Driver.of(world_of(box + '<robot x="2m" y="5m"/>'))
    driver.ask("PR", 400, 400)
    driver.post("WS", 1, 1, 0, 200)
    ended = [float(step.at_s[0]) for step in driver.run_s(6.5) if len(step.at_s)]
    assert ended == [pytest.approx(5.3, abs=0.8)]  # 4.5 s with nothing in the way
    assert driver.state.x_m[0] == pytest.approx(2 + 40 * INCH, abs=0.001)
    told = driver.ask("GS")
    assert told[CONF_X] == pytest.approx(400, abs=1)
    assert told[[VEL_RIGHT, MOTOR_STATUS]].tolist() == [0, 0]


def test_move_pushing_box_arrives_for_any_timestep():
    box = '<box x="3m" y="5m" length="40cm" width="40cm" mass="12kg"/><robot x="2m" y="5m"/>'
    for timestep in ("20ms", "100ms"):
        driver = Driver.of(world_of(box, timestep=timestep))
        driver.ask("PR", 400, 400)
        driver.run_s(7)
        assert driver.state.x_m[0] == pytest.approx(2 + 40 * INCH, abs=0.002)
        assert driver.ask("GS")[MOTOR_STATUS] == 0


@pytest.mark.parametrize(("inside_m", "status"), [(0.004, 0), (0.008, 3)])
def test_move_ending_just_inside_wall_completes(inside_m, status):
    start_m = 10 - SCOUT_RADIUS_M + inside_m - 30 * INCH
    driver = Driver.of(world_of(f'<robot x="{start_m}m" y="5m"/>'))
    driver.ask("PR", 300, 300)
    driver.run_s(6)
    assert driver.ask("GS")[[VEL_RIGHT, MOTOR_STATUS]].tolist() == [0, status]
    assert driver.state.x_m[0] == pytest.approx(10 - SCOUT_RADIUS_M, abs=0.001)


def test_motors_stop_after_stall_time_of_definition(tmp_path):
    driver = changed_scout(tmp_path, ONE, ('give-up="0s"', 'give-up="2s"'))
    driver.ask("PR", 600, 600)
    driver.post("WS", 1, 1, 0, 200)
    # 32 in at 10 in/s and 20 in/s2 take 3.4 s.
    ended = [float(step.at_s[0]) for step in driver.run_s(15) if len(step.at_s)]
    assert ended == [pytest.approx(5.4, abs=0.15)]
    assert driver.ask("GS")[MOTOR_STATUS] == 0
    driver.ask("VM", -100, -100)
    driver.run_s(2)
    assert driver.state.x_m[0] < 9.6


def test_wheels_with_weak_grip_slip_and_count(tmp_path):
    driver = at_the_wall(changed_scout(tmp_path, ONE, ('grip="90N"', 'grip="40N"')))
    told = driver.ask("GS")
    assert told[CONF_X] == pytest.approx(575, abs=1)  # 6 s at 10 in/s, half a second to get there
    assert told[[VEL_RIGHT, VEL_LEFT]].tolist() == [100, 100]
    assert driver.state.x_m[0] == pytest.approx(10 - SCOUT_RADIUS_M, abs=0.005)


# -- robots that push robots -------------------------------------------------------------------

PAIR = '<robot x="2m" y="5m"/><robot x="3m" y="5m" heading="{heading}"/>'


def push(command: str, heading: int = 0, seconds: float = 8.0) -> Driver:
    """Make the first robot push the second one, which was given a command."""
    driver = Driver.of(world_of(PAIR.format(heading=heading)))
    driver.ask(command, robot=1)
    driver.ask("VM", 100, 100)
    driver.run_s(seconds)
    return driver


def test_holding_robot_resists_push_up_to_its_grip():
    driver = push("ST")
    assert driver.state.x_m[1] == pytest.approx(3, abs=0.02)
    assert driver.ask("GET_RC", robot=1)[CONF_X] == 0
    assert driver.state.x_m[0] == pytest.approx(3 - 2 * SCOUT_RADIUS_M, abs=0.02)


def test_limp_robot_rolls_when_pushed_and_counts():
    driver = push("LP")
    rolled_m = driver.state.x_m[1] - 3
    assert rolled_m > 0.8
    told = driver.ask("GS", robot=1)
    assert told[CONF_X] == pytest.approx(rolled_m / INCH * 10, abs=2)
    assert told[VEL_RIGHT] == pytest.approx(100, abs=2)
    assert told[MOTOR_STATUS] == 0
    driver.ask("ST")
    driver.run_s(5)
    assert driver.ask("GS", robot=1)[VEL_RIGHT] == 0  # it has rolled out


def test_limp_robot_counts_backwards_when_pushed_from_front():
    driver = push("LP", heading=180)
    rolled_m = driver.state.x_m[1] - 3
    assert rolled_m > 0.8
    assert driver.ask("GET_RC", robot=1)[CONF_X] == pytest.approx(-rolled_m / INCH * 10, abs=2)


def test_limp_robot_does_not_roll_sideways():
    driver = push("LP", heading=90)
    assert driver.state.x_m[1] == pytest.approx(3, abs=0.02)


def test_limp_wheels_roll_out():
    driver = Driver.of(world_of('<robot x="2m" y="5m"/>'))
    driver.ask("VM", 300, 300)
    driver.run_s(3)
    start_m, speed_mps = driver.state.x_m[0], 30 * INCH
    driver.ask("LP")
    driver.run_s(0.5)
    assert driver.ask("GET_RV")[VEL_RIGHT] == round((speed_mps - 0.15) / INCH * 10)
    driver.run_s(4)
    assert driver.state.x_m[0] - start_m == pytest.approx(speed_mps**2 / 2 / 0.3)


def test_motors_engage_rolling_wheels_at_their_speed():
    driver = push("LP")
    before = driver.ask("GS", robot=1)[VEL_RIGHT]
    driver.ask("ST")
    driver.ask("VM", 200, 200, robot=1)
    assert driver.ask("GET_RV", robot=1)[VEL_RIGHT] == pytest.approx(before, abs=1)
    driver.run_s(0.2)
    assert driver.ask("GET_RV", robot=1)[VEL_RIGHT] == pytest.approx(before + 40, abs=3)


def test_robot_pushing_box_counts_true_distance():
    driver = Driver.of(
        world_of('<box x="3m" y="5m" length="40cm" width="40cm" mass="8kg"/><robot x="2m" y="5m"/>')
    )
    driver.ask("VM", 100, 100)
    driver.run_s(10)
    rolled_m = driver.state.x_m[0] - 2
    assert rolled_m > 2
    assert driver.ask("GET_RC")[CONF_X] == pytest.approx(rolled_m / INCH * 10, abs=2)
