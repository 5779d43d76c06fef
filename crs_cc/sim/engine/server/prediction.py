"""The sensors' readings at another pose: `predict_sensors`.

The sensors measure without errors from a pose in the world frame, with everything else, including
the robot itself, where it was at the start of the timestep; beams pass through the robot's own
body. Chosen by us: all sonars and infrared sensors are reported, even if the program has switched
them off, and the laser as set by `conf_ls` and `conf_sg`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.core.units import tenths_deg_to_rad, tenths_inch_to_m
from crs_cc.requests import NUM_STATE
from crs_cc.sim.devices.mount import mount_rad
from crs_cc.sim.devices.sonar.model import MAX_SONARS
from crs_cc.sim.devices.vendor_state import IR_0, SONAR_0

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.devices.sensor_board import SensorBoard
    from crs_cc.sim.devices.sonar import SonarRing
    from crs_cc.sim.state.env_state import EnvState


def predict(context: RequestContext, *, sonars: SonarRing, sensor_board: SensorBoard) -> None:
    """Answer PREDICT; the state stores what lasers would see."""
    state, constants, rays = context.state, context.constants, context.rays
    rows, wanted = context.rows, context.columns("x", "y", "heading", "turret")
    poses = _mounts(state, constants, rows, wanted.astype(np.float64))
    states = np.zeros((len(rows), NUM_STATE), dtype=np.int32)
    states[:, SONAR_0 : SONAR_0 + MAX_SONARS] = sonars.look(state, rays, rows, poses)
    states[:, IR_0:SONAR_0], counts = sensor_board.look(state, constants, rays, rows, poses)
    context.put_data(states)
    context["laser_count"] = counts


def _mounts(
    state: EnvState, constants: RobotConstants, rows: IndexArray, wanted: FloatArray
) -> FloatArray:
    """Return x, y [m] and direction [rad] of the mounts of robots at x, y, heading and turret."""
    place_m = tenths_inch_to_m(wanted[:, :2])
    heading_rad, turret_rad = tenths_deg_to_rad(wanted[:, 2:]).T
    return np.column_stack([place_m, mount_rad(state, constants, rows, heading_rad, turret_rad)])
