"""Motors, wheels and encoders with something wrong with them: where the robot goes, and believes.

A Scout that is told to run both wheels at 10 in/s, one of which does 0.8 of that, goes along a
circle: the wheels' ways differ by 0.2 * way, over the wheel base.

         ___
            |
    ---o    |     turning to the side of the weak wheel
"""

import math

import numpy as np
import pytest

from crs_cc.sim.devices.vendor_state import CONF_STEER, CONF_X, CONF_Y, VEL_LEFT, VEL_RIGHT
from crs_cc.sim.state.degradation import MOTIONS
from tests.sim.driver import INCH, Driver, open_world

BASE_IN = 13.59
ABRUPT = "AC", 10_000, 10_000, 10_000  # as fast as the definition allows


def scout(*faults: str, robot: str = '<robot x="0" y="0"/>', seed: int = 1) -> Driver:
    degradations = "".join(f'<degradation robot="robot0" {each}/>' for each in faults)
    driver = Driver.of(open_world(robot + degradations), seed)
    driver.ask(*ABRUPT)
    return driver


def truth(driver: Driver) -> tuple[float, float, float]:
    """Return where the robot is [in, in, deg]."""
    state = driver.state
    degrees = (math.degrees(state.heading_rad[0]) + 180) % 360 - 180
    return state.x_m[0] / INCH, state.y_m[0] / INCH, degrees


def believed(driver: Driver) -> tuple[float, float, float]:
    """Return where it believes to be [in, in, deg]."""
    told = driver.ask("GET_RC")
    return told[CONF_X] / 10, told[CONF_Y] / 10, (told[CONF_STEER] / 10 + 180) % 360 - 180


def circle(way_in: float, right: float, left: float = 1.0) -> tuple[float, float, float]:
    """Return where a robot is whose wheels have gone these shares of a way."""
    turn, middle = way_in * (right - left) / BASE_IN, way_in * (right + left) / 2
    radius = middle / turn
    return radius * math.sin(turn), radius * (1 - math.cos(turn)), math.degrees(turn)


def drive(*faults: str, seconds: float = 10.0, robot: str = '<robot x="0" y="0"/>') -> Driver:
    """Lets a robot run 50 in straight on, as it is told."""
    driver = scout(*faults, robot=robot)
    driver.ask("PR", 500, 500)
    driver.run_s(seconds)
    return driver


def near(place):
    return pytest.approx(place, abs=0.3)


def test_a_weak_motor_is_seen_by_the_encoders():
    driver = drive('device="drive" element="right" gain="0.8"')
    assert truth(driver) == near(circle(50, 0.8))
    assert believed(driver) == near(truth(driver))


def test_a_wheel_that_slips_is_not():
    driver = drive('device="wheels" element="left" gain="0.8"')
    assert truth(driver) == near(circle(50, 1.0, 0.8))
    assert believed(driver) == near((50, 0, 0))


def test_an_encoder_that_misses_counts_is_wrong_alone():
    driver = drive('device="odometry" element="right" gain="0.8"')
    assert truth(driver) == near((50, 0, 0))
    assert believed(driver) == near(circle(50, 0.8))


def test_around_a_dead_motor_the_robot_turns():
    """The right wheel goes 10 in along a circle around the left one."""
    driver = scout('device="drive" element="left" dead="yes"')
    driver.ask("PR", 100, 100)
    driver.run_s(4)
    turn = 10 / BASE_IN
    half = BASE_IN / 2
    expected = (half * math.sin(turn), half * (1 - math.cos(turn)), math.degrees(turn))
    assert truth(driver) == near(expected)
    assert believed(driver) == near(expected)


def test_a_motor_that_sticks_runs_on_whatever_it_is_told():
    driver = scout('device="drive" stuck="hold" onset="2s" duration="3s"')
    driver.ask("VM", 100, 100)
    driver.run_s(2)
    at_onset = truth(driver)[0]
    driver.ask("ST")
    driver.run_s(3)
    assert truth(driver)[0] == near(at_onset + 30)
    assert driver.ask("GET_RV")[VEL_RIGHT] in {0, 100}
    driver.run_s(1)
    assert truth(driver)[0] == near(at_onset + 30)


def test_a_motor_can_run_by_itself():
    driver = scout('device="drive" element="left" stuck="-5in/s" duration="1s"')
    driver.run_s(3)
    assert truth(driver) == near((-2.5 * math.sin(5 / BASE_IN) / (5 / BASE_IN),
                                  -2.5 * (5 / BASE_IN) / 2, math.degrees(5 / BASE_IN)))  # fmt: skip


def test_commands_that_come_late_move_the_robot_late():
    driver, other = scout('device="drive" delay="700ms"'), scout()
    ways: tuple[list[float], list[float]] = ([], [])
    for each, seen in zip((driver, other), ways, strict=True):
        for _ in range(60):
            if each.state.cycle == 10:
                each.ask("VM", 100, 100)
            if each.state.cycle == 30:
                each.ask("ST")
            each.run(1)
            seen.append(truth(each)[0])
    assert ways[0][14:] == pytest.approx(ways[1][:-14], abs=0.02)  # 14 cycles of 50 ms


def test_a_bias_moves_a_robot_that_stands():
    driver = scout('device="drive" bias="2in/s" duration="2s"')
    driver.run_s(5)
    assert truth(driver) == near((4, 0, 0))
    assert believed(driver) == near((4, 0, 0))


def test_speeds_are_rounded_to_steps():
    driver = scout('device="drive" step="3in/s"')
    driver.ask("VM", 100, 100)  # 10 in/s
    driver.run_s(3)
    before = truth(driver)[0]
    driver.run_s(1)
    assert truth(driver)[0] - before == near(9)


