"""The kernels of a cycle's end, of speeds and of replies compute what numpy computes."""

from __future__ import annotations

import numpy as np
import pytest

from crs_cc.core.arrays import FloatArray, Records
from crs_cc.core.units import m_to_inch
from crs_cc.requests import NUM_STATE
from crs_cc.sim.devices import vendor_state
from crs_cc.sim.devices.battery.state import motors_of
from crs_cc.sim.devices.bumper.state import bumper_state
from crs_cc.sim.devices.mount import mount_poses
from crs_cc.sim.devices.robot_constants import RobotConstants
from crs_cc.sim.devices.sonar.state import sonar_state
from crs_cc.sim.kernels import tables
from crs_cc.sim.kernels.program import Kernels
from crs_cc.sim.kernels.tables import ADVANCED, NOT_HANDLED, REPLY
from crs_cc.sim.state import robot_rows
from crs_cc.sim.state.env_state import EnvState
from crs_cc.sim.state.rows import ALL
from tests.sim.kernels.numpy_profiles import plan_speed
from tests.sim.kernels.test_drive import ROBOTS, TURN, moving, world

STEP_S, END_S = 0.1, 40.0


def tired(seed: int) -> tuple[EnvState, RobotConstants]:
    """Return robots at the end of a cycle, some with nearly empty batteries or held up."""
    state, constants = moving(seed)
    random, motors = np.random.default_rng(seed), motors_of(state)
    motors.moved_j[:] = random.uniform(0.0, 3e5, len(motors.moved_j))
    motors.moved_j[::4] = 1e9
    motors.speed_mps[:] = random.uniform(-0.5, 0.5, motors.speed_mps.shape)
    state.bodies.slipping[:] = random.random(ROBOTS) < 0.3
    state.bodies.position_m[:] += random.uniform(-1e-3, 1e-3, (ROBOTS, 2))
    state.presence.joined_s = random.uniform(0.0, 30.0, ROBOTS)
    state.base_rad[:] = random.uniform(0.0, TURN, ROBOTS)
    return state, constants


def charge(state: EnvState, constants: RobotConstants, for_s: FloatArray) -> FloatArray:
    """Return the states of charge of computers' and motors' batteries, 0 to 1."""
    supplies = [
        (
            robot.model.device("computer_battery"),
            robot.model.device("motor_battery"),
        )
        for robot in world().robots
    ]
    left = np.ones((ROBOTS, 2))
    number = constants.numbers["motor_battery"]
    for robot, pair in enumerate(supplies):
        for which, supply in enumerate(pair):
            if supply is not None:
                moved_j = motors_of(state).moved_j[number[robot]] if which else 0.0
                used_j = supply.power_w * for_s[robot] + moved_j
                left[robot, which] = max(supply.charge - used_j / supply.capacity_j, 0.0)
    return left


def finish(state: EnvState, constants: RobotConstants, before_m: FloatArray) -> list[int]:
    """End a cycle as numpy does; return which batteries are empty."""
    went_m, drives = state.bodies.position_m - before_m, constants.drives
    state.distance_m += np.sqrt(went_m[:, 0] * went_m[:, 0] + went_m[:, 1] * went_m[:, 1])
    state.heading_rad[:] = state.drive.facing_rad % TURN
    state.base_rad[:] = np.where(drives.synchro, state.base_rad, state.heading_rad)
    turret_rad = state.drive.turret_rad % TURN
    state.mount_rad[:] = np.where(drives.turret, turret_rad, state.base_rad)
    held_back, motors, worked = state.bodies.slipping, motors_of(state), []
    for number, robot in enumerate(np.flatnonzero(constants.numbers["motor_battery"] >= 0)):
        model = world().robots[robot].model
        battery, turns = model.device("motor_battery"), model.drive.steering is not None
        lever = np.array([1.0, model.radius_m, model.radius_m] if turns else [1.0, 1.0, 0.0])
        mass_kg = model.mass_kg if turns else model.mass_kg / 2
        way_m, speed_mps = state.drive.slice[robot] * lever, state.drive.axes.speed[robot] * lever
        before_mps = motors.speed_mps[number]
        faster = np.maximum(speed_mps * speed_mps - before_mps * before_mps, 0.0)
        work_j = battery.friction_n * np.abs(way_m) + mass_kg * (faster / 2)
        moved_j = (work_j[0] + work_j[1] + work_j[2]) * (1.0 / battery.efficiency)
        motors.moved_j[number] += moved_j
        motors.moved_j[number] += battery.stall_w * (STEP_S * held_back[robot])
        motors.speed_mps[number] = speed_mps
        if way_m.any() or held_back[robot]:
            worked.append(robot)
    left = charge(state, constants, END_S - state.presence.joined_s)
    state.drive.moved_m[:] = 0.0
    state.drive.slice[:] = 0.0
    state.drive.facing_rad[:] = state.heading_rad
    return [robot for robot in worked if left[robot, 1] == 0.0]


