"""The vendor's `State[45]`: a robot's report to its host, in the vendor's indices and units.

Indices and units are those of the vendor header `Nclient.h` 1.29. What a robot does not
have is 0. `sensor_board` fills it in.

>>> from crs_cc.sim.files.world_xml import empty_world
>>> world = empty_world()
>>> configuration(EnvState.at_start(world), RobotConstants.of(world), np.array([0])).tolist()
[[0, 0, 0, 0, 0, 0, 0]]
"""

from __future__ import annotations

from typing import Final, NamedTuple, Self

import numpy as np

from crs_cc.core.arrays import BoolArray, FloatArray, IndexArray, Int32Array
from crs_cc.requests import LARGEST
from crs_cc.sim.devices.drive import traction
from crs_cc.sim.devices.robot_constants import RobotConstants
from crs_cc.sim.state.env_state import EnvState
from crs_cc.sim.state.last_measurement import CONFIGURATION
from crs_cc.sim.state.rows import simplest

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

_CONFIGURATION: Final = slice(CONF_X, CONF_X + CONFIGURATION)
_SPEEDS: Final = slice(VEL_RIGHT - CONF_X, MOTOR_STATUS - CONF_X)  # of a report

LASER: Final = 42  # mode
COMPASS: Final = 43  # [0.1 deg], 0 to 3599


class KernelReply(NamedTuple):
    """Results of the kernel that answered a request, for sensors that measure for its reply.

    Attributes:
        configuration: their positions and speeds, see `configuration`, (k, 7).
        mounts: x, y [m] and direction [rad] of their mounts, see `mount_poses`, (k, 3).
    """

    configuration: Int32Array
    mounts: FloatArray

    @classmethod
    def by(cls, states: Int32Array, mounts: FloatArray) -> Self:
        """Return the results from `State` of each robot, (k, 45), and its mount, (k, 3)."""
        return cls(states[:, _CONFIGURATION], mounts)

    def of(self, which: BoolArray) -> Self:
        """Return the results of some of the robots; `which` is a mask, (k,)."""
        return type(self)(self.configuration[which], self.mounts[which])


def report(state: EnvState, constants: RobotConstants, rows: IndexArray) -> Int32Array:
    """Return the part of `State` with positions, speeds and the motors' status, shape (k, 8)."""
    kinds = constants.kinds
    reports = state.rows.reports(simplest(rows, len(kinds.kind)), len(rows), kinds)
    correct_speeds(state, constants, rows, reports[:, _SPEEDS])
    return reports


def correct_speeds(
    state: EnvState, constants: RobotConstants, rows: IndexArray, speeds: Int32Array
) -> None:
    """Set the reported speeds of robots, some of which are held up or degraded, (k, 3)."""
    if constants.degradations.affects_motion(state):
        now_s, speed = state.drive.clock_s[rows], traction.speed(state, constants, rows)
        speed = constants.degradations.speeds(state, "odometry", rows, speed, now_s)
        unit, ticks = constants.drives.unit[rows], np.zeros_like(speed)
        ticks = np.rint(np.divide(speed, unit, out=ticks, where=unit > 0.0))
        speeds[:] = np.clip(ticks, -LARGEST, LARGEST)


def configuration(state: EnvState, constants: RobotConstants, rows: IndexArray) -> Int32Array:
    """Return the part of `State` with positions and speeds, shape (k, 7)."""
    return report(state, constants, rows)[:, :CONFIGURATION]
