"""The sonar ring: times of firings, times of reports, and errors."""

import math
import pickle
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from crs_cc.core.units import SOUND_MPS
from crs_cc.sim.devices.sonar.errors import SonarErrors
from crs_cc.sim.devices.sonar.model import SonarBoard, Sonars, sonars_of
from crs_cc.sim.devices.vendor_state import CONF_X, SONAR_0
from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import empty_world
from crs_cc.sim.model.robot import RobotModel
from crs_cc.sim.model.world import Area, Pose, Robot, WorldModel
from tests.sim.driver import INCH, SCOUT_RADIUS_M, Driver, open_world, world_of

RING = slice(SONAR_0, SONAR_0 + 16)
ROUND = [0, 2, 15, 1, 14, 3, 13, 4, 12, 5, 11, 6, 10, 7, 9, 8]
NO_ECHO = 255


def wall_at(inches: float) -> str:
    """Return a wall whose near side is at a distance ahead of a Scout at the origin."""
    x = inches + 8 + 1
    return f'<wall x1="{x}in" y1="-5m" x2="{x}in" y2="5m" thickness="2in"/>'


def conf_sn(driver: Driver, rate: int, *order: int, at_s: float = 0.0) -> None:
    message, _ = driver.post("CONF_SN", rate, data=bytes(order), at_s=at_s)
    assert message["result"] == 1


def _with_board(model: RobotModel, **changes) -> Sonars:
    sonars = sonars_of(model)
    return replace(sonars, board=replace(sonars.board, **changes))


def with_board(world: WorldModel, **changes) -> WorldModel:
    """Return a world whose robots have other sonar boards."""
    robots = [
        replace(
            robot,
            model=robot.model.with_device("sonar", _with_board(robot.model, **changes)),
        )
        for robot in world.robots
    ]
    return replace(world, robots=tuple(robots))


# -- the timetable -----------------------------------------------------------------------------


def firings(driver: Driver, time_s: float) -> list[tuple[float, int]]:
    """Return the firings of robot 0's sonars, found by sampling every millisecond or less."""
    seen = []
    for _ in range(round(time_s / driver.environment.timestep_s)):
        driver.run(1)
        sonar = driver.sonar
        fired = float(sonar.next_s[0] - sonar.interval_s[0])
        turn = int(sonar.turn[0]) - 1
        if turn >= 0 and (not seen or seen[-1][0] != fired):
            seen.append((fired, int(sonar.order[0, turn % sonar.length[0]])))
    return seen


def test_order_of_definition_is_active_at_start():
    found = firings(Driver.of(open_world()), 2.0)
    assert [number for _, number in found[:20]] == (ROUND * 2)[:20]
    assert [at_s for at_s, _ in found[:20]] == pytest.approx([0.06 * n for n in range(20)])


@pytest.mark.parametrize("timestep", ["1ms", "7ms", "30ms"])
def test_firings_are_exact_multiples_of_interval_for_any_timestep(timestep):
    driver = Driver.of(open_world(timestep=timestep))
    conf_sn(driver, 20, 3, 1, 4, at_s=0.0005)
    found = firings(driver, 1.0)
    assert [at_s for at_s, _ in found] == [pytest.approx(0.0005 + 0.08 * n) for n in range(13)]
    assert [number for _, number in found] == ([3, 1, 4] * 5)[:13]


@pytest.mark.parametrize(
    ("rate", "interval_s"),
    [(0, 0.04), (1, 0.04), (10, 0.04), (11, 0.044), (15, 0.06), (255, 1.02), (256 + 15, 0.06)],
)
def test_rate_is_unsigned_char_in_units_of_4_ms(rate, interval_s):
    driver = Driver.of(open_world())
    conf_sn(driver, rate, 0)
    assert driver.sonar.interval_s[0] == pytest.approx(interval_s)


def test_sonars_fire_independently_of_requests():
    asked, unasked = Driver.of(open_world(wall_robot())), Driver.of(open_world(wall_robot()))
    for _ in range(40):
        asked.ask("GS", at_s=asked.environment.time_s + 0.03)
        asked.run(1)
        unasked.run(1)
    told = [driver.ask("GS")[RING].tolist() for driver in (asked, unasked)]
    assert told[0] == told[1]
    assert asked.sonar.count[0] == unasked.sonar.count[0]


