"""The kernels of the drive compute what numpy computes, to the bit."""

from __future__ import annotations

import math
from dataclasses import fields

import numpy as np
import pytest

from crs_cc.core.arrays import FloatArray
from crs_cc.sim.devices import drive, odometry, vendor_state
from crs_cc.sim.devices.drive import traction
from crs_cc.sim.devices.drive.constants import weighted
from crs_cc.sim.devices.robot_constants import RobotConstants
from crs_cc.sim.files.world_xml import parse_world
from crs_cc.sim.kernels import program
from crs_cc.sim.kernels.program import Kernels
from crs_cc.sim.kernels.tables import ADVANCED
from crs_cc.sim.model.world import WorldModel
from crs_cc.sim.state import motion_profile, robot_rows
from crs_cc.sim.state.env_state import EnvState
from crs_cc.sim.state.motion_profile import ALL, Axes
from tests.sim.kernels.numpy_profiles import plan_speed

ROBOTS = 40
TURN = 2 * math.pi


def world() -> WorldModel:
    """Return a world of robots with both kinds of drive and errors of their wheels."""
    kinds, setups = ("nomad200", "scout", "scout"), ("", 'setup="noisy"')
    rows = [
        f'<robot x="{3 + 2 * n}m" y="2m" heading="{9 * n}deg" definition="{kinds[n % 3]}"'
        f" {setups[n % 2]}/>"
        for n in range(ROBOTS)
    ]
    text = f'<world version="1"><area length="99m" width="9m"/>{"".join(rows)}</world>'
    return parse_world(text.encode(), "drives")


def moving(seed: int) -> tuple[EnvState, RobotConstants]:
    """Return robots in the middle of motions of all kinds."""
    made, random = world(), np.random.default_rng(seed)
    state, constants = EnvState.at_start(made), RobotConstants.of(made)
    axes, now_s, shape = state.drive.axes, np.zeros(ROBOTS), (ROBOTS, 3)
    exists = constants.drives.unit > 0.0
    for step in range(3):
        fast = np.where(random.random(shape) < 0.6, random.uniform(-1, 1, shape), 0.0) * exists
        which = random.random(shape) < 0.5
        plan_speed(axes, ALL, now_s, fast, ramp=0.7, which=which)
        way = random.uniform(-1, 1, shape) * exists
        which = random.random(shape) < 0.3
        motion_profile.plan_move(axes, ALL, now_s, way, limit=0.4, ramp=0.9, which=which)
        now_s = now_s + random.uniform(0.0, 1.0, ROBOTS)
        if step < 2:
            drive.advance(state, constants, ALL, now_s)
    return state, constants


