"""The kernel of reports tells what numpy computes, to the bit."""

from __future__ import annotations

import numpy as np
import pytest

from crs_cc.core.arrays import Int32Array
from crs_cc.core.units import m_to_tenths_inch, rad_to_tenths_deg
from crs_cc.sim.devices import vendor_state
from crs_cc.sim.devices.robot_constants import RobotConstants
from crs_cc.sim.kernels.program import Kernels
from crs_cc.sim.state import robot_rows
from crs_cc.sim.state.env_state import EnvState
from tests.sim.kernels.test_drive import moving

LARGEST = 2**31 - 1


def changed(seed: int) -> tuple[EnvState, RobotConstants]:
    """Return moving robots, some of them limp, and some where no report can tell it."""
    state, constants = moving(seed)
    random, odometry = np.random.default_rng(seed), state.odometry
    state.drive.limp[:] = random.random(state.drive.limp.shape) < 0.2
    odometry.x_m[::5] = random.uniform(-1e3, 1e3, len(odometry.x_m[::5]))
    odometry.y_m[1], odometry.y_m[2], odometry.x_m[3] = 1e9, -1e9, 0.00127  # halves to even
    odometry.turret_rad[4] = odometry.heading_rad[4] = 6.2831
    return state, constants


def numpy_report(state: EnvState, constants: RobotConstants) -> Int32Array:
    odometry, axes, unit = state.odometry, state.drive.axes, constants.drives.unit
    values = np.zeros((len(odometry.x_m), 8))
    values[:, 0], values[:, 1] = m_to_tenths_inch(odometry.x_m), m_to_tenths_inch(odometry.y_m)
    values[:, 2] = rad_to_tenths_deg(odometry.heading_rad)
    values[:, 3] = rad_to_tenths_deg(odometry.turret_rad)
    np.divide(axes.speed, unit, out=values[:, 4:7], where=unit > 0.0)
    whole = np.clip(np.rint(values), -LARGEST, LARGEST).astype(np.int32)
    whole[:, 2:4] %= 3600
    works = (axes.end_s() > state.drive.clock_s[:, None]) & ~state.drive.limp
    whole[:, 7] = works @ np.array([1, 2, 4])
    return whole


@pytest.mark.parametrize("seed", range(3))
def test_reports_are_those_of_numpy(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    state, constants = changed(seed)
    rows, wanted = np.arange(len(state.heading_rad)), numpy_report(state, constants)
    assert vendor_state.report(state, constants, rows).tolist() == wanted.tolist()
    assert vendor_state.report(state, constants, rows[3::7]).tolist() == wanted[3::7].tolist()
    assert {0, 1, 3} <= set(wanted[:, 7].tolist())
    checked = Kernels(holds_world=True, checked=True)
    monkeypatch.setattr(robot_rows, "Kernels", lambda **_: checked)
    state, constants = changed(seed)
    assert vendor_state.report(state, constants, rows).tolist() == wanted.tolist()
