"""The vendor's `State[45]`: what a robot reports to its host, in the vendor's indices and units.

Indices and units are those of the vendor header `Nclient.h` 1.29. What a robot does not
have is 0. `sensor_board` fills it in.

>>> from crs_cc.sim.state.env_state import EnvState
>>> from crs_cc.sim.files.world_xml import empty_world
>>> world = empty_world()
>>> configuration(EnvState.at_start(world), RobotConstants.of(world), np.array([0])).tolist()
[[0, 0, 0, 0, 0, 0, 0]]
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core.arrays import IndexArray, Int32Array
from crs_cc.core.units import m_to_tenths_inch, rad_to_tenths_deg
from crs_cc.requests import LARGEST
from crs_cc.sim.devices.drive import traction
from crs_cc.sim.devices.robot_constants import RobotConstants
from crs_cc.sim.state.env_state import EnvState
from crs_cc.sim.state.last_measurement import CONFIGURATION
from crs_cc.sim.state.rows import take

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

_FULL_TURN: Final = 3600


def configuration(state: EnvState, constants: RobotConstants, rows: IndexArray) -> Int32Array:
    """Return the part of `State` with positions and speeds, shape (k, 7)."""
    odometry = state.odometry
    speed, unit = traction.speed(state, constants, rows), take(constants.drives.unit, rows)
    now_s = state.drive.clock_s[rows]
    speed = constants.degradations.speeds(state, "odometry", rows, speed, now_s)
    reported = np.zeros((len(rows), CONFIGURATION))
    reported[:, 0] = m_to_tenths_inch(odometry.x_m[rows])
    reported[:, 1] = m_to_tenths_inch(odometry.y_m[rows])
    reported[:, 2] = rad_to_tenths_deg(odometry.heading_rad[rows])
    reported[:, 3] = rad_to_tenths_deg(odometry.turret_rad[rows])
    np.divide(speed, unit, out=reported[:, 4:], where=unit > 0.0)
    whole = np.maximum(np.minimum(np.rint(reported), LARGEST), -LARGEST).astype(np.int32)
    whole[:, 2:4] %= _FULL_TURN
    return whole
