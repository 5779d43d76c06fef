"""Robots and objects that are moved or removed while the world runs."""

import math

import pytest

from crs_cc.sim.model.world import Pose
from tests.sim.driver import SCOUT_RADIUS_M, Driver, open_world, world_of

ELEMENTS = (
    '<robot id="a" x="2m" y="2m"/><robot id="b" x="5m" y="5m"/>'
    '<box id="crate" x="8m" y="2m" length="1m" width="0.5m" mass="5kg"/>'
    '<wall id="screen" x1="4m" y1="0" x2="4m" y2="3m" thickness="10cm"/>'
)


def driver_of(elements: str = ELEMENTS) -> Driver:
    return Driver.of(world_of(elements))


def run(driver: Driver, steps: int) -> str:
    for _ in range(steps):
        driver.environment.step()
    return driver.environment.hash()


def test_teleported_robot_keeps_odometry_and_command() -> None:
    driver = driver_of()
    driver.ask("PR", 400, 400)  # 40 in
    run(driver, 20)
    state = driver.state
    gone_m, believed_m = float(state.x_m[0]) - 2.0, float(state.odometry.x_m[0])
    driver.environment.teleport("a", Pose(6.0, 7.0, math.pi / 2))
    assert (state.x_m[0], state.y_m[0], state.heading_rad[0]) == (6.0, 7.0, math.pi / 2)
    assert (state.odometry.x_m[0], state.odometry.heading_rad[0]) == (believed_m, 0.0)
    run(driver, 120)
    assert state.odometry.x_m[0] == pytest.approx(40 * 0.0254)
    assert state.x_m[0] == pytest.approx(6.0)
    assert state.y_m[0] == pytest.approx(7.0 + 40 * 0.0254 - gone_m)


def test_sensors_measure_from_new_pose_at_once() -> None:
    driver = driver_of()
    driver.environment.teleport("a", Pose(9.0, 5.0, 0.0))
    run(driver, 20)
    driver.ask("GET_SN")
    # From the shell, 9 m + 8 in, to the edge at 10 m.
    assert driver.state.devices.sonar.echo_m[0, 0] == pytest.approx(1.0 - SCOUT_RADIUS_M, abs=0.01)


@pytest.mark.parametrize(
    ("name", "place", "message"),
    [
        ("a", Pose(5.1, 5.1), "cannot move 'a': it would overlap 'b'"),
        ("a", Pose(4.0, 1.0), "cannot move 'a': it would overlap 'screen'"),
        ("a", Pose(0.1, 1.0), "cannot move 'a': it would overlap the edge of the world"),
        ("crate", Pose(5.6, 5.0), "cannot move 'crate': it would overlap 'b'"),
        ("crate", Pose(4.2, 2.0, 1.0), "cannot move 'crate': it would overlap 'screen'"),
        ("crate", Pose(9.8, 5.0), "cannot move 'crate': it would overlap the edge of the world"),
        ("screen", Pose(1.0, 1.0), r"unknown robot or movable object 'screen' \(known: a, b, c"),
    ],
)  # fmt: skip
def test_move_to_occupied_place_is_refused_without_effect(name, place, message) -> None:
    driver = driver_of()
    run(driver, 3)
    before = driver.environment.hash()
    with pytest.raises(ValueError, match=message):
        driver.environment.teleport(name, place)
    assert driver.environment.hash() == before


def test_object_is_moved_and_may_touch_others() -> None:
    driver = driver_of()
    # Turned by 90 degrees it is 0.25 m wide to the left: it just touches the screen's side.
    driver.environment.teleport("crate", Pose(4.3, 1.5, math.pi / 2))
    run(driver, 20)
    body = driver.state.bodies
    assert body.position_m[2] == pytest.approx([4.3, 1.5], abs=1e-3)
    driver.ask("PR", 900, 900)  # the robot would come to 2 m + 2.29 m, through the screen
    run(driver, 300)
    assert driver.state.x_m[0] == pytest.approx(4.0 - 0.05 - SCOUT_RADIUS_M, abs=2e-3)