@pytest.mark.parametrize(
    ("speed", "acceleration"), [(240, 50), (7, 390)], ids=["rest later", "rest in same cycle"]
)
def test_sonars_fire_where_robot_is_when_command_timeout_expires_during_ws(speed, acceleration):
    moving, waiting = fired = {}, {}
    for seen in fired:
        driver = Driver.of(open_world(wall_robot(), timestep="100ms"))
        conf_sn(driver, 10, *range(16))  # at all multiples of 40 ms
        driver.ask("AC", acceleration, acceleration)
        driver.ask("CONF_TM", 1)
        driver.ask("VM", speed, speed)
        driver.run_s(0.2)
        # The wheels brake at 1.275 s, between two firings of one cycle.
        driver.post("WS" if seen is waiting else "GS", 1, 1, 0, 255, at_s=0.275)
        for _ in range(20):
            driver.run(1)
            times_s, places = driver.sonar.fired_s[0], driver.sonar.fired_from[0]
            seen.update(zip(times_s.tolist(), places.tolist(), strict=True))
    assert waiting == moving
    assert {round(time_s, 2) for time_s in waiting} >= {1.2, 1.24, 1.28}


def wall_robot() -> str:
    return '<robot x="0" y="0"/>' + wall_at(100)


@pytest.mark.parametrize(
    ("order", "fires"),
    [
        (b"", []),
        (bytes([255]), []),
        (bytes([255, 3]), []),
        (bytes(range(16)), list(range(16))),
        (bytes([3, 3, 3]), [3, 3, 3]),
        (bytes([5, 255, 6]), [5]),
        (bytes([1]) * 40, [1] * 16),
    ],
)
def test_conf_sn_accepts_orders_of_any_length(order, fires):
    driver = Driver.of(open_world())
    message, _ = driver.post("CONF_SN", 15, data=order)
    assert message["result"] == 1
    sonar = driver.sonar
    assert sonar.order[0, : sonar.length[0]].tolist() == fires


def test_conf_sn_refuses_invalid_sonars_and_keeps_order():
    driver = Driver.of(open_world())
    message, _ = driver.post("CONF_SN", 15, data=bytes([1, 16, 2]))
    assert message["result"] == 0
    assert driver.sonar.order[0].tolist() == ROUND


def test_sonars_not_in_order_read_255():
    driver = Driver.of(world_of('<robot x="5m" y="5m"/>'))
    assert (driver.ask("GET_SN")[RING] < NO_ECHO).all()
    conf_sn(driver, 15, 2, 0)
    for _ in range(20):
        readings = driver.ask("GET_SN")[RING]
        assert np.flatnonzero(readings < NO_ECHO).tolist() == [0, 2]
        driver.run(1)


def test_a_dropped_echo_is_reported_when_the_listening_time_ends():
    lost = '<degradation robot="robot0" device="sonar" element="0" dropouts="1" onset="1s"/>'
    driver = Driver.of(open_world(wall_robot() + lost, timestep="1ms"))
    conf_sn(driver, 25, 0)
    driver.run_s(1.001)  # the firing at 1.0 s is the first whose echo is dropped
    listens_s = (
        2 * sonars_of(driver.environment.world.robots[0].model).sonars[0].range_m / SOUND_MPS
    )
    echo_s = 2 * 100 * INCH / SOUND_MPS
    assert echo_s < listens_s - 0.01

    def reading(at_s: float) -> int:
        driver.run_s(at_s - driver.environment.time_s)
        return int(driver.ask("GET_SN")[SONAR_0])

    assert reading(1.0 + echo_s + 0.005) == 100
    assert reading(1.0 + listens_s - 0.002) == 100
    assert reading(1.0 + listens_s + 0.002) == NO_ECHO


