"""The poses of the robots' mounts at the time to which their axes have been advanced.

The mount is the turret, or the base of a robot without one. Within a cycle its pose follows the
axes' motion since the start of the cycle; a robot that is held up counts as being where it was
then.

>>> from crs_cc.sim.state.env_state import EnvState
>>> from crs_cc.sim.devices.robot_constants import RobotConstants
>>> from crs_cc.sim.files.world_xml import empty_world
>>> world = empty_world()
>>> mount_poses(EnvState.at_start(world), RobotConstants.of(world), np.array([0]))
array([[0., 0., 0.]])
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from crs_cc.core.arrays import FloatArray, IndexArray, any_of
from crs_cc.sim.state.rows import simplest, take

if TYPE_CHECKING:
    from crs_cc.sim.devices.robot_constants import RobotConstants
    from crs_cc.sim.state.env_state import EnvState


def mount_poses(state: EnvState, constants: RobotConstants, rows: IndexArray) -> FloatArray:
    """Return x, y [m] and direction [rad] of robots' mounts, world frame, shape (k, 3)."""
    robots = len(state.drive.facing_rad)
    which, slipping = simplest(rows, robots), state.bodies.slipping
    moved_m = take(state.drive.moved_m, which)
    if any_of(slipping):
        moved_m = np.where(slipping[rows, None], 0.0, moved_m)
    facing_rad = turret_rad = state.drive.facing_rad[which]
    if constants.drives.turrets:
        turret_rad = state.drive.turret_rad[which]
    poses = np.empty((len(rows), 3))
    np.add(take(state.bodies.position_m[:robots], which), moved_m, out=poses[:, :2])
    poses[:, 2] = mount_rad(state, constants, rows, facing_rad, turret_rad)
    return poses


def mount_rad(
    state: EnvState,
    constants: RobotConstants,
    rows: IndexArray,
    facing_rad: FloatArray,
    turret_rad: FloatArray,
) -> FloatArray:
    """Return the mounts' directions for directions of wheels and turret [rad], shape (k,).

    Args:
        state: has the directions of synchro drives' bases, which never turn.
        constants: the robots' constants.
        rows: the robots, k of them.
        facing_rad: direction of the wheels of each, shape (k,).
        turret_rad: direction of its turret, ignored where there is none, shape (k,).
    """
    drives = constants.drives
    if not (drives.synchros or drives.turrets):
        return facing_rad
    base_rad = np.where(drives.synchro[rows], state.base_rad[rows], facing_rad)
    return np.where(drives.turret[rows], turret_rad, base_rad)