def test_held_object_stays_behind_and_cannot_be_moved() -> None:
    driver = Driver.of(
        world_of(
            '<robot x="5m" y="5m" definition="nomad200"/>'
            '<cylinder id="can" x="9m" y="9m" radius="5cm" mass="1kg"/>'
        )
    )
    holds = driver.state.bodies.holds
    holds.object[0, 0] = 0
    with pytest.raises(ValueError, match="'robot0' holds 'can'"):
        driver.environment.teleport("can", Pose(1.0, 1.0))
    driver.environment.teleport("robot0", Pose(2.0, 2.0))
    assert holds.object[0, 0] == -1
    assert driver.state.bodies.position_m[1].tolist() == [9.0, 9.0]


def test_synchro_drive_is_turned_as_a_whole() -> None:
    driver = Driver.of(open_world('<robot x="0" y="0" definition="nomad200"/>'))
    driver.ask("PR", 0, 900, 450)  # wheels to 90 deg, turret to 45 deg
    run(driver, 200)
    state = driver.state
    assert state.heading_rad[0] == pytest.approx(math.pi / 2)
    driver.environment.teleport("robot0", Pose(1.0, 1.0, math.pi))
    assert state.base_rad[0] == pytest.approx(math.pi / 2)
    assert state.mount_rad[0] == pytest.approx(3 * math.pi / 4)
    assert state.odometry.heading_rad[0] == pytest.approx(math.pi / 2)


def test_contact_at_new_pose_is_another_collision() -> None:
    driver = driver_of('<robot x="2m" y="2m"/>')
    driver.environment.teleport("robot0", Pose(10.0 - SCOUT_RADIUS_M, 5.0))
    driver.ask("VM", 50, 50)
    run(driver, 20)
    assert driver.state.collisions[0] == 1
    driver.environment.teleport("robot0", Pose(10.0 - SCOUT_RADIUS_M, 7.0))
    run(driver, 20)
    assert driver.state.collisions[0] == 2


def test_objects_can_be_removed_but_not_robots_and_edges() -> None:
    driver = driver_of()
    for name in ("crate", "screen"):
        driver.environment.remove_obstacle(name)
        assert name not in driver.environment.names
        with pytest.raises(ValueError, match=f"unknown object '{name}'"):
            driver.environment.remove_obstacle(name)
    driver.ask(
        "ADD_OBSTACLE",
        3,
        data=bytes.fromhex("0a000000 0a000000 1e000000 0a000000 1e000000 1e000000"),
    )
    driver.environment.remove_obstacle("obstacle-0")
    for name in ("a", "edge-north", "obstacle-0"):
        with pytest.raises(ValueError, match="unknown object"):
            driver.environment.remove_obstacle(name)


def test_dismissed_robot_leaves_at_end_of_cycle() -> None:
    driver = driver_of()
    run(driver, 2)
    driver.environment.dismiss_robot(1)
    assert driver.state.presence.present.tolist() == [True, True]
    step = driver.environment.step()
    assert [(event.kind, event.text, event.robot) for event in step.events] == [
        ("leave", "left", 1)
    ]
    assert driver.state.presence.left_s[1] == pytest.approx(0.15)
    with pytest.raises(ValueError, match="has already left"):
        driver.environment.dismiss_robot(1)


def test_run_from_snapshot_after_changes_is_bitwise_equal() -> None:
    driver = driver_of()
    driver.ask("VM", 100, 80)
    driver.ask("VM", 60, 100, robot=1)
    run(driver, 130)  # the space has been made anew once
    driver.ask("GET_SN", at_s=driver.environment.time_s + 0.01)  # so in the middle of a cycle
    driver.environment.teleport("a", Pose(3.75 - SCOUT_RADIUS_M, 2.0, 0.3))
    driver.environment.teleport("crate", Pose(3.0, 4.0, 0.7))
    driver.environment.dismiss_robot(1)
    snapshot = driver.environment.snapshot()
    ends = [run(driver, 90)]
    driver.environment.restore(snapshot)
    ends.append(run(driver, 90))
    assert ends[0] == ends[1]
    other = Driver.of(driver.environment.world)
    other.environment.restore(snapshot)
    assert run(other, 90) == ends[0]


def test_battery_charge_can_be_set() -> None:
    driver = Driver.of(open_world('<robot x="0" y="0" definition="nomad150"/>'))
    run(driver, 10)
    driver.environment.charge(0, 0.25)
    assert driver.environment.charges(0)[1] == pytest.approx(0.25)
    driver.environment.charge(0, 0.0)
    driver.ask("VM", 100, 0)
    run(driver, 10)
    assert driver.state.x_m[0] == 0.0
