"""The reply with `State[45]`: what the sensor board reports of all devices.

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
from crs_cc.requests import NUM_STATE
from crs_cc.sim.devices.bumper.state import bumper_state
from crs_cc.sim.devices.robot_constants import RobotConstants
from crs_cc.sim.devices.sonar.model import MAX_SONARS
from crs_cc.sim.devices.sonar.state import sonar_state
from crs_cc.sim.devices.vendor_state import (
    BUMPER,
    COMPASS,
    CONF_X,
    IR_0,
    LASER,
    MOTOR_STATUS,
    SIM_SPEED,
    SONAR_0,
    VEL_TURRET,
    configuration,
)
from crs_cc.sim.state.env_state import EnvState
from crs_cc.sim.state.rows import take

_BITS: Final = np.array([1, 2, 4])
_REAL_TIME: Final = 10


def state_vector(state: EnvState, constants: RobotConstants, rows: IndexArray) -> Int32Array:
    """Return `State` of robots at the time to which their axes were turned, shape (k, 45)."""
    vector = np.zeros((len(rows), NUM_STATE), dtype=np.int32)
    vector[:, SIM_SPEED] = _REAL_TIME
    vector[:, SONAR_0 : SONAR_0 + MAX_SONARS] = sonar_state(state).reading_in(rows)
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
    vector[:, BUMPER] = bumper_state(state).pressed[rows]
    vector[:, CONF_X : VEL_TURRET + 1] = configuration(state, constants, rows)
    works = state.drive.axes.end_s(rows) > state.drive.clock_s[rows, None]
    vector[:, MOTOR_STATUS] = (works & ~take(state.drive.limp, rows)) @ _BITS
    return vector