@pytest.mark.parametrize(
    ("device", "told"), [("drive", [50, 100]), ("odometry", [50, 100]), ("wheels", [100, 100])]
)
def test_speeds_are_told_as_the_encoders_see_them(device, told):
    driver = scout(f'device="{device}" element="right" gain="0.5"')
    driver.ask("VM", 100, 100)
    driver.run_s(2)
    assert driver.ask("GET_RV")[[VEL_RIGHT, VEL_LEFT]].tolist() == told


def test_no_motor_runs_faster_than_its_axis_can():
    driver = scout('device="drive" gain="1000"', 'device="wheels" bias="99m/s"')
    driver.ask("VM", 100, 100)
    driver.run_s(1)
    before = truth(driver)[0]
    driver.run_s(1)
    limit_in = driver.environment.world.robots[0].model.drive.wheels.speed_limit / INCH
    assert truth(driver)[0] - before == near(limit_in)


def test_dropouts_of_a_motor_stop_it_for_a_timestep_each():
    """160 timesteps of 0.5 in, of which a quarter is lost: deviation 0.5 * sqrt(30) = 2.7 in."""
    driver = scout('device="drive" dropouts="0.25" onset="1s"')
    driver.ask("VM", 100, 100)
    driver.run_s(1)
    before = truth(driver)[0]
    driver.run(160)
    went = math.hypot(truth(driver)[0] - before, truth(driver)[1])
    steps = np.array([step.slices.motion[0, :2] for step in driver.steps[20:]]) / INCH
    assert set(np.round(steps.ravel(), 6)) == {0.0, 0.5}
    assert steps.sum(axis=0) == pytest.approx([60, 60], abs=8)
    assert went > 0


def test_the_noise_of_a_motor_adds_up_as_a_random_walk():
    """60 timesteps with a deviation of 2 in/s: 0.1 * sqrt(60) = 0.77 in for each of 80 wheels."""
    robots = "".join(f'<robot x="0" y="{4 * n}"/>' for n in range(40))
    fault = '<degradation robot="robot{}" device="drive" noise="2in/s"/>'
    driver = Driver.of(open_world(robots + "".join(fault.format(n) for n in range(40))))
    driver.run(60)
    ends = sum(step.slices.motion[:, :2] for step in driver.steps) / INCH
    assert ends.std() == pytest.approx(0.1 * math.sqrt(60), rel=0.25)
    assert abs(np.corrcoef(ends.T)[0, 1]) < 0.45


def test_how_often_a_program_asks_does_not_change_where_its_robot_goes():
    faults = (
        'device="drive" noise="1in/s" delay="200ms" gain="0.9" onset="1.13s"',
        'device="wheels" dropouts="0.2" stuck="hold" onset="1s" duration="1s" recovery="500ms"',
    )
    quiet, asking = scout(*faults), scout(*faults)
    for each in (quiet, asking):
        each.ask("VM", 100, 70)
    for _ in range(45):
        start_s = asking.environment.time_s
        for part in range(3):
            asking.ask("GET_RC", at_s=start_s + 0.013 * part)
        quiet.run(1)
        asking.run(1)
    assert truth(asking) == pytest.approx(truth(quiet), abs=0.02)


def test_steering_and_turret_of_a_synchro_drive():
    nomad = '<robot definition="nomad200" x="0" y="0"/>'
    faults = ('device="drive" element="steering" gain="0.5"',
              'device="wheels" element="turret" dead="yes"')  # fmt: skip
    driver = scout(*faults, robot=nomad)
    driver.ask("PR", 0, 900, 900)
    driver.run_s(10)
    assert truth(driver)[2] == near(45)
    assert math.degrees(driver.state.mount_rad[0]) == near(0)
    told = driver.ask("GET_RC")
    assert told[CONF_STEER : CONF_STEER + 2].tolist() == [450, 900]


def test_other_robots_run_as_before():
    elements = '<robot x="0" y="0"/><robot x="0" y="3"/>'
    fault = '<degradation robot="robot0" device="drive" noise="3in/s" delay="1s"/>'
    places = []
    for world in (open_world(elements), open_world(elements + fault)):
        driver = Driver.of(world)
        for robot in (0, 1):
            driver.ask("VM", 100, 77, robot=robot, at_s=0.013)
        way = []
        for _ in range(40):
            driver.run(1)
            way.append(driver.state.bodies.position_m.copy())
        places.append(np.array(way))
    assert np.array_equal(places[0][:, 1], places[1][:, 1])
    assert not np.array_equal(places[0][:, 0], places[1][:, 0])


def test_before_its_onset_it_changes_nothing_to_the_last_bit():
    late = 'onset="2s" gain="0.5" bias="1in/s" noise="1in/s" step="1in/s" stuck="hold" delay="1s"'
    driver, sound = scout(*(f'device="{each}" {late}' for each in MOTIONS)), scout()
    for each in (driver, sound):
        for cycle in range(20):
            each.ask("VM", 100 - cycle, 77, at_s=cycle * 0.05 + 0.013)
            each.run(1)
    assert np.array_equal(driver.state.bodies.position_m, sound.state.bodies.position_m)
    assert np.array_equal(driver.ask("GS"), sound.ask("GS"))


def test_a_wheel_that_is_pushed_against_a_wall_by_a_fault_does_no_harm():
    """Contacts and faults at once: it stalls at a wall while its motors are stuck."""
    wall = '<wall x1="1" y1="-5" x2="1" y2="5" thickness="10cm"/>'
    driver = scout('device="drive" stuck="10in/s"', robot='<robot x="0" y="0"/>' + wall)
    driver.run_s(8)
    x_in = truth(driver)[0]
    assert x_in == pytest.approx((0.95 / INCH) - 8, abs=1.5)
    assert np.isfinite(driver.state.bodies.position_m).all()