def test_empty_order_switches_sonars_off():
    driver = Driver.of(world_of('<robot x="5m" y="5m"/>'))
    conf_sn(driver, 15)
    count = driver.sonar.count[0]
    driver.run_s(3)
    assert driver.ask("GET_SN")[RING].tolist() == [NO_ECHO] * 16
    assert driver.sonar.count[0] == count
    conf_sn(driver, 15, 7)
    driver.run_s(0.1)
    assert np.flatnonzero(driver.ask("GET_SN")[RING] < NO_ECHO).tolist() == [7]


def test_missing_sonar_reads_255():
    world = world_of('<robot x="5m" y="5m"/>')
    robot = world.robots[0]
    sonars = Sonars(sonars_of(robot.model).sonars[:4], SonarBoard(order=(0, 1)))
    few = robot.model.with_device("sonar", sonars)
    driver = Driver.of(replace(world, robots=(replace(robot, model=few),)))
    message, _ = driver.post("CONF_SN", 15, data=bytes([0, 9]))
    assert message["result"] == 0  # the order stays as it was
    driver.run_s(0.5)
    assert np.flatnonzero(driver.ask("GET_SN")[RING] < NO_ECHO).tolist() == [0, 1]


# -- when an echo is there ---------------------------------------------------------------------


def test_reading_is_reported_when_echo_arrives():
    driver = Driver.of(open_world('<robot x="0" y="0"/>' + wall_at(100), timestep="100ms"))
    conf_sn(driver, 15)
    conf_sn(driver, 15, 0, at_s=0.01)
    flight_s = 200 * INCH / SOUND_MPS
    assert driver.ask("GET_SN", at_s=0.01 + flight_s - 1e-6)[SONAR_0] == NO_ECHO
    assert driver.ask("GET_SN", at_s=0.01 + flight_s + 1e-6)[SONAR_0] == 100
    assert driver.sonar.fired_s[0, 0] == pytest.approx(0.01)


def test_no_echo_is_reported_after_flight_time_of_range():
    driver = Driver.of(open_world('<robot x="0" y="0"/>' + wall_at(100), timestep="100ms"))
    driver.state.bodies.position_m[0, 1] = 100.0  # away from the wall
    conf_sn(driver, 50, 0)
    flight_s = 510 * INCH / SOUND_MPS
    assert driver.ask("GET_SN", at_s=flight_s - 1e-6)[SONAR_0] == 100  # of the start
    assert driver.ask("GET_SN", at_s=flight_s + 1e-6)[SONAR_0] == NO_ECHO


def test_echo_after_next_firing_is_lost():
    elements = '<robot x="0" y="0"/>' + wall_at(100)
    for least_s, heard in ((0.04, 100), (0.012, NO_ECHO)):
        world = with_board(open_world(elements), least_interval_s=least_s)
        driver = Driver.of(world)
        conf_sn(driver, 0, 0, 8)
        driver.run_s(0.5)
        assert driver.ask("GET_SN")[SONAR_0] == heard


def test_reading_is_that_of_last_firing():
    # Towards a wall at 10 in/s: each sonar tells of the place where it was its turn.
    driver = Driver.of(open_world('<robot x="0" y="0"/>' + wall_at(200)))
    conf_sn(driver, 25, 0, 4, 8, 12)
    driver.ask("AC", 780, 780)
    driver.ask("VM", 100, 100)
    driver.run_s(1)
    for _ in range(100):
        now_s = driver.environment.time_s + 0.021
        told = driver.ask("GS", at_s=now_s)
        fired_s = math.floor((now_s - 0.04) / 0.4) * 0.4  # 40 ms: surely there
        if abs((now_s % 0.4) - 0.02) > 0.03:
            x_in = told[CONF_X] / 10 - 10 * (now_s - fired_s)
            assert told[SONAR_0] == pytest.approx(200 - x_in, abs=0.6)
        driver.run(1)
    sonar = driver.sonar
    assert sonar.fired_s[0, [0, 4, 8, 12]] == pytest.approx(
        np.array([0, 0.1, 0.2, 0.3]) + sonar.fired_s[0, 0]
    )
    # What the robot knew of itself at each firing: x in 0.1 in, and the speeds of its wheels.
    moved = 1000 * (sonar.fired_s[0, 4] - sonar.fired_s[0, 0]) / 10
    assert sonar.fired_from[0, 4, 0] - sonar.fired_from[0, 0, 0] == pytest.approx(moved, abs=1.1)
    assert sonar.fired_from[0, 8].tolist()[1:] == [0, 0, 0, 100, 100, 0]


