"""The vendor's `State[45]`: what a robot reports to its host, in the vendor's indices and units.

Indices and units are those of the vendor header `Nclient.h` 1.29. What a robot does not
have is 0. `sensor_board` fills it in.

>>> from crs_cc.sim.files.world_xml import empty_world
>>> world = empty_world()
>>> configuration(EnvState.at_start(world), RobotConstants.of(world), np.array([0])).tolist()
[[0, 0, 0, 0, 0, 0, 0]]
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core.arrays import IndexArray, Int32Array
from crs_cc.sim.devices.drive import traction
from crs_cc.sim.devices.robot_constants import RobotConstants
from crs_cc.sim.kernels.program import ROBOTS_AT_ONCE, kernels
from crs_cc.sim.state.env_state import EnvState
from crs_cc.sim.state.last_measurement import CONFIGURATION
from crs_cc.sim.state.rows import parts, simplest, take

SIM_SPEED: Final = 0  # 10 is real time
IR_0: Final = 1  # to 16, 0 to 15
SONAR_0: Final = 17  # to 32 [in]
BUMPER: Final = 33  # bit mask
CONF_X: Final = 34  # [0.1 in]
CONF_Y: Final = 35  # [0.1 in]
CONF_STEER: Final = 36  # [0.1 deg], 0 to 3599
CONF_TURRET: Final = 37  # [0.1 deg], 0 to 3599
VEL_RIGHT: Final = 38  # [0.1 in/s]; of a synchro drive the translation
VEL_LEFT: Final = 39  # [0.1 in/s]; of a synchro drive the steering [0.1 deg/s]
VEL_TURRET: Final = 40  # [0.1 deg/s]
MOTOR_STATUS: Final = 41  # bit n: the motor of axis n + 1 works, even if stalled

LASER: Final = 42  # mode
COMPASS: Final = 43  # [0.1 deg], 0 to 3599


def report(state: EnvState, constants: RobotConstants, rows: IndexArray) -> Int32Array:
    """Return the part of `State` with positions, speeds and the motors' status, shape (k, 8)."""
    speed, now_s = traction.speed(state, constants, rows), state.drive.clock_s[rows]
    speed = constants.degradations.speeds(state, "odometry", rows, speed, now_s)
    reports = np.empty((len(rows), CONFIGURATION + 1), dtype=np.int32)
    odometry, axes = state.odometry, state.drive.axes
    before = odometry.x_m, odometry.y_m, odometry.heading_rad, odometry.turret_rad
    profile = axes.start_s, axes.ramp_s, axes.cruise_s, axes.brake_s
    selected = simplest(rows, len(odometry.x_m))
    for some, part in parts(selected, len(rows), ROBOTS_AT_ONCE):
        columns = [
            *(take(column, some) for column in before),
            now_s[part],
            *(take(column, some) for column in profile),
            speed[part],
            take(constants.drives.unit, some),
            take(state.drive.limp, some),
        ]
        reports[part] = kernels().reports(part.stop - part.start, columns)
    return reports


def configuration(state: EnvState, constants: RobotConstants, rows: IndexArray) -> Int32Array:
    """Return the part of `State` with positions and speeds, shape (k, 7)."""
    return report(state, constants, rows)[:, :CONFIGURATION]
