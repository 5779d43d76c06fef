"""Robots that join and leave an environment: their effect on others, and states that grow.

y
2 |  R0 >        place        R1
0 +------------------------------- x
0  1            4            7
"""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from crs_cc.sim.engine.environment import Environment
from crs_cc.sim.files.world_xml import load_robot
from crs_cc.sim.model.world import Pose
from tests.device.robot import scout_with
from tests.nclient.drive import drive
from tests.sim.driver import SCOUT_RADIUS_M, Driver, world_of

R0 = '<robot id="r0" x="1m" y="2m"/>'
PLACE = 'id="late" x="4m" y="2m"'
DEVICES = (
    '<infrared step="1in" half-angle="5deg" reflectance="1" rate="20Hz"/>',
    '<compass rate="10Hz" calibration="180s" on="yes"/>',
    '<laser points="20" field-of-view="60deg" range="3m"/>',
    '<gps rate="10Hz" period="0.1s" noise="1in"/>',
    "<inclinometer/>",
    '<camera columns="8" noise="1cm"/>',
    '<gripper place="8in"/>',
    '<arm x="10in" upper="10in" fore="10in" shoulder-speed="90deg/s" elbow-speed="90deg/s"/>',
    "<light-sensors/><microphones/><lamp/><speaker/>",
)


def hall(elements: str) -> Driver:
    return Driver.of(world_of(elements, 'length="8m" width="4m"', timestep="100ms"))


def ahead_m(driver: Driver) -> float:
    """Return the reading of R0's front sonar after its next firing."""
    driver.run_s(1.0)
    return float(driver.state.devices.sonar.echo_m[0, 0])


def test_robot_is_seen_while_present():
    """Before, the wall at 8 m is beyond the range of 6.477 m; then the robot at 4 m; then again."""
    driver = hall(f'{R0}<robot {PLACE} join="2s" leave="4s"/>')
    assert ahead_m(driver) == math.inf
    driver.run_s(1.0)
    assert ahead_m(driver) == pytest.approx(3.0 - 2 * SCOUT_RADIUS_M)
    driver.run_s(1.0)
    assert ahead_m(driver) == math.inf


def test_heat_of_robot_counts_while_present():
    driver = hall(f'{R0}<robot id="late" x="3m" y="2m" heat="5" join="0.5s" leave="1s"/>')
    readings = [driver.post("HEAT")[0]["i"][0]]
    for _ in range(2):
        driver.run_s(0.5)
        readings.append(driver.post("HEAT")[0]["i"][0])
    assert readings == [0, 5, 0]


def test_contact_with_robot_ends_when_it_leaves():
    """R0 runs into the late one, which leaves: the bumpers are free again, and R0 drives on."""
    driver = hall(f'{R0}<robot id="late" x="1.5m" y="2m" leave="3s"/>')
    driver.ask("VM", 100, 100)
    driver.run_s(2.9)
    assert driver.state.devices.bumper.pressed[0]
    driver.run_s(0.3)
    assert not driver.state.devices.bumper.pressed[0]
    before_m = driver.state.x_m[0]
    driver.run_s(1.0)
    assert driver.state.x_m[0] - before_m == pytest.approx(0.254, abs=1e-3)


def test_joining_robot_is_in_switch_on_state():
    """Its clock and its batteries start when it joins; all its sonars have fired."""
    driver = hall(f'{R0}<robot {PLACE} join="2s"/>')
    driver.run_s(2.0)
    late, first = (driver.post("GS", robot=robot)[0] for robot in (1, 0))
    driver.ask("CONNECT", robot=1)
    late, _ = driver.post("GS", robot=1)
    assert late["f"][0] == 0.0  # the board's clock
    assert first["f"][0] == pytest.approx(2000.0, abs=17.0)
    assert driver.state.devices.sonar.echo_m[1, 8] == pytest.approx(3.0 - 2 * SCOUT_RADIUS_M)
    assert driver.state.devices.sonar.fired_s[1, 8] == 2.0


def test_obstacle_may_be_at_place_of_absent_robot():
    """R0's program puts a square at the place, so that the late one waits until it is gone."""
    driver = hall(f'{R0}<robot {PLACE} join="0.5s"/>')
    corners = np.array([(x, y) for x, y in ((1500, 700), (1600, 700), (1600, 800), (1500, 800))])
    data = corners.astype("<i4").tobytes()
    assert driver.post("ADD_OBSTACLE", 4, data=data)[0]["result"]
    events = [event for step in driver.run_s(1.0) for event in step.events]
    assert [(event.kind, event.text) for event in events] == [
        ("join", "had to wait: place occupied by 'obstacle-0'")
    ]
    assert driver.post("DELETE_OBSTACLE", 4, data=data)[0]["result"]
    driver.run_s(0.2)
    assert driver.state.presence.present.tolist() == [True, True]


def test_place_is_occupied_by_pushed_object():
    """The box stands west of the place at first; R0 pushes it there."""
    box = '<box x="1.6m" y="2m" length="40cm" width="40cm" mass="2kg"/>'
    driver = hall(f'{R0}{box}<robot {PLACE} join="14s"/>')
    driver.ask("PR", 1000, 1000)
    driver.run_s(15.0)
    assert driver.state.bodies.position_m[2, 0] > 3.5
    assert driver.state.presence.present.tolist() == [True, False]