@pytest.mark.parametrize("timestep", ["10ms", "20ms", "100ms"])
def test_firing_pose_is_independent_of_timestep(timestep):
    driver = Driver.of(open_world('<robot x="0" y="0"/>' + wall_at(200), timestep=timestep))
    driver.ask("AC", 780, 780)
    conf_sn(driver, 17, 0, at_s=0.001)
    driver.ask("VM", 390, 390, at_s=0.002)
    driver.run_s(2)
    fired = int((2 - 0.02 - 0.001) / 0.068)
    at_s = fired * 0.068 + 0.001
    way_in = 39 * (at_s - 0.002) - 39**2 / (2 * 78)
    assert driver.sonar.fired_s[0, 0] == pytest.approx(at_s)
    assert driver.sonar.echo_m[0, 0] == pytest.approx((200 - way_in) * INCH, abs=0.02 * INCH)


@pytest.mark.parametrize("timestep", ["20ms", "100ms"])
def test_sonars_fire_during_wait_from_current_pose(timestep):
    driver = Driver.of(open_world('<robot x="0" y="0"/>' + wall_at(200), timestep=timestep))
    driver.ask("AC", 780, 780)
    conf_sn(driver, 17, 0, at_s=0.001)
    driver.ask("VM", 390, 390, at_s=0.002)
    driver.run(int(0.085 / driver.environment.timestep_s))
    _, goes_on_s = driver.post("WS", 1, 1, 0, 2, at_s=0.085)  # gives up at 2.085, in a cycle
    assert math.isinf(goes_on_s)
    while not len(driver.run(1)[0].robots):
        assert driver.environment.time_s < 3
    at_s = 0.001 + 30 * 0.068  # 2.041: its echo comes before the end of the wait
    way_in = 39 * (at_s - 0.002) - 39**2 / (2 * 78)
    assert driver.sonar.fired_s[0, 0] == pytest.approx(at_s)
    assert driver.sonar.echo_m[0, 0] == pytest.approx((200 - way_in) * INCH, abs=1e-9)


@pytest.mark.parametrize(
    ("name", "at_s"), [("NEW_WORLD", 0.01), ("PLACE_ROBOT", 0.01), ("GS", 0.05)]
)
def test_firing_at_end_of_cycle_belongs_to_next(name, at_s):
    driver = Driver.of(open_world(PAIR, timestep="50ms"))
    driver.ask("VM", 300, 300, robot=1)
    driver.run_s(1)
    conf_sn(driver, 25, 0, at_s=1.0)  # at 1.0 s, 1.1 s and so on
    driver.run(1)
    assert driver.post(name, at_s=1.05 + at_s)[1] == driver.environment.end_s
    driver.run(1)
    gap_m = driver.state.x_m[1] - driver.state.x_m[0]
    driver.run(1)
    assert driver.sonar.fired_s[0, 0] == pytest.approx(1.1)
    assert driver.sonar.echo_m[0, 0] == pytest.approx(gap_m - 2 * SCOUT_RADIUS_M)


def test_robot_leaving_contact_fires_from_current_pose():
    # Its bumper is pressed when the cycle begins, but nothing holds it back.
    driver = Driver.of(open_world('<robot x="0" y="0"/>' + wall_at(10), timestep="100ms"))
    driver.ask("VM", 100, 100)
    driver.run_s(3)
    driver.ask("ST")
    driver.run_s(1)
    driver.ask("AC", 780, 780)
    driver.ask("VM", -300, -300)
    conf_sn(driver, 250, 0, at_s=4.09)
    assert driver.state.devices.bumper.pressed[0]
    gap_m = 10 * INCH - driver.state.x_m[0]
    way_m = 78 * INCH * 0.09**2 / 2
    assert driver.sonar.heard_m[0] == pytest.approx(gap_m + way_m)