@pytest.mark.parametrize("seed", range(3))
def test_the_end_of_a_cycle_is_that_of_numpy(seed: int) -> None:
    (state, constants), (wanted, _) = tired(seed), tired(seed)
    before_m = state.bodies.position_m - 0.1
    empty = finish(wanted, constants, before_m)
    found = state.rows.finish(state, (STEP_S, END_S), before_m, constants.kinds)
    assert found == (ADVANCED, empty, True)
    assert 3 < len(empty) < ROBOTS - 3
    assert state.sha256() == wanted.sha256()


def test_free_robots_move_as_their_wheels_do() -> None:
    (state, constants), (wanted, _) = tired(7), tired(7)
    before_m, moved_m = wanted.bodies.position_m.copy(), wanted.drive.moved_m.copy()
    wanted.bodies.position_m += moved_m
    wanted.bodies.velocity_mps[:] = moved_m / STEP_S
    empty = finish(wanted, constants, before_m)
    found = state.rows.finish(state, (STEP_S, END_S), None, constants.kinds)
    assert found == (ADVANCED, empty, True)
    assert state.sha256() == wanted.sha256()


def test_a_robot_that_was_held_up_is_only_moved() -> None:
    state, constants = tired(8)
    state.drive.hindered[5] = True
    moved_m = state.bodies.position_m + state.drive.moved_m
    found = state.rows.finish(state, (STEP_S, END_S), None, constants.kinds)
    assert found[:2] == (NOT_HANDLED, [])
    assert np.array_equal(state.bodies.position_m, moved_m)
    assert state.drive.moved_m.any()


@pytest.mark.parametrize("rows", [ALL, np.arange(1, ROBOTS, 3)])
@pytest.mark.parametrize("some_axes", [False, True])
def test_speeds_are_set_as_by_numpy(rows: np.ndarray | slice, *, some_axes: bool) -> None:
    (state, constants), (wanted, _) = moving(3), moving(3)
    random, count = np.random.default_rng(3), len(np.arange(ROBOTS)[rows])
    speed = np.where(random.random((count, 3)) < 0.7, random.uniform(-2, 2, (count, 3)), -0.0)
    which = random.random((count, 3)) < 0.5 if some_axes else None
    ramp = random.uniform(0.1, 1.0, (count, 3)) if some_axes else None
    state.rows.set_speeds(rows, speed, constants.kinds, ramp=ramp, which=which)
    limit = constants.drives.speed_limit[rows]
    plan_speed(
        wanted.drive.axes,
        rows,
        wanted.drive.clock_s[rows],
        np.minimum(np.maximum(speed, -limit), limit),
        ramp=wanted.drive.ramp[rows] if ramp is None else ramp,
        which=True if which is None else which,
    )
    assert state.sha256() == wanted.sha256()


