"""Placing robots at other poses: `place_robot`.

The robot's true pose and its odometry become the requested ones; the motion of its axes continues.
A synchro drive's base keeps its direction. What the robot holds stays behind. Places outside of the
world's area or occupied by anything else are refused (chosen by us: the vendor's header does not
specify it). The program continues at the end of the timestep.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from crs_cc.core.arrays import BoolArray
from crs_cc.core.units import tenths_deg_to_rad, tenths_inch_to_m
from crs_cc.sim.engine.roster import obstructing_object
from crs_cc.sim.engine.teleport import put_robot
from crs_cc.sim.model.world import Pose

if TYPE_CHECKING:
    from crs_cc.sim.devices.request_context import RequestContext
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.env_state import EnvState


_FULL_TURN: Final = 3600  # [0.1 deg]


def place_robot(context: RequestContext) -> BoolArray:
    """Answer PLACE_ROBOT, one after the other; refuse occupied places."""
    state, constants = context.state, context.constants
    good = np.zeros(len(context), dtype=np.bool_)
    poses = context.columns("x", "y", "heading", "turret").tolist()
    for row, robot in enumerate(context.rows.tolist()):
        x, y, heading, turret = poses[row]
        place = Pose(
            tenths_inch_to_m(float(x)),
            tenths_inch_to_m(float(y)),
            tenths_deg_to_rad(float(heading % _FULL_TURN)),
        )
        radius_m = float(constants.radius_m[robot])
        good[row] = not obstructing_object(state, constants, place, radius_m, robot)
        if good[row]:
            _put(state, constants, robot, place, tenths_deg_to_rad(float(turret % _FULL_TURN)))
    return good


def _put(
    state: EnvState, constants: RobotConstants, robot: int, place: Pose, turret_rad: float
) -> None:
    drives, odometry = constants.drives, state.odometry
    base_rad = float(state.base_rad[robot]) if drives.synchro[robot] else place.heading_rad
    put_robot(state, constants, robot, place, base_rad=base_rad, turret_rad=turret_rad)
    odometry.x_m[robot], odometry.y_m[robot] = place.x_m, place.y_m
    odometry.heading_rad[robot] = place.heading_rad
    odometry.turret_rad[robot] = turret_rad if drives.turret[robot] else 0.0