def play(asks: list[bool], orders: list[tuple[int, list[int]]], speeds: list[int]) -> Driver:
    """Drive a robot while its order changes; `asks` is when it requests in between."""
    driver = Driver.of(world_of('<robot x="5m" y="5m"/>'))
    for ask, (rate, order), speed in zip(asks, orders, speeds, strict=True):
        time_s = driver.environment.time_s
        driver.post("CONF_SN", rate, data=bytes(order), at_s=time_s + 0.004)
        driver.ask("VM", speed, -speed, at_s=time_s + 0.01)
        for _ in range(5):
            if ask:
                driver.ask("GS", at_s=driver.environment.time_s + 0.013)
                driver.ask("GET_SN", at_s=driver.environment.time_s + 0.041)
            driver.run(1)
            sonar = driver.sonar
            assert sonar.listening[0] < 0 or sonar.sent_s[0] < sonar.heard_s[0]
            assert sonar.heard_s[0] <= sonar.next_s[0] or sonar.listening[0] < 0
            assert sonar.next_s[0] >= driver.environment.time_s
            assert (sonar.fired_s[0] <= driver.environment.time_s).all()
    return driver


ORDERS = st.tuples(st.integers(0, 60), st.lists(st.integers(0, 15), max_size=16))


@settings(max_examples=12, deadline=None)
@given(st.lists(st.tuples(st.booleans(), ORDERS, st.integers(-300, 300)), min_size=2, max_size=5))
def test_requests_do_not_affect_readings(plan):
    asks, orders, speeds = (list(column) for column in zip(*plan, strict=True))
    asked, unasked = play(asks, orders, speeds), play([False] * len(plan), orders, speeds)
    assert asked.sonar.echo_m == pytest.approx(unasked.sonar.echo_m, abs=1e-9)
    assert np.array_equal(asked.sonar.fired_s, unasked.sonar.fired_s)
    assert np.array_equal(asked.sonar.turn, unasked.sonar.turn)


def test_initial_readings_are_measured_at_start():
    readings = Driver.of(world_of('<robot x="5m" y="5m"/>')).ask("GET_SN")[RING]
    assert (readings < NO_ECHO).all()
    quarter = readings[[0, 4, 8, 12]]
    assert (quarter == round((5 - SCOUT_RADIUS_M) / INCH)).all()


# -- two robots --------------------------------------------------------------------------------

PAIR = '<robot x="0" y="0"/><robot x="100in" y="0" heading="180"/>'


def test_two_robots_measure_each_other():
    driver = Driver.of(open_world(PAIR))
    for robot in (0, 1):
        driver.post("CONF_SN", 0, robot=robot, data=bytes([0]))
    driver.ask("PR", 200, 200, robot=1)
    driver.run_s(6)
    assert driver.ask("GS", robot=0)[SONAR_0] == 64
    assert driver.ask("GS", robot=1)[SONAR_0] == 64


def crosstalk_driver(second_at_s: float, **changes) -> Driver:
    driver = Driver.of(with_board(open_world(PAIR, timestep="100ms"), **changes))
    for robot in (0, 1):
        driver.post("CONF_SN", 25, robot=robot)
    driver.post("CONF_SN", 250, robot=1, data=bytes([0]), at_s=second_at_s)
    driver.post("CONF_SN", 250, robot=0, data=bytes([0]), at_s=0.02)
    return driver


@pytest.mark.parametrize("later_s", [-0.006, -0.003, 0.0])
def test_ping_of_other_robot_is_mistaken_for_echo(later_s):
    # They face each other over 84 in: a ping takes 6.2 ms from one to the other, an echo 12.4 ms.
    driver = crosstalk_driver(0.02 + later_s, crosstalk=1.0)
    expected = (84 * INCH + later_s * SOUND_MPS) / 2 / INCH
    assert driver.ask("GS", at_s=0.09)[SONAR_0] == round(expected)
    assert driver.sonar.echo_m[0, 0] == pytest.approx(expected * INCH)


