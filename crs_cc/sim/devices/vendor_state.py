"""The vendor's `State[45]`: what a robot reports to its host, in the vendor's indices and units.

Indices and units are those of the vendor header `Nclient.h` 1.29. What a Scout does not have
(infrared, turret, laser, compass) is 0.

>>> from crs_cc.sim.state.env_state import EnvState
>>> from crs_cc.sim.files.world_xml import empty_world
>>> world = empty_world()
>>> vector = state_vector(EnvState.at_start(world), RobotConstants.of(world), np.array([0]))
>>> vector.shape, vector[0, SIM_SPEED], vector[0, SONAR_0]
((1, 45), np.int32(10), np.int32(255))
"""

from __future__ import annotations

from typing import Final

import numpy as np

from crs_cc.core.arrays import IndexArray, Int32Array
from crs_cc.core.units import m_to_tenths_inch, rad_to_tenths_deg
from crs_cc.requests import LARGEST, NUM_STATE
from crs_cc.sim.devices.drive import traction
from crs_cc.sim.devices.robot_constants import RobotConstants
from crs_cc.sim.model.sonar import MAX_SONARS
from crs_cc.sim.state.env_state import EnvState
from crs_cc.sim.state.rows import take
from crs_cc.sim.state.sonar import CONFIGURATION

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

_BITS: Final = np.array([1, 2, 4])
_REAL_TIME: Final = 10
_FULL_TURN: Final = 3600


def state_vector(state: EnvState, constants: RobotConstants, rows: IndexArray) -> Int32Array:
    """Return `State` of robots at the time to which their axes were turned, shape (k, 45)."""
    vector = np.zeros((len(rows), NUM_STATE), dtype=np.int32)
    vector[:, SIM_SPEED] = _REAL_TIME
    vector[:, SONAR_0 : SONAR_0 + MAX_SONARS] = state.sonar.reading_in(rows)
    if len(state.infrared.level):
        has = constants.infrared[rows] >= 0
        level = state.infrared.level[constants.infrared[rows[has]]]
        vector[has, IR_0:SONAR_0] = np.rint(level)
    if len(state.laser.mode):
        has = constants.laser[rows] >= 0
        vector[has, LASER] = state.laser.mode[constants.laser[rows[has]]]
    if len(state.compass.reading):
        has = constants.compass[rows] >= 0
        vector[has, COMPASS] = state.compass.reading[constants.compass[rows[has]]]
    vector[:, BUMPER] = state.bumpers.pressed[rows]
    vector[:, CONF_X : VEL_TURRET + 1] = configuration(state, constants, rows)
    works = state.drive.axes.end_s(rows) > state.drive.clock_s[rows, None]
    vector[:, MOTOR_STATUS] = (works & ~take(state.drive.limp, rows)) @ _BITS
    return vector


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