@pytest.mark.parametrize("seed", [0, 7])
def test_state_grows_by_all_devices_of_robot(tmp_path: Path, seed: int):
    """A third robot of the same kind: added by call, or in the world from the start, absent."""
    model = load_robot(Path(scout_with(tmp_path, *DEVICES)), "noisy")
    world = world_of(f'{R0}<robot id="r1" x="7m" y="2m"/>', 'length="8m" width="4m"')
    world = replace(
        world, robots=tuple(replace(robot, model=replace(model)) for robot in world.robots)
    )
    late = replace(world.robots[0], id="late", start=Pose(4.0, 1.0, 2.0), join_s=0.5)
    by_file = Environment(replace(world, robots=(*world.robots, late)), seed)
    by_call = Environment(world, seed)
    for environment in (by_file, by_call):
        driver = Driver(environment)
        for robot in (0, 1):
            driver.ask("CONNECT", robot=robot)
            driver.post("LIGHT", 100, robot=robot)
            driver.post("GRIPPER", 1, robot=robot)
            driver.ask("VM", 100, 50, robot=robot)
        driver.run_s(0.5)
    by_call.add_robot(replace(late, join_s=0.0))
    assert by_call.hash() == by_file.hash()
    for environment in (by_file, by_call):
        driver = Driver(environment)
        driver.ask("CONNECT", robot=2)
        for name in ("GS", "GPS", "CAMERA", "TILT", "GET_LIGHT", "GET_SOUND", "GET_ARM", "LASER"):
            driver.post(name, robot=2)
        driver.ask("VM", -100, 50, robot=2)
        driver.run_s(1.0)
    assert by_call.hash() == by_file.hash()
    snapshot = by_call.snapshot()
    by_file.step()
    by_file.restore(snapshot)
    for environment in (by_file, by_call):
        Driver(environment).run_s(1.0)
    assert by_call.hash() == by_file.hash()


def test_joining_does_not_affect_others(tmp_path: Path):
    """Noise, timers and readings of the first two are the same with and without a third."""
    model = load_robot(Path(scout_with(tmp_path, *DEVICES)), "noisy")
    world = world_of(f'{R0}<robot id="r1" x="1m" y="98m"/>', 'length="200m" width="100m"')
    world = replace(world, robots=tuple(replace(robot, model=model) for robot in world.robots))
    told = []
    for visited in (False, True):
        driver = Driver.of(world, seed=3)
        driver.run_s(1.0)
        if visited:
            far = replace(world.robots[0], id="late", start=Pose(190.0, 50.0))
            driver.environment.add_robot(far)
        names = ("GS", "GPS", "CAMERA", "GET_LIGHT", "LASER")
        told.append([])
        for _ in range(5):
            driver.run_s(0.3)
            told[-1] += [driver.post(name, robot=robot)[0] for robot in (0, 1) for name in names]
    assert told[0] == told[1]


def test_messages_do_not_reach_absent_robots():
    """Robot 1 joins at 1 s: it gets what is sent then, not what was sent before."""
    send = """
        #include <unistd.h>
        crs_send(1, 1, "early", 5); crs_broadcast(2, "early", 5);
        usleep(1500000);
        crs_send(1, 3, "late", 4);
    """.replace("#include <unistd.h>", "extern int usleep(unsigned);")
    receive = """
        struct crs_message m;
        crs_receive(&m, CRS_FOREVER);
        printf("%d %s %d", m.type, m.data, crs_message_count());
    """
    elements = '<robot x="0" y="0"/><robot x="1m" y="0" join="1s"/>'
    assert drive(send, receive, elements=elements).output[1] == "3 late 0"


def test_held_object_stays_when_robot_leaves(tmp_path: Path):
    """A can is taken at 26 cm ahead, carried for a while, and left behind."""
    model = load_robot(Path(scout_with(tmp_path, "<gripper/>")))
    can = '<cylinder id="can" x="1.26m" y="2m" radius="4cm" mass="1kg"/>'
    world = world_of(f"{R0}{can}", 'length="8m" width="4m"')
    world = replace(world, robots=(replace(world.robots[0], model=model),))
    driver = Driver.of(world)
    driver.post("GRIPPER", 1)
    driver.run_s(3.0)
    assert driver.state.bodies.holds.any()
    driver.ask("VM", 50, 50)
    driver.run_s(2.0)
    driver.environment.remove_robot(0)
    place_m = driver.state.bodies.position_m[1].copy()
    assert place_m[0] > 1.4
    assert not driver.state.bodies.holds.any()
    snapshot = driver.environment.snapshot()
    driver.run_s(1.0)
    after = driver.environment.hash()
    assert np.hypot(*(driver.state.bodies.position_m[1] - place_m)) < 0.05
    driver.environment.restore(snapshot)
    driver.run_s(1.0)
    assert driver.environment.hash() == after