def test_pings_arriving_before_own_one_are_ignored():
    assert crosstalk_driver(0.02 - 0.0065, crosstalk=1.0).ask("GS", at_s=0.09)[SONAR_0] == 84


def test_other_robots_pings_are_ignored_without_crosstalk():
    assert crosstalk_driver(0.02).ask("GS", at_s=0.09)[SONAR_0] == 84


def test_ping_in_other_direction_is_not_mistaken_for_echo():
    driver = crosstalk_driver(0.02, crosstalk=1.0)
    driver.post("CONF_SN", 250, robot=1, data=bytes([8]), at_s=0.095)
    driver.run(1)
    driver.post("CONF_SN", 250, robot=0, data=bytes([0]), at_s=0.1)
    assert driver.ask("GS", at_s=0.19)[SONAR_0] == 84


def test_ping_of_other_robot_follows_its_turret():
    # Their wheels are turned aside; their turrets still face each other.
    robots = PAIR.replace("<robot", '<robot definition="nomad200"')
    told = {}
    for crosstalk in (0.0, 1.0):
        driver = Driver.of(with_board(open_world(robots), crosstalk=crosstalk))
        for robot in (0, 1):
            driver.ask("PR", 0, 900, 0, robot=robot)
        driver.run_s(6)
        for robot in (1, 0):  # both fire now, and robot 0 listens to what robot 1 has begun
            driver.post("CONF_SN", 250, robot=robot, data=bytes([0]))
        driver.run(1)
        told[crosstalk] = driver.ask("GS")[SONAR_0]
    assert told[0.0] < NO_ECHO
    assert told[1.0] == pytest.approx(told[0.0] / 2, abs=0.5)


# -- errors ------------------------------------------------------------------------------------


def readings(world: WorldModel, count: int, seed: int = 1, robot: int = 0) -> np.ndarray:
    """Return many distances of sonar 0 of a robot at rest, in inches."""
    driver = Driver.of(world, seed)
    driver.post("CONF_SN", 10, data=bytes([0]), robot=robot)
    found = []
    for _ in range(count):
        driver.run(1)
        driver.ask("GS", robot=robot, at_s=driver.environment.time_s)
        found.append(driver.sonar.echo_m[robot, 0] / INCH)
    return np.array(found)


SLOW = "40ms"  # so that each cycle has one firing


def told_in(distance_in: float, count: int = 4000, **changes) -> np.ndarray:
    """Return a robot's reports of the same distance many times [in]."""
    (robot,) = with_board(open_world(), **changes).robots
    errors = SonarErrors([sonars_of(robot.model).board], np.array([0]), seed=1, stream=0)
    row, distance_m = np.array([0]), np.array([distance_in * INCH])
    draws = [errors.draw(row, np.array([number])) for number in range(count)]
    return np.array([errors.reported_m(row, row, distance_m, drawn)[0] for drawn in draws]) / INCH


@pytest.mark.parametrize("distance", [50, 200])
def test_noise_has_standard_deviation_of_definition(distance):
    found = told_in(distance, noise_m=0.5 * INCH, noise_share=0.01)
    expected = math.hypot(0.5, 0.01 * distance)
    assert found.std() == pytest.approx(expected, rel=0.05)
    assert found.mean() == pytest.approx(distance, abs=4 * expected / math.sqrt(len(found)))
    assert abs(np.corrcoef(found[1:], found[:-1])[0, 1]) < 0.06


def test_dropouts_have_probability_of_definition():
    found = told_in(50, dropouts=0.2)
    assert np.isinf(found).mean() == pytest.approx(0.2, abs=0.03)
    assert found[np.isfinite(found)] == pytest.approx(50)
    assert np.isinf(told_in(50, 50, dropouts=1.0)).all()


def test_noisy_readings_are_whole_inches():
    world = open_world('<robot x="0" y="0"/>' + wall_at(100), SLOW)
    found = readings(with_board(world, noise_m=2 * INCH), 150)
    assert 1.5 < found.std() < 2.5
    assert len(set(np.rint(found))) > 5