def replies(state: EnvState, constants: RobotConstants, for_s: FloatArray) -> Records:
    found = np.zeros(ROBOTS, REPLY)
    found["state"][:, 0] = 10
    echo_in = np.rint(m_to_inch(sonar_state(state).echo_m))
    found["state"][:, 17:33] = np.minimum(np.maximum(echo_in, 0), 255)
    found["state"][:, 33] = bumper_state(state).pressed
    found["state"][:, 34:42] = vendor_state.report(state, constants, np.arange(ROBOTS))
    found["charge"] = charge(state, constants, for_s)
    boards = [robot.model.board for robot in world().robots]
    start_s, tick_s = np.array([(board.start_s, board.tick_s) for board in boards]).T
    ticks = np.floor((start_s + for_s) / tick_s + 1e-9)
    found["board_ms"] = np.floor(ticks * tick_s * 1e3 + 1e-9) % 2.0**32
    return found


@pytest.mark.parametrize("checked", [False, True])
def test_replies_are_those_of_numpy(monkeypatch: pytest.MonkeyPatch, *, checked: bool) -> None:
    if checked:
        own = Kernels(holds_world=True, checked=True)
        monkeypatch.setattr(robot_rows, "Kernels", lambda **_: own)
    state, constants = tired(4)
    random = np.random.default_rng(4)
    echo_m = sonar_state(state).echo_m
    echo_m[:] = random.uniform(-0.1, 8.0, echo_m.shape)
    echo_m[::3, ::2] = np.inf
    bumper_state(state).pressed[:] = random.integers(0, 2**24, ROBOTS)
    for_s = random.uniform(0.0, 5e6, ROBOTS)
    for_s[:2] = 0.0164, 0.0
    wanted, rows = replies(state, constants, for_s), np.arange(2, ROBOTS, 5)
    assert wanted["state"].shape == (ROBOTS, NUM_STATE)
    every = state.rows.replies(ALL, for_s, constants.kinds)
    some = state.rows.replies(rows, for_s[rows], constants.kinds)
    for found, told in ((every, wanted), (some, wanted[rows])):
        for name in ("state", "charge", "board_ms"):
            assert np.array_equal(found[name], told[name]), name
    assert np.array_equal(state.rows.charges(ALL, for_s, constants.kinds), wanted["charge"])


@pytest.mark.parametrize("rows", [ALL, np.arange(1, ROBOTS, 3)])
def test_mounts_of_replies_are_where_numpy_has_them(rows: np.ndarray | slice) -> None:
    state, constants = tired(6)
    state.connected[:] = True
    mine = np.arange(ROBOTS)[rows]
    asked = (
        state.drive.clock_s[mine],
        state.presence.joined_s[mine],
        np.zeros((len(mine), 8), "<i4"),
    )
    found, _, mounts, _ = state.rows.serve(rows, (END_S, -1.0, 0, 0), asked, constants.kinds)
    assert found == ADVANCED
    assert state.bodies.slipping[mine].any()
    assert state.drive.moved_m[state.bodies.slipping].any()
    assert np.array_equal(mounts, mount_poses(state, constants, mine))


def test_replies_of_as_many_robots_as_possible_have_room() -> None:
    kernels = Kernels(holds_world=True)
    assert tables.ROBOTS * REPLY.itemsize <= kernels.arena[kernels.room // 3 :].nbytes


def test_batteries_that_last_another_cycle_are_known() -> None:
    state, constants = tired(5)
    motors_of(state).moved_j[:] = 0.0
    before_m = state.bodies.position_m.copy()
    found = state.rows.finish(state, (STEP_S, END_S), before_m, constants.kinds)
    assert found == (ADVANCED, [], False)
    motors_of(state).moved_j[0] = 1e9
    state.bodies.slipping[:] = False  # with wheels at rest nobody works, and none is found empty
    found = state.rows.finish(state, (STEP_S, END_S), before_m, constants.kinds)
    assert found == (ADVANCED, [], True)
