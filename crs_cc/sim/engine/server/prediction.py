"""What the sensors would read somewhere else: `predict_sensors`.

The robot is thought to be at a pose in the world frame, the sensors to measure without any error,
and everything else, the robot itself too, to be where it was at the start of the timestep; beams
pass through the robot's own body. Chosen by us: all sonars and infrared sensors are told, whether
the program has switched them on or not, and the laser as `conf_ls` and `conf_sg` have set it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray
from crs_cc.core.units import tenths_deg_to_rad, tenths_inch_to_m
from crs_cc.requests import NUM_STATE
from crs_cc.sim.devices.mount import mount_rad
from crs_cc.sim.devices.vendor_state import IR_0, SONAR_0
from crs_cc.sim.model.sonar import MAX_SONARS

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.devices.sensor_board import SensorBoard
    from crs_cc.sim.devices.sonar import SonarRing
    from crs_cc.sim.state.env_state import EnvState


def predict(asked: RequestContext, *, sensors: tuple[SonarRing, SensorBoard]) -> None:
    """Answers PREDICT.

    Args:
        asked: the poses; the state keeps what lasers would see.
        sensors: those of the robots.
    """
    sonars, instruments = sensors
    state, constants, rays = asked.state, asked.constants, asked.rays
    rows, messages = asked.rows, asked.messages
    poses = _mounts(state, constants, rows, messages["i"][:, :4].astype(np.float64))
    told = np.zeros((len(rows), NUM_STATE), dtype="<i4")
    told[:, SONAR_0 : SONAR_0 + MAX_SONARS] = sonars.look(state, rays, rows, poses)
    told[:, IR_0:SONAR_0], counts = instruments.look(state, constants, rays, rows, poses)
    messages["size"] = told.itemsize * NUM_STATE
    messages["data"][:, : told.itemsize * NUM_STATE] = told.view(np.uint8)
    messages["i"][:, 0] = counts


def _mounts(
    state: EnvState, constants: RobotConstants, rows: IndexArray, asked: FloatArray
) -> FloatArray:
    """Gives x, y [m] and direction [rad] of the mounts of robots at x, y, heading and turret."""
    place_m = tenths_inch_to_m(asked[:, :2])
    heading_rad, turret_rad = tenths_deg_to_rad(asked[:, 2:]).T
    return np.column_stack([place_m, mount_rad(state, constants, rows, heading_rad, turret_rad)])