@pytest.mark.parametrize(
    ("distance", "told"), [(1, 4), (1.5, 4.5), (2, 4), (2.9, 5.8), (3.5, 3.5), (10, 10)]
)
def test_multiple_echo_is_heard_below_blind_distance(distance, told):
    world = open_world('<robot x="0" y="0"/>' + wall_at(distance), SLOW)
    assert readings(with_board(world, blind_m=3.2 * INCH), 4)[-1] == pytest.approx(told)


def test_object_on_shell_is_reported_at_blind_distance():
    world = open_world('<robot x="0" y="0"/>' + wall_at(0), SLOW)
    assert readings(with_board(world, blind_m=3.2 * INCH), 4)[-1] == pytest.approx(3.2)
    assert readings(world, 4)[-1] == 0


def test_no_reading_is_below_minimum():
    world = with_board(open_world('<robot x="0" y="0"/>' + wall_at(2), SLOW), minimum_m=6 * INCH)
    assert readings(world, 4)[-1] == pytest.approx(6)


def test_errors_of_robots_are_independent():
    def crowd(count: int) -> WorldModel:
        model = with_board(empty_world("noisy"), dropouts=0.1).robots[0].model
        robots = tuple(Robot(f"r{n}", model, Pose(0, -30.0 * n)) for n in range(count))
        return WorldModel("w", Area(-500, -500, 1000, 1000, 0), robots=robots,
                          walls=open_world('<robot x="0" y="9"/>' + wall_at(80)).walls)  # fmt: skip

    alone, among = readings(crowd(1), 60), readings(crowd(3), 60)
    assert np.array_equal(alone, among)
    assert not np.array_equal(alone, readings(crowd(1), 60, seed=2))
    assert len(set(alone.tolist())) > 40


def test_ideal_setup_has_no_errors_and_noisy_one_has_all():
    ideal = sonars_of(empty_world().robots[0].model).board
    noisy = sonars_of(empty_world("noisy").robots[0].model).board
    assert ideal == SonarBoard(order=tuple(ROUND))
    assert noisy.order == ideal.order
    assert noisy.critical_rad < ideal.critical_rad
    for name in ("lobe_rad", "blind_m", "noise_m", "noise_share", "dropouts", "crosstalk"):
        assert getattr(noisy, name) > 0


# -- snapshots ---------------------------------------------------------------------------------


def test_pending_ping_survives_snapshot():
    world = open_world('<robot x="0" y="0" setup="noisy"/>' + wall_at(200))
    driver = Driver.of(world)
    driver.ask("VM", 100, 100)
    driver.run(3)
    driver.ask("GS", at_s=0.185)  # sonar 1 fired at 0.18
    assert driver.sonar.listening[0] >= 0
    snapshot = pickle.loads(pickle.dumps(driver.environment.snapshot()))
    other = Environment(world, 1)
    other.restore(snapshot)
    for environment in (driver.environment, other):
        for _ in range(60):
            environment.step()
    assert driver.environment.hash() == other.hash()


@pytest.mark.parametrize(
    "changes",
    [
        {"blind_m": 1e4},
        {"minimum_m": 1e4},
        {"noise_m": 1e4, "noise_share": 1.0},
        {"lobe_rad": math.radians(0.01), "critical_rad": 0.0},
        {"lobe_rad": 1e4, "critical_rad": 1e4, "crosstalk": 1.0},
        {"interval_s": 0.001, "least_interval_s": 0.001, "crosstalk": 1.0},
        {"dropouts": 1.0, "crosstalk": 1.0},
    ],
)
@pytest.mark.filterwarnings("error")
def test_no_board_breaks_simulator(changes):
    elements = '<robot x="5m" y="5m"/><robot x="6m" y="5m" heading="180"/>'
    driver = Driver.of(with_board(world_of(elements), **changes))
    driver.ask("VM", 200, 200)
    for _ in range(40):
        readings = driver.ask("GS")[RING]
        assert ((readings >= 0) & (readings <= NO_ECHO)).all()
        driver.run(1)