def advanced(axes: Axes, to_s: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return how far axes have travelled at a time, and their speeds, computed with numpy."""
    since_s = to_s[:, None] - axes.start_s
    stands = since_s >= axes.ramp_s + axes.cruise_s + axes.brake_s
    ramping_s = np.minimum(since_s, axes.ramp_s)
    behind_s = np.maximum(since_s - axes.ramp_s, 0.0)
    cruising_s = np.minimum(behind_s, axes.cruise_s)
    braking_s = np.minimum(behind_s - cruising_s, axes.brake_s)
    none = np.zeros_like(axes.brake_s)
    slowing = np.divide(axes.cruise, axes.brake_s, out=none, where=axes.brake_s > 0.0)
    way = axes.begun + (axes.first + axes.ramp * ramping_s / 2) * ramping_s
    way += axes.cruise * (cruising_s + braking_s) - slowing * braking_s * braking_s / 2
    ramped = axes.first + axes.ramp * ramping_s
    now = np.where(since_s < axes.ramp_s, ramped, axes.cruise) - slowing * braking_s
    return np.where(stands, axes.total, way), np.where(stands, 0.0, now)


def values(state: EnvState) -> dict[str, bytes]:
    """Return all that kernels change, as bytes."""
    parts = {"axes": state.drive.axes, "drive": state.drive, "odometry": state.odometry}
    return {
        f"{name}.{field.name}": getattr(part, field.name).tobytes()
        for name, part in parts.items()
        for field in fields(part)
        if field.name != "axes"
    }


@pytest.mark.parametrize("seed", range(3))
def test_axes_and_robots_move_as_with_numpy(seed: int) -> None:
    (state, constants), (before, _) = moving(seed), moving(seed)
    to_s = state.drive.clock_s + np.linspace(0.0, 2.0, ROBOTS)
    travelled, speed = advanced(state.drive.axes, to_s)
    drive.advance(state, constants, ALL, to_s)
    way, drives, old = travelled - before.drive.axes.travelled, constants.drives, before.odometry
    assert np.array_equal(state.drive.axes.travelled, travelled)
    assert np.array_equal(state.drive.axes.speed, speed)
    assert np.array_equal(state.drive.slice, before.drive.slice + way)
    facing_rad, turn_rad = before.drive.facing_rad, weighted(way, drives.true_turn)
    moved_m = odometry.arc(facing_rad, weighted(way, drives.true_forward), turn_rad)
    assert np.array_equal(state.drive.moved_m, before.drive.moved_m + np.column_stack(moved_m))
    assert np.array_equal(state.drive.facing_rad, facing_rad + turn_rad)
    assert np.array_equal(state.drive.turret_rad, before.drive.turret_rad + way[:, 2])
    shaft, count = old.shaft + way, drives.table[:, 12:15]
    reported = np.rint(shaft / count) * count
    whole = reported - old.reported
    x_m, y_m = odometry.arc(
        old.heading_rad, weighted(whole, drives.forward), weighted(whole, drives.turn)
    )
    heading_rad = (old.heading_rad + weighted(whole, drives.turn)) % TURN
    turret_rad = (old.turret_rad + np.where(drives.turret, whole[:, 2], 0.0)) % TURN
    assert np.array_equal(state.odometry.shaft, shaft)
    assert np.array_equal(state.odometry.reported, reported)
    assert np.array_equal(state.odometry.x_m, old.x_m + x_m)
    assert np.array_equal(state.odometry.y_m, old.y_m + y_m)
    assert np.array_equal(state.odometry.heading_rad, heading_rad)
    assert np.array_equal(state.odometry.turret_rad, turret_rad)
    assert (way != 0.0).any(axis=0).all()


def test_parts_of_the_motion_are_computed_as_the_whole() -> None:
    (state, constants), (parts, _) = moving(5), moving(5)
    to_s = state.drive.clock_s + 0.3
    drive.advance(state, constants, ALL, to_s)
    parts.drive.hindered[0] = True  # a contact that does not hold up: its speed is that of its axes
    forward_mps = weighted(advanced(parts.drive.axes, to_s)[0] - parts.drive.axes.travelled,
                           constants.drives.forward) / 0.3  # fmt: skip
    parts.drive.forward_mps[0] = forward_mps[0]
    drive.advance(parts, constants, ALL, to_s)
    assert np.allclose(state.odometry.x_m, parts.odometry.x_m, rtol=0, atol=1e-12)
    assert np.array_equal(state.odometry.x_m[1:], parts.odometry.x_m[1:])
    assert np.array_equal(state.drive.moved_m, parts.drive.moved_m)
    assert np.array_equal(state.drive.axes.speed, parts.drive.axes.speed)


def test_hindered_robots_are_advanced_and_reported_as_with_numpy() -> None:
    (state, constants), (again, _) = moving(6), moving(6)
    random = np.random.default_rng(6)
    hindered, forward_mps = random.random(ROBOTS) < 0.6, 0.1 * random.random(ROBOTS)
    for each in (state, again):
        each.drive.hindered[:] = hindered
        each.drive.forward_mps[:] = np.where(hindered, forward_mps, 0.0)
    rows = np.arange(ROBOTS)
    for _ in range(2):
        to_s = state.drive.clock_s + 0.3
        drive.advance(state, constants, ALL, to_s)
        drive._advance_axes(again, constants, ALL, to_s)
        assert values(state) == values(again)
    unit, speed = constants.drives.unit, traction.speed(again, constants, rows)
    told = np.divide(speed, unit, out=np.zeros_like(speed), where=unit > 0.0)
    assert (vendor_state.report(state, constants, rows)[:, 4:7] == np.rint(told)).all()
    assert (speed != again.drive.axes.speed).any(axis=0)[:2].all()
    assert (state.drive.ahead_m != 0.0).sum() > ROBOTS / 3


@pytest.mark.parametrize("rows", [np.arange(3, ROBOTS, 4), np.array([7])])
def test_some_robots_are_advanced_as_all(rows: np.ndarray) -> None:
    (together, constants), (alone, _) = moving(1), moving(1)
    to_s = together.drive.clock_s.copy()
    to_s[rows] += 0.2
    drive.advance(together, constants, ALL, to_s)
    drive.advance(alone, constants, rows, to_s[rows])
    assert values(together) == values(alone)


def test_the_checked_build_computes_the_same(monkeypatch: pytest.MonkeyPatch) -> None:
    state, constants = moving(2)
    to_s = state.drive.clock_s + 0.4
    drive.advance(state, constants, ALL, to_s)
    checked = Kernels(holds_world=True, checked=True)
    monkeypatch.setattr(program._threads, "kernels", Kernels(checked=True))
    monkeypatch.setattr(robot_rows, "Kernels", lambda **_: checked)
    again, _ = moving(2)
    drive.advance(again, constants, ALL, to_s)
    assert values(state) == values(again)


@pytest.mark.parametrize("most", [1, 7])
def test_one_call_and_many_compute_the_same(most: int, monkeypatch: pytest.MonkeyPatch) -> None:
    state, constants = moving(4)
    to_s = state.drive.clock_s + 0.4
    drive.advance(state, constants, ALL, to_s)
    for module in (robot_rows, odometry, motion_profile):
        monkeypatch.setattr(module, "ROBOTS_AT_ONCE", most)
    monkeypatch.setattr(robot_rows, "ROBOTS", most)  # more robots do not fit
    again, _ = moving(4)
    drive.advance(again, constants, ALL, to_s)
    assert values(state) == values(again)
    for each in (state, again):
        each.rows.set_speeds(ALL, np.full((ROBOTS, 3), 0.2), constants.kinds)
        found = each.rows.finish(each, (0.1, 3.0), each.bodies.position_m.copy(), constants.kinds)
        assert found == (ADVANCED, [], False)
    assert state.sha256() == again.sha256()
    rows = np.arange(ROBOTS)
    told = [each.rows.replies(ALL, rows / 7, constants.kinds) for each in (state, again)]
    for name in ("state", "charge", "board_ms"):
        assert np.array_equal(told[0][name], told[1][name])
    left = [each.rows.charges(ALL, rows / 7, constants.kinds) for each in (state, again)]
    assert np.array_equal(left[0], left[1])
    reports = [vendor_state.report(each, constants, rows).tolist() for each in (state, again)]
    assert reports[0] == reports[1]
